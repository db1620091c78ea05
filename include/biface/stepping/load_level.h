// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_load_level_h
#define biface_stepping_load_level_h

#include <deal.II/base/tensor.h>

#include <vector>


namespace Biface
{
  /** Loads, motions of the ground, and how a wheel rolls: a @p Value of
   * each, such as std::optional of what a stage prescribes. All functions for
   * all of them use the lists for_each_motion() and for_each_load(). */
  template <template <class> class Value>
  struct LoadsOf
  {
    Value<double> pressure{};
    /** The factors of the dead loads and of prescribed displacements of
     * supports, see Loads::factors. */
    std::vector<Value<double>> factors = std::vector<Value<double>>(1);

    /** The travel since the ground first touched the shell. */
    Value<double> travel{};
    /** The slide and the turn of the ground, see RigidBody::displaced();
     * the turn is in degrees. */
    Value<dealii::Tensor<1, 3>> slide{};
    Value<double>               turn{};
    /** The angle by which the wheel has turned on the ground, in degrees,
     * see RigidBody::rotated(). */
    Value<double> wheel_turn{};
    /** The inclination angle of the wheel of ISO 8855, in degrees: the
     * ground leans the other way. */
    Value<double> inclination_angle{};

    /** The motion of a rolling wheel, see Rolling; the slip angle is in
     * degrees. */
    Value<double> angular_velocity{};
    Value<double> ground_velocity{};
    Value<double> slip_angle{};

    /** The number of stages whose contact has another stiffness than that of
     * the stage before, up to now: in such a stage, its part. See
     * StageRun::loads_at(). */
    Value<double> changes_of_stiffness{};

    /** The time since the start, and the temperature of the shell. */
    Value<double> time{};
    Value<double> temperature{};
  };


  /** Call a function for each motion of the ground, with those of all the
   * given objects. */
  template <class Function, class... Levels>
  void
  for_each_motion(const Function &function, Levels &&...levels)
  {
    function(levels.travel...);
    function(levels.slide...);
    function(levels.turn...);
    function(levels.wheel_turn...);
    function(levels.inclination_angle...);
  }


  /** Call a function for each load and motion, with those of all the given
   * objects, which must have the same number of factors. */
  template <class Function, class First, class... Levels>
  void
  for_each_load(const Function &function, First &&first, Levels &&...levels)
  {
    function(first.pressure, levels.pressure...);
    for (unsigned int i = 0; i < first.factors.size(); ++i)
      function(first.factors[i], levels.factors[i]...);
    for_each_motion(function, first, levels...);
    function(first.angular_velocity, levels.angular_velocity...);
    function(first.ground_velocity, levels.ground_velocity...);
    function(first.slip_angle, levels.slip_angle...);
    function(first.changes_of_stiffness, levels.changes_of_stiffness...);
    function(first.time, levels.time...);
    function(first.temperature, levels.temperature...);
  }


  /** A level with at least @p n factors: loads that had no factor of their own
   * take the common one. */
  template <class Level>
  Level
  with_factors(const Level &level, const std::size_t n)
  {
    Level result = level;
    while (result.factors.size() < n)
      result.factors.push_back(level.factors[0]);
    return result;
  }


  /** Add the number of factors to an archive, or make room for as many. */
  template <class Archive, class Level>
  void
  serialize_number_of_factors(Archive &archive, Level &level)
  {
    unsigned int n = level.factors.size();
    archive     &n;
    level.factors.resize(n);
  }


  template <class T>
  using Plain = T;


  /** Loads and motions at an instant of an analysis. */
  struct LoadLevel : LoadsOf<Plain>
  {
    bool
    rolls() const
    {
      return angular_velocity != 0 || ground_velocity != 0;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      serialize_number_of_factors(archive, *this);
      for_each_load([&archive](auto &load) { archive &load; }, *this);
    }
  };


  /** The values of all loads and of the components of all motions. */
  std::vector<double>
  load_components(const LoadLevel &level);

  /** The part of the change of the loads from start to end that a level has
   * reached, by the first load that changes; NaN if none does. */
  double
  load_fraction(const LoadLevel &start,
                const LoadLevel &reached,
                const LoadLevel &end);

  /** The loads on the straight line through two levels: 0 for the first, 1 for
   * the second. */
  LoadLevel
  interpolated_loads(const LoadLevel &first,
                     const LoadLevel &second,
                     const double     position);

  /** The changes of the load factors between two levels. */
  std::vector<double>
  change_of_factors(const LoadLevel &before, const LoadLevel &after);

  /** The largest change of a load between two levels, relative to the load. */
  double
  relative_change(const LoadLevel &a, const LoadLevel &b);
} // namespace Biface

#endif
