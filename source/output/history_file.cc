// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include <biface/contact/rigid_body.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/state/loads.h>
#include <biface/model/time/inertia.h>
#include <biface/output/csv.h>
#include <biface/output/fiber_tension.h>
#include <biface/output/history_file.h>
#include <biface/output/ply_results.h>
#include <biface/output/reaction_columns.h>
#include <biface/stepping/step_report.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Whether the shell is a surface of revolution about the axle. */
    bool
    is_wheel(const ShellMesh &mesh)
    {
      return mesh.get_surface().get_periodicity()[1] > 0;
    }


    /** A ratio, zero where it means nothing. */
    double
    ratio(const double numerator, const double denominator)
    {
      return denominator > 0 ? numerator / denominator : 0.;
    }


    /** Empty fields while the body is not there. */
    HistoryGroup
    group_of_body(const std::string &name)
    {
      const std::vector<std::string> of_body{"contact_nodes",
                                             "slipping_nodes",
                                             "contact_area",
                                             "max_pressure",
                                             "u_x",
                                             "u_y",
                                             "u_z",
                                             "turn_x",
                                             "turn_y",
                                             "turn_z"};
      HistoryGroup                   group;
      for (const std::string &column : of_body)
        group.columns.push_back(with_underscores(name) + "_" + column);
      group.values = [name,
                      n = of_body.size()](const HistoryGroup::Step &step) {
        std::vector<std::optional<double>> values(n);
        const auto found = step.report.bodies.find(name);
        if (found == step.report.bodies.end())
          return values;
        const BodyReport &body = found->second;
        values[0]              = body.contact.n_nodes;
        values[1]              = body.contact.n_slipping;
        values[2]              = body.contact.area;
        values[3]              = body.contact.max_pressure;
        for (unsigned int i = 0; i < 3; ++i)
          {
            values[4 + i] = body.displacement[i];
            // degrees, as in the parameter file
            values[7 + i] = body.rotation[i] * 180 / numbers::PI;
          }
        return values;
      };
      return group;
    }


    /** Empty fields but for the time in stages without inertia.
     * @param with_time whether no other group has the time.
     * @param rolls whether the shell may be a wheel that rolls. */
    HistoryGroup
    group_of_motion(const bool with_time, const bool rolls)
    {
      HistoryGroup group;
      if (with_time)
        group.columns.push_back("time");
      for (const char *column : {"kinetic_energy",
                                 "contact_energy",
                                 "numerical_work",
                                 "contact_work",
                                 "energy_error",
                                 "momentum_x",
                                 "momentum_y",
                                 "momentum_z",
                                 "angular_momentum_x",
                                 "angular_momentum_y",
                                 "angular_momentum_z"})
        group.columns.push_back(column);
      if (rolls)
        group.columns.push_back("centrifugal_energy");
      group.values = [with_time, rolls, n = group.columns.size()](
                       const HistoryGroup::Step &step) {
        std::vector<std::optional<double>> values;
        const StepReport                  &report = step.report;
        if (with_time)
          values.emplace_back(report.level.time);
        if (const auto &motion = report.motion)
          {
            for (const double value : {motion->kinetic + motion->of_masses,
                                       motion->contact + motion->of_springs,
                                       report.work.numerical,
                                       report.work.contact,
                                       report.work.unbalanced})
              values.emplace_back(value);
            for (const Tensor<1, 3> &momentum :
                 {motion->momentum, motion->angular_momentum})
              for (unsigned int i = 0; i < 3; ++i)
                values.emplace_back(momentum[i]);
            if (rolls)
              values.emplace_back(motion->centrifugal);
          }
        // a shell at rest has no motion: its fields stay empty
        values.resize(n);
        return values;
      };
      return group;
    }
  } // namespace


  std::vector<HistoryGroup>
  history_groups(const FailureCriteria &criteria,
                 const ShellEquations  &equations,
                 const bool             with_volume)
  {
    using Step   = HistoryGroup::Step;
    using Values = std::vector<std::optional<double>>;

    const ShellMesh &mesh = equations.mesh;

    std::vector<HistoryGroup> groups{
      {{"approach",
        "force",
        "contact_nodes",
        "contact_area",
        "max_pressure",
        "iterations",
        "seconds",
        "pressure",
        "load_factor"},
       [](const Step &step) -> Values {
         const StepReport     &report  = step.report;
         const ContactSummary &contact = report.contact;
         // the pressure of the loads: in a sealed gas it follows from the
         // volume
         return {report.level.travel,
                 contact.force,
                 contact.n_nodes,
                 contact.area,
                 contact.max_pressure,
                 report.iterations,
                 report.seconds,
                 report.loads->pressure,
                 report.loads->factors[0]};
       }},
      {{"strain_energy"},
       [](const Step &step) -> Values {
         return {step.equations.strain_energy(step.state)};
       }},
      {{"load_work",
        "foundation_work",
        "friction_work",
        "damping_work",
        "slide_x",
        "slide_y",
        "slide_z",
        "turn",
        "slipping_nodes"},
       [](const Step &step) -> Values {
         const StepReport &report = step.report;
         return {report.work.loads,
                 report.work.ground,
                 report.work.friction,
                 report.work.damping,
                 report.level.slide[0],
                 report.level.slide[1],
                 report.level.slide[2],
                 report.level.turn,
                 report.contact.n_slipping};
       }}};
    // columns exist only where there is something to say, from the features of
    // the model alone: all steps must have the same ones
    if (with_volume)
      groups.push_back({{"volume"}, [](const Step &step) -> Values {
                          return {step.cavity->volume(step.state)};
                        }});
    if (const auto requested = criteria.requested(); !requested.empty())
      {
        std::vector<std::string> columns;
        for (const FailureCriterion &criterion : requested)
          for (const std::string what : {"index", "alpha_1", "alpha_2", "ply"})
            columns.push_back(criterion.column + '_' + what);
        groups.push_back(
          {columns, [](const Step &step) {
             Values values;
             for (const FailureMaximum &maximum : step.failure_maxima)
               // no ply has strengths: empty fields, as the columns are there
               if (std::isnan(maximum.index))
                 values.resize(values.size() + 4);
               else
                 values.insert(values.end(),
                               {maximum.index,
                                maximum.alpha[0],
                                maximum.alpha[1],
                                static_cast<double>(maximum.ply)});
             return values;
           }});
      }
    if (mesh.get_layup().relaxes())
      groups.push_back(
        {{"time", "temperature"}, [](const Step &step) -> Values {
           return {step.report.level.time, step.report.level.temperature};
         }});
    if (mesh.get_layup().has_slack_cords())
      groups.push_back(
        {{"slack_cords"}, [](const Step &step) -> Values {
           return {step.equations.internal_forces().slack_fraction(step.state)};
         }});
    groups.push_back(
      {{"footprint_length",
        "footprint_width",
        "footprint_area",
        "mean_pressure",
        "recovered_max_pressure",
        "load_ratio",
        "slipping_area",
        "weighted_pressure",
        "pressure_variation"},
       [](const Step &step) -> Values {
         const StepReport     &report    = step.report;
         const ContactSummary &contact   = report.contact;
         const Footprint      &footprint = report.footprint;
         return {footprint.length,
                 footprint.width,
                 footprint.area,
                 ratio(contact.force, footprint.area),
                 footprint.max_pressure,
                 ratio(contact.force, report.loads->pressure * footprint.area),
                 contact.slipping_area,
                 contact.weighted_pressure,
                 contact.pressure_variation};
       }});
    if (is_wheel(mesh))
      groups.push_back({{"loaded_radius", "wheel_turn", "inclination_angle"},
                        [](const Step &step) -> Values {
                          const auto &ground = step.report.loads->ground();
                          // the axle passes through the origin
                          return {ground ? ground->clearance(Point<3>()) : 0.,
                                  step.report.level.wheel_turn,
                                  step.report.level.inclination_angle};
                        }});
    if (Inertia::is_among(equations.get_terms()))
      groups.push_back(
        group_of_motion(!mesh.get_layup().relaxes(), mesh.grid.closed));
    const TensionMembers members(mesh.get_layup());
    if (members.exist())
      {
        std::vector<std::string> columns;
        for (const std::string what : {"", "_alpha_1", "_alpha_2", "_ply"})
          columns.push_back("max_" + members.name() + what);
        groups.push_back({columns, [](const Step &step) -> Values {
                            const MaximumTension maximum =
                              find_maximum_tension(step.equations, step.state);
                            return {maximum.value,
                                    maximum.alpha[0],
                                    maximum.alpha[1],
                                    static_cast<double>(maximum.ply)};
                          }});
      }
    if (!mesh.supported.motions.empty())
      groups.push_back({reaction_columns(mesh),
                        [](const Step &step) {
                          const std::vector<double> values =
                            reaction_values(step.equations.mesh,
                                            *step.report.loads,
                                            step.report.forces_of_bodies);
                          return Values(values.begin(), values.end());
                        },
                        true});
    for (const ForceTerm *term : equations.get_terms())
      if (term->source() == ForceTerm::Source::ground &&
          !term->other_body().empty())
        groups.push_back(group_of_body(term->other_body()));
    return groups;
  }


  std::string
  HistoryFile::header(const FailureCriteria &criteria,
                      const ShellEquations  &equations,
                      const bool             with_volume)
  {
    std::string text = "step,stage";
    for (const HistoryGroup &group :
         history_groups(criteria, equations, with_volume))
      for (const std::string &column : group.columns)
        text += "," + column;
    return text;
  }


  HistoryFile::HistoryFile(const FailureCriteria &criteria,
                           const Cavity          *cavity,
                           ResultsDirectory      &directory,
                           const ShellEquations  &equations)
    : StepTable("history.csv",
                header(criteria, equations, cavity != nullptr),
                1,
                directory,
                equations)
    , criteria(criteria)
    , cavity(cavity)
    , groups(history_groups(criteria, equations, cavity != nullptr))
  {}


  std::vector<std::string>
  HistoryFile::warnings() const
  {
    return criteria.warnings(equations.mesh.get_layup());
  }


  void
  HistoryFile::write(const StepReport &report, const State &state)
  {
    failure_maxima   = find_failure_maxima(equations, state, criteria);
    std::string line = std::to_string(report.step) + ',' + report.stage;
    const HistoryGroup::Step step{
      report, state, equations, cavity, failure_maxima};
    for (const HistoryGroup &group : groups)
      for (const std::optional<double> &value : group.values(step))
        line += ',' + (value ? csv_number(*value) : std::string());
    append(line + '\n');
  }
} // namespace Biface
