// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/laminate/stiffness_along.h>
#include <biface/model/forces/joints.h>
#include <biface/model/mesh/element_between.h>
#include <biface/model/mesh/fold_side.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/state.h>
#include <biface/model/state/step_in_time.h>

namespace Biface
{
  using namespace dealii;

  JointAngle::JointAngle(const Vectors &undeformed, const Vectors &change)
  {
    const Tensor<1, 3> &W_1 = undeformed[0], &W_2 = undeformed[1],
                       &T = undeformed[2];
    Vectors x;
    for (unsigned int i = 0; i < 3; ++i)
      x[i] = undeformed[i] + change[i];
    const Tensor<1, 3> &w_2 = x[1], &t = x[2];

    // sine and cosine of the angle times lengths, in the undeformed shell, and
    // their changes without differences of numbers that are nearly the same
    const double length = t.norm(), former = T.norm(),
                 squares       = 2 * (T * change[2]) + change[2].norm_square();
    const Tensor<1, 3> normal  = cross_product_3d(W_1, W_2),
                       turning = cross_product_3d(change[0], w_2) +
                                 cross_product_3d(W_1, change[1]);
    const double sine       = T * normal / former,
                 d_products = change[2] * (normal + turning) + T * turning,
                 d_sine =
                   (d_products - sine * squares / (length + former)) / length;
    std::array<double, 2> along, d_along;
    for (unsigned int k = 0; k < 2; ++k)
      {
        along[k]   = undeformed[k] * T;
        d_along[k] = undeformed[k] * change[2] + change[k] * t;
      }
    const double of_parts = along[0] * along[1] / (former * former),
                 cosine   = W_1 * W_2 - of_parts,
                 d_parts  = (d_along[0] * (along[1] + d_along[1]) +
                            along[0] * d_along[1] - of_parts * squares) /
                           (length * length),
                 d_cosine = change[0] * w_2 + W_1 * change[1] - d_parts;
    angle                 = std::atan2(d_sine * cosine - d_cosine * sine,
                       (cosine + d_cosine) * cosine + (sine + d_sine) * sine);

    // a director turns about the line by q.dw, and by -(w.t/t) q.dt
    const Tensor<1, 3>          unit = t / length;
    std::array<double, 2>       s, square;
    std::array<Tensor<1, 3>, 2> q;
    for (unsigned int k = 0; k < 2; ++k)
      {
        s[k]      = x[k] * unit;
        square[k] = x[k].norm_square() - s[k] * s[k];
        q[k]      = cross_product_3d(unit, x[k]) / square[k];
      }
    gradient = {{-q[0], q[1], (s[0] * q[0] - s[1] * q[1]) / length}};

    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          Vectors d;
          d[i][j]                    = 1;
          const double       stretch = unit * d[2] / length;
          const Tensor<1, 3> d_unit  = d[2] / length - stretch * unit;
          Tensor<1, 3>       by_line = -stretch * gradient[2];
          Vectors            d_gradient;
          for (unsigned int k = 0; k < 2; ++k)
            {
              const double       sign = (k == 0 ? -1. : 1.);
              const double       d_s  = d[k] * unit + x[k] * d_unit;
              const Tensor<1, 3> d_q =
                (cross_product_3d(unit, d[k]) + cross_product_3d(d_unit, x[k]) -
                 2 * (x[k] * d[k] - s[k] * d_s) * q[k]) /
                square[k];
              d_gradient[k] = sign * d_q;
              by_line -= sign / length * (d_s * q[k] + s[k] * d_q);
            }
          d_gradient[2] = by_line;
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = 0; l < 3; ++l)
              curvature[k][i][l][j] = d_gradient[k][l];
        }
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


    /** The middle between the faces at a node of the undeformed shell. */
    Point<3>
    middle(const Node &node)
    {
      return node.surface.position +
             (node.face_heights[0] + node.face_heights[1]) / 2 *
               node.surface.frame[2];
    }
  } // namespace


  Joints::Joints(const ShellMesh &mesh) : mesh(mesh)
  {
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
          if (std::find(parts.begin(), parts.end(), part.nodes) == parts.end())
            parts.push_back(part.nodes);
        for (unsigned int i = 0; i < parts.size(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            {
              Pair pair{
                element_between(
                  mesh, {{parts[j][0], parts[j][1], parts[i][0], parts[i][1]}}),
                middle(mesh.nodes[parts[j][1]]) -
                  middle(mesh.nodes[parts[j][0]]),
                {}};
              for (unsigned int end = 0; end < 2; ++end)
                if (parts[i][end] != parts[j][end])
                  pair.stiffness[end] = stiffness * fold.length / 2;
              pairs.push_back(pair);
            }
      }
  }


  std::vector<const Cell *>
  Joints::elements() const
  {
    std::vector<const Cell *> result;
    for (const Pair &pair : pairs)
      result.push_back(&pair.element);
    return result;
  }


  std::array<Joints::Unknown, 4>
  Joints::unknowns(const unsigned int end)
  {
    return {{{end, MixedElement::half_difference, 0, 1},
             {2 + end, MixedElement::half_difference, 1, 1},
             {1, MixedElement::mean, 2, 1},
             {0, MixedElement::mean, 2, -1}}};
  }


  JointAngle::Vectors
  Joints::undeformed(const Pair &pair, const unsigned int end)
  {
    JointAngle::Vectors result;
    result[2] = pair.line;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const ElementGeometry::Vertex &at =
          pair.element.geometry.vertices[end + 2 * k];
        Tensor<1, 3> half_difference;
        half_difference[2] = at.thickness / 2;
        result[k]          = at.axes * half_difference;
      }
    return result;
  }


  JointAngle::Vectors
  Joints::change(const Pair                      &pair,
                 const unsigned int               end,
                 const MixedElement::NodalVector &V)
  {
    JointAngle::Vectors result;
    for (const Unknown &unknown : unknowns(end))
      {
        Tensor<1, 3> v;
        for (unsigned int i = 0; i < 3; ++i)
          v[i] = V[MixedElement::dof(unknown.vertex, i, unknown.part)];
        result[unknown.vector] +=
          unknown.sign *
          (pair.element.geometry.vertices[unknown.vertex].axes * v);
      }
    return result;
  }


  void
  Joints::add_moment(const Pair        &pair,
                     const unsigned int end,
                     const JointAngle  &joint,
                     const double       moment,
                     const double       per_angle,
                     const double       of_tangent,
                     CellForces        &forces) const
  {
    const auto axes = [&pair](const Unknown &unknown) {
      return unknown.sign * pair.element.geometry.vertices[unknown.vertex].axes;
    };
    for (const Unknown &one : unknowns(end))
      {
        const Tensor<1, 3> own = joint.gradient[one.vector] * axes(one);
        forces.square += (moment * own).norm_square();
        for (unsigned int i = 0; i < 3; ++i)
          forces.force[MixedElement::dof(one.vertex, i, one.part)] -=
            moment * own[i];
        if (!forces.with_tangent)
          continue;
        for (const Unknown &two : unknowns(end))
          {
            const Tensor<1, 3> other = joint.gradient[two.vector] * axes(two);
            // the angle is not linear in the unknowns, and the moment does not
            // vanish
            const Tensor<2, 3> curved =
              transpose(axes(one)) * joint.curvature[one.vector][two.vector] *
              axes(two);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                forces.tangent[MixedElement::dof(one.vertex, i, one.part)]
                              [MixedElement::dof(two.vertex, j, two.part)] +=
                  of_tangent *
                  (per_angle * own[i] * other[j] + moment * curved[i][j]);
          }
      }
  }


  void
  Joints::add(const CellState &at, CellForces &forces) const
  {
    const Pair &pair = pairs[at.index];
    for (unsigned int end = 0; end < 2; ++end)
      {
        const double stiffness = pair.stiffness[end];
        if (stiffness == 0)
          continue;
        const JointAngle joint(undeformed(pair, end), change(pair, end, at.V));
        add_moment(
          pair, end, joint, stiffness * joint.angle, stiffness, 1, forces);
      }
  }


  namespace
  {
    /** The length of a director across the line. */
    double
    length_across(const JointAngle::Vectors &undeformed,
                  const JointAngle::Vectors &change,
                  const unsigned int         k)
    {
      const Tensor<1, 3> w = undeformed[k] + change[k],
                         t = undeformed[2] + change[2];
      return std::sqrt(w.norm_square() - (w * t) * (w * t) / t.norm_square());
    }
  } // namespace


  void
  Joints::add_over_step(const CellState &start,
                        const CellState &end_of_step,
                        CellForces      &forces) const
  {
    const Pair  &pair = pairs[end_of_step.index];
    const double part = end_of_step.state.step->weight_of_end();
    for (unsigned int end = 0; end < 2; ++end)
      {
        const double stiffness = pair.stiffness[end];
        if (stiffness == 0)
          continue;
        const JointAngle::Vectors at_rest = undeformed(pair, end),
                                  first   = change(pair, end, start.V),
                                  last    = change(pair, end, end_of_step.V);
        JointAngle::Vectors halfway;
        for (unsigned int k = 0; k < 3; ++k)
          halfway[k] = (first[k] + last[k]) / 2;
        const double angle_0 = JointAngle(at_rest, first).angle,
                     angle_1 = JointAngle(at_rest, last).angle,
                     turn    = angle_1 - angle_0;
        // The mean moment on the change of the angle is the change of the
        // energy. The gradient halfway, which takes part in rigid motions,
        // gives this change but for a factor, if directors turn about one axis:
        // the product of the cosines of half of their rotations and of an angle
        // over its sine
        double factor = (std::abs(turn) > 1e-4 ? turn / 2 / std::sin(turn / 2)
                                               : 1 + turn * turn / 24);
        for (unsigned int k = 0; k < 2; ++k)
          factor *= 2 * length_across(at_rest, halfway, k) /
                    (length_across(at_rest, first, k) +
                     length_across(at_rest, last, k));
        add_moment(pair,
                   end,
                   JointAngle(at_rest, halfway),
                   factor * stiffness * (angle_0 + part * turn),
                   2 * part * stiffness,
                   0.5,
                   forces);
      }
  }


  double
  Joints::stored_energy(const State &state) const
  {
    const auto &base   = state.linearization_point;
    double      energy = 0;
    for (const Pair &pair : pairs)
      {
        const auto V = mesh.cell_values(state.displacement, pair.element);
        const auto V_0 =
          (base ? mesh.cell_values(base->displacement, pair.element) : V);
        for (unsigned int end = 0; end < 2; ++end)
          {
            if (pair.stiffness[end] == 0)
              continue;
            const JointAngle joint(undeformed(pair, end),
                                   change(pair, end, V_0));
            // to second order about the state of the linearization, whose
            // derivative are the linearized forces
            const auto d     = change(pair, end, V - V_0);
            double     first = 0, second = 0;
            for (unsigned int k = 0; k < 3; ++k)
              {
                first += joint.gradient[k] * d[k];
                for (unsigned int l = 0; l < 3; ++l)
                  second += d[k] * (joint.curvature[k][l] * d[l]);
              }
            energy += pair.stiffness[end] / 2 *
                      ((joint.angle + first) * (joint.angle + first) +
                       joint.angle * second);
          }
      }
    return energy;
  }


  double
  Joints::dissipated_energy(const State &state) const
  {
    const StepInTime &step = *state.step;
    double            sum  = 0;
    for (const Pair &pair : pairs)
      {
        const auto V_0 =
                     mesh.cell_values(step.start.displacement, pair.element),
                   V_1 = mesh.cell_values(state.displacement, pair.element);
        for (unsigned int end = 0; end < 2; ++end)
          if (pair.stiffness[end] > 0)
            {
              const auto   at_rest = undeformed(pair, end);
              const double turn =
                JointAngle(at_rest, change(pair, end, V_1)).angle -
                JointAngle(at_rest, change(pair, end, V_0)).angle;
              sum += pair.stiffness[end] * turn * turn;
            }
      }
    return (step.weight_of_end() - 0.5) * sum;
  }
} // namespace Biface
