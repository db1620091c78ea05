// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <biface/input/entry_declarations.h>
#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/strip.h>
#include <biface/output/csv.h>
#include <biface/output/fiber_tension.h>
#include <biface/output/plies_file.h>
#include <biface/output/ply_results.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  void
  PliesFile::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Points per ply",
                      points_per_ply,
                      "Number of heights within each ply at which "
                      "plies-NNNN.csv lists strains and stresses at the "
                      "named points: 1 means the middle, 2 both sides, and "
                      "so on; 0: no such file.",
                      Patterns::Integer(0, 101));
  }


  PliesFile::PliesFile(const Parameters      &parameters,
                       const FailureCriteria &criteria,
                       ResultsDirectory      &directory,
                       const ShellEquations  &equations)
    : ResultFile("plies-*.csv", directory, equations)
    , parameters(parameters)
    , criteria(criteria)
  {}


  bool
  PliesFile::is_wanted() const
  {
    return !equations.mesh.points.empty() && parameters.points_per_ply > 0;
  }


  std::vector<std::string>
  PliesFile::warnings() const
  {
    return criteria.warnings(equations.mesh.get_layup());
  }


  namespace
  {
    /** The position of the i-th of n points in a ply, as a fraction of its
     * thickness. */
    double
    height_of(const unsigned int i, const unsigned int n)
    {
      return n == 1 ? 0.5 : static_cast<double>(i) / (n - 1);
    }
  } // namespace


  void
  PliesFile::write(const StepReport &report, const State &state)
  {
    const ShellMesh   &mesh      = equations.mesh;
    const auto        &all_plies = mesh.get_layup().get_plies();
    const unsigned int n_heights = parameters.points_per_ply;
    const auto         names     = ply_value_names(criteria, mesh.get_layup());

    // the number of plies, which may be parts, and their tension along the
    // fibers, then for each height: the number of cells, angle, height above
    // the reference surface, and the values
    const unsigned int n_columns = 3 + names.size();
    constexpr double   round_off = 1e-9;
    std::string text = "name,ply,material,fraction,angle,height,fiber_tension";
    for (const std::string &name : names)
      text += ',' + name;
    text += '\n';

    EquilibriumShear shear(equations, state);
    for (const NamedPoint &point : mesh.points)
      {
        const unsigned int  n = mesh.node_of_point("Named points", point.name);
        const unsigned int  n_of_ply = 2 + n_heights * n_columns;
        std::vector<double> sums(all_plies.size() * n_of_ply);
        for (const unsigned int c : mesh.layers)
          {
            const Cell &cell = mesh.cells[c];
            const auto  v = std::find(cell.nodes.begin(), cell.nodes.end(), n) -
                           cell.nodes.begin();
            if (v == 4)
              continue;
            const Laminate &laminate = *mesh.strips[cell.strip].at_vertices[v];
            const StrainsOfPlies E =
              equations.internal_forces().strains_at_vertices(state, c)[v];

            double height = laminate.face_heights()[0];
            for (unsigned int p = 0; p < laminate.get_plies().size(); ++p)
              {
                const Ply &ply = laminate.get_plies()[p];
                double    *sum = &sums[ply.number * n_of_ply];
                *sum++ += ply.end - ply.begin;
                *sum++ += fiber_tension(laminate, p, E);
                for (unsigned int i = 0; i < n_heights; ++i)
                  {
                    // the layer may contain a part of the ply
                    const double fraction =
                      (height_of(i, n_heights) - ply.begin) /
                      (ply.end - ply.begin);
                    if (!(fraction > -round_off && fraction < 1 + round_off))
                      {
                        sum += n_columns;
                        continue;
                      }
                    *sum++ += 1;
                    *sum++ += ply.angle * 180 / numbers::PI;
                    *sum++ += height + fraction * ply.thickness;
                    for (const double value :
                         ply_values(PlyState(laminate,
                                             p,
                                             fraction,
                                             E,
                                             shear.stress(c, v, p, fraction)),
                                    ply,
                                    criteria,
                                    mesh.get_layup()))
                      *sum++ += value;
                  }
                height += ply.thickness;
              }
          }
        // the cells around a point may belong to several ranks; strains jump
        // between cells, and the file has their means
        Utilities::MPI::sum(sums, communicator, sums);

        for (unsigned int p = 0; p < all_plies.size(); ++p)
          {
            const double *sum     = &sums[p * n_of_ply];
            const double  n_plies = *sum++;
            const double  tension = *sum++ / n_plies;
            for (unsigned int i = 0; n_plies > 0 && i < n_heights; ++i)
              {
                const double n_cells = *sum++;
                text += point.name + ',' + std::to_string(p + 1) + ',' +
                        all_plies[p].material.name + ',' +
                        csv_number(height_of(i, n_heights));
                for (unsigned int k = 1; k < n_columns; ++k, ++sum)
                  {
                    text +=
                      ',' + (std::isnan(*sum) ? std::string()
                                              : csv_number(*sum / n_cells));
                    if (k == 2)
                      text += ',' + csv_number(tension);
                  }
                text += '\n';
              }
          }
      }
    write_text(path(report.step), text, false, communicator);
  }
} // namespace Biface
