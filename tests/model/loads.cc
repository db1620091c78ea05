// SPDX-License-Identifier: LGPL-2.1-or-later

// The nodal forces of pressure and tractions add up to the total force and
// moment of these loads: exactly on plates and cylinders, tractions by the
// trapezoidal rule, and with second order in the cell size on a torus.

#include <deal.II/base/numbers.h>

#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>

#include "cord_shells.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The total force and moment, as a fraction of a scale. */
  void
  check(const std::string  &what,
        const ShellMesh    &mesh,
        const LA::Vector   &nodal_forces,
        const Tensor<1, 3> &force,
        const Tensor<1, 3> &moment,
        const double        scale)
  {
    const Total total(mesh, nodal_forces);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        check_small(what, (total.force - force).norm(), 1e-12, scale);
        // arms are of the order 10
        check_small(
          "  moment", (total.moment - moment).norm(), 1e-12, 10 * scale);
      }
  }


  PressureLoad
  pressure(const Resultants::Face face,
           const AreaMeasure      area,
           const std::string     &distribution = "1")
  {
    PressureLoad load;
    load.face         = face;
    load.area         = area;
    load.distribution = parse_position_formula("distribution", distribution);
    return load;
  }


  LA::Vector
  tractions(const ShellMesh   &mesh,
            const std::string &inner,
            const std::string &outer,
            const AreaMeasure  area)
  {
    DeadLoads loads;
    loads.tractions = {
      {parse_traction("inner", inner), parse_traction("outer", outer)}};
    return loads.assemble(mesh, area)[0];
  }


  void
  on_quarter_of_cylinder()
  {
    const auto shell          = cylinder("0:90:3", false);
    const auto check_pressure = [&](const std::string  &what,
                                    const PressureLoad &load,
                                    const double        radius) {
      // the trapezoidal rule gives the integral of cos and of sin, which is
      // 1, but for this factor
      const double half = numbers::PI / 12;
      const double unit = radius * half / std::tan(half);
      const double sign = (load.face == Resultants::inner ? 1 : -1);
      check(what,
            *shell,
            load.assemble_dead(*shell),
            6 * sign * unit * Tensor<1, 3>({1, 0, 1}),
            18 * sign * unit * Tensor<1, 3>({1, 0, -1}),
            100);
    };
    for (const auto face : {Resultants::inner, Resultants::outer})
      {
        const std::string name =
          (face == Resultants::inner ? "inner pressure" : "outer pressure");
        check_pressure(name + ", area of the middle surface",
                       pressure(face, AreaMeasure::middle),
                       10.25);
        check_pressure(name + ", area of the face",
                       pressure(face, AreaMeasure::face),
                       face == Resultants::inner ? 9.5 : 11);
      }
  }


  void
  on_whole_cylinder()
  {
    const auto   shell = cylinder("0:360:7", true);
    const double turn  = 2 * numbers::PI;
    check(
      "pressure all around",
      *shell,
      pressure(Resultants::inner, AreaMeasure::middle).assemble_dead(*shell),
      Tensor<1, 3>(),
      Tensor<1, 3>(),
      100);
    check("local tractions along the axis, area of the middle surface",
          *shell,
          tractions(*shell, "2; 0; 0; local", "", AreaMeasure::middle),
          Tensor<1, 3>({0, 2 * turn * 10.25 * 6, 0}),
          Tensor<1, 3>(),
          100);
    // e_2 runs from x to z, against the sense of the axis y
    check(
      "local tractions around, area of the faces",
      *shell,
      tractions(*shell, "0; 1; 0; local", "0; 3; 0; local", AreaMeasure::face),
      Tensor<1, 3>(),
      Tensor<1, 3>({0, -turn * 6 * (9.5 * 9.5 + 3 * 11 * 11), 0}),
      1000);
    // x is 10 cos, and so is the pressure; the mean of cos^2 is 1/2
    check("pressure in proportion to x",
          *shell,
          pressure(Resultants::inner, AreaMeasure::middle, "x")
            .assemble_dead(*shell),
          Tensor<1, 3>({turn / 2 * 10 * 10.25 * 6, 0, 0}),
          Tensor<1, 3>({0, 0, -turn / 2 * 10 * 10.25 * 18}),
          1000);
  }


  void
  on_plate()
  {
    const auto shell = plate();
    // integrals of x and x^2, and of y^2 by the trapezoidal rule, over the area
    const double x_dA  = 16;
    const double xx_dA = 2 * 64. / 3;
    const double yy_dA = 4 * (8. / 3 + 2 * 4. / 9 / 6);

    check("pressure of x on the outer face",
          *shell,
          pressure(Resultants::outer, AreaMeasure::face, "alpha_1")
            .assemble_dead(*shell),
          Tensor<1, 3>({0, 0, -x_dA}),
          Tensor<1, 3>({-x_dA, xx_dA, 0}),
          10);
    check("linear tractions on the outer face, at z = 1",
          *shell,
          tractions(*shell, "", "x; 2*pi; 3*alpha_2", AreaMeasure::middle),
          Tensor<1, 3>({x_dA, 16 * numbers::PI, 24}),
          Tensor<1, 3>({3 * yy_dA - 16 * numbers::PI,
                        x_dA - 3 * 16,
                        16 * 2 * numbers::PI - 16}),
          10);
    check("and on the inner face, at z = -0.5",
          *shell,
          tractions(*shell, "1; 0; 0", "", AreaMeasure::face),
          Tensor<1, 3>({8, 0, 0}),
          Tensor<1, 3>({0, -4, -8}),
          10);
  }


  /** The deviation of the total force along the axle on a section of a torus.
   */
  double
  deviation_on_torus(const unsigned int     n_cells,
                     const Resultants::Face face,
                     const AreaMeasure      area)
  {
    const auto  shell = torus(n_cells);
    const Total total(*shell, pressure(face, area).assemble_dead(*shell));

    // the normal is along (cos psi, sin psi), the radius r_c + R cos psi
    const double R     = (area == AreaMeasure::middle ? 50.25
                          : face == Resultants::inner ? 49.5
                                                      : 51);
    const double begin = -numbers::PI / 6, end = numbers::PI / 2;
    const double force =
      2 * numbers::PI * R *
      (200 * (std::cos(begin) - std::cos(end)) +
       R / 2 * (std::pow(std::sin(end), 2) - std::pow(std::sin(begin), 2)));
    const double sign = (face == Resultants::inner ? 1 : -1);
    // around the axle, nothing remains
    return (total.force - Tensor<1, 3>({0, sign * force, 0})).norm() / force;
  }


  void
  on_torus()
  {
    for (const auto face : {Resultants::inner, Resultants::outer})
      for (const auto area : {AreaMeasure::middle, AreaMeasure::face})
        {
          const double coarse = deviation_on_torus(8, face, area);
          const double fine   = deviation_on_torus(16, face, area);
          if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
            {
              std::cout << "torus, "
                        << (face == Resultants::inner ? "inner" : "outer")
                        << " pressure, "
                        << (area == AreaMeasure::middle
                              ? "area of the middle surface"
                              : "area of the face")
                        << std::endl;
              check_small("  force along the axle", fine, 5e-3);
              check_range(
                "  order, as the ratio of deviations", coarse / fine, 3.8, 4.2);
            }
        }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  on_quarter_of_cylinder();
  on_whole_cylinder();
  on_plate();
  on_torus();
}
