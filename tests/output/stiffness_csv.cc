// SPDX-License-Identifier: LGPL-2.1-or-later

// stiffness.csv has a line for each step in which the ground moves in one
// way while all other loads rest, whatever the number of ranks. Its stiffnesses
// are differences of the forces and moments in forces.csv over the motion.

#include <deal.II/base/tensor.h>

#include "../restart.h"

using namespace dealii;

namespace
{
  using Row = std::map<std::string, std::string>;

  std::vector<Row>
  rows_of(const std::string &file)
  {
    const auto       table = read_table("results/" + file);
    std::vector<Row> rows;
    for (unsigned int i = 1; i < table.size(); ++i)
      {
        rows.emplace_back();
        for (unsigned int j = 0; j < table[0].size(); ++j)
          rows.back()[table[0][j]] = table[i].at(j);
      }
    return rows;
  }

  Tensor<1, 3>
  vector_of(const Row &row, const std::string &prefix)
  {
    return Tensor<1, 3>({std::stod(row.at(prefix + "x")),
                         std::stod(row.at(prefix + "y")),
                         std::stod(row.at(prefix + "z"))});
  }


  /** Compare a line with the change from one step to another. */
  void
  check(const Row         &line,
        const std::string &kind,
        const double       amount,
        const Row         &from,
        const Row         &to,
        const double       height)
  {
    // about the point of the ground at which it touched the tire first
    const Tensor<1, 3> center({height, 0., 0.});
    const Tensor<1, 3> force  = vector_of(to, "F_") - vector_of(from, "F_");
    const Tensor<1, 3> moment = vector_of(to, "M_") - vector_of(from, "M_") -
                                cross_product_3d(center, force);
    check_small("  " + kind + " force",
                (vector_of(line, kind + "_F_") - force / amount).norm(),
                1e-7,
                (force / amount).norm());
    check_small("  " + kind + " moment",
                (vector_of(line, kind + "_M_") - moment / amount).norm(),
                1e-6,
                ((moment / amount).norm() + 250 * (force / amount).norm()));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ended ended = run(with(soft_tire,
                               {no_vtu,
                                "Contact/Tangential regularization=100",
                                "Gas/Ambient pressure=0.1",
                                "Stage 2/Travel=10",
                                "Stage 2/Steps=2",
                                "Number of stages=9",
                                "Stage 3/Name=rough",
                                "Stage 3/Contact=true",
                                "Stage 3/Friction=0.5",
                                "Stage 3/Slide=0, 1, 0",
                                "Stage 3/Steps=2",
                                "Stage 4/Name=glued",
                                "Stage 4/Start from=2",
                                "Stage 4/Contact=true",
                                "Stage 4/Glued=true",
                                "Stage 4/Turn=1",
                                "Stage 5/Name=pressure changes",
                                "Stage 5/Start from=2",
                                "Stage 5/Contact=true",
                                "Stage 5/Pressure=0.16",
                                "Stage 5/Travel=11",
                                "Stage 6/Name=two motions",
                                "Stage 6/Start from=2",
                                "Stage 6/Contact=true",
                                "Stage 6/Turn=1",
                                "Stage 6/Travel=11",
                                "Stage 7/Name=no ground",
                                "Stage 7/Start from=2",
                                "Stage 8/Name=ground comes back",
                                "Stage 8/Contact=true",
                                "Stage 8/Travel=12",
                                "Stage 9/Name=sealed",
                                "Stage 9/Start from=2",
                                "Stage 9/Contact=true",
                                "Stage 9/Gas=sealed",
                                "Stage 9/Travel=11"}),
                          "results",
                          MPI_COMM_WORLD);
  if (!is_root())
    return 0;
  std::cout << ended.code << '\n' << ended.err;

  std::map<unsigned int, Row> forces;
  for (const Row &row : rows_of("forces.csv"))
    if (row.at("body") == "foundation")
      forces[std::stoul(row.at("step"))] = row;
  const auto             history = rows_of("history.csv");
  const std::vector<Row> lines   = rows_of("stiffness.csv");
  // where the tire is touched first
  const double crown = std::stod(rows_of("profile-0001.csv")[7].at("outer_x"));
  for (const Row &line : lines)
    {
      const unsigned int step  = std::stoul(line.at("step"));
      const std::string  name  = line.at("stage");
      unsigned int       first = step;
      while (first > 1 && history[first - 2].at("stage") == name)
        --first;
      // the step at the end of the stage from which this one starts
      const unsigned int start  = (name == "contact" ? 1 : 3);
      const unsigned int before = (step == first ? start : step - 1);
      std::cout << "step " << step << ", " << name << ": " << line.at("motion")
                << ' ' << line.at("amount") << " along "
                << vector_of(line, "direction_") << " from the approach "
                << line.at("approach") << ", secant " << line.at("secant")
                << ", tangent " << line.at("tangent") << std::endl;
      check_small("  pressure",
                  std::stod(line.at("pressure")) -
                    std::stod(history[start - 1].at("pressure")),
                  1e-12);
      check_small("  force",
                  std::stod(line.at("force")) -
                    std::stod(history[start - 1].at("force")),
                  1e-6,
                  1000);
      const double amount = std::stod(line.at("amount"));
      const double steps  = step - first + 1;
      const double height = crown - std::stod(line.at("approach"));
      check(line, "secant", amount, forces.at(start), forces.at(step), height);
      check(line,
            "tangent",
            amount / steps,
            forces.at(before),
            forces.at(step),
            height);
    }
}
