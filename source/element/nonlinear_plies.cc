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


    /** Of all modes, see Modes::Group::weight(). */
    Modes::Vector
    weights_of_modes()
    {
      Modes::Vector weights;
      for (const Modes::Group &group : Modes::groups)
        for (unsigned int i = 0; i < group.size; ++i)
          weights[group.first_mode + i] = group.weight(i);
      return weights;
    }


    using AtPoints = std::array<Resultants::Vector, n_gauss_points>;
  } // namespace


  NonlinearPlies::NonlinearPlies(const Laminate     &laminate,
                                 const Formulation   formulation,
                                 const CellTangents *tangents)
    : points(laminate.ply_points())
    , cords(laminate.cord_points())
    , with_twist(formulation == Formulation::standard)
  {
    if (tangents)
      {
        this->tangents = *tangents;
        if (!all_linear())
          along = std::make_shared<const Modes::ComponentsOfGroups>(
            tangents->strains());
      }
    // in the order in which for_relaxing() passes the stresses: those of
    // points, of cords, of thickness strains that vary
    if (points)
      for (const PlyPoints::Point &point : points->get_points())
        if (point.relaxation)
          relaxing.push_back({point.relaxation,
                              PointStrains::n,
                              point.ply,
                              point.thickness * point.area});
    for (const CordPoint &cord : cords)
      if (cord.relaxation)
        relaxing.push_back({cord.relaxation, 1, cord.ply, cord.thickness});
    if (!points)
      return;
    const std::vector<Ply> &plies = laminate.get_plies();
    for (unsigned int k = 0; k < plies.size(); ++k)
      if (plies[k].laws.relaxation)
        {
          relaxing_plies.push_back({plies[k].laws.relaxation,
                                    plies[k].thickness / laminate.thickness()});
          relaxing.push_back({plies[k].laws.relaxation,
                              OfGroups::n_independent_components,
                              k,
                              1.});
        }
    // at small strains the thickness strains that vary must have the linear
    // law, or nearly incompressible layers lock
    ModeStiffness released(laminate.stiffness(), formulation, tangents);
    released.release_thickness_strain(laminate.stiffness_of_slack_cords(),
                                      tangents);
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


  std::array<Resultants::Vector, n_gauss_points>
  NonlinearPlies::at_gauss_points(const Modes::Vector &E) const
  {
    AtPoints strains;
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      strains[g] = Modes::at_gauss_point(E, g, of_tangents());
    return strains;
  }


  template <typename Function>
  void
  NonlinearPlies::for_mean(const unsigned int m,
                           const unsigned int s,
                           const Function    &function) const
  {
    if (!along || m == 3 || s == Resultants::thickness)
      {
        function(s, 1.);
        return;
      }
    const unsigned int face =
      (s == Resultants::tangential(m - 1, Resultants::inner)
         ? Resultants::inner
         : Resultants::outer);
    const Tensor<1, 2> &t = tangents->faces[face][m - 1];
    function(Resultants::tangential(0, face), t[0] * t[0]);
    function(Resultants::tangential(1, face), t[1] * t[1]);
    function(Resultants::tangential(2, face), t[0] * t[1]);
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
          const double       x        = E[mode];
          double             C        = 1;
          if (!is_twist)
            for_mean(m, s, [&](const unsigned int t, const double of_t) {
              C += 2 * of_t * E[t];
            });
          const double factor = varying_parts[m][s] / C;
          result.value += factor * x;
          result.gradient[mode] += factor;
          if (is_twist)
            continue;
          for_mean(m, s, [&](const unsigned int t, const double of_t) {
            result.gradient[t] -= 2 * factor * x / C * of_t;
          });
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
          const auto   law = varying_law(m, stresses);
          sum += law.stiffness * eta * eta / 2 + law.added * eta;
        }
    return sum;
  }


  NonlinearPlies::VaryingLaw
  NonlinearPlies::varying_law(const unsigned int     m,
                              const RelaxedStresses &relaxed) const
  {
    double left = 1, added = 0;
    for (unsigned int i = 0; i < relaxed.varying.size(); ++i)
      {
        const unsigned int g = i / relaxing_plies.size();
        left -= relaxing_plies[i % relaxing_plies.size()].part *
                (1 - relaxed.varying[i].factor) / n_gauss_points;
        added += Modes::value_at_gauss_point(Modes::groups[m], g) *
                 relaxed.varying[i].stress[m - 1] / n_gauss_points;
      }
    return {left * varying_stiffness[m], added};
  }


  void
  NonlinearPlies::add_varying(const Modes::Vector   &E,
                              const RelaxedStresses &relaxed,
                              Modes::Vector         &resultants,
                              Stiffness             *stiffness) const
  {
    if (!points)
      return;
    const Modes::Vector weights = weights_of_modes();
    for (unsigned int m = 1; m < Modes::groups.size(); ++m)
      {
        // the linear law of eta_m, which itself is not linear in the strains:
        // its second derivatives carry the resultant
        const Variation eta = variation(E, m);
        const auto      law = varying_law(m, relaxed);
        const double    D = law.stiffness, H = D * eta.value + law.added;
        for (unsigned int i = 0; i < Modes::n; ++i)
          if (eta.gradient[i] != 0)
            {
              resultants[i] += H * eta.gradient[i] / weights[i];
              if (stiffness)
                for (unsigned int j = 0; j < Modes::n; ++j)
                  (*stiffness)[i][j] += D * eta.gradient[i] * eta.gradient[j];
            }
        if (stiffness)
          for (unsigned int s = 0; s < Resultants::n; ++s)
            if (varying_parts[m][s] != 0)
              {
                const unsigned int mode = Modes::mode_of[m][s];
                for_mean(m, s, [&](const unsigned int t, const double of_t) {
                  for_mean(m, s, [&](const unsigned int u, const double of_u) {
                    (*stiffness)[t][u] += H * eta.by_mean[s] * of_t * of_u;
                  });
                  (*stiffness)[t][mode] += H * eta.mixed[s] * of_t;
                  (*stiffness)[mode][t] += H * eta.mixed[s] * of_t;
                });
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
    const AtPoints strains = at_gauss_points(E);
    AtPoints       at_points;
    bool           loaded = (points != nullptr), soft = loaded;

    // how the thickness stress changes by the modes
    std::array<double, Modes::n> f{};
    double                       compliance = 0;
    PlyPoints::ThicknessState    state;
    if (points)
      state = points->thickness_state(strains, stresses.points);
    PlyPoints::Response response_of_points;
    Resultants::Matrix  C;

    for (unsigned int g = 0; g < n_gauss_points; ++g)
      {
        bool any = false;
        if (points)
          {
            PlyPoints::Response &at = response_of_points;
            points->respond(
              strains[g], stresses.points, state, g, stiffness != nullptr, at);
            at_points[g] = at.H;
            any          = true;
            if (stiffness)
              {
                C = at.C;
                Modes::for_parts_at_gauss_point(g,
                                                with_twist,
                                                of_tangents(),
                                                [&](const unsigned int m,
                                                    const unsigned int s,
                                                    const double       value) {
                                                  f[m] += value * at.f[s] /
                                                          n_gauss_points;
                                                });
                compliance += at.compliance / n_gauss_points;
              }
          }
        for (unsigned int k = 0; k < cords.size(); ++k)
          {
            const CordPoint &cord = cords[k];
            const auto       at   = response(stresses, g, k, strains[g]);
            if (at.stress != 0)
              {
                loaded = true;
                for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
                  at_points[g][s] +=
                    cord.thickness * at.stress * cord.direction[s];
              }
            // taut cords of a linear law are in the law of the laminate already
            if (at.modulus == 0)
              continue;
            soft = true;
            if (!stiffness)
              continue;
            if (!any)
              C = 0;
            any = true;
            for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
              for (unsigned int t = 0; t < Resultants::n_tangential; ++t)
                C[s][t] += cord.thickness * at.modulus * cord.direction[s] *
                           cord.direction[t];
          }
        if (!stiffness || !any)
          continue;

        // C times the modes, then the modes times that
        std::array<std::array<double, Modes::n>, Resultants::n> by_mode{};
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          of_tangents(),
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int t = 0; t < Resultants::n; ++t)
              by_mode[t][m] += value / n_gauss_points * C[t][s];
          });
        Modes::for_parts_at_gauss_point(
          g,
          with_twist,
          of_tangents(),
          [&](const unsigned int m, const unsigned int s, const double value) {
            for (unsigned int n = 0; n < Modes::n; ++n)
              (*stiffness)[m][n] += value * by_mode[s][n];
          });
      }
    // the thickness stress is common to all Gauss points, which it couples by a
    // term of rank one
    if (points && stiffness)
      for (unsigned int m = 0; m < Modes::n; ++m)
        for (unsigned int n = 0; n < Modes::n; ++n)
          (*stiffness)[m][n] += f[m] * f[n] / compliance;
    resultants =
      (loaded ? Modes::from_gauss_points(at_points, with_twist, of_tangents())
              : Modes::Vector());
    add_varying(E, stresses, resultants, stiffness);
    return soft;
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
    const auto at_vertices =
      tangents ? tangents->strains_at_vertices(E) : Modes::at_vertices(E);
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


    /** What relaxes at a Gauss point, in the order of
     * NonlinearPlies::relaxing_stresses(). */
    enum class Kind
    {
      point,
      cords,
      varying
    };

    /** Call a function with the Gauss point, the kind, the number of its kind,
     * and the position of the components, for each stress that relaxes. */
    template <typename Function>
    void
    for_relaxing(const PlyPoints              *points,
                 const std::vector<CordPoint> &cords,
                 const unsigned int            n_plies,
                 const Function               &function)
    {
      unsigned int       position = 0;
      const unsigned int n_points = points ? points->get_points().size() : 0;
      for (unsigned int g = 0; g < n_gauss_points; ++g)
        {
          for (unsigned int k = 0; k < n_points; ++k)
            if (points->get_points()[k].relaxation)
              {
                function(g, Kind::point, k, position);
                position += PointStrains::n;
              }
          for (unsigned int k = 0; k < cords.size(); ++k)
            if (cords[k].relaxation)
              function(g, Kind::cords, k, position++);
          for (unsigned int k = 0; k < n_plies; ++k)
            {
              function(g, Kind::varying, k, position);
              position += Modes::groups.size() - 1;
            }
        }
    }


    template <typename Stress>
    Stress
    components(const double *numbers)
    {
      Stress stress;
      std::copy_n(
        numbers, Stress::n_independent_components, stress.begin_raw());
      return stress;
    }
  } // namespace


  unsigned int
  NonlinearPlies::n_relaxing_components() const
  {
    unsigned int n = 0;
    for (const RelaxingStress &stress : relaxing)
      n += stress.n_components;
    return n;
  }


  unsigned int
  NonlinearPlies::n_internal() const
  {
    unsigned int n = 0;
    for (const RelaxingStress &stress : relaxing)
      n += stress.n_internal();
    return n * n_gauss_points;
  }


  NonlinearPlies::Steps
  NonlinearPlies::steps(const HistoryOfPlies &history) const
  {
    Steps result;
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      for (const RelaxingStress &stress : relaxing)
        if (result[g].count(stress.ply) == 0)
          {
            TimeStep time = history.steps[g];
            if (!history.temperatures.empty())
              time.temperature = history.temperatures[stress.ply];
            result[g].emplace(stress.ply, stress.relaxation->step(time));
          }
    return result;
  }


  template <typename Function>
  void
  NonlinearPlies::for_internal(const Steps    &steps,
                               const Function &function) const
  {
    unsigned int internal = 0, number = 0;
    for_relaxing(
      points.get(),
      cords,
      relaxing_plies.size(),
      [&](const unsigned int g,
          const Kind         kind,
          const unsigned int k,
          const unsigned int position) {
        const RelaxingStress &stress = relaxing[number++ % relaxing.size()];
        function(steps[g].at(stress.ply), g, kind, k, position, internal);
        internal += stress.n_internal();
      });
  }


  NonlinearPlies::RelaxedStresses
  NonlinearPlies::relaxed(const HistoryOfPlies &history) const
  {
    RelaxedStresses result;
    // nothing has relaxed, and the laws are elastic
    if (!history.internal)
      return result;
    const unsigned int n_points = points ? points->get_points().size() : 0;
    result.points.resize(n_gauss_points * n_points);
    result.cords.resize(n_gauss_points * cords.size());
    result.varying.resize(n_gauss_points * relaxing_plies.size());
    for_internal(steps(history),
                 [&](const Relaxation::Step &step,
                     const unsigned int      g,
                     const Kind              kind,
                     const unsigned int      k,
                     const unsigned int,
                     const unsigned int internal) {
                   const double *numbers = history.internal + internal;
                   if (kind == Kind::point)
                     result.points[g * n_points + k] =
                       OfPoint::relaxed(step, numbers);
                   else if (kind == Kind::cords)
                     result.cords[g * cords.size() + k] =
                       OfCords::relaxed(step, numbers);
                   else
                     result.varying[g * relaxing_plies.size() + k] =
                       InternalStresses<OfGroups>::relaxed(step, numbers);
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


  double
  NonlinearPlies::varying_modulus(const unsigned int m) const
  {
    return varying_stiffness[m] / Modes::groups[m].weight();
  }


  void
  NonlinearPlies::elastic_stresses(const Modes::Vector  &E,
                                   const HistoryOfPlies &history,
                                   std::vector<double>  &stresses,
                                   std::vector<double>  *strains) const
  {
    stresses.resize(n_gauss_points * n_relaxing_components());
    if (strains)
      strains->resize(stresses.size());
    const AtPoints            places = at_gauss_points(E);
    PlyPoints::ThicknessState state;
    OfGroups                  eta;
    if (points)
      {
        // the thickness stress is in equilibrium with what has relaxed, though
        // the stresses asked for have not
        state = points->thickness_state(places, relaxed(history).points);
        for (unsigned int m = 1; m < Modes::groups.size(); ++m)
          eta[m - 1] = variation(E, m).value;
      }
    const auto set =
      [&](const unsigned int position, const auto &stress, const auto &strain) {
        std::copy(
          stress.begin_raw(), stress.end_raw(), stresses.begin() + position);
        if (strains)
          std::copy(
            strain.begin_raw(), strain.end_raw(), strains->begin() + position);
      };
    for_relaxing(
      points.get(),
      cords,
      relaxing_plies.size(),
      [&](const unsigned int g,
          const Kind         kind,
          const unsigned int k,
          const unsigned int position) {
        if (kind == Kind::point)
          {
            const PointStrains::Vector strain =
              points->strain(places[g], state, g, k);
            set(position, points->get_points()[k].law->stress(strain), strain);
          }
        else if (kind == Kind::cords)
          {
            const Tensor<1, 1> strain({strain_along(cords[k], places[g])});
            set(position,
                Tensor<1, 1>({cords[k].law->response(strain[0]).stress}),
                strain);
          }
        else
          {
            OfGroups stress, strain;
            for (unsigned int m = 1; m < Modes::groups.size(); ++m)
              {
                strain[m - 1] =
                  Modes::value_at_gauss_point(Modes::groups[m], g) * eta[m - 1];
                stress[m - 1] =
                  relaxing_plies[k].part * varying_modulus(m) * strain[m - 1];
              }
            set(position, stress, strain);
          }
      });
  }


  std::vector<double>
  NonlinearPlies::added_stresses(const HistoryOfPlies &history) const
  {
    return added_stresses(steps(history), history.internal);
  }


  std::vector<double>
  NonlinearPlies::added_stresses(const Steps  &steps,
                                 const double *internal) const
  {
    std::vector<double> stresses;
    stresses.reserve(n_gauss_points * n_relaxing_components());
    const auto append = [&](const auto &stress) {
      stresses.insert(stresses.end(), stress.begin_raw(), stress.end_raw());
    };
    for_internal(
      steps,
      [&](const Relaxation::Step &step,
          const unsigned int,
          const Kind kind,
          const unsigned int,
          const unsigned int,
          const unsigned int position) {
        const double *numbers = internal + position;
        if (kind == Kind::point)
          append(OfPoint::relaxed(step, numbers).stress);
        else if (kind == Kind::cords)
          stresses.push_back(OfCords::relaxed(step, numbers).stress);
        else
          append(InternalStresses<OfGroups>::relaxed(step, numbers).stress);
      });
    return stresses;
  }


  void
  NonlinearPlies::commit(const Modes::Vector  &E,
                         const HistoryOfPlies &history,
                         double               *internal) const
  {
    std::vector<double> stresses;
    elastic_stresses(E, history, stresses);
    if (internal != history.internal)
      std::copy(history.internal, history.internal + n_internal(), internal);
    for_internal(steps(history),
                 [&](const Relaxation::Step &step,
                     const unsigned int,
                     const Kind kind,
                     const unsigned int,
                     const unsigned int position,
                     const unsigned int numbers) {
                   const double *stress = stresses.data() + position;
                   if (kind == Kind::point)
                     OfPoint::commit(step,
                                     components<PointStrains::Vector>(stress),
                                     internal + numbers);
                   else if (kind == Kind::cords)
                     OfCords::commit(step, *stress, internal + numbers);
                   else
                     InternalStresses<OfGroups>::commit(
                       step, components<OfGroups>(stress), internal + numbers);
                 });
  }


  NonlinearPlies::Changes::Changes(const NonlinearPlies &plies,
                                   const Modes::Vector  &E,
                                   const HistoryOfPlies &history)
    : plies(plies), steps(plies.steps(history))
  {
    const AtPoints        places   = plies.at_gauss_points(E);
    const RelaxedStresses stresses = plies.relaxed(history);
    if (plies.points)
      {
        points.emplace(*plies.points,
                       places,
                       stresses.points,
                       plies.points->thickness_state(places, stresses.points));
        for (unsigned int m = 1; m < Modes::groups.size(); ++m)
          varying.push_back(plies.variation(E, m).gradient);
      }
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      for (const CordPoint &cord : plies.cords)
        cords.push_back(
          cord.law->response(strain_along(cord, places[g])).modulus);
  }


  std::vector<PointStrains::Vector>
  NonlinearPlies::Changes::added_at_points(
    const std::vector<double> &added) const
  {
    const unsigned int n_points =
      points ? plies.points->get_points().size() : 0;
    std::vector<PointStrains::Vector> result(n_gauss_points * n_points);
    for_relaxing(plies.points.get(),
                 plies.cords,
                 plies.relaxing_plies.size(),
                 [&](const unsigned int g,
                     const Kind         kind,
                     const unsigned int k,
                     const unsigned int position) {
                   if (kind == Kind::point)
                     result[g * n_points + k] =
                       components<PointStrains::Vector>(added.data() +
                                                        position);
                 });
    return result;
  }


  void
  NonlinearPlies::Changes::elastic_stresses(const Modes::Vector       &dE,
                                            const std::vector<double> &added,
                                            std::vector<double> &stresses) const
  {
    const AtPoints                    strains = plies.at_gauss_points(dE);
    std::vector<PointStrains::Vector> at_points;
    if (points)
      points->elastic_stresses(strains, added_at_points(added), at_points);
    // in the order of elastic_stresses(), of which these are the derivatives
    OfGroups d_eta;
    for (unsigned int m = 0; m < varying.size(); ++m)
      for (unsigned int i = 0; i < Modes::n; ++i)
        d_eta[m] += varying[m][i] * dE[i];
    for_relaxing(
      plies.points.get(),
      plies.cords,
      plies.relaxing_plies.size(),
      [&](const unsigned int g,
          const Kind         kind,
          const unsigned int k,
          const unsigned int position) {
        double *stress = stresses.data() + position;
        if (kind == Kind::point)
          {
            const PointStrains::Vector &of_point =
              at_points[g * plies.points->get_points().size() + k];
            std::copy(of_point.begin_raw(), of_point.end_raw(), stress);
          }
        else if (kind == Kind::cords)
          *stress = cords[g * plies.cords.size() + k] *
                    strain_along(plies.cords[k], strains[g]);
        else
          for (unsigned int m = 1; m < Modes::groups.size(); ++m)
            stress[m - 1] =
              plies.relaxing_plies[k].part * plies.varying_modulus(m) *
              Modes::value_at_gauss_point(Modes::groups[m], g) * d_eta[m - 1];
      });
  }


  Modes::Vector
  NonlinearPlies::Changes::resultants(const std::vector<double> &added) const
  {
    AtPoints of_cords, sums;
    OfGroups of_groups;
    for_relaxing(plies.points.get(),
                 plies.cords,
                 plies.relaxing_plies.size(),
                 [&](const unsigned int g,
                     const Kind         kind,
                     const unsigned int k,
                     const unsigned int position) {
                   const double *stress = added.data() + position;
                   if (kind == Kind::cords)
                     for (unsigned int s = 0; s < Resultants::n_tangential; ++s)
                       of_cords[g][s] += plies.cords[k].thickness * *stress *
                                         plies.cords[k].direction[s];
                   else if (kind == Kind::varying)
                     for (unsigned int m = 1; m < Modes::groups.size(); ++m)
                       of_groups[m - 1] +=
                         Modes::value_at_gauss_point(Modes::groups[m], g) *
                         stress[m - 1] / n_gauss_points;
                 });
    // work-conjugate to the strains of elastic_stresses(): the transpose of
    // their derivatives
    if (points)
      points->resultants(added_at_points(added),
                         make_array_view(sums.begin(), sums.end()));
    for (unsigned int g = 0; g < n_gauss_points; ++g)
      sums[g] += of_cords[g];
    Modes::Vector H =
      Modes::from_gauss_points(sums, plies.with_twist, plies.of_tangents());
    const Modes::Vector weights = weights_of_modes();
    for (unsigned int m = 0; m < varying.size(); ++m)
      for (unsigned int i = 0; i < Modes::n; ++i)
        H[i] += of_groups[m] * varying[m][i] / weights[i];
    return H;
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
  NonlinearPlies::resultants(const Stiffness &stiffness, const Modes::Vector &E)
  {
    Modes::Vector H;
    for (const Modes::Group &group : Modes::groups)
      for (unsigned int i = 0; i < group.size; ++i)
        {
          const unsigned int m   = group.first_mode + i;
          double             sum = 0;
          for (unsigned int n = 0; n < Modes::n; ++n)
            sum += stiffness[m][n] * E[n];
          H[m] = sum / group.weight(i);
        }
    return H;
  }


  Modes::Vector
  NonlinearPlies::resultants(const Linearization  &law,
                             const Modes::Vector  &E,
                             const HistoryOfPlies &history) const
  {
    const Modes::Vector H =
      law.resultants + resultants(law.stiffness, E - law.E);

    // the kink of cords that become slack or taut is kept: linearized across
    // it, their stress would be far from any that they can have
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
    return any
             ? H + Modes::from_gauss_points(changes, with_twist, of_tangents())
             : H;
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
        const Resultants::Vector strain =
          Modes::at_gauss_point(E, g, of_tangents());
        for (const CordPoint &cord : cords)
          if (cord.law->is_slack(strain_along(cord, strain)))
            sums[g] += cord.thickness;
      }
    return sums;
  }
} // namespace Biface
