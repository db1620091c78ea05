// SPDX-License-Identifier: LGPL-2.1-or-later

// The force of a support that moves is that of the whole structure, conjugate
// to its displacement: a tube, its twelfth between cyclic edges and its half
// between planes of symmetry carry E A u/L with the stiffness E A/L; an end
// that tilts is held by the moment of forces.csv; and ends that are widened do
// the work of the sector times their number.

#include <cmath>

#include "../read_csv.h"
#include "../restart.h"
#include "tube.h"

using namespace dealii;

namespace
{
  constexpr double E = 1000, R = 100, L = 60, h = 2, n_sectors = 12;
  const double     area = 2 * numbers::PI * R * h;


  std::string
  setting(const std::string &entry, const std::string &value)
  {
    return "--set\n" + entry + "=" + value + "\n";
  }


  /** Run the tube with further options, one in each line.
   * @return the lines of a table. */
  std::vector<Row>
  table_of(const std::string &options, const std::string &table)
  {
    std::vector<std::string> words{"tube.prm"};
    std::istringstream       lines(options);
    for (std::string line; std::getline(lines, line);)
      words.push_back(line);
    const Ended ended = run(words, "results", MPI_COMM_WORLD);
    if (ended.code != 0)
      std::cout << ended.err;
    MPI_Barrier(MPI_COMM_WORLD);
    return read_csv("results/" + table);
  }


  double
  number(const Row &row, const std::string &column)
  {
    return std::stod(row.at(column));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (is_root)
    std::ofstream("tube.prm") << tube("0");
  else
    std::cout.setstate(std::ios::failbit);
  MPI_Barrier(MPI_COMM_WORLD);

  const std::string pushed =
    setting("Supports/alpha_1 min", "axial both; circumferential both") +
    setting("Stage 1/Load factor", "0.1") + setting("Stage 1/Steps", "2") +
    setting("Stage 1/Strain theory", "linear");
  const std::string axial =
    pushed + setting("Supports/alpha_1 max", "v_1 both = -0.5");
  const auto mesh = [](const std::string &cells, const std::string &sides) {
    return setting("Mesh/Intervals alpha_1", "0:60:2") +
           setting("Mesh/Intervals alpha_2", cells) +
           (sides.empty() ? ""
                          : setting("Mesh/Closed in alpha_2", "false") +
                              setting("Supports/alpha_2 min", sides) +
                              setting("Supports/alpha_2 max", sides));
  };
  const std::string whole = mesh("-180:180:12", "");

  const auto full = table_of(whole + axial, "history.csv");
  const auto last = full.back();
  check_small(
    "displacement", number(last, "alpha_1_max_displacement") - 0.05, 1e-11);
  check_small("force E A u/L",
              number(last, "alpha_1_max_force") / (E * area * 0.05 / L) - 1,
              1e-9);
  for (const auto &[name, model] :
       {std::make_pair("a twelfth", mesh("0:30:1", "cyclic")),
        std::make_pair("half", mesh("0:180:6", "symmetry"))})
    check_small(name,
                number(table_of(model + axial, "history.csv").back(),
                       "alpha_1_max_force") /
                    number(last, "alpha_1_max_force") -
                  1,
                1e-9);

  const std::string wanted =
    setting("Sensitivities/Entries", "Material wall/E") +
    setting("Sensitivities/Outputs",
            "alpha_1 max tangent, alpha_1 max secant, alpha_1_max_force");
  for (const Row &row :
       table_of(mesh("0:30:1", "cyclic") + axial + wanted, "sensitivities.csv"))
    {
      const std::string output = row.at("output");
      if (output.find("force") == std::string::npos)
        check_small(output + " E A/L",
                    number(row, "output_value") / (E * area / L) - 1,
                    1e-9);
      check_small("derivative of " + output + " by E",
                  number(row, "logarithmic_derivative") - 1,
                  1e-6);
    }

  // nothing else holds the end, so that its moment is that about its axis
  const std::string tilt =
    whole + pushed + setting("Supports/alpha_1 max", "axial both = -0.01*x");
  const Row tilted = table_of(tilt, "history.csv").back();
  check_small("angle",
              number(tilted, "alpha_1_max_angle") - 0.001 * 180 / numbers::PI,
              1e-11);
  for (const Row &row : table_of(tilt, "forces.csv"))
    if (row.at("step") == "2" && row.at("body") == "alpha_1 max")
      check_small("moment",
                  number(row, "M_z") / number(tilted, "alpha_1_max_moment") + 1,
                  1e-9);

  const Row wide =
    table_of(mesh("0:30:1", "cyclic") +
               setting("Supports/alpha_1 min",
                       "axial both; circumferential both; radial both = 2") +
               setting("Supports/alpha_1 max", "radial both = 1") +
               setting("Stage 1/Load factor", "0.01"),
             "history.csv")
      .back();
  check_small(
    "widened by", number(wide, "alpha_1_min_displacement") - 0.02, 1e-11);
  check_small("work",
              (number(wide, "alpha_1_max_force") * 0.01 +
               number(wide, "alpha_1_min_force") * 0.02) /
                  (2 * n_sectors * number(wide, "load_work")) -
                1,
              1e-9);

  // in the only step of a stage, tangent and secant are the same
  std::vector<double> by_exponent;
  for (const Row &row : table_of(
         mesh("0:30:1", "cyclic") + setting("Supports/alpha_1 min", "fixed") +
           setting("Supports/alpha_1 max",
                   "axial both = -0.5; circumferential both; radial both") +
           setting("Loads/Pressure type", "follower") +
           setting("Loads/End plates", "alpha_1 min, alpha_1 max") +
           setting("Gas/Ambient pressure", "0.1") +
           setting("Number of stages", "2") +
           setting("Stage 1/Pressure", "0.05") +
           setting("Stage 2/Gas", "sealed") +
           setting("Stage 2/Load factor", "1") +
           setting("Sensitivities/Entries", "Gas/Polytropic exponent") +
           setting("Sensitivities/Outputs",
                   "alpha_1 max tangent, alpha_1 max secant"),
         "sensitivities.csv"))
    by_exponent.push_back(number(row, "derivative"));
  check_true("a sealed gas is stiffer by its exponent", by_exponent.at(0) > 1);
  check_small("derivatives of tangent and secant",
              by_exponent.at(0) / by_exponent.at(1) - 1,
              1e-6);

  // two motions with factors of their own
  const Row twice =
    table_of(mesh("0:30:1", "cyclic") +
               setting("Supports/alpha_1 min", "fixed") +
               setting("Supports/alpha_1 max", "v_1 both = -1; v_2 both = 1") +
               setting("Stage 1/Load factor", "0.1") +
               setting("Stage 1/Load factors", "supports alpha_1 max v_2: 0.2"),
             "history.csv")
      .back();
  check_small("its own factor",
              number(twice, "alpha_1_max_v_2_displacement") - 0.2,
              1e-11);
  check_small("the common factor",
              number(twice, "alpha_1_max_v_1_displacement") - 0.1,
              1e-11);
}
