// SPDX-License-Identifier: LGPL-2.1-or-later

// A bar that touches two lines of nodes, or of points in cells, of a flat plate
// is in the plate between them by the sagitta of its circle, and a plane is
// nowhere deeper than at the nodes or points. They are not on the ground,
// so that no tread lies between them and the plate.

#include <algorithm>
#include <cmath>
#include <utility>

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/quantities/penetration_between_points.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/problem/parameters.h>
#include <biface/problem/shell_model.h>

#include <tests.h>

using namespace dealii;
using namespace Biface;

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Parameters       parameters;
  ParameterHandler prm;
  read_parameters(
    DATA_DIR "/squeezed_plate.prm", {}, MPI_COMM_WORLD, parameters, prm);
  const auto mesh = make_shell_mesh(parameters, MPI_COMM_WORLD);

  // the plate with cells of 5 is 2 thick; the bar is over the middle of a cell
  const double radius = 8, cell = 5, face = 1,
               sagitta = radius - std::sqrt(radius * radius - cell * cell / 4);
  for (const auto &[pushed, points_per_side] :
       {std::pair(1e-9, 0U), std::pair(0.3, 0U), std::pair(0.3, 2U)})
    {
      ContactParameters laws;
      laws.condition.points_per_side = points_per_side;
      laws.tread.height              = 1;
      laws.tread.modulus             = 1;
      BodyParameters bar, plane;
      bar.name        = "bar";
      bar.shape       = BodyParameters::Shape::cylinder;
      bar.radius      = radius;
      bar.point       = Point<3>(7.5, 0, face + radius - sagitta);
      plane.name      = "plane";
      bar.direction   = Tensor<1, 3>({0, 0, 1});
      plane.direction = bar.direction;
      plane.point     = Point<3>(0, 0, face - pushed);
      bar.point[2] -= pushed;
      const ContactInteraction contact(*mesh, laws, {bar, plane});
      const State              state = contact.unloaded_state();
      Loads                    loads;
      for (const unsigned int i : {1, 2})
        loads.place(i,
                    {contact.pairs[i]->moving_body.after_motions(
                       {0.}, [](const RigidBody &body) { return body; }),
                     contact.pairs[i]->laws()});
      const auto of_bar =
                   penetration_between_points(*contact.pairs[1], state, loads),
                 of_plane =
                   penetration_between_points(*contact.pairs[2], state, loads);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        continue;
      // from the circle through the nodes or points
      const double distance = cell / 2 / std::max(1U, points_per_side),
                   height   = radius - sagitta - pushed,
                   at_point = std::hypot(distance, height) - radius,
                   middle   = height - radius;
      check_small("bar", of_bar.depth - (at_point - middle), 1e-9, sagitta);
      check_small(
        "part of the thickness", of_bar.relative - of_bar.depth / 2, 1e-12);
      check_small("plane", of_plane.depth, 1e-12);
    }
}
