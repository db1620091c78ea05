// SPDX-License-Identifier: LGPL-2.1-or-later

#include <array>
#include <cmath>

#include <biface/input/entry_declarations.h>
#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/plies_vtu.h>
#include <biface/output/ply_results.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    patch_data_names(const FailureCriteria &criteria, const Layup &layup)
    {
      std::vector<std::string>       names{"displacement",
                                     "displacement",
                                     "displacement",
                                     "fiber",
                                     "fiber",
                                     "fiber",
                                     "ply"};
      const std::vector<std::string> values = ply_value_names(criteria, layup);
      names.insert(names.end(), values.begin(), values.end());
      if (layup.has_loss())
        names.insert(names.end(), {"heat_source", "temperature"});
      return names;
    }


    /** The parts along two sides of a cell, as multiples of them, that make up
     * a vector in their plane. */
    std::array<double, 2>
    parts_along(const std::array<Tensor<1, 3>, 2> &sides,
                const Tensor<1, 3>                &vector)
    {
      const double a = sides[0].norm_square(), b = sides[0] * sides[1],
                   c           = sides[1].norm_square();
      const double determinant = a * c - b * b;
      const double x = sides[0] * vector, y = sides[1] * vector;
      return {{(c * x - b * y) / determinant, (a * y - b * x) / determinant}};
    }


    /**
     * The direction of the fibers in the deformed shell, as data 3 to 5 of a
     * patch with its vertices and the displacements in data 0 to 2: it follows
     * the sides of the cell, which are coordinate lines unless it has another
     * shape.
     */
    void
    set_fibers(const double              angle,
               const Cell               &cell,
               const std::vector<Node>  &nodes,
               DataOutBase::Patch<3, 3> &patch)
    {
      for (unsigned int i = 0; i < 8; ++i)
        {
          std::array<Tensor<1, 3>, 2> sides, initial;
          for (unsigned int line = 0; line < 2; ++line)
            {
              const unsigned int begin = i & ~(1u << line);
              const unsigned int end   = i | (1u << line);
              sides[line]   = patch.vertices[end] - patch.vertices[begin];
              initial[line] = sides[line];
              for (unsigned int d = 0; d < 3; ++d)
                initial[line][d] -= patch.data(d, end) - patch.data(d, begin);
            }
          const auto           &frame = nodes[cell.nodes[i & 3]].surface.frame;
          std::array<double, 2> parts =
            cell.geometry.along_lines
              ? std::array<double, 2>{{std::cos(angle) / initial[0].norm(),
                                       std::sin(angle) / initial[1].norm()}}
              : parts_along(initial,
                            std::cos(angle) * frame[0] +
                              std::sin(angle) * frame[1]);
          // the sides carry a fiber along: its parts stay those at rest
          Tensor<1, 3> fiber = parts[0] * sides[0] + parts[1] * sides[1];
          fiber /= fiber.norm();
          for (unsigned int d = 0; d < 3; ++d)
            patch.data(3 + d, i) = fiber[d];
        }
    }
  } // namespace


  PlyPatches::PlyPatches(const ShellEquations  &equations,
                         const State           &state,
                         const FailureCriteria &criteria,
                         const HeatOfPlies     *heat,
                         const double           temperature)
    : VertexPatches<3>(patch_data_names(criteria, equations.mesh.get_layup()))
  {
    const ShellMesh &mesh = equations.mesh;
    EquilibriumShear shear(equations, state);
    for (const unsigned int c : mesh.layers)
      {
        const Cell  &cell  = mesh.cells[c];
        const Strip &strip = mesh.strips[cell.strip];
        const auto   E =
          equations.internal_forces().strains_at_vertices(state, c);

        // at each vertex, the height of the inner side of the ply
        std::array<double, 4> height{};
        for (unsigned int p = 0; p < strip.laminate.get_plies().size(); ++p)
          {
            Patch patch = new_patch();
            for (unsigned int v = 0; v < 4; ++v)
              {
                const Node     &node     = mesh.nodes[cell.nodes[v]];
                const Laminate &laminate = *strip.at_vertices[v];
                const Ply      &ply      = laminate.get_plies()[p];

                std::array<Point<3>, 2>     x;
                std::array<Tensor<1, 3>, 2> u;
                for (unsigned int face = 0; face < 2; ++face)
                  {
                    x[face] = mesh.position_of_any_face(
                      state.displacement, node, cell.layer + face);
                    u[face] =
                      node.surface.from_frame(mesh.displacement_of_any_face(
                        state.displacement, node, cell.layer + face));
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
                         ply_values(PlyState(laminate,
                                             p,
                                             side,
                                             E[v],
                                             shear.stress(c, v, p, side)),
                                    ply,
                                    criteria,
                                    mesh.get_layup()))
                      patch.data(d++, i) = value;
                    if (mesh.get_layup().has_loss())
                      {
                        const unsigned int s =
                          heat ? mesh.grid.cell_index(cell.column)[0] : 0;
                        patch.data(d++, i) =
                          heat ? heat->source(s, ply.number) : 0.;
                        patch.data(d++, i) =
                          heat && !heat->temperature.empty()
                            ? heat->temperature(s, ply.number)
                            : temperature;
                      }
                  }
                height[v] += ply.thickness;
              }
            set_fibers(
              strip.laminate.get_plies()[p].angle, cell, mesh.nodes, patch);
            patches.push_back(patch);
          }
      }
  }


  void
  PliesVtu::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Write ply VTU",
                      write,
                      "Whether to write each ply as a layer of hexahedra for "
                      "ParaView, with strains and stresses.",
                      Patterns::Bool());
  }


  PliesVtu::PliesVtu(const Parameters      &parameters,
                     const FailureCriteria &criteria,
                     ResultsDirectory      &directory,
                     const ShellEquations  &equations)
    : VtuSeries("plies", parameters.write, directory, equations)
    , criteria(criteria)
  {}


  std::vector<std::string>
  PliesVtu::warnings() const
  {
    return criteria.warnings(equations.mesh.get_layup());
  }


  void
  PliesVtu::write(const StepReport &report, const State &state)
  {
    write_patches<3>(
      std::make_unique<PlyPatches>(equations,
                                   state,
                                   criteria,
                                   report.heat ? &*report.heat : nullptr,
                                   report.level.temperature),
      report.step);
  }
} // namespace Biface
