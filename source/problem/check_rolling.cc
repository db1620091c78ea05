// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/contact/rolling.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  std::vector<bool>
  Parameters::rolling_stages() const
  {
    // in each stage, and at its end
    std::vector<bool> rolling, at_end;
    // the velocities at the end of each; none if they are computed
    using Velocity = std::optional<double>;
    std::vector<Velocity> turning, moving;
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage &stage      = stages[i];
        const auto   before     = stage_before(stages, i);
        const bool   begins     = stage.rolls(LoadLevel());
        const bool   rolled     = before && at_end[*before];
        const auto   at_its_end = [&](const Velocity              &given,
                                    const std::vector<Velocity> &all) {
          return given ? given : (before ? all[*before] : Velocity(0));
        };
        turning.push_back(stage.prescribes_axle_moment() || stage.slip_ratio
                            ? Velocity()
                            : at_its_end(stage.angular_velocity, turning));
        moving.push_back(at_its_end(stage.ground_velocity, moving));
        // a velocity that is computed may be anything but zero
        const bool stops =
          turning.back().value_or(1) == 0 && moving.back().value_or(1) == 0;
        rolling.push_back(begins || rolled);
        at_end.push_back(begins || (rolled && !stops));
      }
    return rolling;
  }


  namespace
  {
    /** Check the slip ratio and the axle moment of a stage. */
    void
    check_spin(const std::vector<Stage> &stages, const unsigned int i)
    {
      const Stage      &stage   = stages[i];
      const std::string section = "Stage " + std::to_string(i + 1);
      if (!stage.prescribes_axle_moment() && stage.axle_moment != 0)
        throw InputError(section + "/Axle moment",
                         number_to_string(stage.axle_moment),
                         "it needs 'Control = axle moment' or 'foundation "
                         "force and axle moment'");
      if (!stage.slip_ratio)
        return;
      const auto refuse = [&](const std::string &why) {
        throw InputError(
          section + "/Slip ratio", number_to_string(*stage.slip_ratio), why);
      };
      if (stage.angular_velocity)
        refuse("it must be 'none' with a given 'Angular velocity'");
      if (!stage.contact)
        refuse("it needs 'Contact = true'");
      if (stage.prescribes_axle_moment())
        refuse("it must be 'none' with 'Control = " + stage.control_name() +
               "'");
      // along the way to the stage, not in the order of the file
      auto free = stage_before(stages, i);
      while (free && !stages[*free].ends_free_rolling())
        free = stage_before(stages, *free);
      if (!free)
        refuse("an earlier stage must end in free rolling, with 'Control = "
               "axle moment' and 'Axle moment = 0', since it gives the rolling "
               "radius");
    }
  } // namespace


  void
  Parameters::check_inclination(const std::string &section,
                                const double       angle) const
  {
    const auto refuse = [&](const std::string &why) {
      throw InputError(
        section + "/Inclination angle", number_to_string(angle), why);
    };
    if (!(std::abs(angle) < 90))
      refuse("it must lie between -90 and 90");
    if (surface.type != ReferenceSurface::Parameters::Type::revolution)
      refuse("it must be 0 unless 'Surface/Type = surface of revolution'");
    const Tensor<1, 3> &direction = contact.body.line.direction;
    const auto          is_steep  = [&]() {
      const WheelAxes    axes(direction);
      const double       radians = angle * numbers::PI / 180;
      const Tensor<1, 3> down =
        std::cos(radians) * direction / direction.norm() -
        std::sin(radians) *
          cross_product_3d(axes.forward, direction / direction.norm());
      return !WheelAxes::fit(down) || down * direction <= 0;
    };
    if (!WheelAxes::fit(direction) || is_steep())
      refuse(
        "the ground must not be nearly parallel to the y axis, the axle of "
        "the wheel");
  }


  void
  Parameters::check_transient_rolling(const std::string &section,
                                      const Stage       &stage,
                                      const bool         rolls) const
  {
    const auto need = [&](const bool is_given, const std::string &what) {
      if (!is_given)
        throw InputError(
          section + "/Transient rolling", "true", "it must be 'false' " + what);
    };
    need(rolls && stage.contact,
         "unless the wheel rolls, with 'Contact = true'");
    need(contact.friction.in_rolling == FrictionInRolling::bristles,
         "without 'Contact/Rolling friction = bristles'");
    need(!friction_in(stage).is_zero(), "without friction");
    need(stage.duration > 0, "without a positive 'Duration'");
    need(stage.control != ControlKind::displacement &&
           stage.control != ControlKind::arc_length,
         "with 'Control = " + stage.control_name() + "'");
    need(stage.theory == StrainTheory::nonlinear,
         "with 'Strain theory = linear'");
    need(sensitivities.entries.empty(), "with 'Sensitivities'");
    need(heat.temperatures == RollingHeat::Parameters::Temperatures::given,
         "without 'Heat/Temperatures = given'");
  }


  void
  Parameters::check_rolling() const
  {
    const std::vector<bool> rolling = rolling_stages();
    // at the end of each stage
    std::vector<bool>   turned;
    std::vector<double> inclined;
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage      &stage   = stages[i];
        const std::string section = "Stage " + std::to_string(i + 1);
        const auto        before  = stage_before(stages, i);
        check_spin(stages, i);
        turned.push_back(stage.wheel_turn ? *stage.wheel_turn != 0
                                          : before && turned[*before]);
        if (stage.wheel_turn.value_or(0) != 0 &&
            surface.type != ReferenceSurface::Parameters::Type::revolution)
          throw InputError(section + "/Wheel turn",
                           number_to_string(*stage.wheel_turn),
                           "it must be 0 unless 'Surface/Type = surface of "
                           "revolution'");
        inclined.push_back(stage.inclination_angle.value_or(
          before && !stage.from_prestress ? inclined[*before] : 0));
        if (inclined.back() != 0)
          check_inclination(section, inclined.back());
        if (stage.transient_rolling)
          check_transient_rolling(section, stage, rolling[i]);
        if (!rolling[i])
          continue;

        for (const BodyParameters &body : bodies)
          {
            const bool is_there =
              std::count(stage.bodies.begin(), stage.bodies.end(), body.name) >
              0;
            if (!is_there || body.is_about_y_axis())
              continue;
            if (!stage.transient_rolling)
              throw InputError(
                section + "/Bodies",
                body.name,
                "with steady rolling it must be a body of revolution about "
                "the y axis, the axle, that moves along it or turns about it "
                "only, with 'Friction = 0'");
            if (!body.friction.is_zero())
              throw InputError(section + "/Bodies",
                               body.name,
                               "where the wheel rolls it must have 'Friction = "
                               "0'");
          }
        if (contact.condition.points_per_side > 0 && stage.contact)
          throw InputError("Contact/Points in cells",
                           std::to_string(contact.condition.points_per_side),
                           "it must be 0 for the wheel that rolls in stage " +
                             std::to_string(i + 1));
        if (turned.back() || (before && turned[*before]))
          throw InputError(section + "/Wheel turn",
                           stage.wheel_turn
                             ? number_to_string(*stage.wheel_turn)
                             : "unchanged",
                           "it must be 0, also at the start, in a stage with "
                           "steady rolling");
        if (!mesh.closed ||
            surface.type != ReferenceSurface::Parameters::Type::revolution)
          {
            const auto refuse = [&](const std::string &entry,
                                    const std::string &value) {
              throw InputError(section + "/" + entry,
                               value,
                               "it needs 'Surface/Type = surface of "
                               "revolution' and 'Mesh/Closed in alpha_2 = "
                               "true'");
            };
            if (stage.angular_velocity.value_or(0) != 0)
              refuse("Angular velocity",
                     number_to_string(*stage.angular_velocity));
            if (stage.ground_velocity.value_or(0) != 0)
              refuse("Ground velocity",
                     number_to_string(*stage.ground_velocity));
            refuse("Control", stage.control_name());
          }
        if (stage.n_buckling > 0)
          throw InputError(section + "/Buckling",
                           std::to_string(stage.n_buckling),
                           "it must be 0 where the wheel rolls or spins");
        if (!stage.contact)
          {
            if (stage.ground_velocity.value_or(0) != 0)
              throw InputError(section + "/Ground velocity",
                               number_to_string(*stage.ground_velocity),
                               "it needs 'Contact = true'");
            continue;
          }
        const Tensor<1, 3> &direction = contact.body.line.direction;
        using Shape                   = GroundParameters::Shape;
        if (contact.body.shape == Shape::sphere)
          throw InputError("the wheel rolls in stage " + std::to_string(i + 1) +
                           ", which needs 'Contact/Foundation = plane' or "
                           "'drum'.");
        if (!WheelAxes::fit(direction))
          throw InputError("Contact/Direction",
                           vector_to_string(direction),
                           "it must not be nearly parallel to the y axis, "
                           "the axle of the wheel");
        // between the axle and the axis of a drum
        constexpr double   min_cosine = 0.1;
        const Tensor<1, 3> axis       = contact.body.drum.axis;
        if (contact.body.shape == Shape::drum &&
            std::abs(axis[1]) < min_cosine * axis.norm())
          throw InputError("Contact/Drum/Axis",
                           vector_to_string(axis),
                           "it must not be nearly orthogonal to the y axis, "
                           "the axle of the wheel");
      }
  }
} // namespace Biface
