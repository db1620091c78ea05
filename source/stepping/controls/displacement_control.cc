// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/stepping/controls/displacement_control.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The vector @f$\mathbf l@f$ for which @f$\mathbf l\cdot\mathbf V@f$ is
     * the controlled displacement of the middle surface. */
    LA::Vector
    displacement_functional(const ShellMesh &mesh, const StageControl &stage)
    {
      LA::Vector         functional = mesh.owned_vector();
      const unsigned int n =
        mesh.node_of_point("Control point", stage.control_point);
      if (n != numbers::invalid_unsigned_int && mesh.nodes[n].locally_owned)
        {
          const Node        &node = mesh.nodes[n];
          const Tensor<1, 3> unit = direction(
            stage.control_component, node.surface, mesh.get_surface().axis());
          // the means of both faces are unknowns of their own, section 7
          for (unsigned int i = 0; i < 3; ++i)
            functional(node.dof(i, MixedElement::mean)) = unit[i];
        }
      // collective, also on ranks without the node
      functional.compress(VectorOperation::insert);
      return functional;
    }


    /** The change of a displacement, @f$\mathbf l\cdot\mathbf V@f$, in the step
     * is prescribed. */
    class DisplacementEquation : public ControlEquation
    {
    public:
      DisplacementEquation(const LoadRates  &rate,
                           const LA::Vector &functional,
                           const double      change)
        : ControlEquation(rate), functional(functional), change(change)
      {}

      double
      parameter_change(const Iteration  &iteration,
                       const LA::Vector &dV_R,
                       const LA::Vector &dV_q) const override
      {
        return (change - functional * iteration.total - functional * dV_R) /
               (functional * dV_q);
      }

      std::string
      remedies() const override
      {
        return "another 'Control point' or 'Control component'";
      }

      double
      violation(const Iteration &iteration) const override
      {
        return std::abs(functional * iteration.total - change) /
               std::abs(change);
      }

    private:
      const LA::Vector functional;
      const double     change;
    };
  } // namespace


  void
  DisplacementControl::check(const std::string &section,
                             const KnownStart  &start) const
  {
    if (stage.control_point.empty())
      throw InputError(section + "/Control point",
                       stage.control_point,
                       "displacement control needs a point");
    check_loads_follow(stage, start);
    if (start.is_undeformed)
      check_value(0);
  }


  Control::KnownStart
  DisplacementControl::known_end(const KnownStart &start) const
  {
    const KnownStart from = with_factors(start, stage.factors.size());
    KnownStart       end  = EqualSteps::known_end(start);
    // loads that change end where the displacement is reached
    for_each_load(
      [](auto &known, const auto &prescribed, const auto &at_start) {
        if (prescribed && prescribed != at_start)
          known.reset();
      },
      end,
      stage,
      from);
    return end;
  }


  void
  DisplacementControl::check_value(const double start_value) const
  {
    // equal steps of 0 determine no loads, and a violation relative to them is
    // not a number
    if (stage.control_value == start_value)
      throw InputError("the stage '" + stage.name +
                       "' prescribes a displacement of " +
                       number_to_string(start_value) +
                       ", which is already its value at the start of the "
                       "stage.");
  }


  void
  DisplacementControl::check(const std::string &section,
                             const ShellMesh   &mesh) const
  {
    mesh.node_of_point(section + "/Control point", stage.control_point);
    check_component(section + "/Control component",
                    stage.control_component,
                    mesh.get_surface());
    check_nothing_prescribed(stage, mesh);
  }


  void
  DisplacementControl::begin(const Equilibrium &from)
  {
    // here also what was not known before the run
    check_loads_follow(stage, KnownStart::at(from.level));
    EqualSteps::begin(from);
    load_fraction                 = 0;
    const ShellMesh &mesh         = from.equations.mesh;
    LA::Vector       displacement = mesh.owned_vector();
    displacement                  = from.state.displacement;
    start_value = displacement_functional(mesh, stage) * displacement;
    check_value(start_value);
  }


  Control::Trial
  DisplacementControl::propose(const Equilibrium &from) const
  {
    Trial trial;
    trial.level = [this](const LoadParameters &mu) { return level_at(mu[0]); };
    trial.mu    = {load_fraction};
    trial.equations = std::make_shared<const DisplacementEquation>(
      load_rate(),
      displacement_functional(from.equations.mesh, stage),
      (next() - fraction) * (stage.control_value - start_value));
    return trial;
  }


  void
  DisplacementControl::accept(const Step &step)
  {
    EqualSteps::accept(step);
    load_fraction = step.mu[0];
  }


  double
  DisplacementControl::value_at(const double fraction) const
  {
    return start_value + fraction * (stage.control_value - start_value);
  }


  std::optional<std::pair<std::string, double>>
  DisplacementControl::controlled() const
  {
    const std::string &component =
      component_names()[static_cast<unsigned int>(stage.control_component)];
    return std::make_pair("displacement " + component + " of " +
                            stage.control_point,
                          value_at(fraction));
  }


  Control::Memory
  DisplacementControl::get_memory() const
  {
    Memory memory                   = EqualSteps::get_memory();
    memory.numbers["start value"]   = start_value;
    memory.numbers["load fraction"] = load_fraction;
    return memory;
  }


  void
  DisplacementControl::restore(const Memory &memory)
  {
    EqualSteps::restore(memory);
    start_value   = memory.numbers.at("start value");
    load_fraction = memory.numbers.at("load fraction");
  }


  void
  DisplacementControl::change_path(const Stage &now, const LoadLevel &reached)
  {
    const double                value = value_at(fraction);
    const std::optional<double> load_part =
      common_part(progressions_of_loads(reached, now.end(start)));
    std::optional<double> part;
    // both must lie on the new path, each with a part of its own, since the
    // response is not linear
    if (load_part)
      part = common_part({{start_value, value, now.control_value}});
    if (go_on_from(part, reached))
      load_fraction = *load_part;
    else
      {
        load_fraction = 0;
        start_value   = value;
      }
  }
} // namespace Biface
