// SPDX-License-Identifier: LGPL-2.1-or-later

#include <set>

#include <biface/input/entry_declarations.h>
#include <biface/laminate/failure_criteria.h>
#include <biface/laminate/layup.h>
#include <biface/output/requested_criteria.h>

namespace Biface
{
  using namespace dealii;

  void
  FailureCriteria::add_parameters(EntryDeclarations &prm)
  {
    prm.declare_entry("Failure criteria",
                      "",
                      Patterns::MultipleSelection("maximum stress|Tsai-Wu"),
                      "List of criteria ('maximum stress', 'Tsai-Wu') whose "
                      "failure indices are written with the stresses of plies; "
                      "they need the strengths of the materials. In 'Tsai-Wu' "
                      "the interaction F_12 of the stresses along and across "
                      "the fibers is -sqrt(F_11 F_22)/2.",

                      // they have columns in history.csv
                      RestartChange::never);
    prm.add_action("Failure criteria", [this](const std::string &text) {
      const auto asked = [&](const std::string &name) {
        return text.find(name) != std::string::npos;
      };
      maximum_stress = asked("maximum stress");
      tsai_wu        = asked("Tsai-Wu");
    });
  }


  std::vector<FailureCriterion>
  FailureCriteria::requested() const
  {
    std::vector<FailureCriterion> criteria;
    if (maximum_stress)
      criteria.push_back(
        {"maximum stress", "maximum_stress", &maximum_stress_index});
    if (tsai_wu)
      criteria.push_back({"Tsai-Wu", "tsai_wu", &tsai_wu_index});
    return criteria;
  }


  std::vector<std::string>
  FailureCriteria::warnings(const Layup &layup) const
  {
    std::vector<std::string> sentences;
    if (!maximum_stress && !tsai_wu)
      return sentences;
    std::set<std::string> bare;
    for (const PlyDescription &ply : layup.get_plies())
      if (!ply.material.strengths && bare.insert(ply.material.name).second)
        sentences.push_back("The material '" + ply.material.name +
                            "' has no strengths (X_t to S): its plies have "
                            "no failure index.");
    return sentences;
  }
} // namespace Biface
