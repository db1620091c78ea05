// SPDX-License-Identifier: LGPL-2.1-or-later

// Named points are found at their nodes: across the end of a turn, on either
// side of a slit, and where the angle is written a turn further.

#include <deal.II/base/mpi.h>

#include <biface/laminate/layup.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>
#include <biface/surface/surface_of_revolution.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  find(const std::string                            &name,
       const std::string                            &intervals,
       const bool                                    closed,
       const std::vector<std::pair<double, double>> &places)
  {
    auto surface = std::make_unique<SurfaceOfRevolution>(
      std::make_shared<CircularArc>(CircularArc::Parameters()));
    ChartGrid::Parameters parameters;
    parameters.intervals = {{parse_intervals("intervals", "-20:20:4"),
                             parse_intervals("intervals", intervals)}};
    parameters.closed    = closed;
    const ChartGrid         grid(parameters, *surface);
    const double            degree = surface->coordinate_unit(1);
    std::vector<NamedPoint> points;
    for (const auto &place : places)
      points.push_back(
        {"point", Point<2>(place.first * degree, place.second * degree)});
    const bool first = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (first)
      std::cout << name << std::endl;
    try
      {
        const ShellMesh mesh(MPI_COMM_WORLD,
                             std::move(surface),
                             grid,
                             Layup(Layup::Parameters(), cord_ply()),
                             Supports(),
                             points);
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const unsigned int n = mesh.nodes_of_points[i];
            unsigned int       number =
              (n < mesh.nodes.size() && mesh.nodes[n].locally_owned
                 ? mesh.nodes[n].number
                 : 0);
            number = Utilities::MPI::sum(number, MPI_COMM_WORLD);
            if (first)
              std::cout << "  " << places[i].first << ' ' << places[i].second
                        << ": line " << number % 5 << " and " << number / 5
                        << ", alpha_2 = "
                        << std::round(mesh.points[i].alpha[1] / degree)
                        << std::endl;
          }
      }
    catch (const std::exception &error)
      {
        if (first)
          std::cout << "  " << error.what() << std::endl;
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  find(
    "ring", "-180:180:8", true, {{-20, -180}, {20, 180}, {0, 540}, {10, 315}});
  find("slit", "-180:180:8", false, {{-10, -180}, {-10, 180}, {10, 225}});
  find("part of a ring",
       "350:400:5",
       false,
       {{0, 350}, {0, -10}, {20, 30}, {0, 400}});
  find("no node", "350:400:5", false, {{0, 0}, {2, 23}});
  find("beyond the edge", "350:400:5", false, {{0, 340}});
}
