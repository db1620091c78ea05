// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_support_motion_h
#define biface_model_mesh_support_motion_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * A motion of a support: its prescribed displacements with the same load
   * factor.
   *
   * Its force is conjugate to its displacement: their product is the work of
   * the support.
   */
  struct SupportMotion
  {
    enum class Kind
    {
      /** All nodes move by the same vector in the directions that are
       * prescribed. Force and displacement are those along it. */
      translation,
      /** All nodes move as in a small rotation. Force and displacement are
       * moment and angle about its axis. */
      rotation,
      /** The displacement is the largest one of the support; the force is the
       * sum of all, each weighted by its displacement over the largest one. */
      other
    };

    /** The name of the support, followed by the components that it moves if it
     * has several motions. */
    std::string name;
    /** The position of the support in SupportedNodes::bodies. */
    unsigned int body;
    /** The position of the load factor in Loads::factors. */
    unsigned int factor;
    /** How often the part that is modeled occurs in the whole structure: the
     * full turn over a sector between cyclic edges or planes of symmetry, and 2
     * for an edge or point that one plane of symmetry halves. */
    double multiple;
    Kind   kind = Kind::other;
    /** The unit vector along a translation; zero for the other kinds. */
    dealii::Tensor<1, 3> direction = dealii::Tensor<1, 3>();
    /** The displacement at the load factor 1. Unit: length, or radians. */
    double amount = 0;

    /** The name of the column of the displacement: `displacement` or
     * `angle`. */
    const char *
    displacement_name() const
    {
      return kind == Kind::rotation ? "angle" : "displacement";
    }

    /** The name of the column of the force: `force` or `moment`. */
    const char *
    force_name() const
    {
      return kind == Kind::rotation ? "moment" : "force";
    }

    /** The displacement at a load factor. Unit: length, or degrees. */
    double
    displacement_at(const double load_factor) const
    {
      return load_factor * amount *
             (kind == Kind::rotation ? 180 / dealii::numbers::PI : 1.);
    }
  };


  /** The common motion of all supports with a load factor, as of edges on the
   * same rim: the first of those given with this factor; none if there is none
   * or if they differ in kind, amount or multiple. */
  std::optional<SupportMotion>
  common_motion(const std::vector<SupportMotion> &motions,
                const unsigned int                factor);
} // namespace Biface

#endif
