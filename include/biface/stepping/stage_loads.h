// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_loads_h
#define biface_stepping_stage_loads_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>

#include <biface/stepping/load_level.h>

namespace Biface
{
  /** Add a value that may not be set to an archive, or read it from one. */
  template <class Archive, class Value>
  void
  serialize_optional(Archive &archive, std::optional<Value> &value)
  {
    bool            given   = value.has_value();
    Value           content = value.value_or(Value());
    archive &given &content;
    value = (given ? std::optional<Value>(content) : std::nullopt);
  }


  /** The loads and motions at the end of a stage; those that are not set are
   * those at its start. */
  struct StageLoads : LoadsOf<std::optional>
  {
    /** Whether the gas that exerts the pressure is sealed in, see Gas. */
    bool sealed = false;
    /** Whether there is a foundation. */
    bool contact = false;
    /** Instead of the angular velocity, see Stage::with_angular_velocity(). */
    std::optional<double> slip_ratio;
    /** The coefficient of friction, see FrictionLaw; empty for that of the
     * section 'Contact'. */
    std::string friction;
    /** Whether the nodes in contact at the start of the stage cannot slip. */
    bool glued = false;

    /** The loads at the end of the stage for given loads at its start. */
    LoadLevel
    end(const LoadLevel &start) const;

    /** @param section the name of the section of the stage. */
    void
    add_parameters(dealii::ParameterHandler &prm, const std::string &section);

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    /** Check that the foundation slides across its direction of travel. Throws
     * InputError. */
    void
    check_slide(const std::string          &section,
                const dealii::Tensor<1, 3> &direction) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for_each_load(
        [&archive](auto &load) { serialize_optional(archive, load); }, *this);
      serialize_optional(archive, slip_ratio);
      archive &sealed &contact &friction &glued;
    }

  private:
    void
    check_without_contact(const std::string &section) const;
  };
} // namespace Biface

#endif
