// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_rig_table_h
#define biface_output_rig_table_h

#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

#include <biface/output/result_file.h>

namespace Biface
{
  struct StepReport;


  /** The signs of the results of a tire test. */
  enum class RigAxes
  {
    /** ISO 8855: forward, to the left, up; the slip angle is positive if the
     * wheel moves to the left of its plane. */
    ISO,
    /** SAE J670e: forward, to the right, down; the slip angle is positive if
     * the wheel moves to the right of its plane. */
    SAE,
    /** The axes of ISO, but slip angle and inclination angle have the sign of
     * the lateral force that they cause @cite Besselink2000. */
    adapted_ISO
  };

  /** The names of RigAxes in files, by their values. */
  std::vector<std::string>
  rig_axes_names();


  /** What a point of a tire test asks for, in the axes of ISO; not a number for
   * what its stage leaves unchanged. Angles in degrees. */
  struct RigTarget
  {
    double load, pressure, velocity, inclination_angle, slip_angle, slip_ratio;
  };


  /** The result of a point of a tire test, in the axes of ISO. Angles in
   * degrees. */
  struct RigPoint
  {
    double pressure = 0, velocity = 0, inclination_angle = 0, slip_angle = 0,
           slip_ratio = 0, angular_velocity = 0, rolling_radius = 0,
           loaded_radius = 0;
    /** The force and the moment of the ground on the wheel, see
     * RollingSummary. */
    dealii::Tensor<1, 3> force, moment;
    double               axle_moment = 0, rolling_resistance = 0;
    double       footprint_length = 0, footprint_width = 0, footprint_area = 0;
    unsigned int n_iterations = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &pressure &velocity &inclination_angle &slip_angle &slip_ratio;
      archive &angular_velocity &rolling_radius                  &loaded_radius;
      archive &force &moment &axle_moment        &rolling_resistance;
      archive &footprint_length &footprint_width &footprint_area;
      archive                                    &n_iterations;
    }
  };


  /** The point of a tire test at the end of its stage.
   * @param report that of the last step of the stage. */
  RigPoint
  rig_point(const RigTarget &target, const StepReport &report);


  /** The table of a tire test, `tire_test.csv`: a row for each point, also for
   * those that have failed, written anew whenever points are added. */
  class RigTable
  {
  public:
    static constexpr const char *file_name = "tire_test.csv";

    /** The results of points, and the reasons why others have none, both by
     * the positions of their stages. */
    using Points   = std::map<unsigned int, RigPoint>;
    using Failures = std::map<unsigned int, std::string>;

    /** The directory is kept by reference.
     * @param targets those of the points, in the order of their stages.
     * @param first_point the position of the stage of the first point: all
     * stages from there on are points. */
    RigTable(const RigAxes                 axes,
             const std::vector<RigTarget> &targets,
             const unsigned int            first_point,
             ResultsDirectory             &directory);

    /** Whether the stage at a position is a point of the test. */
    bool
    is_point(const unsigned int position) const
    {
      return position >= first_point;
    }

    /** What the point of the stage at a position asks for. */
    const RigTarget &
    target(const unsigned int position) const
    {
      return targets[position - first_point];
    }

    /** Write the table if it is not up to date. Must be called on all ranks.
     * Throws OutputError. */
    void
    write(const Points &points, const Failures &failures);

    /** "2 of 30 points of the tire test failed" with the reason of the first
     * one; empty if none did. */
    std::string
    warning(const Failures &failures) const;

    /** The name of the file, if it is written; else empty. */
    std::string
    description() const;

  private:
    /** The row of a stage. The point is null if it failed. */
    std::string
    row(const unsigned int position,
        const RigPoint    *point,
        const std::string &status) const;

    const RigAxes                axes;
    const std::vector<RigTarget> targets;
    const unsigned int           first_point;
    ResultsDirectory            &directory;
    std::size_t                  n_written = 0;
  };
} // namespace Biface

#endif
