// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/edge_moments.h>

namespace Biface
{
  using namespace dealii;

  std::vector<EdgeMoment>
  parse_edge_moments(const std::string &entry, const std::string &text)
  {
    const std::string form = "each moment must have the form 'edge: M dead' "
                             "or 'edge: M follower'";

    std::vector<EdgeMoment> moments;
    for (const std::string &item : split_list(entry, text))
      {
        const auto named = split_named(entry, item, form);
        const auto words = split_words(named.second);
        if (words.size() != 2 || (words[1] != "dead" && words[1] != "follower"))
          throw InputError(entry, item, form);
        moments.push_back({item,
                           parse_edge(entry, item, named.first),
                           parse_number(entry, words[0], form),
                           words[1] == "follower"});
      }
    return moments;
  }


  std::vector<VertexMoment>
  vertex_moments(const std::vector<EdgeMoment> &moments,
                 const bool                     follower,
                 const ShellMesh               &mesh)
  {
    std::vector<VertexMoment> result;
    for (const EdgeMoment &moment : moments)
      {
        if (moment.follower != follower)
          continue;

        // e_3 x (outward normal of the edge)
        Tensor<1, 3> axis;
        switch (moment.edge)
          {
            case Edge::alpha_1_min:
              axis[1] = -1;
              break;
            case Edge::alpha_1_max:
              axis[1] = 1;
              break;
            case Edge::alpha_2_min:
              axis[0] = 1;
              break;
            case Edge::alpha_2_max:
              axis[0] = -1;
              break;
          }
        for (const BoundarySegment &segment : mesh.boundary)
          if (segment.edge == moment.edge)
            for (const unsigned int vertex : segment.vertices)
              result.push_back({segment.cell,
                                vertex,
                                moment.moment * segment.length / 2,
                                axis,
                                moment.factor});
      }
    return result;
  }


  FollowerCouple::FollowerCouple(const double        moment,
                                 const Tensor<1, 3> &axis,
                                 const Tensor<1, 3> &director)
  {
    const Tensor<1, 3> turned = cross_product_3d(axis, director);
    const Tensor<1, 3> across = director - (director * axis) * axis;
    const double       square = across.norm_square();
    force                     = moment / square * turned;
    for (unsigned int j = 0; j < 3; ++j)
      {
        Tensor<1, 3> unit;
        unit[j]                   = 1;
        const Tensor<1, 3> change = cross_product_3d(axis, unit) / square -
                                    2 * across[j] / (square * square) * turned;
        for (unsigned int i = 0; i < 3; ++i)
          derivative[i][j] = moment * change[i];
      }
  }


  FollowerMoments::FollowerMoments(const ShellMesh               &mesh,
                                   const std::vector<EdgeMoment> &edge_moments)
  {
    for (const VertexMoment &moment : vertex_moments(edge_moments, true, mesh))
      moments[moment.cell].push_back(moment);
  }


  FollowerCouple
  FollowerMoments::couple(const CellState &at, const VertexMoment &moment)
  {
    Tensor<1, 3> director;
    for (unsigned int i = 0; i < 3; ++i)
      director[i] = 2 * at.V[MixedElement::dof(
                          moment.vertex, i, MixedElement::half_difference)];
    director[2] += at.cell.geometry.vertices[moment.vertex].thickness;
    return FollowerCouple(moment.moment, moment.axis, director);
  }


  void
  FollowerMoments::add(const CellState &at, CellForces &forces) const
  {
    for (const VertexMoment &moment : moments.at(at.index))
      {
        const FollowerCouple couple = this->couple(at, moment);
        const double factor = factor_at(at.loads.factors, moment.factor);
        const auto   dof    = [&](const unsigned int i) {
          return MixedElement::dof(
            moment.vertex, i, MixedElement::half_difference);
        };
        // opposite forces on the faces do work on the half difference alone
        for (unsigned int i = 0; i < 3; ++i)
          {
            forces.load[dof(i)] += 2 * factor * couple.force[i];
            for (unsigned int j = 0; j < 3; ++j)
              forces.tangent[dof(i)][dof(j)] -=
                4 * factor * couple.derivative[i][j];
          }
      }
  }


  void
  FollowerMoments::add_load_derivative(const CellState           &at,
                                       const LoadRates           &rates,
                                       MixedElement::NodalVector &force) const
  {
    for (const VertexMoment &moment : moments.at(at.index))
      {
        const FollowerCouple couple = this->couple(at, moment);
        for (const auto face : {Resultants::inner, Resultants::outer})
          MixedElement::add_face_force(
            MixedElement::face_sign[face] *
              factor_at(rates.factors, moment.factor) * couple.force,
            moment.vertex,
            face,
            force);
      }
  }
} // namespace Biface
