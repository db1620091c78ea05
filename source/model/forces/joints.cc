// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/stiffness_along.h>
#include <biface/model/forces/joints.h>
#include <biface/model/mesh/fold_side.h>
#include <biface/model/mesh/strip.h>

namespace Biface
{
  using namespace dealii;

  JointAngle::JointAngle(const std::array<Tensor<1, 3>, 2> &W,
                         const std::array<Tensor<1, 3>, 2> &change)
  {
    const std::array<double, 2> length{{W[0].norm(), W[1].norm()}};
    const double                both   = length[0] * length[1];
    const double                cosine = W[0] * W[1] / both,
                 sine = cross_product_3d(W[0], W[1]).norm() / both;

    // without the difference of large products
    angle =
      (W[0] * change[1] + change[0] * W[1] + change[0] * change[1]) / both;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const double       square = length[k] * length[k];
        const Tensor<1, 3> w      = W[k] + change[k],
                           other  = W[1 - k] + change[1 - k];
        angle -=
          cosine / 2 * (2 * W[k] * change[k] + change[k] * change[k]) / square;
        gradient[k]         = (other / both - cosine / square * w) / sine;
        curvature[k][k]     = -cosine / square / sine;
        curvature[k][1 - k] = 1 / both / sine;
      }
    angle /= sine;
  }


  namespace
  {
    /** The moment per length and angle of a side where parts are joined
     * rigidly. Unit: force. */
    double
    rigid_stiffness(const ShellMesh &mesh, const FoldSide &fold)
    {
      // an additional strip of a hundredth of the thickness yields as much
      constexpr double factor  = 100;
      double           minimum = std::numeric_limits<double>::infinity();
      for (const FoldSide::Part &part : fold.parts)
        {
          const Laminate &wall = mesh.strips[part.strip].laminate;
          minimum              = std::min(minimum,
                             bending_stiffness_along(wall, part.across) /
                               wall.thickness());
        }
      return factor * minimum;
    }


    /** The half difference of the faces of the undeformed shell at a vertex. */
    Tensor<1, 3>
    undeformed(const Cell &element, const unsigned int vertex)
    {
      const ElementGeometry::Vertex &at = element.geometry.vertices[vertex];
      Tensor<1, 3>                   normal;
      normal[2] = at.thickness / 2;
      return at.axes * normal;
    }
  } // namespace


  Joints::Joints(const ShellMesh &mesh)
  {
    agree_on_errors(mesh.communicator, [&]() {
      for (const FoldSide &fold : mesh.folds)
        {
          if (fold.stiffness == 0)
            continue;
          const double stiffness =
            (std::isinf(fold.stiffness) ? rigid_stiffness(mesh, fold)
                                        : fold.stiffness);
          // cells of one part have the same nodes
          std::vector<std::array<unsigned int, 2>> parts;
          for (const FoldSide::Part &part : fold.parts)
            if (std::find(parts.begin(), parts.end(), part.nodes) ==
                parts.end())
              parts.push_back(part.nodes);
          for (unsigned int i = 0; i < parts.size(); ++i)
            for (unsigned int j = 0; j < i; ++j)
              {
                Pair pair{
                  element_between(
                    mesh,
                    {{parts[j][0], parts[j][1], parts[i][0], parts[i][1]}}),
                  {}};
                for (unsigned int end = 0; end < 2; ++end)
                  {
                    if (parts[i][end] == parts[j][end])
                      continue;
                    pair.stiffness[end] = stiffness * fold.length / 2;
                    const Node &one     = mesh.nodes[parts[j][end]],
                               &two     = mesh.nodes[parts[i][end]];
                    const double sine   = cross_product_3d(one.surface.frame[2],
                                                         two.surface.frame[2])
                                          .norm();
                    if (!(sine > 0.05))
                      throw InputError(
                        "parts of the mesh meet at (" +
                        vector_to_string(one.surface.position) +
                        "), where their normals are parallel, so that no fold "
                        "joins them: let the cells there be smaller, or raise "
                        "'Surface/Mesh/Fold angle'.");
                  }
                pairs.push_back(pair);
              }
        }
    });
  }


  std::vector<const Cell *>
  Joints::elements() const
  {
    std::vector<const Cell *> result;
    for (const Pair &pair : pairs)
      result.push_back(&pair.element);
    return result;
  }


  void
  Joints::add(const CellState &at, CellForces &forces) const
  {
    const Pair &pair = pairs[at.index];
    for (unsigned int end = 0; end < 2; ++end)
      {
        if (pair.stiffness[end] == 0)
          continue;
        const std::array<unsigned int, 2> vertex{{end, 2 + end}};
        const auto dof = [&](const unsigned int k, const unsigned int i) {
          return MixedElement::dof(vertex[k], i, MixedElement::half_difference);
        };
        std::array<Tensor<1, 3>, 2> W, change;
        std::array<Tensor<2, 3>, 2> axes;
        for (unsigned int k = 0; k < 2; ++k)
          {
            axes[k] = pair.element.geometry.vertices[vertex[k]].axes;
            W[k]    = undeformed(pair.element, vertex[k]);
            for (unsigned int i = 0; i < 3; ++i)
              change[k][i] = at.V[dof(k, i)];
            change[k] = axes[k] * change[k];
          }
        const JointAngle joint(W, change);
        const double     moment = pair.stiffness[end] * joint.angle;
        for (unsigned int k = 0; k < 2; ++k)
          {
            const Tensor<1, 3> own = joint.gradient[k] * axes[k];
            forces.square += (moment * own).norm_square();
            for (unsigned int i = 0; i < 3; ++i)
              forces.force[dof(k, i)] -= moment * own[i];
            for (unsigned int l = 0; forces.with_tangent && l < 2; ++l)
              {
                const Tensor<1, 3> other = joint.gradient[l] * axes[l];
                const Tensor<2, 3> turn  = transpose(axes[k]) * axes[l];
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    forces.tangent[dof(k, i)][dof(l, j)] +=
                      pair.stiffness[end] * own[i] * other[j] +
                      moment * joint.curvature[k][l] * turn[i][j];
              }
          }
      }
  }
} // namespace Biface
