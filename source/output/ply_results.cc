// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <limits>

#include <biface/laminate/failure_criteria.h>
#include <biface/laminate/material.h>
#include <biface/output/ply_results.h>

namespace Biface
{
  using namespace dealii;

  PlyState::PlyState(const Laminate           &laminate,
                     const unsigned int        ply,
                     const double              fraction,
                     const Resultants::Vector &E)
  {
    const std::vector<Ply> &plies = laminate.get_plies();
    double                  z     = fraction * plies[ply].thickness;
    for (unsigned int p = 0; p < ply; ++p)
      z += plies[p].thickness;
    strain = laminate.strain(E, ply, z);
    stress = laminate.stress(E, ply, z) +
             rotate_about_normal(plies[ply].initial_stress, plies[ply].angle);
  }


  std::vector<std::string>
  ply_value_names(const FailureCriteria &criteria)
  {
    std::vector<std::string> names{
      "e_11", "e_22", "e_33", "g_23", "g_13", "g_12", "s_11", "s_22",
      "s_33", "t_23", "t_13", "t_12", "e_L",  "e_T",  "e_N",  "g_TN",
      "g_LN", "g_LT", "s_L",  "s_T",  "s_N",  "t_TN", "t_LN", "t_LT"};
    if (criteria.maximum_stress)
      names.push_back("maximum_stress_index");
    if (criteria.tsai_wu)
      names.push_back("tsai_wu_index");
    return names;
  }


  std::vector<double>
  ply_values(const PlyState        &state,
             const double           angle,
             const PlyDescription  &ply,
             const FailureCriteria &criteria)
  {
    std::vector<double> values;
    const auto          append = [&](const SymmetricTensor<2, 3> &tensor,
                            const double                 shear_factor) {
      for (unsigned int i = 0; i < 3; ++i)
        values.push_back(tensor[i][i]);
      values.push_back(shear_factor * tensor[1][2]);
      values.push_back(shear_factor * tensor[0][2]);
      values.push_back(shear_factor * tensor[0][1]);
    };
    const SymmetricTensor<2, 3> stress =
      rotate_about_normal(state.stress, -angle);
    append(state.strain, 2);
    append(state.stress, 1);
    append(rotate_about_normal(state.strain, -angle), 2);
    append(stress, 1);

    const double none = std::numeric_limits<double>::quiet_NaN();
    if (criteria.maximum_stress)
      values.push_back(
        ply.strengths ? maximum_stress_index(stress, *ply.strengths) : none);
    if (criteria.tsai_wu)
      values.push_back(ply.strengths ? tsai_wu_index(stress, *ply.strengths)
                                     : none);
    return values;
  }


  namespace
  {
    /**
     * The direction of the fibers in the deformed shell, as data 3 to 5 of a
     * patch with its vertices and the displacements in data 0 to 2: each
     * coordinate line carries its component along.
     */
    void
    set_fibers(const double angle, DataOutBase::Patch<3, 3> &patch)
    {
      for (unsigned int i = 0; i < 8; ++i)
        {
          Tensor<1, 3> fiber;
          for (unsigned int line = 0; line < 2; ++line)
            {
              const unsigned int begin = i & ~(1u << line);
              const unsigned int end   = i | (1u << line);
              const Tensor<1, 3> edge =
                patch.vertices[end] - patch.vertices[begin];
              Tensor<1, 3> initial_edge = edge;
              for (unsigned int d = 0; d < 3; ++d)
                initial_edge[d] -= patch.data(d, end) - patch.data(d, begin);
              fiber += (line == 0 ? std::cos(angle) : std::sin(angle)) /
                       initial_edge.norm() * edge;
            }
          fiber /= fiber.norm();
          for (unsigned int d = 0; d < 3; ++d)
            patch.data(3 + d, i) = fiber[d];
        }
    }
  } // namespace


  PlyPatches::PlyPatches(const ShellEquations  &equations,
                         const State           &state,
                         const FailureCriteria &criteria)
    : names({"displacement",
             "displacement",
             "displacement",
             "fiber",
             "fiber",
             "fiber",
             "ply"})
  {
    const std::vector<std::string> value_names = ply_value_names(criteria);
    names.insert(names.end(), value_names.begin(), value_names.end());

    const ShellMesh &mesh = equations.mesh;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell  &cell  = mesh.cells[c];
        const Strip &strip = mesh.strips[cell.strip];
        const auto   E = Modes::at_vertices(equations.total_strains(state, c));

        // at each vertex, how far up the ply at hand begins
        std::array<double, 4> height{};
        for (unsigned int p = 0; p < strip.laminate.get_plies().size(); ++p)
          {
            DataOutBase::Patch<3, 3> patch;
            patch.patch_index    = patches.size();
            patch.n_subdivisions = 1;
            patch.reference_cell = ReferenceCells::Hexahedron;
            patch.data.reinit(names.size(), 8);
            for (unsigned int v = 0; v < 4; ++v)
              {
                const Node     &node     = mesh.nodes[cell.nodes[v]];
                const Laminate &laminate = strip.at_lines[v & 1];
                const Ply      &ply      = laminate.get_plies()[p];

                std::array<Point<3>, 2>     x;
                std::array<Tensor<1, 3>, 2> u;
                for (unsigned int face = 0; face < 2; ++face)
                  {
                    x[face] =
                      mesh.deformed_position(state.displacement, node, face);
                    u[face] = node.surface.from_frame(
                      mesh.displacement(state.displacement, node, face));
                  }
                for (unsigned int side = 0; side < 2; ++side)
                  {
                    const unsigned int i = v + 4 * side;
                    const double       z =
                      (height[v] + side * ply.thickness) / laminate.thickness();
                    patch.vertices[i] = x[0] + z * (x[1] - x[0]);

                    const Tensor<1, 3> u_z = u[0] + z * (u[1] - u[0]);
                    for (unsigned int d = 0; d < 3; ++d)
                      patch.data(d, i) = u_z[d];
                    unsigned int d     = 6; // see set_fibers()
                    patch.data(d++, i) = ply.number + 1;
                    for (const double value :
                         ply_values(PlyState(laminate, p, side, E[v]),
                                    ply.angle,
                                    mesh.layup.get_plies()[ply.number],
                                    criteria))
                      patch.data(d++, i) = value;
                  }
                height[v] += ply.thickness;
              }
            set_fibers(strip.laminate.get_plies()[p].angle, patch);
            patches.push_back(patch);
          }
      }
  }


  const std::vector<DataOutBase::Patch<3, 3>> &
  PlyPatches::get_patches() const
  {
    return patches;
  }


  std::vector<std::string>
  PlyPatches::get_dataset_names() const
  {
    return names;
  }


  std::vector<
    std::tuple<unsigned int,
               unsigned int,
               std::string,
               DataComponentInterpretation::DataComponentInterpretation>>
  PlyPatches::get_nonscalar_data_ranges() const
  {
    const auto vector =
      DataComponentInterpretation::component_is_part_of_vector;
    return {std::make_tuple(0, 2, std::string("displacement"), vector),
            std::make_tuple(3, 5, std::string("fiber"), vector)};
  }
} // namespace Biface
