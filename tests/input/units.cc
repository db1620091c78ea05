// SPDX-License-Identifier: LGPL-2.1-or-later

// Four shipped examples, with friction, with a rolling wheel, on a drum with a
// sealed gas, and on a cleat, give the same results in m, N, Pa and kg as in
// mm, N, MPa and tonnes, with all entries at their defaults that do not
// describe the example. What is converted follows from the declared units of
// the entries.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/model/state/loads.h>
#include <biface/problem/design_variable.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/step_report.h>

#include <run_analysis.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  // factors from mm, N, MPa and t to m, N, Pa and kg
  constexpr double length = 1e-3, pressure = 1e6, mass = 1e3;

  /** The factor of the numbers of an entry. */
  double
  factor_of(const Unit &unit)
  {
    // remarks follow a comma; the coordinates of tires are angles
    const std::string name =
      unit.get_name().substr(0, unit.get_name().find(','));
    if (!unit.is_common() || name.rfind("degrees", 0) == 0)
      return 1;
    const double area = length * length, volume = area * length;
    return Formula("unit",
                   name,
                   {"length",
                    "area",
                    "volume",
                    "force",
                    "mass",
                    "pressure",
                    "stress",
                    "power",
                    "temperature",
                    "time",
                    "radians"})(
      {length, area, volume, 1, mass, pressure, pressure, length, 1, 1, 1});
  }


  /** All numbers in the value of an entry, in the form of
   * 'Sensitivities/Entries'. */
  std::string
  numbers_in(const std::string &entry, const DeclaredEntries &declared)
  {
    std::string numbers;
    for (unsigned int i = 1;; ++i)
      {
        const std::string number = entry + "[" + std::to_string(i) + "]";
        try
          {
            DesignVariable("", number).check(declared);
          }
        catch (const InputError &)
          {
            return numbers;
          }
        numbers += (numbers.empty() ? "" : ", ") + number;
      }
  }


  /** The settings of an example with all numbers in m, N, Pa and kg. */
  std::vector<Override>
  converted(const std::string &file, const std::vector<Override> &overrides)
  {
    Parameters       parameters;
    ParameterHandler prm;
    read_parameters(file, overrides, MPI_COMM_WORLD, parameters, prm);
    const DeclaredEntries declared(prm);
    // thicknesses and angles
    std::string         variables = "plies: factor of Laminate/Plies[1], "
                                    "Laminate/Plies[3], Laminate/Plies[5], "
                                    "Laminate/Plies[7]";
    std::vector<double> factors{length};
    for (const auto &[entry, attributes] : parameters.attributes)
      {
        const double      factor  = factor_of(attributes.get_unit());
        const std::string numbers = numbers_in(entry, declared);
        if (factor == 1 || numbers.empty())
          continue;
        variables += "; " + entry + ": factor of " + numbers;
        factors.push_back(factor);
      }
    std::vector<Override> result = overrides;
    for (const Override &setting : settings(
           parse_design_variables("", variables), factors, declared, "test"))
      result.push_back(setting);
    return result;
  }


  /** The results of a step in mm, N and MPa. */
  std::vector<double>
  results_of(const StepReport &report,
             const double      length,
             const double      pressure)
  {
    const double        energy = length;
    std::vector<double> numbers{report.loads->pressure / pressure,
                                report.contact.force,
                                report.contact.area / (length * length),
                                report.contact.max_pressure / pressure,
                                report.footprint.length / length,
                                report.footprint.width / length,
                                report.work.loads / energy,
                                report.work.friction / energy};
    if (report.rolling)
      for (const double number : {report.rolling->force[0],
                                  report.rolling->force[1],
                                  report.rolling->force[2],
                                  report.rolling->moment[2] / energy,
                                  report.rolling->rolling_resistance,
                                  report.rolling->rolling_radius / length})
        numbers.push_back(number);
    return numbers;
  }


  void
  compare(const std::string &name, const std::vector<Override> &changes)
  {
    const std::string     file = PRM_DIR "/" + name;
    std::vector<Override> overrides{
      "Mesh/Intervals alpha_1=-120:120:10",
      "Mesh/Intervals alpha_2=-180:-30:3, -30:30:8, 30:180:3",
      "Contact/Multiplier mass=lumped",
      "Contact/Regularization=automatic",
      "Contact/Tangential regularization=automatic",
      "Material cord/Density=1.2e-9",
      "Newton/Residual tolerance=1e-10"};
    overrides.insert(overrides.end(), changes.begin(), changes.end());

    const auto in_mm      = run_analysis(file, overrides);
    const auto in_m       = run_analysis(file, converted(file, overrides));
    double     difference = in_m.size() == in_mm.size() ? 0. : 1.;
    for (unsigned int s = 0; s < std::min(in_m.size(), in_mm.size()); ++s)
      {
        const auto expected = results_of(in_mm[s], 1, 1);
        const auto found    = results_of(in_m[s], length, pressure);
        for (unsigned int i = 0; i < expected.size(); ++i)
          // forces across the symmetry of the tire are round-off of others
          difference = std::max(difference,
                                std::abs(found[i] - expected[i]) /
                                  std::max(std::abs(expected[i]), 1e-3));
      }
    check_small(
      name + ", " + std::to_string(in_mm.size()) + " steps", difference, 1e-6);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  compare("tire_on_rough_ground.prm",
          {"Stage 2/Steps=2",
           "Stage 3/Steps=2",
           "Stage 4/Steps=1",
           "Stage 5/Steps=1"});
  compare("rolling_tire.prm",
          {"Contact/Rolling friction=slip velocity",
           "Contact/Critical velocity=500",
           "Contact/Tread/Height=none",
           "Contact/Tread/Modulus=0",
           "Stage 2/Steps=1",
           "Stage 3/Steps=2",
           "Stage 4/Slip angle=-1",
           "Stage 4/Steps=1",
           "Stage 5/Slip angle=1",
           "Stage 5/Steps=1",
           "Stage 6/Angular velocity=41.5",
           "Stage 6/Steps=1",
           "Stage 7/Angular velocity=41",
           "Stage 7/Steps=1"});
  compare("tire_on_drum.prm",
          {"Stage 2/Steps=2",
           "Stage 2/Pressure=unchanged",
           "Stage 2/Gas=sealed",
           "Gas/Ambient pressure=0.101325"});
  compare("cleat.prm",
          {"Mesh/Intervals alpha_1=-120:-45:4, -45:45:8, 45:120:4",
           "Mesh/Intervals alpha_2=-180:-27.5:5:smooth, -27.5:27.5:12, "
           "27.5:180:5:smooth",
           "Contact/Regularization=automatic",
           "Body cleat/Radius=16",
           "Stage 2/Steps=2",
           "Stage 3/Steps=6",
           "Stage 3/Load factors=bodies: 0.3"});
  return 0;
}
