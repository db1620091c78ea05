// SPDX-License-Identifier: LGPL-2.1-or-later

// Rigid motions that the supports leave free are found and named.

#include <deal.II/base/mpi.h>

#include <iostream>

#include <biface/model/rigid_motions.h>
#include <biface/surface/circular_arc.h>
#include <biface/surface/plane.h>
#include <biface/surface/surface_of_revolution.h>

#include "../tests.h"
#include <cord_ply.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  print(const std::string                &what,
        std::unique_ptr<ReferenceSurface> surface,
        const std::array<std::string, 2> &intervals,
        const std::array<std::string, 4> &edges,
        const std::string                &points  = "",
        const std::string                &support = "")
  {
    ChartGrid::Parameters parameters;
    for (unsigned int a = 0; a < 2; ++a)
      parameters.intervals[a] = parse_intervals("intervals", intervals[a]);
    parameters.closed = false;
    const ChartGrid grid(parameters, *surface);
    NamedPoints     named;
    named.list        = parse_points("points", points);
    const auto parsed = named.on(*surface);
    Supports   supports;
    for (unsigned int e = 0; e < 4; ++e)
      supports.edges[e] = parse_support("edge", edges[e], e / 2);
    supports.points = parse_point_supports("points", support);

    Layup::Parameters layup_parameters;
    layup_parameters.plies = parse_plies("plies", "cord: 0.2 @ 0");
    layup_parameters.reference =
      parse_thickness_position("reference", "middle");
    const Layup     layup(layup_parameters, cord_ply());
    const ShellMesh mesh(
      MPI_COMM_WORLD, std::move(surface), grid, layup, supports, parsed);
    const auto motions = free_rigid_motions(mesh);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::cout << what << ':' << std::endl;
        for (const std::string &motion : motions)
          std::cout << "  " << motion << std::endl;
        if (motions.empty())
          std::cout << "  none" << std::endl;
      }
  }


  std::unique_ptr<ReferenceSurface>
  torus()
  {
    return std::make_unique<SurfaceOfRevolution>(
      std::make_shared<CircularArc>(CircularArc::Parameters()));
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::array<std::string, 2> plate{{"0:2:4", "0:1:3"}};
  const auto plane = []() { return std::make_unique<Plane>(); };

  print("free plate", plane(), plate, {{"free", "free", "free", "free"}});
  print("clamped plate", plane(), plate, {{"fixed", "free", "free", "free"}});
  print("plate hinged along y",
        plane(),
        plate,
        {{"hinged", "free", "free", "free"}});
  print("quarter of a plate",
        plane(),
        plate,
        {{"symmetry", "free", "symmetry", "free"}});
  print("quarter of a plate, held at a corner",
        plane(),
        plate,
        {{"symmetry", "free", "symmetry", "free"}},
        "corner: 2 1",
        "corner: v_3 middle");
  print("half of a torus section",
        torus(),
        {{"-60:60:4", "0:180:6"}},
        {{"free", "free", "symmetry", "symmetry"}});
}
