// SPDX-License-Identifier: LGPL-2.1-or-later

// A sector with cyclic edges has the displacements and the forces of the full
// turn, with plies at an angle, too: a single cell of an inflated tire, and a
// quarter of a cylinder whose load repeats four times; for both distributions
// of the mesh, with every kind of solver, and starting from coarser meshes.

#include <biface/stepping/step_report.h>

#include "forces.h"

using namespace dealii;
using namespace Biface;

namespace
{
  /** The displacements of both faces on the line alpha_2 = 0, in the frames of
   * its nodes, and the forces on the shell. */
  struct Line
  {
    std::vector<double>              values;
    std::map<std::string, Resultant> of;
    double                           imbalance = 0;

    Line(const std::string           &file,
         std::vector<Override>        overrides,
         const std::vector<Override> &others)
    {
      overrides.insert(overrides.end(), others.begin(), others.end());
      run_analysis(
        file,
        overrides,
        [&](const ShellEquations &equations,
            const StepReport     &report,
            const State          &state) {
          const ShellMesh &mesh = equations.mesh;
          values.assign(6 * mesh.grid.lines[0].size(), 0);
          for (const Node &node : mesh.nodes)
            if (node.locally_owned && std::abs(node.alpha[1]) < 1e-9)
              for (unsigned int face = 0; face < 2; ++face)
                for (unsigned int i = 0; i < 3; ++i)
                  values[6 * node.grid_index[0] + 3 * face + i] =
                    mesh.displacement(state.displacement, node, face)[i];
          Utilities::MPI::sum(values, MPI_COMM_WORLD, values);

          Resultant sum{};
          double    largest = 0;
          for (const auto &item : report.forces_of_bodies)
            for (unsigned int i = 0; i < 6; ++i)
              {
                const double f   = (i < 3 ? item.force[i] : item.moment[i - 3]);
                of[item.body][i] = f;
                sum[i] += f;
                largest = std::max(largest, std::abs(f));
              }
          imbalance = 0;
          for (const double s : sum)
            imbalance = std::max(imbalance, std::abs(s) / largest);
        });
    }

    double
    distance(const Line &other) const
    {
      if (values.size() != other.values.size() || values.empty())
        return 1e10;
      double apart = 0, largest = 0;
      for (unsigned int i = 0; i < values.size(); ++i)
        {
          apart   = std::max(apart, std::abs(values[i] - other.values[i]));
          largest = std::max(largest, std::abs(other.values[i]));
        }
      return apart / largest;
    }
  };


  const std::vector<Override> cyclic{"Mesh/Closed in alpha_2=false",
                                     "Supports/alpha_2 min=cyclic",
                                     "Supports/alpha_2 max=cyclic"};

  std::vector<Override>
  with(std::vector<Override> overrides, const std::vector<Override> &others)
  {
    overrides.insert(overrides.end(), others.begin(), others.end());
    return overrides;
  }


  // plies at 45 and -45 degrees, hinged at one end, twisted at the other
  const std::string cylinder = R"(
subsection Surface
  set Meridian = straight line
  subsection Straight line
    set Start = 10, 0
    set End   = 10, 20
  end
end
subsection Mesh
  set Intervals alpha_1 = 0:20:6
end
set Materials = cord
subsection Material cord
  set Type = orthotropic
  set E_1  = 1000
  set E_2  = 20
  set E_3  = 20
  set G_12 = 10
  set G_13 = 10
  set G_23 = 10
end
subsection Laminate
  set Plies = cord: 0.2 @ 45, cord: 0.2 @ -45
end
subsection Supports
  set alpha_1 min = hinged
  set alpha_1 max = circumferential both = 0.2; radial middle
end
subsection Loads
  set Pressure type         = follower
  set Pressure distribution = 1 + 0.5*cos(4*pi*alpha_2/180)
end
subsection Stage 1
  set Pressure    = 0.05
  set Load factor = 1
  set Steps       = 2
end
subsection Newton
  set Residual tolerance = 1e-12
end
)";
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one rank speaks for all
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);

  {
    const std::string           tire = PRM_DIR "/bias_tire.prm";
    const std::vector<Override> inflation{"Stage 2/Contact=false",
                                          "Stage 2/Travel=0",
                                          "Stage 2/Pressure=0.16",
                                          "Stage 2/Steps=1",
                                          "Mesh/Intervals alpha_1=-120:120:12",
                                          "Laminate/Reference surface=middle",
                                          "Loads/Pressure type=follower",
                                          "Newton/Residual tolerance=1e-12"};

    const Line full(tire, inflation, {"Mesh/Intervals alpha_2=0:360:36"});
    const Line cell(
      tire, inflation, with(cyclic, {"Mesh/Intervals alpha_2=0:10:1"}));
    check_small("one cell of a tire", cell.distance(full), 1e-8);
    check_small("  balance", cell.imbalance, 1e-8);
    check_small("  a 36th of the force of the bead",
                36 * cell.of.at("alpha_1 max")[1] -
                  full.of.at("alpha_1 max")[1],
                1e-8,
                full.of.at("alpha_1 max")[1]);
    // the hoop forces on both edges, along e_2, which turns by the angle
    const Resultant &a = cell.of.at("alpha_2 min"),
                    &b = cell.of.at("alpha_2 max");
    const double angle = 10 * numbers::PI / 180;
    check_true("  hoop tension", b[2] > 100);
    check_small("  passed on to the next sector",
                a[2] + b[2] * std::cos(angle) - b[0] * std::sin(angle),
                1e-9,
                b[2]);
    const Line symmetric(tire,
                         inflation,
                         {"Mesh/Intervals alpha_2=0:10:1",
                          "Mesh/Closed in alpha_2=false",
                          "Supports/alpha_2 min=symmetry",
                          "Supports/alpha_2 max=symmetry"});
    check_true("  not with symmetry", symmetric.distance(full) > 0.01);
  }

  {
    const std::string file = write_prm("cylinder.prm", cylinder);
    const Line        full(file, {}, {"Mesh/Intervals alpha_2=-180:180:32"});
    for (const std::vector<Override> &setting :
         std::vector<std::vector<Override>>{{},
                                            {"Mesh/Distribution=distributed"},
                                            {"Mesh/Coarse meshes=1"},
                                            {"Linear solver/Type=iterative"}})
      {
        const Line quarter(
          file, with(cyclic, {"Mesh/Intervals alpha_2=-45:45:8"}), setting);
        check_small("a quarter of a cylinder" +
                      (setting.empty() ? "" : ", " + setting[0].setting),
                    quarter.distance(full),
                    1e-8);
        check_small("  balance", quarter.imbalance, 1e-8);
        check_small("  a quarter of the moment about the axis",
                    4 * quarter.of.at("alpha_1 max")[4] -
                      full.of.at("alpha_1 max")[4],
                    1e-7,
                    full.of.at("alpha_1 max")[4]);
      }
  }
}
