// SPDX-License-Identifier: LGPL-2.1-or-later

// On a closed section of a torus, the cells of MappingManifold have the exact
// area, and the weights of the paper's elements that of the middle surface by
// the midpoint rule.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_manifold.h>

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

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double R = 50, r_c = 200;
  const auto   surface = SurfaceOfRevolution(
    std::make_shared<CircularArc>(CircularArc::Parameters()));
  // half a circle of unequal cells, and a ring that does not begin at 0
  ChartGrid::Parameters parameters;
  parameters.intervals = {
    {parse_intervals("intervals", "-120:-15:5:0.8, -15:60:4"),
     parse_intervals("intervals", "-90:90:7, 90:270:5")}};
  const ChartGrid             grid(parameters, surface);
  const std::array<double, 2> faces{{-1, 5}};
  Layup::Parameters           layup_parameters;
  layup_parameters.plies     = parse_plies("plies", "cord: 6 @ 0");
  layup_parameters.reference = parse_thickness_position("reference", "1");
  const Layup     layup(layup_parameters, cord_ply());
  const ShellMesh mesh(MPI_COMM_WORLD,
                       std::make_unique<SurfaceOfRevolution>(surface),
                       grid,
                       layup,
                       Supports(),
                       {},
                       Formulation::paper);

  // the first moment tells where the section lies
  const MappingManifold<2, 3> mapping;
  const FE_Q<2, 3>            fe(1);
  FEValues<2, 3>              values(
    mapping, fe, QGauss<2>(6), update_JxW_values | update_quadrature_points);
  double area = 0, moment = 0;
  for (const auto &cell : mesh.get_dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        values.reinit(static_cast<Triangulation<2, 3>::cell_iterator>(cell));
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
          {
            area += values.JxW(q);
            moment += values.JxW(q) * values.quadrature_point(q)[1];
          }
      }
  double weight = 0;
  for (const Cell &cell : mesh.cells)
    weight += cell.geometry.weight;
  area   = Utilities::MPI::sum(area, MPI_COMM_WORLD);
  moment = Utilities::MPI::sum(moment, MPI_COMM_WORLD);
  weight = Utilities::MPI::sum(weight, MPI_COMM_WORLD);

  // r = r_c + R cos s, y = R sin s, dA = 2 pi r R ds
  const double begin = -2 * numbers::PI / 3, end = numbers::PI / 3;
  const double exact_area =
    2 * numbers::PI * R *
    (r_c * (end - begin) + R * (std::sin(end) - std::sin(begin)));
  const double exact_moment =
    2 * numbers::PI * R * R *
    (r_c * (std::cos(begin) - std::cos(end)) +
     R / 2 * (std::pow(std::sin(end), 2) - std::pow(std::sin(begin), 2)));

  // the middle surface, at the distance 2, one strip of cells after the other
  const auto  &lines        = grid.lines[0];
  const double R_mid        = R + (faces[0] + faces[1]) / 2;
  double       exact_weight = 0;
  for (unsigned int i = 0; i + 1 < lines.size(); ++i)
    exact_weight += 2 * numbers::PI * R_mid * (lines[i + 1] - lines[i]) *
                    (r_c + R_mid * std::cos((lines[i] + lines[i + 1]) / 2));

  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      check_small("area", area - exact_area, 1e-12, exact_area);
      check_small("first moment", moment - exact_moment, 1e-12, exact_area * R);
      check_small(
        "weights of the elements", weight - exact_weight, 1e-12, exact_weight);
    }
}
