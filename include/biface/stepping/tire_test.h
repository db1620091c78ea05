// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_tire_test_h
#define biface_stepping_tire_test_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include <biface/stepping/stage.h>

namespace Biface
{
  struct StepReport;

  /**
   * A tire test, as on a test rig: a wheel that rolls at every combination of
   * pressures, inclination angles and loads, and there with slip angles and
   * slip ratios.
   *
   * It is a sequence of stages that follows those of the parameter file. Each
   * point is the end of a stage, which starts from the end of the nearest
   * point before: from zero slip to larger slip on both sides, from load to
   * load, from inclination to inclination. Points at zero slip ratio roll
   * freely, without a moment of the axle.
   */
  struct TireTest
  {
    /** How slip angles and slip ratios are combined. */
    enum class Slip
    {
      /** One of the two is zero. */
      pure,
      /** Every slip angle with every slip ratio. */
      combined
    };

    /** The signs of the results. */
    enum class Axes
    {
      /** ISO 8855: forward, to the left, up; the slip angle is positive if the
       * wheel moves to the left of its plane. */
      ISO,
      /** SAE J670e: forward, to the right, down; the slip angle is positive if
       * the wheel moves to the right of its plane. */
      SAE,
      /** Those of ISO, but slip angle and inclination angle have the sign of
       * the lateral force that they cause @cite Besselink2000. */
      adapted_ISO
    };

    /** The number of the stage from whose end the test starts; 0 for the last
     * one. There the tire is inflated and does not roll. */
    unsigned int start_from = 0;
    /** Empty for that at the start. */
    std::vector<double> pressures;
    std::vector<double> loads;
    std::vector<double> inclination_angles{0.};
    std::vector<double> slip_angles;
    std::vector<double> slip_ratios;
    double              ground_velocity = 0;
    Slip                slip            = Slip::pure;
    unsigned int        n_steps         = 1;
    Axes                axes            = Axes::ISO;

    bool
    is_requested() const
    {
      return !loads.empty();
    }

    /** The number of the stage from whose end the test starts. */
    unsigned int
    number_of_start(const std::vector<Stage> &stages) const
    {
      return start_from == 0 ? stages.size() : start_from;
    }

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Throws InputError if a value is invalid.
     * @param stages those of the parameter file. */
    void
    check(const std::vector<Stage> &stages) const;

    /** Append the stages of the test. */
    void
    append_to(std::vector<Stage> &stages) const;

    /** The number of points. */
    static unsigned int
    n_points(const std::vector<Stage> &stages);
  };


  /** The result of a point of a tire test, in the axes of ISO. */
  struct TireTestResult
  {
    /** Why there is none; empty otherwise. */
    std::string failure;

    double pressure = 0, velocity = 0, inclination_angle = 0, slip_angle = 0,
           slip_ratio = 0, angular_velocity = 0, rolling_radius = 0,
           loaded_radius = 0;
    /** See RollingSummary. */
    dealii::Tensor<1, 3> force, moment;
    double               axle_moment = 0, rolling_resistance = 0;
    double       footprint_length = 0, footprint_width = 0, footprint_area = 0;
    unsigned int n_iterations = 0;

    static TireTestResult
    failed(const std::string &why)
    {
      TireTestResult result;
      result.failure = why;
      return result;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &failure &pressure &velocity &inclination_angle &slip_angle
                                                 &slip_ratio;
      archive &angular_velocity &rolling_radius  &loaded_radius;
      archive &force &moment &axle_moment        &rolling_resistance;
      archive &footprint_length &footprint_width &footprint_area;
      archive                                    &n_iterations;
    }
  };


  /** The result at the end of a stage. */
  TireTestResult
  test_result(const Stage &stage, const StepReport &report);
} // namespace Biface

#endif
