// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/stepping/controls/force_control.h>

namespace Biface
{
  namespace
  {
    /** How far the foundation travels beyond the first touch, to get into
     * contact. */
    double
    beyond_touching(const ShellMesh &mesh)
    {
      return 0.01 * mesh.thickness();
    }


    /** The force on the foundation is prescribed; the load parameter is the
     * travel of the foundation. */
    class ForceEquation : public ControlEquation
    {
    public:
      /** @param force the compressive force. */
      explicit ForceEquation(const double force)
        : ControlEquation(unit_travel()), force(force)
      {}

      double
      parameter_change(const Iteration  &iteration,
                       const LA::Vector &dV_R,
                       const LA::Vector &dV_q) const override
      {
        const ContactInteraction &contact = iteration.contact;
        // without contact, travel until it touches
        if (contact.count_active(iteration.state) == 0)
          return contact.travel_to_touch(iteration.state, iteration.loads) +
                 beyond_touching(contact.mesh);
        const auto F = contact.force(iteration.state, iteration.loads);
        return (force - F.value - F.gradient * dV_R) /
               (F.gradient * dV_q + F.per_travel);
      }

      double
      violation(const Iteration &iteration) const override
      {
        const double now =
          iteration.contact.force(iteration.state, iteration.loads).value;
        return std::abs(now - force) / std::abs(force);
      }

    private:
      static LoadRates
      unit_travel()
      {
        LoadRates rates;
        rates.travel = 1;
        return rates;
      }

      const double force;
    };
  } // namespace


  void
  ForceControl::check(const std::string &section,
                      const KnownStart & /*start*/) const
  {
    if (!stage.contact)
      throw InputError(
        section + "/Control", "foundation force", "it needs 'Contact = true'");
    if (stage.travel.value_or(0) != 0)
      throw InputError(section + "/Travel",
                       number_to_string(*stage.travel),
                       "with 'Control = foundation force' it must not be set: "
                       "the travel is computed");
    check_positive(section + "/Force", stage.force);
  }


  Control::KnownStart
  ForceControl::known_end(const KnownStart &start) const
  {
    KnownStart end = EqualSteps::known_end(start);
    end.travel.reset();
    return end;
  }


  void
  ForceControl::begin(const Equilibrium &from)
  {
    EqualSteps::begin(from);
    start_force = from.contact.force(from.state, from.loads(from.level)).value;
  }


  Control::Trial
  ForceControl::propose(const Equilibrium &from) const
  {
    const double part = next();
    Trial        trial;
    trial.level = [this, part](const double travel) {
      LoadLevel level = level_at(part);
      level.travel    = travel;
      return level;
    };
    trial.mu = from.level.travel;
    if (from.contact.count_active(from.state) == 0)
      trial.mu +=
        from.contact.travel_to_touch(from.state, from.loads(from.level)) +
        beyond_touching(from.equations.mesh);
    trial.equation = std::make_shared<const ForceEquation>(force_at(part));
    trial.size     = part - fraction;
    return trial;
  }


  double
  ForceControl::force_at(const double fraction) const
  {
    return start_force + fraction * (stage.force - start_force);
  }


  Control::Memory
  ForceControl::get_memory() const
  {
    Memory memory                 = EqualSteps::get_memory();
    memory.numbers["start force"] = start_force;
    return memory;
  }


  void
  ForceControl::restore(const Memory &memory)
  {
    EqualSteps::restore(memory);
    start_force = memory.numbers.at("start force");
  }


  void
  ForceControl::change_way(const Stage &now, const LoadLevel &reached)
  {
    const double     force = force_at(fraction);
    std::vector<Way> ways  = ways_of_loads(reached, now.end(start));
    // the travel is unknown
    ways.back() = {start_force, force, now.force};
    if (!go_on_from(common_part(ways), reached))
      start_force = force;
  }
} // namespace Biface
