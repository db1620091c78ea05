// SPDX-License-Identifier: LGPL-2.1-or-later

// A tire that starts to roll at a slip angle, or braked, has at each way the
// forces of one that is turned over the ground, whose mesh turns with it and
// whose friction has the history of standing tires. So has a locked wheel whose
// ground begins to move, in one step. A cleat that comes with slippery ground
// has the forces of one that moves under a standing tire.

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/rolling_summary.h>

#include "../tests.h"
#include "bias_tire.h"

using namespace Biface;
using dealii::numbers::PI;

namespace
{
  constexpr unsigned int around = 60, n_cells = 10;
  constexpr double       turn = 2 * PI * n_cells / around;

  std::vector<Override>
  with(const std::vector<Override> &more)
  {
    std::vector<Override> all{
      "Mesh/Intervals alpha_1=-120:-45:3, -45:45:6, 45:120:3",
      "Mesh/Intervals alpha_2=-180:180:" + std::to_string(around),
      "Contact/Multiplier mass=lumped",
      "Contact/Friction=0.5",
      "Contact/Rolling friction=bristles",
      "Contact/Tread/Height=8",
      "Contact/Tread/Modulus=1.8",
      "Stage 2/Friction=0",
      "Stage 2/Steps=2",
      "Stage 3/Contact=true"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }


  dealii::Tensor<1, 3>
  force_of_ground(const StepReport &report)
  {
    for (const auto &item : report.forces_of_bodies)
      if (item.body == "foundation")
        return item.force;
    return {};
  }


  void
  compare(const std::string &name, const double radius, const double angle)
  {
    // turned with its mesh, in steps of half a cell
    const auto turned = run_bias_tire(with(
      {"Number of stages=3",
       "Stage 3/Wheel turn=" + std::to_string(turn * 180 / PI),
       "Stage 3/Slide=0, " + std::to_string(-radius * turn * std::tan(angle)) +
         ", " + std::to_string(-radius * turn),
       "Stage 3/Steps=" + std::to_string(2 * n_cells)}));
    // through the mesh of the axle
    const auto rolled = run_bias_tire(
      with({"Number of stages=4",
            "Stage 3/Angular velocity=10",
            "Stage 3/Ground velocity=" +
              std::to_string(radius * 10 / std::cos(angle)),
            "Stage 3/Slip angle=" + std::to_string(angle * 180 / PI),
            "Stage 3/Transient rolling=true",
            "Stage 3/Duration=1e-8",
            "Stage 4/Contact=true",
            "Stage 4/Transient rolling=true",
            "Stage 4/Duration=" + std::to_string(turn / 10),
            "Stage 4/Steps=" + std::to_string(n_cells)}));
    double error = 0, scale = 0;
    for (unsigned int i = 1; i <= n_cells; ++i)
      {
        const auto &of_mesh = turned[turned.size() - 1 - 2 * (n_cells - i)];
        // from axes that turn with the wheel: down is x at the start
        const double               psi = turn * i / n_cells;
        const dealii::Tensor<1, 3> f   = force_of_ground(of_mesh);
        const dealii::Tensor<1, 3> expected(
          {std::cos(psi) * f[2] - std::sin(psi) * f[0], f[1], 0.});
        const dealii::Tensor<1, 3> &force =
          rolled[rolled.size() - 1 - (n_cells - i)].rolling->force;
        for (unsigned int k = 0; k < 2; ++k)
          error = std::max(error, std::abs(force[k] - expected[k]));
        scale = std::max(scale, expected.norm());
      }
    check_small(name, error, 0.03, scale);
  }


  void
  compare_locked()
  {
    const double slid = force_of_ground(
      run_bias_tire(with({"Number of stages=3", "Stage 3/Slide=0, 0, -2"}))
        .back())[2];
    const double moved = run_bias_tire(with({"Number of stages=3",
                                             "Stage 3/Transient rolling=true",
                                             "Stage 3/Duration=0.004",
                                             "Stage 3/Ground velocity=1000"}))
                           .back()
                           .rolling->force[0];
    check_small("locked", moved - slid, 1e-4, slid);
  }


  std::vector<dealii::Tensor<1, 3>>
  forces_of_cleat(const std::vector<Override> &more)
  {
    std::vector<Override> all{
      "Mesh/Intervals alpha_1=-120:-45:3, -45:45:6, 45:120:3",
      "Mesh/Intervals alpha_2=-180:-28:5:smooth, -28:28:14, 28:180:5:smooth",
      "Stage 2/Steps=2",
      "Body cleat/Motions=pass: 0 0 -130",
      "Stage 3/Steps=6"};
    all.insert(all.end(), more.begin(), more.end());
    std::vector<dealii::Tensor<1, 3>> result;
    for (const StepReport &report : run_analysis(PRM_DIR "/cleat.prm", all))
      for (const auto &item : report.forces_of_bodies)
        if (item.body == "cleat")
          result.push_back(item.force);
    return result;
  }


  void
  compare_cleats()
  {
    const auto standing = forces_of_cleat({});
    const auto rolling  = forces_of_cleat({"Contact/Friction=1e-10",
                                           "Contact/Rolling friction=bristles",
                                           "Stage 3/Transient rolling=true",
                                           "Stage 3/Angular velocity=4.1",
                                           "Stage 3/Ground velocity=1000",
                                           "Stage 3/Duration=0.13"});
    double     error = 0, scale = 0;
    check_true("as many steps", standing.size() == rolling.size());
    for (unsigned int i = 0; i < std::min(standing.size(), rolling.size()); ++i)
      {
        error = std::max(error, (rolling[i] - standing[i]).norm());
        scale = std::max(scale, standing[i].norm());
      }
    check_small("cleat", error, 1e-6, scale);
  }
} // namespace


int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  compare("at a slip angle", 239.8, 2 * PI / 180);
  compare("braked", 239.8 * 1.02, 0);
  compare_locked();
  compare_cleats();
}
