// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>
#include <biface/element/quadrilateral.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/stiffness_along.h>
#include <biface/model/forces/edge_moments.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>

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
                           named.first,
                           parse_number(entry, words[0], form),
                           words[1] == "follower"});
      }
    return moments;
  }


  namespace
  {
    /** The stiffness of a layer along the coordinate that runs across an edge,
     * or, on a mesh without coordinates, across the side itself. */
    StiffnessOfFaces
    stiffness_across(const BoundarySegment &segment,
                     const Cell            &layer,
                     const Laminate        &laminate)
    {
      if (layer.geometry.along_lines)
        return laminate.stiffness_along(segment.is_on(Edge::alpha_1_min) ||
                                            segment.is_on(Edge::alpha_1_max)
                                          ? 0
                                          : 1);
      const Tensor<1, 3> along =
        layer.geometry.quadrilateral->material_frame() *
        (layer.geometry.vertices[segment.vertices[0]].axes * segment.axes[0]);
      const Tensor<1, 2> across({-along[1], along[0]});
      return stiffness_along(laminate, across / across.norm());
    }


    /** The contributions of the half differences over the layers at a vertex
     * to that of a section across a side, see SideMoment. */
    std::vector<double>
    contributions_to_section(const ShellMesh       &mesh,
                             const BoundarySegment &segment,
                             const unsigned int     vertex)
    {
      const unsigned int wall = segment.cell;
      struct Part
      {
        const Cell           *layer;
        std::array<double, 2> heights;
        StiffnessOfFaces      stiffness;
      };
      std::vector<Part> parts;
      double            stiffness = 0, first_moment = 0;
      const auto [begin, end] = mesh.layers_of(wall);
      for (unsigned int c = begin; c < end; ++c)
        {
          const Cell     &layer = mesh.cells[c];
          const Laminate &laminate =
            *mesh.strips[layer.strip].at_vertices[vertex];
          parts.push_back({&layer,
                           laminate.face_heights(),
                           stiffness_across(segment, layer, laminate)});
          const Part &part = parts.back();
          for (unsigned int p = 0; p < 2; ++p)
            for (unsigned int q = 0; q < 2; ++q)
              {
                stiffness += part.stiffness[p][q];
                first_moment += part.stiffness[p][q] * part.heights[q];
              }
        }
      // the height about which a section turns without a resultant force,
      // section 5 of doc/theory.md
      const double neutral = first_moment / stiffness;

      const unsigned int  n = mesh.n_layers();
      std::vector<double> result(n);
      double              rigidity = 0;
      for (const Part &part : parts)
        {
          // the forces on the faces for the unit curvature
          std::array<double, 2> force{};
          for (unsigned int p = 0; p < 2; ++p)
            {
              for (unsigned int q = 0; q < 2; ++q)
                force[p] += part.stiffness[p][q] * (part.heights[q] - neutral);
              rigidity += force[p] * (part.heights[p] - neutral);
            }
          for (unsigned int k = 0; k < n; ++k)
            {
              const Cell::Contribution &by =
                part.layer->contributions[vertex * n + k];
              result[k] += (force[1] + force[0]) * by.mean +
                           (force[1] - force[0]) * by.half_difference;
            }
        }
      // the director h sum f v/sum f delta is twice the half difference of an
      // element
      const double thickness =
        mesh.cells[wall].geometry.vertices[vertex].thickness;
      for (double &value : result)
        value *= thickness / (2 * rigidity);
      return result;
    }


    Cell
    section_of(const ShellMesh &mesh, const BoundarySegment &segment)
    {
      Cell               section = mesh.cells[segment.cell];
      const unsigned int n       = mesh.n_layers();
      if (n == 1)
        return section;
      for (const unsigned int vertex : segment.vertices)
        {
          const std::vector<double> of_layers =
            contributions_to_section(mesh, segment, vertex);
          for (unsigned int k = 0; k < n; ++k)
            section.contributions[vertex * n + k].half_difference =
              of_layers[k];
        }
      return section;
    }
  } // namespace


  std::vector<SideMoment>
  side_moments(const std::vector<EdgeMoment> &moments,
               const bool                     follower,
               const ShellMesh               &mesh)
  {
    std::vector<SideMoment> result;
    for (const EdgeMoment &moment : moments)
      {
        if (moment.follower != follower)
          continue;

        const unsigned int edge =
          mesh.find_edge("Loads/Edge moments", moment.text, moment.edge);
        if (mesh.edges[edge].is_inside)
          throw InputError("Loads/Edge moments",
                           moment.text,
                           "a part of the line lies inside the shell, where a "
                           "moment has no direction");
        for (const BoundarySegment &segment : mesh.boundary)
          // half of it at each of its vertices
          if (segment.edge == edge)
            result.push_back({section_of(mesh, segment),
                              segment.vertices,
                              moment.moment * segment.length / 2,
                              segment.axes,
                              moment.factor});
      }
    return result;
  }


  void
  SideMoment::add_couple(const Tensor<1, 3>        &force,
                         const unsigned int         vertex,
                         MixedElement::NodalVector &forces)
  {
    for (const auto face : {Resultants::inner, Resultants::outer})
      MixedElement::add_face_force(
        MixedElement::face_sign[face] * force, vertex, face, forces);
  }


  FollowerCouple::FollowerCouple(const double        moment,
                                 const Tensor<1, 3> &axis,
                                 const Tensor<1, 3> &director)
  {
    // M w x d/|d_perp|^2 does work on the angle of the director alone, whatever
    // its length (section 5 of doc/theory.md)
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
    : moments(side_moments(edge_moments, true, mesh))
  {}


  std::vector<const Cell *>
  FollowerMoments::elements() const
  {
    std::vector<const Cell *> sections;
    for (const SideMoment &moment : moments)
      sections.push_back(&moment.section);
    return sections;
  }


  FollowerCouple
  FollowerMoments::couple(const CellState   &at,
                          const SideMoment  &moment,
                          const unsigned int end)
  {
    const unsigned int vertex = moment.vertices[end];
    Tensor<1, 3>       director;
    for (unsigned int i = 0; i < 3; ++i)
      director[i] =
        2 * at.V[MixedElement::dof(vertex, i, MixedElement::half_difference)];
    director[2] += at.cell.geometry.vertices[vertex].thickness;
    return FollowerCouple(moment.moment, moment.axes[end], director);
  }


  void
  FollowerMoments::add(const CellState &at, CellForces &forces) const
  {
    const SideMoment &moment = moments[at.index];
    const double      factor = factor_at(at.loads.factors, moment.factor);
    for (unsigned int end = 0; end < 2; ++end)
      {
        const unsigned int   vertex = moment.vertices[end];
        const FollowerCouple couple = this->couple(at, moment, end);
        const auto           dof    = [&](const unsigned int i) {
          return MixedElement::dof(vertex, i, MixedElement::half_difference);
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
    const SideMoment &moment = moments[at.index];
    for (unsigned int end = 0; end < 2; ++end)
      moment.add_couple(factor_at(rates.factors, moment.factor) *
                          couple(at, moment, end).force,
                        moment.vertices[end],
                        force);
  }
} // namespace Biface
