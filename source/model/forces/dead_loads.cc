// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/edge_moments.h>
#include <biface/model/mesh/strip.h>

namespace Biface
{
  using namespace dealii;

  void
  DeadLoads::add_parameters(EntryDeclarations &prm)
  {
    // all loads are given for the load factor 1, by which stages multiply them
    const std::string form =
      "three components, optionally followed by the face ('inner', 'outer', "
      "or by default 'middle') and by 'local' for components in the frame "
      "e_1, e_2, e_3 instead of x, y, z.";

    add_parsed(prm,
               "Point forces",
               "",
               point_forces,
               parse_point_forces,
               "Forces at named points: a comma-separated list of 'name: ' "
               "and " +
                 form,
               Unit("force"));
    add_parsed(
      prm,
      "Edge forces",
      "",
      edge_forces,
      parse_edge_forces,
      "Forces along edges: a comma-separated list of 'alpha_1 min: "
      "' (or alpha_1 max, alpha_2 min, alpha_2 max) and " +
        form +
        " Instead of a face, 'ply N' has it act in the middle of ply "
        "N, counted from the inner face.",
      Unit("force/length, of the edge on the reference surface, or, with "
           "'true length' at the end, at the height where the force acts"));
    add_parsed(
      prm,
      "Edge moments",
      "",
      edge_moments,
      parse_edge_moments,
      "Moments along edges: a comma-separated list of 'alpha_1 min: "
      "M dead' or 'alpha_1 min: M follower' (likewise for the other "
      "edges). A positive moment pushes the outer face outward "
      "beyond the edge. 'dead' is a couple of forces on the faces "
      "with constant directions; 'follower' does work on the angle "
      "by which the line between the faces rotates about the edge. "
      "With several 'Laminate/Layers' the forces act on the faces of "
      "all layers, as the stresses of a plane section do. "
      "Several moments on one edge add up.",
      Unit("force, as moment/length of the edge on the reference surface"));
    for (const auto face : {Resultants::inner, Resultants::outer})
      add_parsed(
        prm,
        face == Resultants::inner ? "Inner traction" : "Outer traction",
        "",
        tractions[face],
        parse_traction,
        "A force on the face: three formulas, separated by semicolons, for "
        "the components x, y, z, or, followed by '; local', in the frame "
        "e_1, e_2, e_3. The variables are those of 'Pressure distribution'. "
        "Empty for none.",
        Unit("force/area, of the undeformed face"));
    prm.add_parameter(
      "Area force",
      area_force,
      "A force on the whole shell, such as its weight: "
      "components x, y, z.",
      Unit("force/area, of the middle surface (halfway between the faces)"));
  }


  namespace
  {
    /** Parse three components, the face, 'local'.
     * @param text of the whole item.
     * @param form what is allowed. */
    DeadForce
    parse_force(const std::string              &entry,
                const std::string              &text,
                const std::vector<std::string> &words,
                const std::string              &form)
    {
      if (words.size() < 3)
        throw InputError(entry, text, form);
      DeadForce force;
      for (unsigned int i = 0; i < 3; ++i)
        force.components[i] = parse_number(entry, words[i], form);
      for (unsigned int i = 3; i < words.size(); ++i)
        if (words[i] == "inner")
          force.faces = {{1, 0}};
        else if (words[i] == "outer")
          force.faces = {{0, 1}};
        else if (words[i] == "local")
          force.local = true;
        else if (words[i] != "middle")
          throw InputError(entry, text, form);
      return force;
    }
  } // namespace


  std::vector<PointForce>
  parse_point_forces(const std::string &entry, const std::string &text)
  {
    std::vector<PointForce> forces;
    for (const std::string &item : split_list(entry, text))
      {
        const std::string form =
          "each force must have the form 'name: F_1 F_2 F_3', optionally "
          "followed by 'inner', 'outer' or 'middle' and by 'local'";
        const auto named = split_named(entry, item, form);
        forces.push_back(
          {named.first,
           parse_force(entry, item, split_words(named.second), form)});
      }
    return forces;
  }


  std::vector<EdgeForce>
  parse_edge_forces(const std::string &entry, const std::string &text)
  {
    std::vector<EdgeForce> forces;
    for (const std::string &item : split_list(entry, text))
      {
        const std::string form =
          "each force must have the form 'edge: F_1 F_2 F_3', optionally "
          "followed by 'inner', 'outer', 'middle' or 'ply N', by 'local' and "
          "by 'true length'";
        const auto               named = split_named(entry, item, form);
        std::vector<std::string> words = split_words(named.second);
        EdgeForce                force;
        force.text = item;
        force.edge = named.first;

        // words in pairs are taken out first; parse_force() knows only single
        // ones
        const auto length = std::find(words.begin(), words.end(), "length");
        if (length != words.end())
          {
            if (length == words.begin() || length[-1] != "true")
              throw InputError(entry, item, form);
            force.true_length = true;
            words.erase(length - 1, length + 1);
          }
        const auto ply = std::find(words.begin(), words.end(), "ply");
        if (ply != words.end())
          {
            const double n =
              (ply + 1 == words.end() ? 0. : parse_number(entry, ply[1], form));
            if (!(n >= 1 && n <= 1000 && n == std::floor(n)))
              throw InputError(entry, item, form);
            force.ply = static_cast<unsigned int>(n);
            words.erase(ply, ply + 2);
            for (const char *face : {"middle", "inner", "outer"})
              if (std::find(words.begin(), words.end(), face) != words.end())
                throw InputError(entry, item, form);
          }
        force.force = parse_force(entry, item, words, form);
        forces.push_back(force);
      }
    return forces;
  }


  Traction
  parse_traction(const std::string &entry, const std::string &text)
  {
    std::vector<std::string> formulas = split_list(entry, text, ';');
    Traction                 traction;
    if (formulas.empty())
      return traction;
    traction.local = (formulas.size() == 4 && formulas[3] == "local");
    if (traction.local)
      formulas.pop_back();
    if (formulas.size() != 3)
      throw InputError(entry,
                       text,
                       "it must consist of three formulas, separated by "
                       "semicolons, optionally followed by '; local'");
    for (const std::string &formula : formulas)
      traction.components.push_back(parse_position_formula(entry, formula));
    return traction;
  }


  namespace
  {
    /** Add a fraction of a force to the nodal forces.
     * @param by_layers the derivatives of the displacement on which it does
     * work by the half differences over the layers. */
    void
    add_nodal_force(const Node                &node,
                    const DeadForce           &force,
                    const double               share,
                    const std::vector<double> &by_layers,
                    LA::Vector                &nodal_forces)
    {
      const Tensor<1, 3> f =
        share * (force.local ? force.components
                             : node.surface.to_frame(force.components));
      for (unsigned int i = 0; i < 3; ++i)
        {
          std::vector<double> values{f[i]};
          for (const double derivative : by_layers)
            values.push_back(derivative * f[i]);
          nodal_forces.add(std::vector<types::global_dof_index>(
                             &node.dofs[node.position(i, 0)],
                             &node.dofs[node.position(i, 0)] + node.n_parts()),
                           values);
        }
    }


    /** The same for a force on one of the faces, or else spread evenly over the
     * thickness. */
    void
    add_nodal_force(const Node      &node,
                    const DeadForce &force,
                    const double     share,
                    LA::Vector      &nodal_forces)
    {
      const double inner = force.faces[Resultants::inner];
      const double outer = force.faces[Resultants::outer];
      add_nodal_force(node,
                      force,
                      share,
                      inner == outer
                        ? node.thickness_weights()
                        : std::vector<double>(node.n_layers(), outer - inner),
                      nodal_forces);
    }


    /** The derivatives of the displacement at a part of the thickness of the
     * wall by the half differences over the layers. */
    std::vector<double>
    at_part_of_thickness(const Node &node, const double part)
    {
      const double height =
        node.face_heights[0] +
        part * (node.face_heights[1] - node.face_heights[0]);
      std::vector<double> by_layers;
      double              middle = node.face_heights[0];
      for (const double half : node.half_thickness)
        {
          middle += half;
          // the mean displacement, plus the half differences of the layers
          // below the height, less those of the layers above it
          by_layers.push_back(
            half == 0 ? 0.
                      : std::min(1., std::max(-1., (height - middle) / half)));
          middle += half;
        }
      return by_layers;
    }


    /** Add a force along an edge. Throws InputError where its ply does not
     * reach the edge. */
    void
    add_edge_force(const ShellMesh &mesh,
                   const EdgeForce &force,
                   LA::Vector      &nodal_forces)
    {
      const unsigned int edge =
        mesh.find_edge("Loads/Edge forces", force.text, force.edge);
      unsigned int n_loaded = 0;
      for (const BoundarySegment &segment : mesh.boundary)
        if (segment.edge == edge)
          for (unsigned int k = 0; k < 2; ++k)
            {
              const Node     &node = mesh.nodes[segment.nodes[k]];
              const Laminate &laminate =
                *mesh.strips[mesh.cells[segment.cell].strip]
                   .at_vertices[segment.vertices[k]];
              const std::array<double, 2> heights   = laminate.face_heights();
              const double                thickness = heights[1] - heights[0];

              // where the force acts, as a fraction of the thickness
              double part = force.force.faces[1];
              if (force.ply > 0)
                {
                  double below = 0;
                  bool   found = false;
                  for (const Ply &ply : laminate.get_plies())
                    {
                      found = (ply.number + 1 == force.ply);
                      below += ply.thickness * (found ? 0.5 : 1.);
                      if (found)
                        break;
                    }
                  if (!found)
                    continue;
                  part = below / thickness;
                }
              ++n_loaded;
              // cells at one node may have different plies, so that each
              // segment has its own height
              const double height = heights[0] + part * thickness;
              const double stretch =
                (force.true_length ? 1 + segment.curvatures[k] * height : 1.);
              const double share = stretch * segment.length / 2;
              if (force.ply > 0)
                add_nodal_force(node,
                                force.force,
                                share,
                                at_part_of_thickness(node, part),
                                nodal_forces);
              else
                add_nodal_force(node, force.force, share, nodal_forces);
            }
      // the edge may lie on other ranks
      if (Utilities::MPI::sum(n_loaded, mesh.communicator) == 0)
        throw InputError("Loads/Edge forces",
                         force.text,
                         force.ply > 0
                           ? "there is no such ply on this edge"
                           : "there is no side of a cell along this edge");
    }


    /** Add a force per area of the middle surface. */
    void
    add_area_force(const ShellMesh &mesh,
                   const DeadForce &force,
                   LA::Vector      &nodal_forces)
    {
      for (const Cell &cell : mesh.wall_elements())
        for (unsigned int v = 0; v < 4; ++v)
          add_nodal_force(mesh.nodes[cell.nodes[v]],
                          force,
                          cell.geometry.vertex_areas[v],
                          nodal_forces);
    }


    /** Add a force per area of a face that depends on the position. */
    void
    add_traction(const ShellMesh       &mesh,
                 const Resultants::Face face,
                 const Traction        &traction,
                 LA::Vector            &nodal_forces)
    {
      const auto values = evaluate_at_nodes(traction.components, mesh);
      DeadForce  force;
      force.local       = traction.local;
      force.faces       = {{0, 0}};
      force.faces[face] = 1;
      for (const Cell &cell : mesh.wall_elements())
        for (unsigned int v = 0; v < 4; ++v)
          {
            for (unsigned int i = 0; i < 3; ++i)
              force.components[i] = values[cell.nodes[v]][i];
            add_nodal_force(mesh.nodes[cell.nodes[v]],
                            force,
                            vertex_area(cell, v, face),
                            nodal_forces);
          }
    }
  } // namespace


  std::vector<LA::Vector>
  DeadLoads::assemble(const ShellMesh &mesh) const
  {
    // a vector for each factor, which a stage can change without another
    // assembly
    unsigned int last = factor_of_area_force;
    for (const PointForce &item : point_forces)
      last = std::max(last, item.force.factor);
    for (const EdgeForce &item : edge_forces)
      last = std::max(last, item.force.factor);
    for (const EdgeMoment &item : edge_moments)
      last = std::max(last, item.factor);
    for (const Traction &traction : tractions)
      last = std::max(last, traction.factor);
    std::vector<LA::Vector> nodal_forces(last + 1, mesh.owned_vector());
    for (const PointForce &item : point_forces)
      if (item.force.local)
        mesh.require_direction("Loads/Point forces", item.point);
    for (const EdgeForce &item : edge_forces)
      if (item.force.local)
        mesh.require_direction("Loads/Edge forces", item.text);
    for (const auto face : {Resultants::inner, Resultants::outer})
      if (tractions[face].local)
        mesh.require_direction(face == Resultants::inner
                                 ? "Loads/Inner traction"
                                 : "Loads/Outer traction",
                               "local");

    for (const PointForce &item : point_forces)
      {
        const unsigned int n =
          mesh.node_of_point("Loads/Point forces", item.point);
        if (n < mesh.nodes.size() && mesh.nodes[n].locally_owned)
          add_nodal_force(
            mesh.nodes[n], item.force, 1, nodal_forces[item.force.factor]);
      }

    for (const EdgeForce &item : edge_forces)
      add_edge_force(mesh, item, nodal_forces[item.force.factor]);

    for (const SideMoment &moment : side_moments(edge_moments, false, mesh))
      {
        // a couple with constant directions, which is that of the undeformed
        // director
        MixedElement::NodalVector force;
        for (unsigned int v = 0; v < 2; ++v)
          {
            const unsigned int vertex = moment.vertices[v];
            Tensor<1, 3>       director;
            director[2] = moment.section.geometry.vertices[vertex].thickness;
            moment.add_couple(
              FollowerCouple(moment.moment, moment.axes[v], director).force,
              vertex,
              force);
          }
        mesh.add_nodal_forces(
          moment.section, force, nodal_forces[moment.factor]);
      }

    for (const auto face : {Resultants::inner, Resultants::outer})
      if (!tractions[face].components.empty())
        add_traction(
          mesh, face, tractions[face], nodal_forces[tractions[face].factor]);

    if (area_force.norm() > 0)
      {
        DeadForce weight;
        weight.components = area_force;
        add_area_force(mesh, weight, nodal_forces[factor_of_area_force]);
      }

    for (LA::Vector &forces : nodal_forces)
      forces.compress(VectorOperation::add);
    return nodal_forces;
  }
} // namespace Biface
