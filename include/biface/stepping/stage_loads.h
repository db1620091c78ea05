// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_loads_h
#define biface_stepping_stage_loads_h

#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/base/serialize_optional.h>
#include <biface/contact/contact_laws_of_stage.h>
#include <biface/model/state/load_rates.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  class EntryDeclarations;


  /** Loads or supports as the entry 'Load factors' names them, each with its
   * factor; not set for 'unchanged'. */
  using NamedFactors =
    std::vector<std::pair<std::string, std::optional<double>>>;

  /** Read a comma-separated list 'name: factor'. Throws InputError if it is
   * malformed. */
  NamedFactors
  parse_load_factors(const std::string &entry, const std::string &text);


  /** The factors at given positions among others, see
   * StageLoads::positions_in(). */
  template <typename Number>
  std::vector<Number>
  rearranged(const std::vector<Number>       &factors,
             const std::vector<unsigned int> &positions)
  {
    std::vector<Number> result;
    for (const unsigned int position : positions)
      result.push_back(factor_at(factors, position));
    return result;
  }


  /** The loads and motions at the end of a stage; those that are not set are
   * those at its start. */
  struct StageLoads : LoadsOf<std::optional>
  {
    /** The common factor and those of named loads, from which set_factors()
     * sets the factors of all loads. */
    std::optional<double> common_factor;
    NamedFactors          own_factors;
    /** For each of the factors, the names in 'Load factors' of any stage that
     * include its loads, from the most general one to that of the factor. */
    std::vector<std::vector<std::string>> names_of_factors = {{}};
    /** Whether the gas that exerts the pressure is sealed in, see Gas. */
    bool sealed = false;
    /** The viscous damping, a force per area against a motion of 1 over the
     * whole stage, see ViscousDamping. Unit: force/volume. */
    double damping = 0;
    /** Whether there is a ground. */
    bool contact = false;
    /** The slip ratio at the end of the stage, given instead of the angular
     * velocity, see with_angular_velocity(). */
    std::optional<double> slip_ratio;
    /** The names of the bodies that are there beside the ground. */
    std::vector<std::string> bodies;
    /** The laws of contact of the stage, where they are not those of the
     * section 'Contact'. */
    ContactLawsOfStage laws;
    /** The duration of the stage, from which the time at its end follows. Unit:
     * time. */
    double duration = 0;

    /** Set the factors of all loads: of several names that include a load, the
     * last one counts.
     * @param names see names_of_factors. */
    void
    set_factors(const std::vector<std::vector<std::string>> &names);

    /** For each of the factors, its position among those of another run, in
     * which the same loads had that factor. */
    std::vector<unsigned int>
    positions_in(const StageLoads &other) const;

    /** The loads at the end of the stage for given loads at its start. */
    LoadLevel
    end(const LoadLevel &start) const;

    /** Declare the entries of the loads. */
    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check(const std::string &section) const;

    /** Check that the ground slides across its direction of travel. Throws
     * InputError. */
    void
    check_slide(const std::string          &section,
                const dealii::Tensor<1, 3> &direction) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      serialize_number_of_factors(archive, *this);
      for_each_load(
        [&archive](auto &load) { serialize_optional(archive, load); }, *this);
      archive &names_of_factors;
      serialize_optional(archive, slip_ratio);
      serialize_optional(archive, laws.friction);
      serialize_optional(archive, laws.penalty_stiffness);
      serialize_optional(archive, laws.tangential_stiffness);
      archive &sealed &damping &contact &bodies &laws.glued &duration;
    }

  private:
    void
    check_without_contact(const std::string &section) const;
  };
} // namespace Biface

#endif
