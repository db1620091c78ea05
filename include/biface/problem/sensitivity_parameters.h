// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_sensitivity_parameters_h
#define biface_problem_sensitivity_parameters_h

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Biface
{
  class EntryDeclarations;
  struct Parameters;


  /** What SensitivityAnalysis computes, and the perturbed parameters that it
   * needs. */
  struct SensitivityParameters
  {
    /** The entries by which derivatives are taken, see
     * parse_design_variables(). */
    std::string              entries;
    std::vector<std::string> outputs;
    /** The numbers of the stages at whose ends derivatives are computed; empty
     * for the last one. */
    std::vector<unsigned int> stages;
    /** The change of an entry relative to its value; chosen by the program if
     * not set. */
    std::optional<double> step;

    /** What a change of an entry changes in the mesh. */
    enum class MeshChange
    {
      nothing,
      plies,
      anything
    };

    /** A design variable with the parameters of a run in which it is
     * different. */
    struct Change
    {
      std::string name;
      double      value;
      /** The difference of the two values, and the parameters with the lower
       * and the higher one. */
      double                                           step;
      std::array<std::shared_ptr<const Parameters>, 2> parameters;
      /** The parts of the mesh that may differ. */
      MeshChange mesh_change;
    };

    /** The changes, one for each of the entries, see read_parameters(). */
    std::vector<Change> changes;

    void
    add_parameters(EntryDeclarations &prm);

    /** Throws InputError if a value is invalid. */
    void
    check(const unsigned int n_stages) const;

    /** Whether derivatives are computed at the end of a stage. */
    bool
    is_wanted(const unsigned int position, const unsigned int n_stages) const;
  };
} // namespace Biface

#endif
