// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_contact_contact_traction_h
#define biface_model_contact_contact_traction_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Biface
{
  struct ContactState;
  struct PlacedBody;
  class ShellMesh;
  struct State;


  /** The traction of a body on the shell. Unit: force/area. */
  struct ContactTraction
  {
    dealii::Tensor<1, 3> total;
    /** The tangential part of the traction. */
    dealii::Tensor<1, 3> friction;
  };


  /** The traction at a point from its multipliers; zero if it is inactive, or
   * if the body, then null, is not there.
   * @param x the deformed position of the point. */
  ContactTraction
  contact_traction(const ContactState     &state,
                   const PlacedBody       *body,
                   const unsigned int      point,
                   const dealii::Point<3> &x);


  /** Whether a point slips at the limit of friction of a body, which is null if
   * it is not there. */
  bool
  slips(const ContactState &state,
        const PlacedBody   *body,
        const unsigned int  point);


  /** What happens at the nodes of this rank between the shell and a body: what
   * the state contains or, if the points are in cells, the nodal values that
   * exert the same forces, with nodes in contact that have a point in contact
   * around. Must be called on all ranks.
   * @param number see ContactPair::number. */
  ContactState
  contact_at_nodes(const ShellMesh   &mesh,
                   const State       &state,
                   const unsigned int number,
                   const PlacedBody  &body);
} // namespace Biface

#endif
