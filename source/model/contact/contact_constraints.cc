// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <map>

#include <biface/contact/contact_laws.h>
#include <biface/contact/tangential_law.h>
#include <biface/model/contact/contact_constraints.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    types::global_cell_index
    number_on_all_ranks(const ContactPoints &points,
                        const ShellMesh     &mesh,
                        const unsigned int   point)
    {
      return points.at_nodes() ? mesh.nodes[point].number
                               : mesh.cells[point / points.per_cell()].number *
                                     points.per_cell() +
                                   point % points.per_cell();
    }
  } // namespace


  std::vector<ContactPoint>
  contact_points(const ContactInteraction &contact)
  {
    std::vector<ContactPoint> result;
    for (const auto &pair : contact.pairs)
      for (unsigned int i = 0; i < pair->points.size(); ++i)
        result.emplace_back(pair->number,
                            number_on_all_ranks(pair->points, contact.mesh, i));
    return result;
  }


  std::vector<ContactConstraint>
  contact_constraints(const ContactInteraction        &contact,
                      const State                     &state,
                      const Loads                     &loads,
                      const std::vector<ContactPoint> &points)
  {
    const ShellMesh &mesh = contact.mesh;

    std::map<ContactPoint, unsigned int> positions;
    for (unsigned int i = 0; i < points.size(); ++i)
      positions[points[i]] = i;

    // the part of a cell in the gradient of a point
    struct Gradient
    {
      const Cell               *cell = nullptr;
      MixedElement::NodalVector of_cell;
    };
    std::vector<Gradient>          gradients(points.size());
    std::vector<double>            clearances(points.size(), 0.);
    std::vector<ContactConstraint> result(points.size());
    for (ContactConstraint &point : result)
      point.forces = mesh.owned_vector();
    for (const auto &pair : contact.pairs)
      {
        if (!pair->body(loads))
          continue;
        const auto &on_cell = pair->points.on_cell();
        for (const Cell &cell : mesh.wall_elements())
          for (unsigned int i = 0; i < on_cell.size(); ++i)
            {
              const unsigned int n  = pair->points.number(cell, i);
              const auto         at = positions.find(
                {pair->number, number_on_all_ranks(pair->points, mesh, n)});
              if (at == positions.end())
                continue;
              const unsigned int        k     = at->second;
              const PointInContact      in    = pair->at_point(state, loads, n);
              const auto                areas = pair->points.areas(cell, i);
              MixedElement::NodalVector forces, gradient;
              for (unsigned int r = 0; r < 4; ++r)
                {
                  const double       sign = cell.sign_of_face(r, pair->face);
                  const Tensor<1, 3> normal =
                    mesh.nodes[cell.nodes[r]].surface.to_frame(
                      in.at_body.normal);
                  MixedElement::add_force(areas[r] * normal, r, sign, forces);
                  MixedElement::add_force(
                    on_cell[i].position[r] * normal, r, sign, gradient);
                }
              mesh.add_nodal_forces(cell, forces, result[k].forces);
              // a node is a point of all cells around
              if (pair->points.is_owned(n) && gradients[k].cell == nullptr)
                {
                  gradients[k]  = {&cell, gradient};
                  clearances[k] = in.at_body.clearance;
                }
            }
      }
    Utilities::MPI::sum(clearances, mesh.communicator, clearances);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        result[k].clearance = clearances[k];
        // a body that has been taken away exerts no forces
        const ContactPair &pair   = *contact.pairs[points[k].first];
        const PlacedBody  *placed = pair.body(loads);
        result[k].stiffness =
          (placed ? placed->laws : pair.laws()).condition().penalty_stiffness();
        LA::Vector gradient = mesh.owned_vector();
        if (gradients[k].cell != nullptr)
          mesh.add_nodal_forces(
            *gradients[k].cell, gradients[k].of_cell, gradient);
        for (LA::Vector *vector : {&result[k].forces, &gradient})
          {
            // without the part that supports take up
            vector->compress(VectorOperation::add);
            mesh.condense(*vector);
          }
        for (unsigned int i = 0; i < gradient.locally_owned_size(); ++i)
          if (const double value = gradient.begin()[i]; value != 0)
            result[k].gradient.emplace_back(i, value);
      }
    return result;
  }
} // namespace Biface
