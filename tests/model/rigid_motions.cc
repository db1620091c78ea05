// SPDX-License-Identifier: LGPL-2.1-or-later

// Rigid motions that the supports leave free are found and named.

#include <deal.II/base/mpi.h>

#include <iostream>

#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/reference_surface.h>

#include "cord_shells.h"
#include <tests.h>

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
    NamedPoints named;
    named.list        = parse_points("points", points);
    const auto parsed = named.on(*surface);
    Supports   supports;
    for (unsigned int e = 0; e < 4; ++e)
      supports.edges[e] = parse_support("edge", edges[e], e / 2);
    supports.points = parse_point_supports("points", support);

    const auto mesh    = cord_shell(std::move(surface),
                                 intervals,
                                 false,
                                 "cord: 0.2 @ 0",
                                 "middle",
                                 supports,
                                 parsed);
    const auto motions = free_rigid_motions(*mesh);
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
