// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_quantities_footprint_h
#define biface_model_quantities_footprint_h


namespace Biface
{
  class ContactPair;
  struct Loads;
  struct State;


  /**
   * The figures of a footprint, the zone of contact seen along the direction in
   * which the ground travels, between the nodes of the mesh.
   *
   * Along each line of the mesh a node in contact covers the line up to halfway
   * to its neighbors. The edge of the zone, the line of zero clearance, lies in
   * the part covered by the last node in contact, at the fraction
   * @f[ f=\frac{P}{P+G},\qquad P=\frac{p_0}{p_{-1}},\qquad
   *     G=\frac{g_1}{g_2}\left(1+\frac{h_2(h_0+2h_1+h_2)}{h_1(h_0+h_1)}\right)
   * @f]
   * of this part: @f$p_0@f$ and @f$p_{-1}@f$ are the pressures of this node and
   * of the one before, @f$g_1@f$ and @f$g_2@f$ the clearances of the next two
   * nodes, and @f$h_0,h_1,h_2@f$ the lengths of the segments between the four
   * nodes. When a node enters or leaves, its pressure and its clearance are
   * zero, and the edge passes from the part of one node to that of the next.
   * So it moves continuously. It is exact at these instants for a membrane
   * under constant pressure, whose nodal pressures act on the parts of the
   * nodes.
   *
   * On a mesh without lines a node in contact covers its cells up to halfway to
   * its neighbors, so that the edge jumps by half a cell with a node; and a
   * point in a cell covers its part of the cell.
   */
  struct Footprint
  {
    /** The extent in the wheel plane, normal to the y axis, and across it,
     * along the projection of the y axis. Unit: length. */
    double length = 0, width = 0;

    /** The area of the deformed face within the edge. Unit: area. */
    double area = 0;

    /**
     * The maximum over the nodes of the pressure
     * @f$-\lambda_h=-\sum_r\lambda_r\psi_r@f$, the mean of the cells around the
     * node, if all their corners are in contact; that of the nodal pressures if
     * there is no such node. For the lumped mortar matrix,
     * @f$\psi_r@f$ are the dual basis functions of the bilinear
     * @f$N_r@f$, @f$\int\psi_rN_s\,d\xi=\delta_{rs}\int N_r\,d\xi@f$
     * @cite Wohlmuth2000 , and the lumped matrix is that of such a field. For
     * the consistent one they are @f$N_r@f$. Unit: force/area.
     */
    double max_pressure = 0;
  };


  /** The footprint of a state; zero without contact. Must be called on all
   * ranks. */
  Footprint
  find_footprint(const ContactPair &pair,
                 const State       &state,
                 const Loads       &loads);
} // namespace Biface

#endif
