// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <functional>

#include <biface/laminate/layup.h>
#include <biface/laminate/material.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/cell_maximum.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/failure_maxima.h>
#include <biface/output/ply_results.h>
#include <biface/output/requested_criteria.h>
#include <biface/output/result_file.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Call a function with each corner of a cell, ply with strengths, and
     * stress in the axes of the ply at one of its sides. */
    void
    for_stresses_of_cell(
      const ShellEquations                                           &equations,
      const State                                                    &state,
      const unsigned int                                              c,
      const std::function<void(const unsigned int vertex,
                               const PlyDescription &,
                               const unsigned int           ply_number,
                               const SymmetricTensor<2, 3> &stress)> &function)
    {
      const ShellMesh &mesh = equations.mesh;
      const auto E = equations.internal_forces().strains_at_vertices(state, c);
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Laminate &laminate =
            *mesh.strips[mesh.cells[c].strip].at_vertices[v];
          for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
            {
              const Ply            &ply = laminate.get_plies()[p];
              const PlyDescription &description =
                mesh.get_layup().get_plies()[ply.number];
              if (description.material.strengths)
                // strains are linear across a ply: one of its sides has the
                // most
                for (unsigned int side = 0; side < 2; ++side)
                  function(
                    v,
                    description,
                    ply.number,
                    PlyState(laminate, p, side, E[v], {}).failure_stress(ply));
            }
        }
    }
  } // namespace


  std::vector<FailureMaximum>
  find_failure_maxima(const ShellEquations  &equations,
                      const State           &state,
                      const FailureCriteria &failure_criteria)
  {
    const ShellMesh                    &mesh     = equations.mesh;
    const std::vector<FailureCriterion> criteria = failure_criteria.requested();
    if (criteria.empty())
      return {};

    // first the maximum of each cell, of which all ranks find the largest; its
    // place only where the cell is
    std::vector<std::vector<double>> of_cells(
      criteria.size(),
      std::vector<double>(mesh.cells.size(), CellMaximum::none));
    for (const unsigned int c : mesh.layers)
      for_stresses_of_cell(
        equations,
        state,
        c,
        [&](const unsigned int,
            const PlyDescription &ply,
            const unsigned int,
            const SymmetricTensor<2, 3> &stress) {
          for (unsigned int i = 0; i < criteria.size(); ++i)
            of_cells[i][c] =
              std::max(of_cells[i][c],
                       criteria[i].index(stress, *ply.material.strengths));
        });

    std::vector<FailureMaximum> maxima(criteria.size());
    for (unsigned int i = 0; i < criteria.size(); ++i)
      {
        FailureMaximum &maximum = maxima[i];
        maximum.name            = criteria[i].name;
        const auto largest      = find_cell_maximum(mesh, of_cells[i]);
        if (!largest)
          continue;
        maximum.index = largest->value;

        // place and ply, of the rank that owns the cell
        std::vector<double> place(3);
        if (largest->position)
          for_stresses_of_cell(
            equations,
            state,
            *largest->position,
            [&](const unsigned int           v,
                const PlyDescription        &ply,
                const unsigned int           number,
                const SymmetricTensor<2, 3> &stress) {
              // the first place of those that differ by round-off
              if (place[2] != 0 ||
                  criteria[i].index(stress, *ply.material.strengths) <
                    largest->bound())
                return;
              const Node &node =
                mesh.nodes[mesh.cells[*largest->position].nodes[v]];
              place = {chart_coordinate(mesh.get_surface(), node, 0),
                       chart_coordinate(mesh.get_surface(), node, 1),
                       number + 1.};
            });
        Utilities::MPI::sum(place, mesh.communicator, place);
        maximum.alpha = {{place[0], place[1]}};
        maximum.ply   = static_cast<unsigned int>(place[2]);
      }
    return maxima;
  }
} // namespace Biface
