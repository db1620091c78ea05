// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<Edge>
    parse_end_plates(const std::string &entry, const std::string &text)
    {
      std::vector<Edge> edges;
      for (const std::string &name : split_list(entry, text))
        {
          const Edge edge = parse_edge(entry, text, name);
          if (edge != Edge::alpha_1_min && edge != Edge::alpha_1_max)
            throw InputError(entry,
                             text,
                             "the edges must be 'alpha_1 min' or 'alpha_1 "
                             "max'");
          if (std::find(edges.begin(), edges.end(), edge) != edges.end())
            throw InputError(entry, text, "an edge is named twice");
          edges.push_back(edge);
        }
      return edges;
    }
  } // namespace


  void
  PressureLoad::add_parameters(EntryDeclarations &prm)
  {
    // only how the pressure acts: its value belongs to the stages
    add_choice(
      prm,
      "Pressure type",
      kind,
      {"dead", "follower"},
      "The type of the pressure of the stages: 'dead' (it keeps its "
      "initial direction and acts on the undeformed area of the face, "
      "with 'Formulation = paper' of the middle surface) or 'follower' "
      "(true pressure on the deformed face; at an edge that is free to "
      "move the tangent is not symmetric).");
    add_choice(prm,
               "Pressure face",
               face,
               {"inner", "outer"},
               "The face on which the pressure of the stages acts. Positive "
               "pressure pushes the face toward the shell.");
    add_parsed(prm,
               "End plates",
               "",
               end_plates,
               parse_end_plates,
               "Edges of a surface of revolution, 'alpha_1 min' and 'alpha_1 "
               "max' separated by a comma, that a rigid plate closes. The "
               "pressure acts on the plate as well, which passes the force on "
               "to the edge: along the axis, that of the circle within the "
               "face under pressure. The support of the edge is that of the "
               "plate, and must hold its radius.");
    add_parsed(prm,
               "Pressure distribution",
               "1",
               distribution,
               parse_position_formula,
               "Factor of the pressure of the stages: a formula of the "
               "position x, y, z on the undeformed reference surface, and of "
               "alpha_1, alpha_2 as in 'Mesh'.",
               Unit::none());
  }


  std::vector<double>
  PressureLoad::values(const ShellMesh &mesh) const
  {
    std::vector<double> result;
    for (const auto &value : evaluate_at_nodes({distribution}, mesh))
      result.push_back(value[0]);
    return result;
  }


  double
  vertex_area(const Cell        &cell,
              const unsigned int vertex,
              const unsigned int face)
  {
    const double middle = cell.geometry.vertex_areas[vertex];
    return cell.geometry.formulation == Formulation::paper
             ? middle
             : middle / cell.geometry.vertices[vertex].metric.area_ratio(face);
  }


  LA::Vector
  PressureLoad::assemble_dead(const ShellMesh &mesh) const
  {
    const std::vector<double> p            = values(mesh);
    LA::Vector                nodal_forces = mesh.owned_vector();
    for (const Cell &cell : mesh.wall_elements())
      {
        std::array<double, 4> p_v;
        for (unsigned int v = 0; v < 4; ++v)
          p_v[v] = p[cell.nodes[v]];

        MixedElement::NodalVector force;
        // a true pressure on the undeformed face, integrated exactly as that on
        // the deformed one
        if (mesh.formulation != Formulation::paper)
          force = FollowerPressure(
                    cell.geometry, MixedElement::NodalVector(), face, p_v)
                    .force();
        else
          for (unsigned int v = 0; v < 4; ++v)
            {
              // e_3 points outward: a pressure on the inner face pushes along
              // it
              Tensor<1, 3> normal_force;
              normal_force[2] = (face == Resultants::inner ? 1 : -1) * p_v[v] *
                                vertex_area(cell, v, face);
              MixedElement::add_face_force(normal_force, v, face, force);
            }
        mesh.add_nodal_forces(cell, force, nodal_forces);
      }
    nodal_forces.compress(VectorOperation::add);
    return nodal_forces;
  }


  PressureForces::PressureForces(const ShellMesh    &mesh,
                                 const PressureLoad &pressure)
    : mesh(mesh)
    , kind(pressure.kind)
    , face(pressure.face)
    , distribution(pressure.values(mesh))
  {
    if (kind == PressureKind::dead)
      at_unit_pressure = pressure.assemble_dead(mesh);
  }


  FollowerPressure
  PressureForces::unit_pressure(const CellState &at) const
  {
    std::array<double, 4> pressure;
    for (unsigned int v = 0; v < 4; ++v)
      pressure[v] = distribution[at.cell.nodes[v]];
    return FollowerPressure(at.cell.geometry, at.V, face, pressure);
  }


  void
  PressureForces::add(const CellState &at, CellForces &forces) const
  {
    const FollowerPressure unit = unit_pressure(at);
    forces.load += at.loads.pressure * unit.force();
    if (forces.with_tangent)
      unit.add_derivative(-at.loads.pressure, forces.tangent);
  }


  void
  PressureForces::add_load_derivative(const CellState           &at,
                                      const LoadRates           &rates,
                                      MixedElement::NodalVector &force) const
  {
    force += rates.pressure * unit_pressure(at).force();
  }


  void
  PressureForces::add_dead_forces(const LoadRates &loads,
                                  LA::Vector      &nodal_forces) const
  {
    if (kind == PressureKind::dead)
      nodal_forces.add(loads.pressure, at_unit_pressure);
  }


  bool
  PressureForces::is_symmetric(const Loads &loads) const
  {
    // whether a pressure that follows the shell has a potential depends on its
    // edges
    return kind == PressureKind::dead || loads.pressure == 0;
  }
} // namespace Biface
