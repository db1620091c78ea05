// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/straight_line.h>

namespace Biface
{
  using namespace dealii;

  void
  StraightLine::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Start",
                      start,
                      "Start point of the line: radius, axial coordinate.",
                      Unit("length"));
    prm.add_parameter("End",
                      end,
                      "End point of the line: radius, axial coordinate. The "
                      "outward normal points to the right of the line.",
                      Unit("length"));
  }


  namespace
  {
    Tensor<1, 2>
    unit_direction(const StraightLine::Parameters &parameters)
    {
      for (const Point<2> &point : {parameters.start, parameters.end})
        // a cone or a disk may end on the axis
        if (!(point[0] >= 0))
          throw InputError("an end of the line 'Surface/Straight line' has "
                           "the radius " +
                           number_to_string(point[0]) +
                           ", but a meridian must not cross the axis.");
      const Tensor<1, 2> line = parameters.end - parameters.start;
      if (!(line.norm() > 0))
        throw InputError("the ends of the line 'Surface/Straight line' "
                         "coincide, but a meridian must have a positive "
                         "length.");
      return line / line.norm();
    }
  } // namespace


  StraightLine::StraightLine(const Parameters &parameters)
    : start(parameters.start)
    , direction(unit_direction(parameters))
    , length(parameters.start.distance(parameters.end))
  {}


  Meridian::PointOfCurve
  StraightLine::evaluate(const double s) const
  {
    return {start + s * direction, direction, Tensor<1, 2>()};
  }


  double
  StraightLine::parameter_of(const Point<2> &point) const
  {
    return (point - start) * direction;
  }


  std::pair<double, double>
  StraightLine::range() const
  {
    return {0, length};
  }


  double
  StraightLine::coordinate_unit() const
  {
    return 1;
  }
} // namespace Biface
