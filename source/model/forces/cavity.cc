// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/element/follower_pressure.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/forces/cavity.h>
#include <biface/model/forces/end_plates.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/state.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  void
  Cavity::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_optional_number(
      prm,
      "Cavity volume",
      volume,
      "computed",
      "Volume that the gas fills in the undeformed shell. 'computed', for a "
      "surface of revolution: between the face under pressure, the cylinder "
      "of 'Rim radius', and planes orthogonal to the axis or through it; for a "
      "mesh from a file that is closed, or but for planes of symmetry. Only "
      "the part that is modeled counts.",
      Unit("length^3"));
    add_optional_number(
      prm,
      "Rim radius",
      rim_radius,
      "edges",
      "Radius of the cylinder that closes the cavity of a surface of "
      "revolution toward the axis; 0 for a vessel without a rim. 'edges': the "
      "smallest radius of the face under pressure at the edges of alpha_1, or "
      "0 with 'Loads/End plates'.",
      Unit("length"));
  }


  void
  Cavity::Parameters::check(const bool is_known) const
  {
    if (volume)
      check_positive("Gas/Cavity volume", *volume);
    else if (!is_known)
      throw InputError("Gas/Cavity volume",
                       "computed",
                       "it must be a number unless the shell is a surface of "
                       "revolution or a mesh from a file");
    if (rim_radius)
      check_not_negative("Gas/Rim radius", *rim_radius);
  }


  Cavity::Cavity(const ShellMesh       &mesh,
                 const Parameters      &parameters,
                 const Resultants::Face face,
                 const bool             follows)
    : mesh(mesh)
    , face(face)
    , axis(mesh.get_surface().axis())
    , rim_radius(parameters.rim_radius ? *parameters.rim_radius
                                       : radius_of_edges())
    , gaps(gaps_at_folds(mesh, face))
    , directors(mesh, face, follows)
    , within_rim(mesh.owned_vector())
  {
    const bool has_chart = mesh.get_surface().has_chart();
    if (!has_chart)
      set_field_of_mesh(parameters);
    else if (axis.norm_square() > 0)
      {
        // r/2 e_r has the divergence 1, as F of section 5 of doc/theory.md
        linear_part = unit_symmetric_tensor<3>();
        linear_part = (linear_part - outer_product(axis, axis)) / 2;
        // as an edge moves along the axis, the circle of the rim sweeps a
        // volume that does not belong to the cavity
        if (rim_radius > 0)
          for (const BoundarySegment &segment : mesh.boundary)
            if (segment.is_on(Edge::alpha_1_min) ||
                segment.is_on(Edge::alpha_1_max))
              {
                MixedElement::NodalVector of_cell;
                for (unsigned int n = 0; n < 2; ++n)
                  MixedElement::add_face_force(
                    half_of_plane(mesh,
                                  face,
                                  segment,
                                  mesh.nodes[segment.nodes[n]],
                                  rim_radius),
                    segment.vertices[n],
                    face,
                    of_cell);
                mesh.add_nodal_forces(
                  mesh.cells[segment.cell], of_cell, within_rim);
              }
        within_rim.compress(VectorOperation::add);
      }
    else
      linear_part[2][2] = 1;

    const double of_cells = flux(nullptr);
    // the faces of a mesh from a file are those of its cells
    double exact = (has_chart ? 0. : of_cells);
    if (has_chart)
      for (const Cell &cell : mesh.wall_elements())
        exact += exact_flux(cell);
    // the faces of the cells give the changes of the volume, of which the
    // forces are the exact derivatives, and not the volume itself
    exact    = Utilities::MPI::sum(exact, mesh.communicator);
    constant = parameters.volume.value_or(exact) -
               Utilities::MPI::sum(of_cells, mesh.communicator);
    // more than round-off
    if (!parameters.volume && !(exact > 1e-12 * std::pow(mesh.size(), 3)))
      throw InputError("Gas/Cavity volume",
                       "computed",
                       "the face under pressure encloses the volume " +
                         number_to_string(exact) +
                         ", which must be positive; " +
                         (has_chart ? "give the volume or the 'Rim radius'"
                                    : "'Loads/Pressure face' chooses the other "
                                      "face"));
  }


  void
  Cavity::set_field_of_mesh(const Parameters &parameters)
  {
    // the field must not pass through planes of symmetry
    std::vector<unsigned int> along;
    for (unsigned int d = 0; d < 3; ++d)
      if (mesh.symmetry_planes[d].empty())
        along.push_back(d);
    for (unsigned int d = 0; d < 3 && along.empty(); ++d)
      {
        const auto &planes = mesh.symmetry_planes[d];
        const auto  ends   = std::minmax_element(planes.begin(), planes.end());
        if (*ends.second - *ends.first < 1e-6 * mesh.size())
          {
            along     = {d};
            origin[d] = *ends.first;
          }
      }
    if (along.empty())
      throw InputError("the section 'Gas' cannot find the volume between two "
                       "planes of symmetry along each of the axes; leave out "
                       "one of the planes.");
    for (const unsigned int d : along)
      linear_part[d][d] = 1. / along.size();

    agree_on_errors(mesh.communicator, [&]() {
      for (const unsigned int n : mesh.ends_of_faces[face])
        {
          const Node       &node = mesh.nodes[n];
          const std::string here =
            "the section 'Gas' needs a closed cavity, but the face under "
            "pressure ends at (" +
            vector_to_string(node.surface.position) + "), ";
          const bool moves =
            std::any_of(mesh.prescribed.begin(),
                        mesh.prescribed.end(),
                        [&node](const PrescribedDisplacement &prescribed) {
                          return std::find(node.dofs.begin(),
                                           node.dofs.end(),
                                           prescribed.dof) != node.dofs.end();
                        });
          if (node.face_is_free[face] || moves)
            throw InputError(here +
                             "where it can move: let 'Edge supports' hold it, "
                             "or make the edge one of 'symmetry'.");
          if (!parameters.volume)
            throw InputError(here + "so that 'Gas/Cavity volume' must be a "
                                    "number.");
        }
    });
  }


  double
  Cavity::volume(const State &state) const
  {
    const double sum = flux(&state.displacement);
    return constant + Utilities::MPI::sum(sum, mesh.communicator) -
           within_rim * owned_part(state.displacement);
  }


  LA::Vector
  Cavity::volume_gradient(const State &state) const
  {
    LA::Vector gradient = mesh.owned_vector();
    flux(&state.displacement, &gradient);
    gradient.compress(VectorOperation::add);
    gradient -= within_rim;
    return gradient;
  }


  Tensor<1, 3>
  Cavity::field(const Point<3> &x) const
  {
    // (r^2 - r_0^2)/2r e_r does not pass through the rim
    const Tensor<1, 3> linear = linear_part * x;
    return rim_radius > 0
             ? (1 - rim_radius * rim_radius / (4 * linear.norm_square())) *
                 linear
             : linear;
  }


  double
  Cavity::flux(const LA::Vector *V, LA::Vector *gradient) const
  {
    double     sum    = 0;
    const auto values = [&](const Cell &cell) {
      return V ? mesh.cell_values(*V, cell) : MixedElement::NodalVector();
    };
    for (const Cell &cell : mesh.cells)
      {
        MixedElement::NodalVector       of_cell;
        const MixedElement::NodalVector v = values(cell);
        if (cell.is_wall)
          sum += flux(cell, v, gradient ? &of_cell : nullptr);
        if (directors.act_on(cell.position))
          {
            sum += directors.volume(cell, v);
            if (gradient)
              directors.add_force(1, cell, v, of_cell);
          }
        if (gradient)
          mesh.add_nodal_forces(cell, of_cell, *gradient);
      }
    // cells at a fold leave gaps, without which the surface is not closed
    for (const GapAtFold &gap : gaps)
      {
        MixedElement::NodalVector of_gap;
        sum += flux(gap.element,
                    gap.displacements(values(gap.element)),
                    gradient ? &of_gap : nullptr);
        if (gradient)
          mesh.add_nodal_forces(
            gap.element, gap.at_unknowns(of_gap), *gradient);
      }
    return sum;
  }


  double
  Cavity::flux(const Cell                      &cell,
               const MixedElement::NodalVector &V,
               MixedElement::NodalVector       *gradient) const
  {
    return FollowerPressure(cell.geometry, V, face)
      .flux(linear_part, gradient, origin);
  }


  double
  Cavity::exact_flux(const Cell &cell) const
  {
    const QGauss<2> quadrature(5);
    const Point<2>  first = mesh.nodes[cell.nodes[0]].alpha;
    Tensor<1, 2>    size;
    for (unsigned int a = 0; a < 2; ++a)
      {
        // independent of where a closed coordinate starts
        const ElementGeometry::Vertex &vertex = cell.geometry.vertices[0];
        size[a]                               = 1 / (std::abs(vertex.slope[a]) *
                       mesh.nodes[cell.nodes[0]].surface.lame[a]);
      }

    // the undeformed volume alone is not that of the nodes, which differs by an
    // error of the mesh
    double sum = 0;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<2> &xi = quadrature.point(q);
        Point<2>        alpha;
        for (unsigned int a = 0; a < 2; ++a)
          alpha[a] = first[a] + xi[a] * size[a];
        const SurfacePoint at = mesh.get_surface().evaluate(alpha);

        // bilinear between the vertices
        const std::array<double, 4> heights{
          {height(cell, 0), height(cell, 1), height(cell, 2), height(cell, 3)}};
        const double delta =
          (1 - xi[1]) * ((1 - xi[0]) * heights[0] + xi[0] * heights[1]) +
          xi[1] * ((1 - xi[0]) * heights[2] + xi[0] * heights[3]);
        const std::array<double, 2> slope{
          {((1 - xi[1]) * (heights[1] - heights[0]) +
            xi[1] * (heights[3] - heights[2])) /
             size[0],
           ((1 - xi[0]) * (heights[2] - heights[0]) +
            xi[0] * (heights[3] - heights[1])) /
             size[1]}};
        std::array<Tensor<1, 3>, 2> tangents;
        for (unsigned int a = 0; a < 2; ++a)
          tangents[a] =
            at.lame[a] * (1 + at.curvature[a] * delta) * at.frame[a] +
            slope[a] * at.frame[2];
        sum += quadrature.weight(q) * size[0] * size[1] *
               (field(at.position + delta * at.frame[2]) *
                cross_product_3d(tangents[0], tangents[1]));
      }
    // the cross product points outward, away from the gas inside and toward a
    // gas outside
    return face == Resultants::inner ? sum : -sum;
  }


  double
  Cavity::height(const Cell &cell, const unsigned int vertex) const
  {
    return mesh.strips[cell.strip].at_vertices[vertex]->face_heights()[face];
  }


  double
  Cavity::radius_of_edges() const
  {
    double radius = std::numeric_limits<double>::max();
    for (const BoundarySegment &side : mesh.boundary)
      if (side.is_on(Edge::alpha_1_min) || side.is_on(Edge::alpha_1_max))
        {
          const Cell         &cell    = mesh.cells[side.cell];
          const SurfacePoint &surface = mesh.nodes[side.nodes[0]].surface;
          const Tensor<1, 3>  x =
            surface.position +
            height(cell, side.vertices[0]) * surface.frame[2];
          radius = std::min(radius, (x - (x * axis) * axis).norm());
        }
    radius = Utilities::MPI::min(radius, mesh.communicator);
    return axis.norm_square() == 0 ||
               radius == std::numeric_limits<double>::max()
             ? 0.
             : radius;
  }
} // namespace Biface
