// SPDX-License-Identifier: LGPL-2.1-or-later

// Directors that tilt in turn by an angle change the volume under a pressure by
// A sin^2/2 times the distance of the tension from the loaded face: half of the
// thickness in a wall of one material, and in one with a soft ply that of the
// other ply, also if each is a layer.

#include <biface/model/mesh/pressed_directors.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  double
  distance(const std::string     &plies,
           const std::string     &layers,
           const Resultants::Face face)
  {
    auto                  surface = std::make_unique<Plane>();
    ChartGrid::Parameters parameters;
    parameters.intervals = {{parse_intervals("intervals", "0:200:2"),
                             parse_intervals("intervals", "0:100:1")}};
    parameters.closed    = false;
    const ChartGrid   grid(parameters, *surface);
    Layup::Parameters layup;
    layup.plies                               = parse_plies("plies", plies);
    layup.layers                              = parse_layers("layers", layers);
    std::vector<MaterialParameters> materials = {cord_ply()[0], cord_ply()[0]};
    materials[1].name                         = "soft";
    for (double *const modulus : {&materials[1].E_L,
                                  &materials[1].E_T,
                                  &materials[1].G_LT,
                                  &materials[1].G_TT})
      *modulus /= 100;
    const ShellMesh mesh(MPI_COMM_WORLD,
                         std::move(surface),
                         grid,
                         Layup(layup, materials),
                         Supports(),
                         std::vector<NamedPoint>());

    // all layers by the same angle
    const double           angle = 0.1;
    const PressedDirectors directors(mesh, face);
    double                 volume = 0, area = 0;
    for (const Cell &cell : mesh.cells)
      if (directors.act_on(cell.position))
        {
          MixedElement::NodalVector V;
          for (unsigned int q = 0; q < 4; ++q)
            {
              const double h    = cell.geometry.vertices[q].thickness,
                           sign = (q == 0 || q == 3 ? 1 : -1);
              V[MixedElement::dof(q, 0, MixedElement::half_difference)] =
                h / 2 * sign * std::sin(angle);
              V[MixedElement::dof(q, 2, MixedElement::half_difference)] =
                h / 2 * (std::cos(angle) - 1);
            }
          volume += directors.volume(cell, V);
          area += (cell.layer == 0 ? cell.geometry.weight : 0);
        }
    return -volume / (area * std::sin(angle) * std::sin(angle) / 2);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // cells longer than the wall is thick, in which all squares count as in thin
  // ones
  const auto check =
    [](const std::string &what, const double distance, const double expected) {
      check_range(what, distance / expected, 0.999, 1.001);
    };
  for (const std::string layers : {"one", "2, 2", "one per ply"})
    check("one material, layers: " + layers,
          distance("4 x (cord: 0.5 @ 0)", layers, Resultants::inner),
          1);
  for (const std::string layers : {"one", "one per ply"})
    {
      // 0.01 of the tension at 0.5 mm from the inner face, the rest at 1.5 mm
      const std::string plies = "soft: 1 @ 0, cord: 1 @ 0";
      check("soft inside, layers: " + layers,
            distance(plies, layers, Resultants::inner),
            (0.005 + 1.5) / 1.01);
      check("loaded outside, layers: " + layers,
            distance(plies, layers, Resultants::outer),
            (0.015 + 0.5) / 1.01);
    }
}
