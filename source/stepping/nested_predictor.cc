// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <iterator>
#include <utility>

#include <biface/model/state/contact_points.h>
#include <biface/model/state/state.h>
#include <biface/stepping/nested_predictor.h>
#include <biface/stepping/stage_sequence.h>

namespace Biface
{
  using namespace dealii;

  NestedPredictor::NestedPredictor(const ChartGrid          &coarse,
                                   const unsigned int        n_layers,
                                   const std::vector<Stage> &stages)
    : undeformed(GridState(coarse, n_layers))
    , continued(continued_stages(stages))
  {}


  void
  NestedPredictor::learn(const Instant &instant, GridState &&state)
  {
    states.insert_or_assign(instant, std::move(state));
  }


  NestedPredictor::Mean
  NestedPredictor::at(const Instant &instant) const
  {
    // round-off in fractions that are different sums
    constexpr double tolerance = 1e-9;

    const auto after =
      states.lower_bound({instant.stage, instant.fraction - tolerance});
    const bool exact =
      (after != states.end() && after->first.stage == instant.stage &&
       after->first.fraction <= instant.fraction + tolerance);
    if (exact)
      return {&after->second, &after->second, 1};

    // the last step of the stage from whose end this one starts
    const auto end_before = [&]() -> const GridState * {
      const auto position = continued[instant.stage];
      if (!position)
        return &*undeformed;
      const auto next = states.lower_bound({*position + 1, 0});
      return next == states.begin() || std::prev(next)->first.stage != *position
               ? nullptr
               : &std::prev(next)->second;
    };

    const bool first_of_stage =
      (after == states.begin() ||
       std::prev(after)->first.stage != instant.stage);
    const GridState *before =
      (first_of_stage ? end_before() : &std::prev(after)->second);
    const double begin =
      (first_of_stage ? 0. : std::prev(after)->first.fraction);

    if (instant.fraction <= begin + tolerance)
      return {before, before, 1};
    // beyond what the coarser mesh has reached
    if (after == states.end() || after->first.stage != instant.stage)
      return {nullptr, nullptr, 0};
    return {before,
            &after->second,
            (instant.fraction - begin) / (after->first.fraction - begin)};
  }


  bool
  NestedPredictor::predict(const ShellMesh &mesh,
                           const Instant   &from,
                           const Instant   &to,
                           State           &state) const
  {
    // without coarser meshes
    if (states.empty())
      return false;
    // The change on the coarser mesh is added, instead of taking its state: the
    // error of a change vanishes with the step.
    const Mean begin = at(from), end = at(to);
    if (begin.before == nullptr || end.before == nullptr)
      return false;

    const auto change = [&](const auto &value) {
      return (1 - end.weight) * value(*end.before) +
             end.weight * value(*end.after) -
             (1 - begin.weight) * value(*begin.before) -
             begin.weight * value(*begin.after);
    };

    // between two active sets, use the nearer one
    const GridState    &zone   = (end.weight < 0.5 ? *end.before : *end.after);
    ContactState       &ground = state.contacts[0];
    const ContactPoints points(mesh, Resultants::outer, ground);
    for (unsigned int point = 0; point < points.size(); ++point)
      ground.active[point] = (points.interpolate(point, [&](const Node &node) {
        return zone.contact(node.alpha);
      }) > 0.5);

    LA::Vector increment = mesh.owned_vector();
    std::vector<std::pair<types::global_dof_index, double>> of_supports;
    for (const Node &node : mesh.nodes)
      {
        if (!node.locally_owned)
          continue;
        for (unsigned int part = 0; part < node.n_parts(); ++part)
          {
            const Tensor<1, 3> moved = change([&](const GridState &s) {
              return s.displacement(node.alpha, part);
            });
            for (unsigned int i = 0; i < 3; ++i)
              {
                const auto dof = node.dof(i, part);
                // other constrained unknowns follow from these in distribute();
                // prescribed ones, which depend on no others, are set behind it
                if (!mesh.constraints.is_constrained(dof))
                  increment(dof) = moved[i];
                else if (mesh.constraints.get_constraint_entries(dof)->empty())
                  of_supports.emplace_back(dof, moved[i]);
              }
          }
      }
    increment.compress(VectorOperation::insert);
    mesh.constraints.distribute(increment);
    // supports that move, as on the coarser mesh
    for (const auto &[dof, moved] : of_supports)
      increment(dof) = moved;
    increment.compress(VectorOperation::insert);
    LA::Vector displacement = mesh.owned_vector();
    displacement            = state.displacement;
    displacement += increment;
    state.displacement = displacement;

    const auto &lines = mesh.grid.lines;
    // resultants are unknowns of the mixed iteration like displacements
    for (const unsigned int c : mesh.layers)
      {
        const Point<2> low = mesh.nodes[mesh.cells[c].nodes[0]].alpha;
        Point<2>       high;
        for (unsigned int a = 0; a < 2; ++a)
          // by lines, since beyond a closed seam nodes start again from the
          // lowest
          high[a] =
            *std::upper_bound(lines[a].begin(), lines[a].end() - 1, low[a]);
        const std::array<Point<2>, 4> vertices{
          {low, Point<2>(high[0], low[1]), Point<2>(low[0], high[1]), high}};
        state.resultants[c] += change([&](const GridState &s) {
          return s.resultants(vertices, mesh.cells[c].layer);
        });
      }
    return true;
  }
} // namespace Biface
