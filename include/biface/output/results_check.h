// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_results_check_h
#define biface_output_results_check_h

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Biface
{
  struct Loads;
  class ShellEquations;
  struct State;
  struct StepReport;


  /**
   * What an engineer checks before results are used: whether the force on the
   * ground is plausible, whether the mesh resolves the footprint, and
   * whether penetration and errors of the mesh are small beside the results.
   */
  class ResultsCheck
  {
  public:
    /** A check of the steps of one run. The arguments are kept by reference. */
    ResultsCheck(const ShellEquations     &equations,
                 const ContactInteraction &contact);

    /**
     * Look at a converged step. Must be called on all ranks.
     *
     * @return warnings, each at most once a stage: of a penetration of more
     * than 1 % of the thickness, or of a tread compressed by more than 30 % of
     * its height, of an error of the interpolation of rigid
     * motions, see forces_on_shell(), of more than 1 % of the largest reaction,
     * and of strains below @p least_stable_strain or shear strains above 1;
     * once, of flat cells between frames that differ by more than 30 degrees,
     * see Formulation.
     */
    std::vector<std::string>
    add(const StepReport &report, const State &state);

    /** The figures of the last step in two lines: the force on the ground
     * beside the pressure on the footprint, with the cells in the footprint, or
     * without contact the largest reaction beside the loads; then penetration,
     * balance of forces and error of the interpolation. Empty without steps. */
    std::string
    summary() const;

  private:
    /** The place where the penetration is largest beside the thickness or, of a
     * tread, the compression beside its height. */
    struct Penetration
    {
      double depth     = 0;
      double thickness = 1;

      double
      relative() const
      {
        return depth / thickness;
      }
    };

    /** The resultants of the forces on the shell. */
    struct Balance
    {
      double loads = 0, largest_reaction = 0, interpolation = 0;
      /** The sum of the magnitudes of all loads on nodes, which is the scale
       * where the loads balance themselves and reactions are round-off. */
      double nodal_loads = 0;
      /** The remainder of forces and moments, beside the largest of them. */
      double error = 0;
      /** The sum of the magnitudes of all internal forces on nodes, which is
       * the scale of their round-off. */
      double internal = 0;
    };

    struct Figures
    {
      bool   in_contact = false;
      double pressure = 0, force = 0, footprint_area = 0;
      /** The number of grid lines of each coordinate with nodes in contact. */
      std::array<unsigned int, 2> n_lines{};
      Penetration                 penetration;
      Balance                     balance;
    };

    Penetration
    largest_penetration(const State &state, const Loads &loads) const;

    std::array<unsigned int, 2>
    lines_in_contact(const State &state) const;

    Balance
    balance(const StepReport &report) const;

    const ShellEquations     &equations;
    const ContactInteraction &contact;
    std::optional<Figures>    last;
    /** The stages in which each of the warnings was given. */
    std::set<unsigned int> warned_of_penetration, warned_of_interpolation,
      warned_of_strains;
    /** Whether the cells have been looked at; they do not change. */
    bool checked_cells = false;
  };
} // namespace Biface

#endif
