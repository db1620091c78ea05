// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_heat_rolling_heat_h
#define biface_model_heat_rolling_heat_h

#include <deal.II/base/table.h>

#include <vector>

#include <biface/model/heat/wall_conduction.h>

namespace Biface
{
  class EntryDeclarations;
  struct HeatOfPlies;
  struct Hysteresis;
  struct Loads;
  class ShellMesh;
  struct State;


  /**
   * The heat of a wheel that rolls steadily: what its plies lose in a turn, see
   * Hysteresis, flows through the wall to the gas inside, the air, and the
   * ground. The wheel turns so fast that all particles of a line around the
   * axle have the same temperature.
   */
  class RollingHeat
  {
  public:
    struct Parameters
    {
      /** The source of the temperatures of the plies: the stage, or a
       * computation, without or with an effect on the relaxation. */
      enum class Temperatures
      {
        given,
        computed,
        coupled
      };

      Temperatures temperatures = Temperatures::given;
      /** The films to the gas inside, to the air, and to the ground. */
      HeatFilm inside, air, ground;

      void
      add_parameters(EntryDeclarations &prm);

      /** Throws InputError if a value is invalid. */
      void
      check() const;
    };

    /** The mesh is kept by reference. */
    RollingHeat(const Parameters &parameters, const ShellMesh &mesh);

    bool
    is_computed() const
    {
      return parameters.temperatures != Parameters::Temperatures::given;
    }

    bool
    is_coupled() const
    {
      return parameters.temperatures == Parameters::Temperatures::coupled;
    }

    /** The part of a turn in which each strip touches the ground. Must be
     * called on all ranks. */
    std::vector<double>
    parts_in_contact(const State &state) const;

    /** The field of an equilibrium in which the wheel rolls.
     * @param parts see parts_in_contact(). */
    HeatOfPlies
    field(const Hysteresis          &hysteresis,
          const std::vector<double> &parts,
          const Loads               &loads) const;

    /** The temperatures that the relaxation in a state follows. */
    dealii::Table<2, double>
    followed(const State &state) const;

    /** The iteration between rolling and conduction in a step, in which the
     * relaxation follows the temperatures. */
    class Iteration
    {
    public:
      /** @param heat kept by reference. */
      explicit Iteration(const RollingHeat &heat) : heat(heat)
      {}

      /** Let the relaxation in a state follow the temperatures that its losses
       * gave, by Aitken's method.
       * @param tolerance relative to the largest difference of the temperatures
       * from those of the films.
       * @return whether it already did. */
      bool
      advance(const HeatOfPlies &field, const double tolerance, State &state);

    private:
      const RollingHeat  &heat;
      std::vector<double> last_change;
      double              factor = 1;
    };

  private:
    const Parameters parameters;
    const ShellMesh &mesh;
    /** The section of the wall, without sources and films. A ply that does not
     * exist is thin. */
    WallSection section;
    /** The volumes by strip and ply; 0 where a ply does not exist. Unit:
     * length^3. */
    dealii::Table<2, double> volumes;
  };
} // namespace Biface

#endif
