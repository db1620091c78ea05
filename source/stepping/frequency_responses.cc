// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/state/loads.h>
#include <biface/stepping/frequency_responses.h>
#include <biface/stepping/stage_run.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  namespace
  {
    /** The factors of all loads per unit of the factor with a name, or of the
     * common one. */
    std::vector<double>
    rates_of_factors(const Stage &stage, const std::string &name)
    {
      StageLoads   unit;
      const bool   is_common = (name == "load factor");
      NamedFactors own;
      if (is_common)
        for (const auto &[other, factor] : stage.own_factors)
          own.emplace_back(other, 0);
      else
        own = {{name, 1}};
      unit.common_factor = (is_common ? 1 : 0);
      unit.own_factors   = own;
      unit.set_factors(stage.names_of_factors);
      std::vector<double> rates;
      for (const std::optional<double> &factor : unit.factors)
        rates.push_back(factor.value_or(0));
      return rates;
    }


    Excitation
    excitation_of(const std::string        &name,
                  const Stage              &stage,
                  const Loads              &loads,
                  const ContactInteraction &contact)
    {
      Excitation result;
      result.name = name;
      if (const auto motion = StageResponse::motion(name, stage))
        {
          result.direction = motion->second;
          for (const ContactPair *pair : contact.present(loads))
            // what stands on the ground moves with it
            if (motion->first == (pair->number == 0 ? "ground" : pair->name) ||
                (motion->first == "ground" && pair->moving_body.is_on_ground()))
              result.bodies.insert(pair->number);
          return result;
        }
      LoadRates rates;
      if (name == "pressure")
        {
          rates.pressure = 1;
          rates.factors.assign(loads.factors.size(), 0.);
        }
      else
        rates.factors = rates_of_factors(stage, name);
      result.loads = rates;
      return result;
    }
  } // namespace


  void
  FrequencyResponses::end_stage(const StageRun &run, StepReport &report)
  {
    const Stage &stage = run.stage;
    if (!stage.vibrates())
      return;
    HarmonicResponse::Request request;
    request.frequencies = stage.frequencies;
    request.losses      = {stage.loss_factor,
                           stage.damping_in_time.of_mass,
                           stage.damping_in_time.of_stiffness,
                           report.level.temperature};
    for (const std::string &name : stage.excitations)
      request.excitations.push_back(
        excitation_of(name, stage, *report.loads, run.contact));
    auto result = std::make_shared<const FrequencyResponse>(
      response.compute(run.state, *report.loads, request));
    out << "  response at " << result->frequencies.size() << " frequencies to "
        << result->excitations.size()
        << (result->excitations.size() == 1 ? " excitation" : " excitations")
        << std::endl;
    if (result->n_failed > 0)
      out << "  Warning: the response of " << stage.name << " was not found at "
          << result->n_failed << " frequencies: " << result->message << "."
          << std::endl;
    report.response = result;
  }
} // namespace Biface
