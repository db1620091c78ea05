// SPDX-License-Identifier: LGPL-2.1-or-later

// In linear theory loads of all kinds superpose, each with its own factor, in a
// stage and in the next one, which is linearized about another state, and the
// work that they do is the strain energy.

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <biface/model/forces/internal_forces.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  const std::string plate = R"(
subsection Surface
  set Type = plane
end
subsection Mesh
  set Intervals alpha_1  = 0:10:8
  set Intervals alpha_2  = 0:4:3
  set Closed in alpha_2  = false
end
set Materials = plate
subsection Material plate
  set Type = isotropic
  set E    = 1e5
  set nu   = 0
end
subsection Laminate
  set Plies             = plate: 0.2 @ 0
  set Reference surface = middle
end
set Named points = the tip: 10 4
subsection Supports
  set alpha_1 min    = v_1 both; v_2 both; v_3 both = 0.003
  set Point supports = the tip: v_2 middle = 0.01
end
subsection Loads
  set Point forces   = the tip: 0 0 1, the tip: 1 0 0
  set Edge forces    = alpha_1 max: 0 0 2, alpha_2 max: 0 1 1 outer
  set Edge moments   = alpha_1 max: 3 dead, alpha_2 max: 2 dead
  set Inner traction = 0; 0.1; 0.01
  set Outer traction = 0; 0; x/100
  set Area force     = 0, 0, -0.02
end
set Number of stages = 2
subsection Stage 1
  set Strain theory = linear
  set Steps         = 2
end
subsection Stage 2
  set Strain theory = linear
end
)";

  using Numbers = std::vector<double>;

  /** The displacements at the ends of both stages. */
  std::vector<Numbers>
  displacements(const std::string &first, const std::string &second)
  {
    std::vector<Numbers> at_ends(2);
    run_analysis(
      "plate.prm",
      {"Stage 1/Load factors=" + first,
       "Stage 2/Load factors=" + second,
       "Newton/Residual tolerance=1e-12"},
      [&](const ShellEquations &equations,
          const StepReport     &report,
          const State          &state) {
        Numbers &end = at_ends[report.instant.stage];
        end.clear();
        for (const auto dof : equations.mesh.locally_owned)
          end.push_back(state.displacement(dof));
        const double energy = equations.internal_forces().strain_energy(state);
        // a support alone moves the plate as a whole, without energy
        if (report.step == 2 && first.rfind("supports alpha_1", 0) != 0)
          check_small("work of " + first, report.work.loads / energy - 1, 1e-7);
      });
    return at_ends;
  }


  double
  norm(const Numbers &numbers)
  {
    double square = 0;
    for (const double x : numbers)
      square += x * x;
    return std::sqrt(square);
  }


  void
  add_multiple(Numbers &sum, const double factor, const Numbers &numbers)
  {
    sum.resize(numbers.size());
    for (unsigned int i = 0; i < numbers.size(); ++i)
      sum[i] += factor * numbers[i];
  }


  std::string
  item(const std::string &name, const double factor)
  {
    return name + ": " + std::to_string(factor);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream("plate.prm") << plate;

  const std::vector<std::pair<std::string, double>> loads{
    {"point forces the tip 1", 0.1},
    {"point forces the tip 2", 0.2},
    {"edge forces alpha_1 max", -0.3},
    {"edge forces alpha_2 max 1", 0.4},
    {"edge moments alpha_1 max", 0.5},
    {"edge moments alpha_2 max", 0.6},
    {"inner traction", -0.7},
    {"outer traction", 0.8},
    {"area force", 0.9},
    {"supports alpha_1 min v_3", 1.5},
    {"supports the tip", -2}};

  // in the first stage each alone, in the second one after the same first
  std::string          all, next;
  std::vector<Numbers> units;
  Numbers              sum;
  for (const auto &[name, factor] : loads)
    {
      all += (all.empty() ? "" : ", ") + item(name, factor);
      units.push_back(displacements(item(name, 1), "")[0]);
      if (!(norm(units.back()) > 0))
        std::cout << "FAILED, no displacements by " << name << std::endl;
      add_multiple(sum, factor, units.back());
    }
  const std::vector<Numbers> together = displacements(all, "");
  Numbers                    deviation(sum);
  add_multiple(deviation, -1, together[0]);
  check_small("first stage", norm(deviation), 1e-9, norm(sum));

  Numbers increments;
  for (const auto &[name, factor] : loads)
    {
      next += (next.empty() ? "" : ", ") + item(name, 2 * factor + 0.1);
      add_multiple(
        increments, 1, displacements(all, item(name, 2 * factor + 0.1))[1]);
      add_multiple(increments, -1, together[1]);
    }
  const std::vector<Numbers> after = displacements(all, next);
  deviation                        = increments;
  add_multiple(deviation, -1, after[1]);
  add_multiple(deviation, 1, together[1]);
  check_small("second stage", norm(deviation), 1e-9, norm(increments));

  // names that include others
  Numbers nested = units[0];
  add_multiple(nested, 0.25, units[1]);
  add_multiple(
    nested,
    -1,
    displacements("point forces: 1, point forces the tip 2: 0.25", "")[0]);
  check_small("nested names", norm(nested), 1e-9, norm(units[0]));
  Numbers displaced = units[9];
  add_multiple(displaced, 0.25, units[10]);
  add_multiple(
    displaced, -1, displacements("supports the tip: 0.25, supports: 1", "")[0]);
  check_small("nested supports", norm(displaced), 1e-9, norm(units[9]));

  // the deflection P L^3/(3 E I) of a cantilever, with 0.7 P
  double deflection = 0;
  run_analysis(
    "plate.prm",
    {"Supports/alpha_1 min=fixed",
     "Supports/Point supports=",
     "Number of stages=1",
     "Stage 1/Load factors=edge forces alpha_1 max: 0.7"},
    [&](
      const ShellEquations &equations, const StepReport &, const State &state) {
      const ShellMesh &mesh = equations.mesh;
      deflection            = mesh.displacement(state.displacement,
                                     mesh.nodes[mesh.nodes_of_points[0]],
                                     Resultants::outer)[2];
    });
  check_small("deflection of a cantilever",
              deflection / (0.7 * 2 * 1000 / (3 * 1e5 * 0.008 / 12)) - 1,
              0.01);
}
