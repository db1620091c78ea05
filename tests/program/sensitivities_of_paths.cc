// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives are those of whole runs with a changed entry, by central
// differences, along every kind of path: where the foundation touches a shell
// that depends on the entry, with friction, linear strain theory, a force or a
// displacement that is controlled, a sealed gas, a prestress, and a stage that
// starts from an earlier one; of frequencies and buckling factors, too.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include <biface/program/design_variable.h>
#include <biface/stepping/sensitivity_table.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  SensitivityTable
  table_of(const std::string &file, const std::vector<Override> &overrides)
  {
    const auto reports = run_analysis(file, overrides);
    return *reports.back().sensitivities;
  }


  void
  check(const std::string           &title,
        const std::string           &file,
        const std::vector<Override> &overrides,
        const std::string           &entries,
        const std::string           &outputs,
        const double                 tolerance = 1e-4)
  {
    constexpr double step = 1e-4;

    std::vector<Override> all = overrides;
    all.emplace_back("Newton/Residual tolerance=1e-11");
    all.emplace_back("Sensitivities/Outputs=" + outputs);
    all.emplace_back("Sensitivities/Entries=" + entries);

    Parameters       parameters;
    ParameterHandler prm;
    read_parameters(file, all, MPI_COMM_WORLD, parameters, prm);
    const auto             variables = parse_design_variables("", entries);
    const SensitivityTable table     = table_of(file, all);

    double largest = 0;
    for (unsigned int e = 0; e < variables.size(); ++e)
      {
        const double value = variables[e].value(prm);
        const double size  = step * (value == 0 ? 1 : std::abs(value));
        std::array<SensitivityTable, 2> changed;
        for (unsigned int side = 0; side < 2; ++side)
          {
            std::vector<Override> with_change = all;
            for (const Override &setting :
                 settings({variables[e]},
                          {value + (side == 0 ? -size : size)},
                          prm,
                          "test"))
              with_change.push_back(setting);
            with_change.emplace_back("Sensitivities/Entries=" +
                                     parameters.sensitivities.entries);
            changed[side] = table_of(file, with_change);
          }
        for (unsigned int o = 0; o < table.outputs.size(); ++o)
          {
            const double expected =
              (changed[1].outputs[o].value - changed[0].outputs[o].value) /
              (2 * size);
            const double found = table.derivatives[e][o];
            // outputs that hardly depend on the entry are round-off
            const double scale =
              std::max(std::abs(expected),
                       1e-3 * std::abs(table.outputs[o].value / size * step));
            const double error = std::abs(found - expected) / scale;
            largest            = std::max(largest, error);
            if (!(error <= tolerance) &&
                Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
              std::cout << "FAILED: " << title << ", d "
                        << table.outputs[o].name << " / d "
                        << table.entries[e].name << " is " << found << ", not "
                        << expected << std::endl;
          }
      }
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << title << (largest <= tolerance ? "" : " deviates") << ": "
                << variables.size() << " entries, " << table.outputs.size()
                << " outputs" << std::endl;
  }
} // namespace


int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string           tire = PRM_DIR "/bias_tire.prm";
  const std::vector<Override> coarse{
    "Mesh/Intervals alpha_1=-120:120:14",
    "Mesh/Intervals alpha_2=-180:-20:4:smooth, -20:20:6, 20:180:4:smooth",
    "Contact/Multiplier mass=lumped",
    "Contact/Regularization=1e3",
    "Named points=side: 0 -180",
    "Stage 2/Steps=2"};
  const auto with = [&](const std::vector<Override> &more) {
    std::vector<Override> all = coarse;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::string entries =
    "p: Stage 1/Pressure, Stage 2/Pressure; Stage 2/Travel; Laminate/Plies[2]; "
    "Material cord/E_L; Surface/Circular arc/Radius";
  const std::string outputs =
    "force, footprint_area, max_pressure, loaded_radius, side u_x, "
    "strain_energy, max_fiber_tension, alpha_1 min F_x";

  check("touched", tire, with({"Stage 2/Travel=10"}), entries, outputs);
  check("linear",
        tire,
        with({"Stage 2/Strain theory=linear", "Stage 2/Travel=10"}),
        entries,
        "force, side u_x");
  check("friction",
        tire,
        with({"Contact/Friction=0.5",
              "Number of stages=3",
              "Stage 2/Travel=10",
              "Stage 3/Contact=true",
              "Stage 3/Slide=0,2,0",
              "Stage 3/Steps=2"}),
        "Contact/Friction; Stage 3/Slide[2]; " + entries,
        "force, foundation F_y, side u_y",
        3e-3);
  // the foundation penetrates by less than it moves with the entries
  check("stiff contact with friction",
        tire,
        with({"Contact/Regularization=1e4", "Stage 2/Friction=0.5"}),
        "Stage 2/Travel; angle: Laminate/Plies[2], -Laminate/Plies[4], "
        "Laminate/Plies[6], -Laminate/Plies[8]; Material cord/E_L",
        "force, footprint_area, max_pressure");
  check("force",
        tire,
        with({"Stage 2/Travel=unchanged",
              "Stage 2/Control=foundation force",
              "Stage 2/Force=500"}),
        "Stage 2/Force; Material cord/E_L; Laminate/Plies[2]",
        "approach, side u_x");
  check("branch",
        tire,
        with({"Number of stages=3",
              "Stage 3/Start from=1",
              "Stage 3/Pressure=0.2",
              "Stage 2/Travel=5"}),
        "Stage 1/Pressure; Stage 3/Pressure; Material cord/E_L",
        "side u_x, strain_energy");
  check("modes",
        tire,
        with({"Element/Strain sampling=means",
              "Material cord/Density=1.2e-9",
              "Stage 2/Travel=10",
              "Stage 2/Modes=3"}),
        "Stage 1/Pressure; Material cord/E_L; Material cord/Density; "
        "Laminate/Plies[2]; Surface/Circular arc/Radius",
        "frequency 1, frequency 2, frequency 3");
  // pairs of the same factor
  check("buckling",
        PRM_DIR "/laminated_cylinder.prm",
        {"Mesh/Intervals alpha_1=0:510:12",
         "Mesh/Intervals alpha_2=-180:180:24",
         "Stage 1/Buckling=0",
         "Stage 2/Load factor=0.04",
         "Stage 2/Critical points=ignore",
         "Stage 2/Steps=1",
         "Stage 2/Buckling=4"},
        "Material carbon/E_L; Material carbon/G_LT; Laminate/Plies[1]; "
        "radius: Surface/Straight line/Begin[1], Surface/Straight line/End[1]; "
        "Supports/alpha_1 max",
        "buckling factor 1, buckling factor 2, buckling factor 3, buckling "
        "factor 4");
  check("buckling after steps",
        tire,
        with({"Stage 1/Pressure=-0.001",
              "Stage 2/Pressure=0.1",
              "Stage 2/Travel=10",
              "Stage 2/Buckling=1"}),
        "Stage 1/Pressure; Stage 2/Pressure; Material cord/E_L; "
        "Laminate/Plies[2]; Surface/Circular arc/Radius",
        "buckling factor 1, side u_x");
  check("gas",
        DATA_DIR "/gas_tube.prm",
        {"Named points=middle: 25 0", "Mesh/Intervals alpha_1=0:25:2, 25:50:2"},
        "Gas/Ambient pressure; Stage 1/Pressure; Material wall/E; "
        "Supports/alpha_1 max; Surface/Straight line/Begin[1]",
        "pressure, volume, middle u_x");
  check("modes with gas",
        DATA_DIR "/gas_tube.prm",
        {"Material wall/Density=1e-9",
         "Supports/alpha_1 max=v_1 both = 5",
         "Stage 2/Modes=2"},
        "Gas/Ambient pressure; Stage 1/Pressure; Material wall/E; "
        "Supports/alpha_1 max",
        "frequency 1, frequency 2");
}
