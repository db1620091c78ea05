// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_known_surface_h
#define biface_surface_known_surface_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <biface/input/formula.h>

namespace Biface
{
  /** A surface that is known apart from the mesh on it: it gives the places of
   * nodes and the normals there. */
  class KnownSurface
  {
  public:
    virtual ~KnownSurface() = default;

    /** The point of the surface next to a point that is close to it; nothing
     * if none is found.
     * @param size the size of the whole mesh. Unit: length. */
    virtual std::optional<dealii::Point<3>>
    closest_point(const dealii::Point<3> &x, const double size) const = 0;

    /** The point of the surface next to the middle of other points of it, on
     * the part of the surface on which these are; nothing if none is found.
     * @param size the size of the whole mesh. Unit: length. */
    virtual std::optional<dealii::Point<3>>
    point_between(const dealii::Point<3>              &middle,
                  const std::vector<dealii::Point<3>> &others,
                  const double                         size) const = 0;

    /** The point in the middle of two points of a line at which the surface
     * ends or has a fold; nothing if none is found.
     * @param size the size of the whole mesh. Unit: length. */
    virtual std::optional<dealii::Point<3>>
    middle_of_edge(const dealii::Point<3> &a,
                   const dealii::Point<3> &b,
                   const double            size) const
    {
      return closest_point(a + (b - a) / 2, size);
    }

    /** A unit normal at a point of the surface; where there are several, that
     * next to a direction. Zero if there is none, as at a kink.
     * @param size the size of the whole mesh. Unit: length. */
    virtual dealii::Tensor<1, 3>
    normal(const dealii::Point<3>     &x,
           const dealii::Tensor<1, 3> &direction,
           const double                size) const = 0;
  };


  /** The surface on which a formula of x, y and z is zero, whose gradient is
   * found by differences. The closest point of the tangential plane at the last
   * point is the next one, until it stays. */
  class SurfaceOfFormula : public KnownSurface
  {
  public:
    explicit SurfaceOfFormula(const Formula &formula) : formula(formula)
    {}

    std::optional<dealii::Point<3>>
    closest_point(const dealii::Point<3> &x, const double size) const override;

    std::optional<dealii::Point<3>>
    point_between(const dealii::Point<3>              &middle,
                  const std::vector<dealii::Point<3>> &others,
                  const double                         size) const override;

    dealii::Tensor<1, 3>
    normal(const dealii::Point<3>     &x,
           const dealii::Tensor<1, 3> &direction,
           const double                size) const override;

  private:
    double
    value(const dealii::Point<3> &x) const
    {
      return formula.unchecked({x[0], x[1], x[2]});
    }

    /** The step of differences, for which errors of rounding and of the
     * difference are about equal where features are a hundredth as large as the
     * mesh. */
    static double
    step(const double size)
    {
      return 1e-6 * size;
    }

    dealii::Tensor<1, 3>
    gradient(const dealii::Point<3> &x, const double size) const;

    const Formula formula;
  };


  /** The faces of a file of STEP (ISO 10303), with their edges. Throws
   * InputError if the text is none, has no faces, or cannot be read.
   * @param name that of the file, for messages.
   * @param unit the unit of length of the mesh, in millimeters. */
  std::shared_ptr<const KnownSurface>
  surface_of_step(const std::string &text,
                  const std::string &name,
                  const double       unit);
} // namespace Biface

#endif
