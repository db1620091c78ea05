// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <biface/contact/bristles.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** In compression over shear, that of rubber, see Tread: on stiffer ground
     * the edge of the footprint would jump from node to node. */
    constexpr double stiffest_tread = 4;


    /** The matrix of the cross product with a vector. */
    Tensor<2, 3>
    cross_product_matrix(const Tensor<1, 3> &w)
    {
      Tensor<2, 3> result;
      for (unsigned int j = 0; j < 3; ++j)
        {
          Tensor<1, 3> e;
          e[j]                      = 1;
          const Tensor<1, 3> column = cross_product_3d(w, e);
          for (unsigned int i = 0; i < 3; ++i)
            result[i][j] = column[i];
        }
      return result;
    }


    /** The motion of the ground at a position while the wheel turns by an
     * angle, times its angular speed, so that it is finite for a locked wheel.
     */
    struct GroundStep
    {
      Tensor<1, 3> value;
      Tensor<2, 3> per_position;
      Tensor<1, 3> per_angular_speed;
    };


    GroundStep
    ground_step(const GroundMotion &ground,
                const Point<3>     &x,
                const double        angle,
                const double        angular_speed)
    {
      // near a locked wheel a drum would turn several times between two nodes,
      // whose bristles slip, in whatever direction it moves them there
      constexpr double largest_turn = 0.5;

      const Tensor<2, 3> spin = cross_product_matrix(ground.spin);
      const double       turn = angle * ground.spin.norm();
      // the time between the nodes is angle/|Omega|: times |Omega|, the way at
      // a constant velocity does not depend on Omega
      if (turn == 0 || turn > largest_turn * angular_speed)
        return {angle * ground.at(x), angle * spin, {}};

      // about its axis
      const double       spin_square = ground.spin.norm_square();
      const Tensor<1, 3> r =
        x - ground.point -
        cross_product_3d(ground.spin, ground.velocity) / spin_square;
      const Tensor<1, 3> ahead =
        (ground.velocity * ground.spin) / spin_square * ground.spin;
      const double       psi      = turn / angular_speed;
      const Tensor<2, 3> axis     = spin / ground.spin.norm();
      const Tensor<2, 3> identity = Tensor<2, 3>(unit_symmetric_tensor<3>());
      // Rodrigues' formula, with 1 - cos(psi) = 2 sin^2(psi/2)
      const Tensor<2, 3> rotation =
        identity + std::sin(psi) * axis +
        2 * std::pow(std::sin(psi / 2), 2) * axis * axis;
      const Tensor<2, 3> moved = rotation - identity;
      return {angle * ahead + angular_speed * (moved * r),
              angular_speed * moved,
              moved * r - psi * (axis * (rotation * r))};
    }


    /** The products of a vector with both tangents. */
    Tensor<1, 2>
    along(const std::array<Tensor<1, 3>, 2> &tangents, const Tensor<1, 3> &v)
    {
      return Tensor<1, 2>({tangents[0] * v, tangents[1] * v});
    }


    /** The part of the segment between two stations that touches, with its
     * derivatives by the clearance before and by the pressure at its end. */
    struct TouchingPart
    {
      double value         = 1;
      double per_clearance = 0;
      double per_pressure  = 0;
    };


    /** @param stiffness of a tread, whose clearance at the end of the segment
     * is linear with the one before. */
    TouchingPart
    touching_part(const double before,
                  const double pressure,
                  const double stiffness)
    {
      // the node before is inside the ground, though not in contact in this
      // iteration: the whole segment touches
      if (!(before > 0))
        return {};
      if (!(pressure > 0))
        return {0, 0, 0};
      // c_j/(c_j - c_{j-1}) of section 10 of doc/theory.md, where the clearance
      // at the end of the segment is -pressure/stiffness
      const double all = pressure + stiffness * before;
      return {pressure / all,
              -stiffness * pressure / (all * all),
              stiffness * before / (all * all)};
    }
  } // namespace


  namespace
  {
    /** The particles that come to a station in a part of a step from the
     * segment before it: P and gamma of section 10 of doc/theory.md. */
    struct Passing
    {
      /** P, with its derivatives by C and by the part of the segment that
       * touches. */
      double part, per_way = 1, per_touching = 0;
      /** gamma, the part of its motion that the ground has, likewise. */
      double of_ground, of_ground_per_way, of_ground_per_touching;

      /** @param way C: that of the particles, over the segment.
       * @param stays, touching the parts that touch of the motion at the
       * station, and of the segment. */
      Passing(const double way, const double stays, const double touching)
        : part(way)
      {
        if (touching < 1 && way > 0 && way >= touching)
          {
            // all particles at the station have entered in this time
            part                   = 1;
            per_way                = 0;
            of_ground              = touching / way;
            of_ground_per_way      = -touching / (way * way);
            of_ground_per_touching = 1 / way;
            return;
          }
        if (touching < 1 && touching > 0)
          {
            part         = way / touching;
            per_way      = 1 / touching;
            per_touching = -part / touching;
          }
        of_ground              = (1 - part) * stays + part;
        of_ground_per_way      = per_way * (1 - stays);
        of_ground_per_touching = per_touching * (1 - stays);
      }
    };
  } // namespace


  BristleLaw::Station
  BristleLaw::station(const RigidBody &body,
                      const Point<3>  &x,
                      const bool       touches,
                      const double     angle)
  {
    Station station;
    station.touches      = touches;
    station.x            = x;
    station.at_body      = body.evaluate(x);
    station.tangents     = body.tangents(station.at_body.normal);
    const auto by_normal = body.tangent_derivatives(station.at_body.normal);
    for (unsigned int i = 0; i < 2; ++i)
      station.tangent_gradients[i] =
        by_normal[i] * Tensor<2, 3>(station.at_body.normal_gradient);
    station.angle = angle;
    return station;
  }


  std::vector<BristleLaw::Bristle>
  BristleLaw::deflections(const std::vector<Station> &line,
                          const Rolling              &rolling) const
  {
    std::vector<Bristle> result(line.size());
    for (unsigned int j = 0; j < line.size(); ++j)
      {
        // a node that does not touch has a bristle without deflection, with
        // which that of the next node begins
        result[j].first = j;
        result[j].per_position.resize(1);
        if (j > 0 && line[j].touches)
          move(line[j - 1], result[j - 1], line[j], rolling, result[j]);
      }
    return result;
  }


  void
  BristleLaw::move(const Station &before,
                   const Bristle &bristle_before,
                   const Station &at,
                   const Rolling &rolling,
                   Bristle       &bristle) const
  {
    const double        speed = std::abs(rolling.angular_velocity);
    const Tensor<1, 3> &n     = at.at_body.normal;
    // where contact is stiff, the pressure of a clearance that is not yet that
    // of an equilibrium would be many times too large
    const double exact    = -condition.multiplier(at.at_body.clearance);
    const double pressure = at.pressure.value_or(exact);
    // the trial deflection and its derivatives, times the angular speed
    const TouchingPart theta =
      before.touches
        ? TouchingPart()
        : touching_part(before.at_body.clearance,
                        pressure,
                        std::min(condition.penalty_stiffness(),
                                 stiffest_tread * law.tangential_stiffness()));
    const GroundStep ground =
      ground_step(rolling.ground, before.x, at.angle, speed);
    const Tensor<1, 3> motion       = speed * (at.x - before.x) - ground.value;
    const Tensor<1, 2> along_motion = along(at.tangents, motion);
    Tensor<1, 2>       trial =
      speed * bristle_before.deflection + theta.value * along_motion;
    const Tensor<1, 2> trial_extrapolation =
      speed * bristle_before.extrapolation +
      (exact - pressure) * theta.per_pressure * along_motion;

    // a deflection depends on all stations that the particle has passed in
    // contact; the list grows by one along the footprint
    bristle.first        = bristle_before.first;
    bristle.per_position = bristle_before.per_position;
    for (auto &by_station : bristle.per_position)
      for (Tensor<1, 3> &component : by_station)
        component *= speed;
    bristle.per_position.emplace_back();
    auto &by_before = *(bristle.per_position.end() - 2);
    auto &by_itself = bristle.per_position.back();
    for (unsigned int i = 0; i < 2; ++i)
      {
        // a clearance changes by -n times the motion: theta depends on that of
        // the station before and on the pressure at this one
        const Tensor<1, 3> &t = at.tangents[i];
        by_before[i] -=
          theta.value * (speed * t + t * ground.per_position) +
          theta.per_clearance * along_motion[i] * before.at_body.normal;
        by_itself[i] +=
          theta.value * (speed * t + motion * at.tangent_gradients[i]) +
          theta.per_pressure * along_motion[i] * condition.penalty_stiffness() *
            n;
      }
    Tensor<1, 2> per_speed =
      bristle_before.deflection +
      theta.value *
        along(at.tangents, at.x - before.x - ground.per_angular_speed);
    // the derivative by the angular velocity of the bristle before, by the
    // speed
    const double sign = rolling.angular_velocity < 0 ? -1 : 1;
    per_speed += speed * sign * bristle_before.per_angular_velocity;

    bristle.per_angular_velocity = sign * per_speed;
    if (speed == 0 && trial.norm() == 0)
      {
        // nothing has moved
        for (auto &by_station : bristle.per_position)
          by_station = {};
        bristle.per_angular_velocity = 0;
        return;
      }
    // the factor speed on both sides
    limit(bristle,
          trial,
          trial_extrapolation,
          speed,
          pressure,
          exact,
          condition.penalty_stiffness() * n);
    if (!bristle.is_limited)
      bristle.per_angular_velocity -= sign / speed * bristle.deflection;
    else
      bristle.slip_velocity = (trial - speed * bristle.deflection) / at.angle;
  }


  void
  BristleLaw::limit(Bristle            &bristle,
                    const Tensor<1, 2> &trial,
                    const Tensor<1, 2> &trial_extrapolation,
                    const double        scale,
                    const double        pressure,
                    const double        exact_pressure,
                    const Tensor<1, 3> &pressure_per_position) const
  {
    // the projection of section 10 of doc/theory.md: Coulomb's limit as a
    // length of the deflection
    const FrictionLaw::Limit limit  = law.limit(pressure);
    const double             radius = limit.value / law.tangential_stiffness();
    const double             norm   = trial.norm();
    if (norm <= scale * radius)
      {
        bristle.deflection    = trial / scale;
        bristle.extrapolation = trial_extrapolation / scale;
        for (auto &by_station : bristle.per_position)
          for (Tensor<1, 3> &component : by_station)
            component /= scale;
        bristle.per_angular_velocity /= scale;
        return;
      }
    // in slip the length is that of the limit, so that only changes across the
    // trial deflection turn it; the scale cancels
    const Tensor<1, 2> direction = trial / norm;
    const auto         project   = [&](const Tensor<1, 2> &v) {
      return radius / norm * (v - (direction * v) * direction);
    };
    const double per_pressure = limit.per_pressure / law.tangential_stiffness();
    bristle.is_limited        = true;
    bristle.deflection        = radius * direction;
    bristle.extrapolation =
      project(trial_extrapolation) +
      (exact_pressure - pressure) * per_pressure * direction;
    for (auto &by_station : bristle.per_position)
      {
        const auto unlimited = by_station;
        for (unsigned int k = 0; k < 3; ++k)
          {
            const Tensor<1, 2> column =
              project(Tensor<1, 2>({unlimited[0][k], unlimited[1][k]}));
            for (unsigned int i = 0; i < 2; ++i)
              by_station[i][k] = column[i];
          }
      }
    // the limit follows the pressure of the clearance at this station
    for (unsigned int i = 0; i < 2; ++i)
      bristle.per_position.back()[i] +=
        per_pressure * direction[i] * pressure_per_position;
    bristle.per_angular_velocity = project(bristle.per_angular_velocity);
  }


  BristleLaw::Bristle
  BristleLaw::move_in_time(const std::vector<Station> &line,
                           const std::vector<Past>    &past,
                           const std::vector<Bristle> &at_start,
                           const PartOfStep           &part,
                           const unsigned int          j,
                           const Rolling              &rolling) const
  {
    const auto position = [&](const unsigned int i, const double time) {
      return past[i].x + time * (line[i].x - past[i].x);
    };
    const auto clearance = [&](const unsigned int i, const double time) {
      return past[i].clearance +
             time * (line[i].at_body.clearance - past[i].clearance);
    };
    const Station &at      = line[j];
    const bool     is_last = part.to == 1;
    Bristle        bristle;
    bristle.per_position.resize(j + 1);
    if (is_last ? !at.touches : !(clearance(j, part.to) < 0))
      return bristle;

    const double        speed = std::abs(rolling.angular_velocity);
    const Tensor<1, 3> &n     = at.at_body.normal;
    const double        exact = -condition.multiplier(clearance(j, part.to));
    const double pressure     = is_last ? at.pressure.value_or(exact) : exact;
    const double stiffness =
      std::min(condition.penalty_stiffness(),
               stiffest_tread * law.tangential_stiffness());
    const Tensor<1, 3> pressure_per_position =
      condition.penalty_stiffness() * part.to * n;

    const TouchingPart stays =
      touching_part(clearance(j, part.from), pressure, stiffness);
    const TouchingPart passes =
      touching_part(clearance(j - 1, part.from), pressure, stiffness);
    const double  per_speed = part.duration / at.angle;
    const Passing flow(per_speed * speed, stays.value, passes.value);

    const GroundStep ground =
      ground_step(rolling.ground, position(j - 1, part.from), at.angle, speed);
    const Tensor<1, 3> of_body =
      per_speed * ground.value + (part.to - part.from) * past[j].shift;
    const Tensor<1, 3> of_staying =
      position(j, part.to) - position(j, part.from);
    const Tensor<1, 3> of_passing =
      position(j, part.to) - position(j - 1, part.from);
    const Tensor<1, 3> motion = (1 - flow.part) * stays.value * of_staying +
                                flow.part * passes.value * of_passing -
                                flow.of_ground * of_body;
    const Bristle     &own    = at_start[j];
    const Bristle     &before = at_start[j - 1];
    const Tensor<1, 2> trial  = (1 - flow.part) * own.deflection +
                               flow.part * before.deflection +
                               along(at.tangents, motion);
    const Tensor<1, 2> by_passing =
      before.deflection - own.deflection +
      along(at.tangents, passes.value * of_passing - stays.value * of_staying);
    // by both parts that touch
    const Tensor<1, 2> by_stays =
      (1 - flow.part) * along(at.tangents, of_staying - of_body);
    const Tensor<1, 2> by_passes =
      flow.per_touching * by_passing +
      along(at.tangents,
            flow.part * of_passing - flow.of_ground_per_touching * of_body);
    const Tensor<1, 2> by_pressure =
      stays.per_pressure * by_stays + passes.per_pressure * by_passes;
    for (unsigned int i = 0; i <= j; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        {
          bristle.per_position[i][c] = (1 - flow.part) * own.per_position[i][c];
          if (i < j)
            bristle.per_position[i][c] += flow.part * before.per_position[i][c];
        }
    for (unsigned int c = 0; c < 2; ++c)
      {
        const Tensor<1, 3> &t = at.tangents[c];
        bristle.per_position[j][c] +=
          ((1 - flow.part) * stays.value * (part.to - part.from) +
           flow.part * passes.value * part.to) *
            t +
          motion * at.tangent_gradients[c] +
          by_pressure[c] * pressure_per_position -
          stays.per_clearance * by_stays[c] * part.from * n;
        bristle.per_position[j - 1][c] -=
          part.from *
          (flow.part * passes.value * t +
           flow.of_ground * per_speed * (t * ground.per_position) +
           passes.per_clearance * by_passes[c] * line[j - 1].at_body.normal);
      }
    // by the speed
    const double sign = rolling.angular_velocity < 0 ? -1 : 1;
    bristle.per_angular_velocity =
      sign * per_speed *
        (flow.per_way * by_passing -
         along(at.tangents,
               flow.of_ground_per_way * of_body +
                 flow.of_ground * ground.per_angular_speed)) +
      (1 - flow.part) * own.per_angular_velocity +
      flow.part * before.per_angular_velocity;
    limit(bristle,
          trial,
          (exact - pressure) * by_pressure,
          1,
          pressure,
          exact,
          pressure_per_position);
    if (bristle.is_limited && part.duration > 0)
      bristle.slip_velocity = (trial - bristle.deflection) / part.duration;
    return bristle;
  }


  std::vector<BristleLaw::Bristle>
  BristleLaw::deflections_in_time(const std::vector<Station> &line,
                                  const std::vector<Past>    &past,
                                  const double                duration,
                                  const Rolling              &rolling) const
  {
    AssertDimension(line.size(), past.size());
    // particles may pass a little more than a segment: where they should pass
    // whole ones, the number of parts must not change in the iteration
    constexpr double more     = 0.01;
    double           smallest = std::numeric_limits<double>::max(), largest = 0;
    for (const Station &station : line)
      {
        smallest = std::min(smallest, station.angle);
        largest  = std::max(largest, station.angle);
      }
    const double angle = std::abs(rolling.angular_velocity) * duration;
    const double n_parts =
      std::max(1., std::ceil((1 - more) * angle / smallest));
    // what has left the line need not be followed
    const double       memory = (4 * line.size() + 20) * largest / smallest;
    const unsigned int n_last =
      static_cast<unsigned int>(std::min(n_parts, std::ceil(memory)));

    std::vector<Bristle> result(line.size());
    for (unsigned int j = 0; j < line.size(); ++j)
      {
        result[j].deflection = past[j].deflection;
        result[j].per_position.resize(j + 1);
      }
    for (unsigned int k = 0; k < n_last; ++k)
      {
        const PartOfStep part{1 - (n_last - k) / n_parts,
                              1 - (n_last - k - 1) / n_parts,
                              duration / n_parts};
        // a first station does not touch, or follows no other on a line that
        // touches all around
        std::vector<Bristle> moved(line.size());
        if (!line.empty())
          moved[0].per_position.resize(1);
        for (unsigned int j = 1; j < line.size(); ++j)
          {
            moved[j] = move_in_time(line, past, result, part, j, rolling);
            moved[j].slip_velocity =
              (moved[j].slip_velocity + k * result[j].slip_velocity) / (k + 1);
          }
        result = std::move(moved);
      }
    return result;
  }
} // namespace Biface
