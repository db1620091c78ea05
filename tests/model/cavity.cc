// SPDX-License-Identifier: LGPL-2.1-or-later

// The volume of the bias tire beyond its rim is that of the torus, for any
// mesh, and the gradient of the volume is its derivative: on a shell whose
// edges are held, the forces of a unit pressure.

#include <deal.II/base/numbers.h>

#include <cmath>

#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/cavity.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/mesh/supports.h>
#include <biface/model/state/loads.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/intervals.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The volume between an arc from -angle to angle, of radius R about a center
   * at the distance C from the axis, and the cylinder of radius r. */
  double
  volume_beyond(const double C,
                const double R,
                const double angle,
                const double r)
  {
    const double s = std::sin(angle), c = std::cos(angle);
    return numbers::PI * R *
           ((C * C - r * r) * 2 * s + 2 * C * R * (angle + s * c) +
            R * R * (2 * s - 2. / 3 * s * s * s));
  }


  std::unique_ptr<ShellMesh>
  torus(const std::string &turn,
        const bool         closed,
        const Formulation  formulation = Formulation::paper)
  {
    auto surface = std::make_unique<SurfaceOfRevolution>(
      std::make_shared<CircularArc>(CircularArc::Parameters()));
    ChartGrid::Parameters parameters;
    parameters.intervals = {{parse_intervals("intervals", "-120:120:6"),
                             parse_intervals("intervals", turn)}};
    parameters.closed    = closed;
    const ChartGrid grid(parameters, *surface);
    return std::make_unique<ShellMesh>(MPI_COMM_WORLD,
                                       std::move(surface),
                                       grid,
                                       Layup(Layup::Parameters(), cord_ply()),
                                       Supports(),
                                       std::vector<NamedPoint>(),
                                       formulation);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto   tire  = torus("-180:180:8", true);
  const double inner = 50 + tire->strips[0].laminate.face_heights()[0];
  const double angle = 120 * numbers::PI / 180;
  const double rim   = 200 + inner * std::cos(angle);
  check_small("volume of the tire, relative",
              Cavity(*tire, Cavity::Parameters(), Resultants::inner)
                    .volume(State(*tire)) /
                  volume_beyond(200, inner, angle, rim) -
                1,
              1e-9);

  const auto vectors = torus("-180:180:8", true, Formulation::standard);
  check_small("the same, vectors interpolated",
              Cavity(*vectors, Cavity::Parameters(), Resultants::inner)
                    .volume(State(*vectors)) /
                  volume_beyond(200, inner, angle, rim) -
                1,
              1e-9);

  const auto         sector = torus("10:46:3", false);
  Cavity::Parameters without_rim;
  without_rim.rim_radius = 0;
  check_small(
    "a tenth of it to the axis, relative",
    Cavity(*sector, without_rim, Resultants::inner).volume(State(*sector)) /
        (volume_beyond(200, inner, angle, 0) / 10) -
      1,
    1e-9);

  const std::pair<Resultants::Face, Formulation> cases[] = {
    {Resultants::inner, Formulation::paper},
    {Resultants::outer, Formulation::paper},
    {Resultants::inner, Formulation::standard}};
  for (const auto &[face, formulation] : cases)
    {
      const auto mesh =
        coarse_torus(Layup(Layup::Parameters(), cord_ply()), formulation);
      Cavity::Parameters parameters;
      parameters.volume = 1e6;
      const Cavity     cavity(*mesh, parameters, face);
      State            state(*mesh);
      const LA::Vector V     = some_displacement(*mesh, 1, 1);
      const LA::Vector dV    = some_displacement(*mesh, 1, 2);
      state.displacement     = V;
      const double predicted = cavity.volume_gradient(state) * dV;

      const double          h = 2e-4;
      std::array<double, 2> volumes;
      for (const int sign : {-1, 1})
        {
          LA::Vector moved = V;
          moved.add(sign * h, dV);
          state.displacement      = moved;
          volumes[(sign + 1) / 2] = cavity.volume(state);
        }
      check_small(formulation == Formulation::standard
                    ? "gradient, vectors interpolated"
                  : face == Resultants::inner ? "gradient, inner face"
                                              : "gradient, outer face",
                  (volumes[1] - volumes[0]) / (2 * h) / predicted - 1,
                  1e-7);
    }

  struct Closed
  {
    std::string      name;
    Formulation      formulation;
    std::string      layers;
    Resultants::Face face;
  };
  for (const Closed &shell :
       {Closed{"", Formulation::paper, "one", Resultants::inner},
        Closed{", vectors interpolated",
               Formulation::standard,
               "one",
               Resultants::inner},
        Closed{", three layers, outside",
               Formulation::standard,
               "2, 1, 1",
               Resultants::outer}})
    {
      Layup::Parameters layup;
      layup.layers = parse_layers("layers", shell.layers);
      const auto mesh =
        coarse_torus(Layup(layup, cord_ply()), shell.formulation, true);
      ContactParameters contact_parameters;
      contact_parameters.condition.penalty_stiffness = 1;
      const ContactInteraction contact(*mesh, contact_parameters);
      PressureLoad             pressure;
      pressure.face = shell.face;
      const ShellEquations equations(
        *mesh, make_force_terms(*mesh, contact, DeadLoads(), pressure));
      State state(*mesh);
      // named, since a temporary would be moved together with its partition
      const LA::Vector V = some_displacement(*mesh, 5, 1);
      state.displacement = V;
      LoadRates unit;
      unit.pressure        = 1;
      const LA::Vector   f = equations.load_direction(state, Loads(), unit);
      Cavity::Parameters cavity_parameters;
      cavity_parameters.volume = 1e6;
      LA::Vector difference =
        Cavity(*mesh, cavity_parameters, shell.face).volume_gradient(state);
      mesh->condense(difference);
      difference -= f;
      const double deviation = difference.l2_norm(), norm = f.l2_norm();
      check_small(
        "forces are the gradient" + shell.name, deviation, 1e-13, norm);
    }
}
