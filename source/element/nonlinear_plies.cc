// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <optional>
#include <type_traits>

#include <biface/element/nonlinear_plies.h>

namespace Biface
{
  using namespace dealii;
  using Modes::n_gauss_points;

  namespace
  {
    double
    strain_along(const CordPoint &cord, const Resultants::Vector &E)
    {
      double e = 0;
      for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
        e += cord.direction[s] * E[s];
      return e;
    }


    using AtPoints = std::array<Resultants::Vector, n_gauss_points>;

    AtPoints
    at_gauss_points(const Modes::Vector &E)
    {
      AtPoints strains;
      for (unsigned int g = 0; g < n_gauss_points; ++g)
        strains[g] = Modes::at_gauss_point(E, g);
      return strains;
    }
  } // namespace


  NonlinearPlies::NonlinearPlies(const Laminate      &laminate,
                                 const StrainSampling sampling)
    : points(laminate.ply_points())
    , cords(laminate.cord_points())
    , with_twist(sampling == StrainSampling::means)
  {
    if (!points)
      return;
    ModeStiffness released(laminate.stiffness(), sampling);
    released.release_thickness_strain(laminate.stiffness_of_slack_cords());
    for (unsigned int m = 1; m < Modes::groups.size(); ++m)
      {
        const Modes::Group &group = Modes::groups[m];
        const auto          index = [&](const unsigned int s) {
          return Modes::mode_of[m][s] - group.first_mode;
        };
        const unsigned int i = index(Resultants::thickness);
        const double       D = released(m, i, i);
        varying_stiffness[m] = group.weight() * D;
        for (unsigned int s = 0; s <= Modes::twist; ++s)
          if (Modes::mode_of[m][s] != Modes::n &&
              (s != Modes::twist || with_twist))
            varying_parts[m][s] = released(m, i, index(s)) / D;
      }
  }


  NonlinearPlies::Variation
  NonlinearPlies::variation(const Modes::Vector &E, const unsigned int m) const
  {
    Variation result;
    for (unsigned int s = 0; s <= Modes::twist; ++s)
      if (varying_parts[m][s] != 0)
        {
          // E^m_s and the squared mean stretch
          const bool         is_twist = (s == Modes::twist);
          const unsigned int mode     = Modes::mode_of[m][s];
          const double       x = E[mode], C = is_twist ? 1. : 1 + 2 * E[s];
          const double       factor = varying_parts[m][s] / C;
          result.value += factor * x;
          result.gradient[mode] += factor;
          if (is_twist)
            continue;
          result.gradient[s] -= 2 * factor * x / C;
          result.mixed[s]   = -2 * factor / C;
          result.by_mean[s] = 8 * factor * x / (C * C);
        }
    return result;
  }


  double
  NonlinearPlies::energy(const Modes::Vector  &E,
                         const HistoryOfPlies &history) const
  {
    const RelaxedStresses stresses = relaxed(history);
    const AtPoints        strains  = at_gauss_points(E);
    double                sum      = 0;
    if (points)
      {
        const auto state = points->thickness_state(strains, stresses.points);
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          sum += points->energy(strains[g], stresses.points, state, g);
      }
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      for (unsigned int k = 0; k < cords.size(); ++k)
        sum += cords[k].thickness * response(stresses, g, k, strains[g]).energy;
    sum /= n_gauss_points;
    if (points)
      for (unsigned int m = 1; m < Modes::groups.size(); ++m)
        {
          const double eta = variation(E, m).value;
          sum += varying_stiffness[m] * eta * eta / 2;
        }
    return sum;
  }


  void
  NonlinearPlies::add_varying(const Modes::Vector &E,
                              Modes::Vector       &resultants,
                              Stiffness           *stiffness) const
  {
    if (!points)
      return;
    Modes::Vector weights;
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < group.size; ++i)
        weights[group.first_mode + i] = group.weight(i);
    for (unsigned int m = 1; m < Modes::groups.size(); ++m)
      {
        const Variation eta = variation(E, m);
        const double    H   = varying_stiffness[m] * eta.value;
        for (unsigned int i = 0; i < Modes::n; ++i)
          if (eta.gradient[i] != 0)
            {
              resultants[i] += H * eta.gradient[i] / weights[i];
              if (stiffness)
                for (unsigned int j = 0; j < Modes::n; ++j)
                  (*stiffness)[i][j] +=
                    varying_stiffness[m] * eta.gradient[i] * eta.gradient[j];
            }
        if (stiffness)
          for (unsigned int s = 0; s < Resultants::n; ++s)
            if (varying_parts[m][s] != 0)
              {
                const unsigned int mode = Modes::mode_of[m][s];
                (*stiffness)[s][s] += H * eta.by_mean[s];
                (*stiffness)[s][mode] += H * eta.mixed[s];
                (*stiffness)[mode][s] += H * eta.mixed[s];
              }
      }
  }


  bool
  NonlinearPlies::evaluate(const Modes::Vector  &E,
                           const HistoryOfPlies &history,
                           Modes::Vector        &resultants,
                           Stiffness            *stiffness) const
  {
    const RelaxedStresses stresses = relaxed(history);
    if (stiffness)
      for (auto &row : *stiffness)
        row.fill(0);
    const AtPoints                                 strains = at_gauss_points(E);
    AtPoints                                       at_points;
    std::array<Resultants::Matrix, n_gauss_points> C;
    std::array<bool, n_gauss_points>               any{};

    if (points)
      {
        // how the thickness stress changes by the modes
        std::array<double, Modes::n> f{};
        double                       compliance = 0;
        const auto state = points->thickness_state(strains, stresses.points);
        PlyPoints::Response response;
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          {
            points->respond(strains[g],
                            stresses.points,
                            state,
                            g,
                            stiffness != nullptr,
                            response);
            at_points[g] = response.H;
            any[g]       = true;
            if (!stiffness)
              continue;
            C[g] = response.C;
            Modes::for_parts_at_gauss_point(g,
                                            with_twist,
                                            [&](const unsigned int m,
                                                const unsigned int s,
                                                const double       value) {
                                              f[m] += value * response.f[s] /
                                                      n_gauss_points;
                                            });
            compliance += response.compliance / n_gauss_points;
          }
        if (stiffness)
          for (unsigned int m = 0; m < Modes::n; ++m)
            for (unsigned int n = 0; n < Modes::n; ++n)
              (*stiffness)[m][n] += f[m] * f[n] / compliance;
      }

    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        for (unsigned int k = 0; k < cords.size(); ++k)
          {
            const CordPoint &cord = cords[k];
            const auto       at   = response(stresses, g, k, strains[g]);
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              at_points[g][s] += cord.thickness * at.stress * cord.direction[s];
            if (at.modulus == 0)
              continue;
            any[g] = true;
            if (stiffness)
              for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
                for (unsigned int t = 0; t < Resultants::n_tangential; ++t)
                  C[g][s][t] += cord.thickness * at.modulus *
                                cord.direction[s] * cord.direction[t];
          }
        if (!stiffness || !any[g])
          continue;

        // C times the modes, then the modes times that
        std::array<std::array<double, Modes::n>, Resultants::n> by_mode{};
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int t = 0; t < Resultants::n; ++t)
              by_mode[t][m] += value / n_gauss_points * C[g][t][s];
          });
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int n = 0; n < Modes::n; ++n)
              (*stiffness)[m][n] += value * by_mode[s][n];
          });
      }
    resultants = Modes::from_gauss_points(at_points, with_twist);
    add_varying(E, resultants, stiffness);
    return std::any_of(
      any.begin(), any.end(), [](const bool here) { return here; });
  }


  Modes::Vector
  NonlinearPlies::resultants(const Modes::Vector  &E,
                             const HistoryOfPlies &history) const
  {
    Modes::Vector H;
    evaluate(E, history, H, nullptr);
    return H;
  }


  bool
  NonlinearPlies::stiffness(const Modes::Vector  &E,
                            Stiffness            &result,
                            const HistoryOfPlies &history) const
  {
    Modes::Vector H;
    return evaluate(E, history, H, &result);
  }


  std::array<StrainsOfPlies, 4>
  NonlinearPlies::strains_at_vertices(const Modes::Vector  &E,
                                      const HistoryOfPlies &history) const
  {
    const auto                    at_vertices = Modes::at_vertices(E);
    std::array<StrainsOfPlies, 4> strains;
    const RelaxedStresses         stresses = relaxed(history);
    for (unsigned int v = 0; v < 4; ++v)
      {
        strains[v].E         = at_vertices[v];
        const auto of_vertex = [v](const auto &all) {
          const auto begin = all.begin() + v * (all.size() / n_gauss_points);
          return std::decay_t<decltype(all)>(
            begin, begin + all.size() / n_gauss_points);
        };
        strains[v].points = of_vertex(stresses.points);
        strains[v].cords  = of_vertex(stresses.cords);
      }
    if (points)
      {
        const auto H = Modes::at_vertices(resultants(E, history));
        for (unsigned int v = 0; v < 4; ++v)
          strains[v].E[Resultants::thickness] = points->thickness_strain(
            strains[v].E,
            strains[v].points,
            H[v][Resultants::thickness] / points->get_thickness());
      }
    return strains;
  }


  namespace
  {
    using OfPoint = InternalStresses<PointStrains::Vector>;
    using OfCords = InternalStresses<double>;


    /** Call functions with the step of each point and each cord of each Gauss
     * point that relaxes, its number, and the position of its internal
     * variables.
     * @return the number of these. */
    template <typename OnPoint, typename OnCord>
    unsigned int
    for_internal(const PlyPoints              *points,
                 const std::vector<CordPoint> &cords,
                 const TimeStep               &time,
                 const OnPoint                &on_point,
                 const OnCord                 &on_cord)
    {
      // the points of a ply follow each other
      const Relaxation *last = nullptr;
      Relaxation::Step  step;
      const auto        step_of =
        [&](const Relaxation &relaxation) -> const Relaxation::Step & {
        if (&relaxation != last)
          step = relaxation.step(time);
        last = &relaxation;
        return step;
      };

      unsigned int       position = 0;
      const unsigned int n_points = points ? points->get_points().size() : 0;
      for (unsigned int g = 0; g < n_gauss_points; ++g)
        {
          for (unsigned int k = 0; k < n_points; ++k)
            if (const auto &relaxation = points->get_points()[k].relaxation)
              {
                on_point(step_of(*relaxation), g, k, position);
                position += OfPoint::n_numbers(*relaxation);
              }
          for (unsigned int k = 0; k < cords.size(); ++k)
            if (const auto &relaxation = cords[k].relaxation)
              {
                on_cord(step_of(*relaxation), g, k, position);
                position += OfCords::n_numbers(*relaxation);
              }
        }
      return position;
    }
  } // namespace


  unsigned int
  NonlinearPlies::n_internal() const
  {
    const auto nothing = [](const Relaxation::Step &,
                            const unsigned int,
                            const unsigned int,
                            const unsigned int) {};
    return for_internal(points.get(), cords, {}, nothing, nothing);
  }


  NonlinearPlies::RelaxedStresses
  NonlinearPlies::relaxed(const HistoryOfPlies &history) const
  {
    RelaxedStresses result;
    if (!history.internal)
      return result;
    const unsigned int n_points = points ? points->get_points().size() : 0;
    result.points.resize(n_gauss_points * n_points);
    result.cords.resize(n_gauss_points * cords.size());
    for_internal(
      points.get(),
      cords,
      history.step,
      [&](const Relaxation::Step &step,
          const unsigned int      g,
          const unsigned int      k,
          const unsigned int      position) {
        result.points[g * n_points + k] =
          OfPoint::relaxed(step, history.internal + position);
      },
      [&](const Relaxation::Step &step,
          const unsigned int      g,
          const unsigned int      k,
          const unsigned int      position) {
        result.cords[g * cords.size() + k] =
          OfCords::relaxed(step, history.internal + position);
      });
    return result;
  }


  CordLaw::Response
  NonlinearPlies::response(const RelaxedStresses    &relaxed,
                           const unsigned int        g,
                           const unsigned int        k,
                           const Resultants::Vector &strain) const
  {
    const double      e      = strain_along(cords[k], strain);
    CordLaw::Response result = cords[k].law->response(e);
    if (!relaxed.cords.empty())
      {
        const Relaxed<double> &at = relaxed.cords[g * cords.size() + k];
        result                    = {at.factor * result.energy + at.stress * e,
                                     at.factor * result.stress + at.stress,
                                     at.factor * result.modulus};
      }
    return result;
  }


  void
  NonlinearPlies::commit(const Modes::Vector &E,
                         const TimeStep      &time,
                         double              *internal) const
  {
    const AtPoints            strains  = at_gauss_points(E);
    const RelaxedStresses     stresses = relaxed({internal, time});
    PlyPoints::ThicknessState state;
    if (points)
      state = points->thickness_state(strains, stresses.points);
    for_internal(
      points.get(),
      cords,
      time,
      [&](const Relaxation::Step &step,
          const unsigned int      g,
          const unsigned int      k,
          const unsigned int      position) {
        OfPoint::commit(step,
                        points->get_points()[k].law->stress(
                          points->strain(strains[g], state, g, k)),
                        internal + position);
      },
      [&](const Relaxation::Step &step,
          const unsigned int      g,
          const unsigned int      k,
          const unsigned int      position) {
        OfCords::commit(
          step,
          cords[k].law->response(strain_along(cords[k], strains[g])).stress,
          internal + position);
      });
  }


  NonlinearPlies::Linearization
  NonlinearPlies::linearize(const Modes::Vector  &E,
                            const HistoryOfPlies &history) const
  {
    Linearization law;
    law.E = E;
    evaluate(E, history, law.resultants, &law.stiffness);
    return law;
  }


  Modes::Vector
  NonlinearPlies::resultants(const Linearization  &law,
                             const Modes::Vector  &E,
                             const HistoryOfPlies &history) const
  {
    const Modes::Vector dE = E - law.E;
    Modes::Vector       H  = law.resultants;
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < group.size; ++i)
        {
          const unsigned int m   = group.first_mode + i;
          double             sum = 0;
          for (unsigned int n = 0; n < Modes::n; ++n)
            sum += law.stiffness[m][n] * dE[n];
          H[m] += sum / group.weight(i);
        }

    const AtPoints strains = at_gauss_points(E), about = at_gauss_points(law.E);
    AtPoints       changes;
    bool           any = false;
    std::optional<RelaxedStresses> stresses;
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      for (unsigned int k = 0; k < cords.size(); ++k)
        {
          const CordPoint &cord = cords[k];
          const double     e    = strain_along(cord, strains[g]),
                       e_0      = strain_along(cord, about[g]);
          if (cord.law->is_slack(e) == cord.law->is_slack(e_0))
            continue;
          any = true;
          if (!stresses)
            stresses = relaxed(history);
          const auto   from   = response(*stresses, g, k, about[g]);
          const double change = response(*stresses, g, k, strains[g]).stress -
                                (from.stress + from.modulus * (e - e_0));
          for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
            changes[g][s] += cord.thickness * change * cord.direction[s];
        }
    return any ? H + Modes::from_gauss_points(changes, with_twist) : H;
  }


  double
  NonlinearPlies::thickness_of_cords() const
  {
    double sum = 0;
    for (const CordPoint &cord : cords)
      sum += cord.thickness;
    return sum;
  }


  std::array<double, n_gauss_points>
  NonlinearPlies::slack_thickness(const Modes::Vector &E) const
  {
    std::array<double, n_gauss_points> sums{};
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        const Resultants::Vector strain = Modes::at_gauss_point(E, g);
        for (const CordPoint &cord : cords)
          if (cord.law->is_slack(strain_along(cord, strain)))
            sums[g] += cord.thickness;
      }
    return sums;
  }
} // namespace Biface
