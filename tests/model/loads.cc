// SPDX-License-Identifier: LGPL-2.1-or-later

// The nodal forces of pressure and tractions add up to the total force and
// moment of these loads. With the standard formulation they act on the flat
// faces of the cells, where those of a pressure are exact; with that of the
// paper on the middle surface, by the trapezoidal rule, with an error of second
// order in the cell size on a torus.

#include <deal.II/base/numbers.h>

#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>

#include "cord_shells.h"
#include <name_of.h>
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
  pressure(const Resultants::Face face, const std::string &distribution = "1")
  {
    PressureLoad load;
    load.face         = face;
    load.distribution = parse_position_formula("distribution", distribution);
    return load;
  }


  LA::Vector
  tractions(const ShellMesh   &mesh,
            const std::string &inner,
            const std::string &outer)
  {
    DeadLoads loads;
    loads.tractions = {
      {parse_traction("inner", inner), parse_traction("outer", outer)}};
    return loads.assemble(mesh)[0];
  }


  void
  on_quarter_of_cylinder(const Formulation formulation)
  {
    const auto shell = cylinder("0:90:3", false, formulation);
    for (const auto face : {Resultants::inner, Resultants::outer})
      {
        double radius = (face == Resultants::inner ? 9.5 : 11);
        if (formulation == Formulation::paper)
          {
            // the trapezoidal rule gives the integral of cos and of sin, which
            // is 1, but for this factor
            const double half = numbers::PI / 12;
            radius            = 10.25 * half / std::tan(half);
          }
        const double sign = (face == Resultants::inner ? 1 : -1);
        check(name_of(formulation) + (face == Resultants::inner
                                        ? ": inner pressure"
                                        : ": outer pressure"),
              *shell,
              pressure(face).assemble_dead(*shell),
              6 * sign * radius * Tensor<1, 3>({1, 0, 1}),
              18 * sign * radius * Tensor<1, 3>({1, 0, -1}),
              100);
      }
  }


  void
  on_whole_cylinder(const Formulation formulation)
  {
    const auto        shell = cylinder("0:360:7", true, formulation);
    const std::string name  = name_of(formulation) + ": ";
    const double      turn  = 2 * numbers::PI;
    // the radius of a circle as long as the cells are
    const auto radius = [&](const double of_face) {
      return formulation == Formulation::paper
               ? 10.25
               : of_face * 14 * std::sin(turn / 14) / turn;
    };
    check(name + "pressure all around",
          *shell,
          pressure(Resultants::inner).assemble_dead(*shell),
          Tensor<1, 3>(),
          Tensor<1, 3>(),
          100);
    check(name + "local tractions along the axis",
          *shell,
          tractions(*shell, "2; 0; 0; local", ""),
          Tensor<1, 3>({0, 2 * turn * radius(9.5) * 6, 0}),
          Tensor<1, 3>(),
          100);
    // e_2 runs from x to z, against the sense of the axis y
    check(name + "local tractions around",
          *shell,
          tractions(*shell, "0; 1; 0; local", "0; 3; 0; local"),
          Tensor<1, 3>(),
          Tensor<1, 3>(
            {0, -turn * 6 * (radius(9.5) * 9.5 + 3 * radius(11) * 11), 0}),
          1000);
    // x is 10 cos, and so is the pressure; the mean of cos^2 is 1/2. Between
    // the nodes the pressure is linear: in the middle of a side lower by the
    // cosine
    const double force =
      turn / 2 * 10 * radius(9.5) * 6 *
      (formulation == Formulation::paper ? 1. : std::cos(turn / 14));
    check(name + "pressure in proportion to x",
          *shell,
          pressure(Resultants::inner, "x").assemble_dead(*shell),
          Tensor<1, 3>({force, 0, 0}),
          Tensor<1, 3>({0, 0, -3 * force}),
          1000);
  }


  void
  on_plate(const Formulation formulation)
  {
    const auto        shell = plate(formulation);
    const std::string name  = name_of(formulation) + ": ";
    // integrals over the area of x and of x^2, the paper's by the trapezoidal
    // rule, as that of y^2
    const double x_dA = 16;
    const double xx_dA =
      2 *
      (64. / 3 + (formulation == Formulation::paper ? 4 * 16. / 25 / 6 : 0.));
    const double yy_dA = 4 * (8. / 3 + 2 * 4. / 9 / 6);

    check(name + "pressure of x on the outer face",
          *shell,
          pressure(Resultants::outer, "alpha_1").assemble_dead(*shell),
          Tensor<1, 3>({0, 0, -x_dA}),
          Tensor<1, 3>({-x_dA, xx_dA, 0}),
          10);
    check(name + "linear tractions on the outer face, at z = 1",
          *shell,
          tractions(*shell, "", "x; 2*pi; 3*alpha_2"),
          Tensor<1, 3>({x_dA, 16 * numbers::PI, 24}),
          Tensor<1, 3>({3 * yy_dA - 16 * numbers::PI,
                        x_dA - 3 * 16,
                        16 * 2 * numbers::PI - 16}),
          10);
    check(name + "and on the inner face, at z = -0.5",
          *shell,
          tractions(*shell, "1; 0; 0", ""),
          Tensor<1, 3>({8, 0, 0}),
          Tensor<1, 3>({0, -4, -8}),
          10);
  }


  /** The deviation of the total force along the axle on a section of a torus.
   */
  double
  deviation_on_torus(const Formulation      formulation,
                     const unsigned int     n_cells,
                     const Resultants::Face face)
  {
    constexpr unsigned int n_around = 8;
    const auto  shell = torus(n_cells, n_around, thick_ply, formulation);
    const Total total(*shell, pressure(face).assemble_dead(*shell));

    // the normal is along (cos psi, sin psi), the radius r_c + R cos psi
    const bool   on_middle = (formulation == Formulation::paper);
    const double turn      = 2 * numbers::PI;
    const double R         = (on_middle                   ? 50.25
                              : face == Resultants::inner ? 49.5
                                                          : 51);
    const double begin = -numbers::PI / 6, end = numbers::PI / 2;
    // the area of a polygon in place of a circle
    const double force =
      (on_middle ? turn : n_around * std::sin(turn / n_around)) * R *
      (200 * (std::cos(begin) - std::cos(end)) +
       R / 2 * (std::pow(std::sin(end), 2) - std::pow(std::sin(begin), 2)));
    const double sign = (face == Resultants::inner ? 1 : -1);
    // around the axle, nothing remains
    return (total.force - Tensor<1, 3>({0, sign * force, 0})).norm() / force;
  }


  void
  on_torus(const Formulation formulation)
  {
    for (const auto face : {Resultants::inner, Resultants::outer})
      {
        const double coarse = deviation_on_torus(formulation, 8, face);
        const double fine   = deviation_on_torus(formulation, 16, face);
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
          continue;
        std::cout << name_of(formulation) << ": torus, "
                  << (face == Resultants::inner ? "inner" : "outer")
                  << " pressure" << std::endl;
        if (formulation != Formulation::paper)
          {
            check_small("  force along the axle", coarse, 1e-12);
            continue;
          }
        check_small("  force along the axle", fine, 5e-3);
        check_range(
          "  order, as the ratio of deviations", coarse / fine, 3.8, 4.2);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const auto formulation : {Formulation::paper, Formulation::standard})
    {
      on_quarter_of_cylinder(formulation);
      on_whole_cylinder(formulation);
      on_plate(formulation);
      on_torus(formulation);
    }
}
