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
#include <biface/model/state/state.h>

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
    half_difference(const Cell &element, const unsigned int vertex)
    {
      const ElementGeometry::Vertex &at = element.geometry.vertices[vertex];
      Tensor<1, 3>                   normal;
      normal[2] = at.thickness / 2;
      return at.axes * normal;
    }
  } // namespace


  Joints::Joints(const ShellMesh &mesh) : mesh(mesh)
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


  Joints::Directors::Directors(const Pair                      &pair,
                               const unsigned int               end,
                               const MixedElement::NodalVector &V)
  {
    for (unsigned int k = 0; k < 2; ++k)
      {
        const unsigned int vertex = end + 2 * k;
        axes[k]                   = pair.element.geometry.vertices[vertex].axes;
        undeformed[k]             = half_difference(pair.element, vertex);
        for (unsigned int i = 0; i < 3; ++i)
          change[k][i] =
            V[MixedElement::dof(vertex, i, MixedElement::half_difference)];
        change[k] = axes[k] * change[k];
      }
  }


  void
  Joints::add(const CellState &at, CellForces &forces) const
  {
    const Pair &pair = pairs[at.index];
    for (unsigned int end = 0; end < 2; ++end)
      {
        if (pair.stiffness[end] == 0)
          continue;
        const auto dof = [&](const unsigned int k, const unsigned int i) {
          return MixedElement::dof(
            end + 2 * k, i, MixedElement::half_difference);
        };
        const Directors  directors(pair, end, at.V);
        const JointAngle joint(directors.undeformed, directors.change);
        const double     moment = pair.stiffness[end] * joint.angle;
        for (unsigned int k = 0; k < 2; ++k)
          {
            const Tensor<1, 3> own = joint.gradient[k] * directors.axes[k];
            forces.square += (moment * own).norm_square();
            for (unsigned int i = 0; i < 3; ++i)
              forces.force[dof(k, i)] -= moment * own[i];
            for (unsigned int l = 0; forces.with_tangent && l < 2; ++l)
              {
                const Tensor<1, 3> other =
                  joint.gradient[l] * directors.axes[l];
                const Tensor<2, 3> turn =
                  transpose(directors.axes[k]) * directors.axes[l];
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    forces.tangent[dof(k, i)][dof(l, j)] +=
                      pair.stiffness[end] * own[i] * other[j] +
                      moment * joint.curvature[k][l] * turn[i][j];
              }
          }
      }
  }


  double
  Joints::strain_energy(const State &state) const
  {
    double energy = 0;
    for (const Pair &pair : pairs)
      {
        const auto V = mesh.cell_values(state.displacement, pair.element);
        const auto V_0 =
          (state.linearization_point
             ? mesh.cell_values(state.linearization_point->displacement,
                                pair.element)
             : V);
        for (unsigned int end = 0; end < 2; ++end)
          {
            if (pair.stiffness[end] == 0)
              continue;
            const Directors  at(pair, end, V_0), change(pair, end, V - V_0);
            const JointAngle joint(at.undeformed, at.change);
            // to second order about the state of the linearization, whose
            // derivative are the linearized forces
            double first = 0, second = 0;
            for (unsigned int k = 0; k < 2; ++k)
              {
                first += joint.gradient[k] * change.change[k];
                for (unsigned int l = 0; l < 2; ++l)
                  second += joint.curvature[k][l] *
                            (change.change[k] * change.change[l]);
              }
            energy += pair.stiffness[end] / 2 *
                      ((joint.angle + first) * (joint.angle + first) +
                       joint.angle * second);
          }
      }
    return energy;
  }
} // namespace Biface
