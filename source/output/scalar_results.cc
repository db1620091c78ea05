// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/types.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include <biface/base/errors.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/quantities/point_displacement.h>
#include <biface/output/scalar_results.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Whether a column of history.csv is a function of the state that can be
     * differentiated; works are sums over all steps. */
    bool
    has_derivative(const std::string &column)
    {
      const auto ends_with = [&](const std::string &end) {
        return column.size() >= end.size() &&
               column.compare(column.size() - end.size(), end.size(), end) == 0;
      };
      for (const std::string counted : {"iterations", "seconds", "slack_cords"})
        if (column == counted)
          return false;
      return !ends_with("contact_nodes") && !ends_with("slipping_nodes") &&
             !ends_with("_work") && !ends_with("_alpha_1") &&
             !ends_with("_alpha_2") && !ends_with("_ply");
    }


    /** Split off the last word of a text. */
    std::string
    take_last_word(std::string &text)
    {
      const auto        blank = text.find_last_of(' ');
      const std::string word =
        (blank == std::string::npos ? text : text.substr(blank + 1));
      text =
        (blank == std::string::npos ? ""
                                    : Utilities::trim(text.substr(0, blank)));
      return word;
    }


    /** The position of a word; none if it is not in the list. */
    std::optional<unsigned int>
    position_of(const std::string &word, const std::vector<std::string> &list)
    {
      const auto found = std::find(list.begin(), list.end(), word);
      if (found == list.end())
        return {};
      return found - list.begin();
    }


    /** The names of what can move: the ground, bodies and supports. */
    std::vector<std::string>
    movable(const ShellEquations &equations)
    {
      std::vector<std::string> names{"foundation"};
      for (const SupportMotion &motion : equations.mesh.supported.motions)
        names.push_back(motion.name);
      for (const ForceTerm *term : equations.get_terms())
        if (term->source() == ForceTerm::Source::ground &&
            !term->other_body().empty())
          names.push_back(term->other_body());
      return names;
    }


    const std::vector<std::string> probe_components{
      "u_x", "u_y", "u_z", "u_1", "u_2", "u_3"};
    const std::vector<std::string> force_components{
      "F_x", "F_y", "F_z", "M_x", "M_y", "M_z"};
  } // namespace


  ScalarResults::Known
  ScalarResults::Known::at_ends(const Cavity             *cavity,
                                const std::vector<Stage> &stages)
  {
    // a result must exist at the ends of all of them
    return {
      cavity != nullptr, fewest_modes(stages), fewest_buckling_loads(stages)};
  }


  ScalarResults::ScalarResults(const std::string              &entry,
                               const std::vector<std::string> &names,
                               const ShellEquations           &equations,
                               const FailureCriteria          &criteria,
                               const Point<3>                 &moment_center,
                               const Known                    &known,
                               const Columns                   columns)
    : names(names)
    , criteria(criteria)
    , moment_center(moment_center)
    , columns(columns)
    , history(history_groups(criteria, equations, known.volume))
  {
    for (const std::string &name : names)
      {
        const std::optional<Source> source = find(name, equations, known);
        if (!source)
          {
            std::string counting;
            for (const HistoryGroup &group : history)
              for (const std::string &column : group.columns)
                if (counts(column))
                  counting += (counting.empty() ? "" : ", ") + column;
            throw InputError(
              entry,
              name,
              "it must be one of " + counting +
                ", 'POINT u_x' with a named point, 'BODY F_x' "
                "with a body of forces.csv, "
                "'BODY tangent' or 'BODY secant' with the ground "
                "('foundation'), a body or a support that moves, "
                "'frequency 1' or 'buckling factor "
                "1' with the number of a mode that 'Modes' or 'Buckling' asks "
                "for");
          }
        sources.push_back(*source);
      }
  }


  std::optional<ScalarResults::Source>
  ScalarResults::find(const std::string    &name,
                      const ShellEquations &equations,
                      const Known          &known) const
  {
    const ShellMesh &mesh = equations.mesh;
    Source           source;
    // fixed names before those that contain a name of the user
    for (unsigned int g = 0; g < history.size(); ++g)
      if (const auto column = position_of(name, history[g].columns))
        {
          if (!counts(name))
            return {};
          source.position  = g;
          source.component = *column;
          return source;
        }

    std::string       rest = Utilities::trim(name);
    const std::string last = take_last_word(rest);
    if (const auto component = position_of(last, probe_components))
      {
        source.kind             = Source::Kind::probe;
        source.component        = *component;
        std::string       point = rest;
        const std::string face  = take_last_word(point);
        // a point may itself have the name of a face
        if (!point.empty() && position_of(face, {"inner", "outer", "middle"}))
          {
            source.inner = (face == "inner" ? 1 : face == "outer" ? 0 : 0.5);
            rest         = point;
          }
        for (unsigned int p = 0; p < mesh.points.size(); ++p)
          if (mesh.points[p].name == rest)
            {
              source.position = p;
              return source;
            }
        return {};
      }
    if (const auto component = position_of(last, {"tangent", "secant"}))
      {
        source.kind      = Source::Kind::stiffness;
        source.component = *component;
        source.name      = rest;
        const auto moves = movable(equations);
        if (position_of(rest, moves))
          return source;
        return {};
      }
    for (const auto &[words, n, kind] :
         {std::make_tuple("frequency", known.n_modes, Source::Kind::frequency),
          std::make_tuple(
            "buckling factor", known.n_buckling, Source::Kind::buckling)})
      for (unsigned int m = 0; m < n; ++m)
        if (rest == words && last == std::to_string(m + 1))
          {
            source.kind     = kind;
            source.position = m;
            return source;
          }
    if (const auto component = position_of(last, force_components))
      {
        source.kind      = Source::Kind::force;
        source.component = *component;
        if (const auto body = position_of(rest, bodies_on_shell(equations)))
          {
            source.position = *body;
            return source;
          }
        return {};
      }
    return {};
  }


  bool
  ScalarResults::counts(const std::string &column) const
  {
    return columns == Columns::all || has_derivative(column);
  }


  bool
  ScalarResults::have(const Source::Kind kind) const
  {
    return std::any_of(
      sources.begin(), sources.end(), [&](const Source &source) {
        return source.kind == kind;
      });
  }


  bool
  ScalarResults::have_force() const
  {
    return std::any_of(
      sources.begin(), sources.end(), [&](const Source &source) {
        return source.kind == Source::Kind::force ||
               (source.kind == Source::Kind::history &&
                history[source.position].of_forces);
      });
  }


  std::vector<double>
  ScalarResults::evaluate(const ShellEquations &equations,
                          const Cavity         *cavity,
                          const StepReport     &report,
                          const State          &state) const
  {
    const ShellMesh &mesh = equations.mesh;

    // only the groups that contain a result
    std::vector<std::vector<std::optional<double>>> groups(history.size());
    if (have(Source::Kind::history))
      {
        const auto failure_maxima =
          find_failure_maxima(equations, state, criteria);
        const HistoryGroup::Step step{
          report, state, equations, cavity, failure_maxima};
        for (const Source &source : sources)
          if (source.kind == Source::Kind::history &&
              groups[source.position].empty())
            groups[source.position] = history[source.position].values(step);
      }
    std::vector<double> values;
    for (const Source &source : sources)
      {
        double value = std::numeric_limits<double>::quiet_NaN();
        switch (source.kind)
          {
            case Source::Kind::history:
              value = groups[source.position][source.component].value_or(value);
              break;
            case Source::Kind::probe:
              {
                const PointDisplacement u = displacement_at(
                  mesh.points[source.position], state.displacement, mesh);
                const auto &faces = (source.component < 3 ? u.global : u.local);
                const unsigned int i = source.component % 3;
                value =
                  source.inner * faces[0][i] + (1 - source.inner) * faces[1][i];
                break;
              }
            case Source::Kind::force:
              {
                const ForceOnShell &body =
                  report.forces_of_bodies[source.position];
                value =
                  (source.component < 3
                     ? body.force
                     : body.moment_about(moment_center))[source.component % 3];
                break;
              }
            case Source::Kind::stiffness:
              {
                const auto found = report.stiffness.find(source.name);
                if (found != report.stiffness.end())
                  value = (source.component == 0 ? found->second.tangent
                                                 : found->second.secant)
                            .along();
                break;
              }
            case Source::Kind::frequency:
              if (report.modes && source.position < report.modes->modes.size())
                value = report.modes->modes[source.position].frequency();
              break;
            case Source::Kind::buckling:
              if (report.buckling &&
                  source.position < report.buckling->loads.size())
                value = report.buckling->loads[source.position].factor;
              break;
          }
        values.push_back(value);
      }
    return values;
  }
} // namespace Biface
