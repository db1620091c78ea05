// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <string>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/problem/parameters.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/stiffness_of_motions.h>

namespace Biface
{
  namespace
  {
    /** Check the motions that forces find in a stage with inertia. */
    void
    check_masses(const Stage &stage, const std::string &section)
    {
      for (const MotionByForce &item : stage.motions_by_force)
        {
          if (item.moves_supports())
            continue;
          // its work over a step is known for translations alone
          if (item.motion.turn != 0)
            throw InputError(section + "/Forces on bodies",
                             item.name(),
                             "with 'Inertia = true' the motion must be a "
                             "translation without a turn");
          if (item.motion.suspension.mass == 0)
            throw InputError(section + "/Forces on bodies",
                             item.name(),
                             "with 'Inertia = true' it must have a mass in "
                             "'Masses' of the body");
        }
      for (const auto &[name, velocity] : stage.velocities_of_bodies)
        {
          const auto &items = stage.motions_by_force;
          if (std::none_of(items.begin(),
                           items.end(),
                           [&, &wanted = name](const MotionByForce &item) {
                             return item.name() == wanted &&
                                    !item.moves_supports();
                           }))
            throw InputError(
              section + "/Initial velocities of bodies",
              name,
              "it must be a body in 'Forces on bodies'; supports "
              "move as 'Initial velocity' says");
          check_finite(section + "/Initial velocities of bodies", velocity);
        }
    }
  } // namespace


  bool
  Parameters::has_inertia() const
  {
    return std::any_of(stages.begin(), stages.end(), [](const Stage &stage) {
      return stage.inertia;
    });
  }


  void
  Parameters::check_inertia_of_wheel(const std::string &section,
                                     const Stage       &stage) const
  {
    // it would brake the rotation
    if (stage.damping_in_time.of_mass > 0)
      throw InputError(section + "/Mass damping",
                       number_to_string(stage.damping_in_time.of_mass),
                       "it must be 0 with 'Inertia = true' where the wheel "
                       "rolls or spins");
    if (stage.moment_of_inertia > 0 && !stage.prescribes_axle_moment())
      throw InputError(section + "/Moment of inertia",
                       number_to_string(stage.moment_of_inertia),
                       "it needs 'Control = axle moment'");
    if (stage.contact && !friction_in(stage).is_zero() &&
        !stage.transient_rolling)
      throw InputError(section + "/Transient rolling",
                       "false",
                       "it must be 'true' with 'Inertia = true' where the "
                       "wheel rolls with friction");
  }


  void
  Parameters::check_inertia() const
  {
    const std::vector<bool> rolls = rolling_stages();
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const Stage &stage = stages[i];
        if (!stage.inertia)
          continue;
        const std::string section = "Stage " + std::to_string(i + 1);
        const auto        refuse  = [&](const bool         wrong,
                                const std::string &entry,
                                const std::string &value,
                                const std::string &allowed) {
          if (wrong)
            throw InputError(entry,
                             value,
                             "it must be " + allowed +
                               " with 'Inertia = true' in stage " +
                               std::to_string(i + 1));
        };
        refuse(!(stage.duration > 0),
               section + "/Duration",
               number_to_string(stage.duration),
               "positive");
        refuse(stage.control != ControlKind::load &&
                 stage.control != ControlKind::axle_moment,
               section + "/Control",
               stage.control_name(),
               "'load' or 'axle moment'");
        check_masses(stage, section);
        refuse(stage.theory == StrainTheory::linear,
               section + "/Strain theory",
               "linear",
               "'nonlinear'");
        refuse(stage.damping > 0,
               section + "/Damping",
               number_to_string(stage.damping),
               "0, or 'Mass damping',");
        refuse(stage.locates_critical_points(),
               section + "/Critical points",
               stage.critical_points_name(),
               "'report' or 'ignore'");
        refuse(stage.n_modes > 0,
               section + "/Modes",
               std::to_string(stage.n_modes),
               "0, as there is no equilibrium,");
        refuse(stage.n_buckling > 0,
               section + "/Buckling",
               std::to_string(stage.n_buckling),
               "0, as there is no equilibrium,");
        // its resultants are no derivatives of an energy
        refuse(laminate.law == ThicknessLaw::asymmetric,
               "Laminate/Thickness law",
               "asymmetric",
               "'symmetric'");
        // its forces on the nodes have no energy
        refuse((stage.contact || !stage.bodies.empty()) &&
                 contact.condition.mortar_matrix == MortarMatrix::consistent,
               "Contact/Multiplier mass",
               "consistent",
               "'lumped'");
        // the results are in axes that turn with the wheel, in which there
        // would be forces
        for (const auto &[entry, angle] :
             {std::make_pair("/Wheel turn", stage.wheel_turn),
              std::make_pair("/Inclination angle", stage.inclination_angle)})
          refuse(angle.has_value(),
                 section + entry,
                 number_to_string(angle.value_or(0)),
                 "'unchanged'");
        // springs that change their stiffness do work
        const auto before      = stage_before(stages, i);
        const bool had_contact = before && (stages[*before].contact ||
                                            !stages[*before].bodies.empty());
        refuse(had_contact && stages[*before].laws.penalty_stiffness !=
                                stage.laws.penalty_stiffness,
               section + "/Regularization",
               number_to_string(stage.laws.penalty_stiffness.value_or(0)),
               "that of the stage before");
        refuse(mesh.n_coarse > 0,
               "Mesh/Coarse meshes",
               std::to_string(mesh.n_coarse),
               "0");
        refuse(!sensitivities.entries.empty(),
               "Sensitivities/Entries",
               sensitivities.entries,
               "empty");
        if (rolls[i])
          check_inertia_of_wheel(section, stage);
        else
          refuse(stage.moment_of_inertia > 0,
                 section + "/Moment of inertia",
                 number_to_string(stage.moment_of_inertia),
                 "0 where no wheel rolls");
        for (const PlyParameters &ply : laminate.plies)
          for (const MaterialParameters &material : materials)
            if (material.name == ply.material && material.relaxes())
              throw InputError(section + "/Inertia",
                               "true",
                               "it must be 'false' with the material '" +
                                 material.name +
                                 "', whose stresses relax; 'Stiffness "
                                 "damping' is a simpler law");
      }
  }
} // namespace Biface
