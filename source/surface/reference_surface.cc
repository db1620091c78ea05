// SPDX-License-Identifier: LGPL-2.1-or-later

#include <limits>

#include <biface/surface/meridian.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  dealii::DerivativeForm<1, 2, 3>
  ReferenceSurface::push_forward_gradient(const dealii::Point<2> &alpha) const
  {
    const SurfacePoint              point = evaluate(alpha);
    dealii::DerivativeForm<1, 2, 3> tangents;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int a = 0; a < 2; ++a)
        tangents[i][a] = point.lame[a] * point.frame[a][i];
    return tangents;
  }


  std::vector<RoundedCorner>
  ReferenceSurface::get_corners() const
  {
    return {};
  }


  std::vector<double>
  ReferenceSurface::formula_variables(const dealii::Point<3> &x,
                                      const dealii::Point<2> &alpha) const
  {
    return {x[0],
            x[1],
            x[2],
            alpha[0] / coordinate_unit(0),
            alpha[1] / coordinate_unit(1)};
  }


  double
  ReferenceSurface::end(const unsigned int a) const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    if (a != 0)
      return infinity;
    const double last = range().second;
    return last < std::numeric_limits<double>::max() ? last / coordinate_unit(0)
                                                     : infinity;
  }
} // namespace Biface
