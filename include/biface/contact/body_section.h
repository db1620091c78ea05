// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_contact_body_section_h
#define biface_contact_body_section_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Biface
{
  /** The signed distance from the boundary of a plane region. */
  struct SectionPoint
  {
    /** The distance, negative inside the region. Unit: length. */
    double distance;
    /** The derivative of the distance, a unit vector. */
    dealii::Tensor<1, 2> gradient;
    /** The curvature: the second derivative of the distance is this number
     * times @f$\mathbf t\mathbf t^T@f$ with the unit vector @f$\mathbf t@f$
     * along the boundary. Unit: 1/length. */
    double curvature;
  };


  /** The section of a body that is extruded along an axis or revolved about
   * one: a region of the plane. */
  class BodySection
  {
  public:
    virtual ~BodySection() = default;

    virtual SectionPoint
    evaluate(const dealii::Point<2> &x) const = 0;
  };


  /** A disk; with a negative radius, the plane around a hole. */
  class Disk : public BodySection
  {
  public:
    /** The disk of a circle, or the plane around it.
     * @param radius any nonzero number. */
    Disk(const dealii::Point<2> &center, const double radius)
      : center(center), radius(radius)
    {}

    SectionPoint
    evaluate(const dealii::Point<2> &x) const override;

  private:
    const dealii::Point<2> center;
    const double           radius;
  };


  /**
   * A region that is bounded by straight lines and arcs: a polygon with rounded
   * corners. An open polygon goes on beyond its first and last point along its
   * first and last line to infinity, and the region is to the right of one who
   * walks along it: below a curve from left to right. A closed polygon is a
   * region in either direction.
   *
   * The distance is exact on both sides. At a sharp corner it is that from the
   * corner.
   */
  class RoundedPolygon : public BodySection
  {
  public:
    struct Corner
    {
      dealii::Point<2> point;
      /** The radius of the arc that rounds the corner; 0 for a sharp one. */
      double radius = 0;
    };

    /** The region of given corners. Throws InputError if there are fewer than
     * two corners, or three of a closed polygon, if corners coincide, if it
     * turns back at a corner, crosses itself, or has no room for the arcs.
     * @param corners those of a closed polygon end with the first, whose
     * radius may be given at either place.
     * @param entry the name of the entry that contains them, for error
     * messages. */
    RoundedPolygon(std::vector<Corner> corners, const std::string &entry);

    SectionPoint
    evaluate(const dealii::Point<2> &x) const override;

    /** The radii of the arcs. */
    std::vector<double>
    radii() const;

  private:
    struct Line
    {
      dealii::Point<2>     start;
      dealii::Tensor<1, 2> along;
      /** The range of the positions along the line. Unit: length. */
      double begin, end;
    };

    struct Arc
    {
      dealii::Point<2> center;
      double           radius;
      /** Whether the region is on the side of the center. */
      bool convex;
      /** The outward normals at both ends of the arc. */
      dealii::Tensor<1, 2> first, last;
    };

    std::vector<Line> lines;
    std::vector<Arc>  arcs;
  };
} // namespace Biface

#endif
