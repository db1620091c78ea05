// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <biface/base/errors.h>
#include <biface/input/formula.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/mesh/faces_of_layers.h>
#include <biface/model/mesh/parallel_triangulation.h>
#include <biface/model/mesh/plies_of_cells.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/mesh/support_motions.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/greatest_deviation.h>
#include <biface/surface/imperfection.h>
#include <biface/surface/meridian.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  class ShellMesh::Faces
  {
  public:
    Faces(const Layup            &layup,
          const ReferenceSurface &surface,
          const ChartGrid        &grid);

    /** See ShellMesh::strips. */
    std::vector<Strip> strips;

    /** `[i][k]` is the position in @p strips of the layer k between the lines
     * i and i + 1; an invalid number if it does not exist there. */
    std::vector<std::vector<unsigned int>> layers;

    /** The heights of all faces, inner face first. */
    using Heights = std::vector<double>;

    /** `[i][side]`: between the lines i and i + 1, at both of these. */
    std::vector<std::array<Heights, 2>> of_strips;

    /** On each line: the mean of both sides if a ply ends there. */
    std::vector<Heights> on_lines;

    /** On each line: of the layers on both sides the stiffest_layer(). */
    std::vector<unsigned int> stiffest;

    /** The number of elements between the first line and each line, across the
     * shell. */
    std::vector<unsigned int> n_elements{0};

    /** Whether there is the layer @p k between the lines @p i and i + 1. */
    bool
    exists(const unsigned int i, const unsigned int k) const
    {
      return layers[i][k] != numbers::invalid_unsigned_int;
    }

    /** Of the inner and the outer face on one side of each line: below or
     * above. */
    std::vector<std::array<double, 2>>
    on_side(const unsigned int side) const;
  };


  namespace
  {
    /** The lines of the first coordinate in the user's unit. Throws InputError
     * if a ply ends between two lines. */
    std::vector<double>
    lines_of_plies(const Layup            &layup,
                   const ReferenceSurface &surface,
                   const ChartGrid        &grid)
    {
      std::vector<double> lines = grid.lines[0];
      for (double &alpha_1 : lines)
        alpha_1 /= surface.coordinate_unit(0);

      const double tolerance = 1e-7 * (lines.back() - lines.front());
      for (const PlyDescription &ply : layup.get_plies())
        for (const double end : {ply.begin, ply.end})
          if (std::isfinite(end) &&
              std::none_of(lines.begin(), lines.end(), [&](const double line) {
                return std::abs(line - end) <= tolerance;
              }))
            throw InputError(
              "Laminate/Plies",
              ply.text,
              "a ply must start and end at mesh lines, and there is none at "
              "alpha_1 = " +
                number_to_string(end));
      return lines;
    }


    /** Throw InputError unless the surface and both faces are regular at all
     * nodes. */
    void
    check_geometry(const ReferenceSurface                   &surface,
                   const ChartGrid                          &grid,
                   const std::vector<std::array<double, 2>> &face_heights)
    {
      double size = 0;
      for (const double alpha_1 : grid.lines[0])
        size = std::max(size,
                        surface.evaluate(Point<2>(alpha_1, grid.lines[1][0]))
                          .position.norm());

      for (unsigned int i = 0; i < grid.lines[0].size(); ++i)
        for (const double alpha_2 : grid.lines[1])
          {
            const double                 alpha_1 = grid.lines[0][i];
            const std::array<double, 2> &heights = face_heights[i];
            const SurfacePoint           point =
              surface.evaluate(Point<2>(alpha_1, alpha_2));
            const auto where = [&] {
              return "alpha_1 = " +
                     coordinate_to_string(
                       alpha_1 / surface.coordinate_unit(0),
                       (grid.lines[0].back() - grid.lines[0].front()) /
                         surface.coordinate_unit(0));
            };

            if (!(point.lame[0] > 1e-8 * size && point.lame[1] > 1e-8 * size))
              throw InputError("the entry 'Mesh/Intervals alpha_1' reaches " +
                               where() +
                               ", where the radius of the surface is " +
                               number_to_string(point.lame[1]) +
                               ", but it must be positive everywhere.");

            // beyond a center of curvature, a face would be turned inside out
            const ThicknessMetric metric(point.curvature, heights);
            for (unsigned int face = 0; face < 2; ++face)
              for (unsigned int a = 0; a < 2; ++a)
                if (!(metric.zeta[face][a] > 0))
                  throw InputError(
                    "the entry 'Laminate/Plies' places a face at " +
                    number_to_string(heights[face]) +
                    " from the reference surface, but at " + where() +
                    " the center of curvature is only " +
                    number_to_string(1 / std::abs(point.curvature[a])) +
                    " away.");
          }
    }


    /** Throw InputError if a face lies beyond the center of curvature of a
     * rounded corner, whether or not there are nodes on it. @p face_heights
     * are those of all faces between two lines, at both of these. */
    void
    check_corners(
      const ReferenceSurface                                &surface,
      const ChartGrid                                       &grid,
      const std::vector<std::array<std::vector<double>, 2>> &face_heights)
    {
      for (const RoundedCorner &corner : surface.get_corners())
        for (unsigned int i = 0; i + 1 < grid.lines[0].size(); ++i)
          {
            const double below = grid.lines[0][i], above = grid.lines[0][i + 1];
            if (!(below <= corner.s && corner.s <= above))
              continue;
            const auto  &heights = face_heights[i];
            const bool   inside  = corner.radius > 0;
            const double x       = (corner.s - below) / (above - below);
            const double height =
              inside ? (1 - x) * heights[0].front() + x * heights[1].front()
                     : (1 - x) * heights[0].back() + x * heights[1].back();
            if (!(1 + height / corner.radius > 0))
              throw InputError(
                "Surface/Spline/Corner radius",
                number_to_string(std::abs(corner.radius)),
                "it must be greater than " +
                  number_to_string(std::abs(height)) +
                  ", the distance of the " + (inside ? "inner" : "outer") +
                  " face from the reference surface at the corner at "
                  "alpha_1 = " +
                  number_to_string(corner.s / surface.coordinate_unit(0)));
          }
    }


    /** The diagonal of the box around a triangulation on all ranks. */
    double
    diagonal_of_box(const parallel::TriangulationBase<2, 3> &triangulation)
    {
      const MPI_Comm communicator = triangulation.get_communicator();
      const auto     box =
        GridTools::compute_bounding_box(triangulation).get_boundary_points();
      Tensor<1, 3> diagonal;
      for (unsigned int d = 0; d < 3; ++d)
        diagonal[d] = Utilities::MPI::max(box.second[d], communicator) -
                      Utilities::MPI::min(box.first[d], communicator);
      return diagonal.norm();
    }


    /** Whether any displacement of a face is free: the sum of the unknowns of a
     * component, with the signs of the face. */
    bool
    face_is_free(const Node                      &node,
                 const unsigned int               face,
                 const AffineConstraints<double> &constraints)
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          // the derivative of the sum by each unknown
          std::map<types::global_dof_index, double> change;
          for (unsigned int part = 0; part < node.n_parts(); ++part)
            {
              const auto   dof  = node.dof(i, part);
              const double sign = Node::sign_of_part(face, part);
              if (!constraints.is_constrained(dof))
                change[dof] += sign;
              else
                for (const auto &entry :
                     *constraints.get_constraint_entries(dof))
                  change[entry.first] += sign * entry.second;
            }
          for (const auto &entry : change)
            if (std::abs(entry.second) > 1e-12)
              return true;
        }
      return false;
    }
  } // namespace


  ShellMesh::Faces::Faces(const Layup            &layup,
                          const ReferenceSurface &surface,
                          const ChartGrid        &grid)
  {
    const std::vector<double> lines = lines_of_plies(layup, surface, grid);
    const unsigned int        n     = lines.size() - 1;
    struct Walls
    {
      WallAtPlace     inside;
      WallsAtVertices at_vertices;
    };
    std::vector<Walls> walls;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double middle = (lines[i] + lines[i + 1]) / 2;
        walls.push_back({WallAtPlace(layup, middle, middle), {}});
        const auto at = [&](const double line) {
          return std::make_shared<const WallAtPlace>(layup, line, middle);
        };
        const auto low = at(lines[i]), high = at(lines[i + 1]);
        walls[i].at_vertices = {{low, high, low, high}};
        strips.push_back(strip_of_wall(walls[i].inside, walls[i].at_vertices));
        of_strips.push_back({{low->heights, high->heights}});
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        layers.push_back(
          append_layers(i, walls[i].inside, walls[i].at_vertices, strips));
        n_elements.push_back(n_elements.back() +
                             n_elements_of(walls[i].inside.layers));
      }

    // where a ply ends, a node has the mean heights of both sides
    on_lines.push_back(of_strips.front()[0]);
    for (unsigned int i = 1; i < n; ++i)
      {
        const Heights &below = of_strips[i - 1][1], &above = of_strips[i][0];
        Heights        mean;
        for (unsigned int k = 0; k < below.size(); ++k)
          mean.push_back(below[k] / 2 + above[k] / 2);
        on_lines.push_back(mean);
      }
    on_lines.push_back(of_strips.back()[1]);

    for (unsigned int i = 0; i <= n; ++i)
      {
        const unsigned int below = (i == 0 ? 0 : i - 1),
                           above = std::min(i, n - 1);
        std::vector<double> stiffness(layup.n_layers(), 0.);
        for (unsigned int k = 0; k < layup.n_layers(); ++k)
          if (exists(below, k) && exists(above, k))
            for (const unsigned int side : {below, above})
              stiffness[k] +=
                strips[layers[side][k]].laminate.membrane_stiffness();
        stiffest.push_back(stiffest_layer(stiffness));
        if (stiffest.back() == numbers::invalid_unsigned_int)
          throw InputError(
            "the entry 'Laminate/Layers' has no layer with plies on both sides "
            "of alpha_1 = " +
            number_to_string(lines[i]) +
            ", where the wall would be a hinge: put the plies on both sides into "
            "one layer.");
      }
  }


  std::vector<std::array<double, 2>>
  ShellMesh::Faces::on_side(const unsigned int side) const
  {
    std::vector<std::array<double, 2>> heights;
    for (unsigned int i = 0; i <= of_strips.size(); ++i)
      {
        const bool     below = i > 0 && (side == 0 || i == of_strips.size());
        const Heights &all   = below ? of_strips[i - 1][1] : of_strips[i][0];
        heights.push_back({{all.front(), all.back()}});
      }
    return heights;
  }


  ShellMesh::ShellMesh(const MPI_Comm                          communicator,
                       std::unique_ptr<const ReferenceSurface> surface,
                       const ChartGrid                        &grid,
                       const Layup                            &layup,
                       const Supports                         &supports,
                       const std::vector<NamedPoint>          &points,
                       const Formulation                       formulation)
    : MeshNodes(communicator, std::move(surface), grid, points)
    , formulation(formulation)
    , normal_thickness(layup.n_layers() > 1)
  {
    set_layup(layup);
    const Faces faces(*this->layup, *this->surface, grid);
    strips  = faces.strips;
    n_walls = grid.n_cells(0);
    for (const Faces::Heights &heights : faces.on_lines)
      max_thickness = std::max(max_thickness, heights.back() - heights.front());
    check_corners(*this->surface, grid, faces.of_strips);
    for (const unsigned int side : {0, 1})
      check_geometry(*this->surface, grid, faces.on_side(side));

    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    triangulation              = make_parallel_triangulation(
      communicator,
      grid.distribution,
      [&](Triangulation<2, 3> &whole) {
        create_triangulation(*this->surface, grid, whole);
      },
      [&](Triangulation<2, 3> &whole) {
        partition_triangulation(*this->surface, grid, n_ranks, whole);
      },
      this->surface.get());
    distribute_dofs();

    // the positions of entries are known when cyclic edges have added the
    // unknowns of other ranks
    collect_cells_and_nodes(faces);
    if (supports.is_cyclic())
      add_cyclic_nodes(faces);
    for (unsigned int edge = 0; edge < edge_names.size(); ++edge)
      {
        edges.push_back({edge_names[edge], {}});
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (grid.on_edge(nodes[n].grid_index, static_cast<Edge>(edge)))
            edges.back().nodes.push_back(n);
      }
    complete(supports);
  }


  void
  ShellMesh::distribute_dofs()
  {
    const auto new_dof_handler =
      std::make_shared<DoFHandler<2, 3>>(*triangulation);
    new_dof_handler->distribute_dofs(
      FESystem<2, 3>(FE_Q<2, 3>(1), n_dofs_per_node()));
    dof_handler   = new_dof_handler;
    locally_owned = dof_handler->locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(*dof_handler, locally_relevant);

    diameter = diagonal_of_box(*triangulation);
  }


  void
  ShellMesh::complete(const Supports              &supports,
                      const std::vector<Point<3>> &positions)
  {
    set_wall_stiffness();
    locally_relevant.compress();
    // found once, since assemblies read vectors by these positions
    for (Cell &cell : cells)
      for (const auto dof : cell.dofs)
        cell.positions.push_back(locally_relevant.index_within_set(dof));
    for (Node &node : nodes)
      for (const auto dof : node.dofs)
        node.entries.push_back(locally_relevant.index_within_set(dof));
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        if (cells[c].is_wall)
          walls.push_back(c);
        if (cells[c].is_layer)
          layers.push_back(c);
      }
    n_all_elements = Utilities::MPI::sum(
      static_cast<types::global_dof_index>(cells.size()), communicator);
    find_points(positions);
    make_constraints(supports, *this, constraints, prescribed, supported);
    supported.motions = find_support_motions(supports, *this, supported);

    for (Node &node : nodes)
      for (const auto face : {Resultants::inner, Resultants::outer})
        node.face_is_free[face] =
          face_is_free(node, face * node.n_layers(), constraints);
    types::global_dof_index n_owned_free = 0;
    for (const auto dof : locally_owned)
      if (!constraints.is_constrained(dof))
        ++n_owned_free;
    n_free = Utilities::MPI::sum(n_owned_free, communicator);
  }


  ShellMesh::ShellMesh(const ShellMesh &) = default;


  ShellMesh::~ShellMesh() = default;


  void
  ShellMesh::set_layup(const Layup &new_layup)
  {
    const auto plies = std::make_shared<Layup>(new_layup);
    plies->set_thickness_strain_along_normal(normal_thickness);
    n_all_layers = plies->n_layers();
    layup        = plies;
  }


  namespace
  {
    /** Whether supports prevent a displacement of a node along the normal, the
     * same on all faces. */
    bool
    holds_normal(const Node &node, const AffineConstraints<double> &constraints)
    {
      const auto normal = node.dof(2, MixedElement::mean);
      for (const auto dof : node.dofs)
        {
          if (!constraints.is_constrained(dof))
            continue;
          double value = 0;
          bool   own   = true;
          for (const auto &entry : *constraints.get_constraint_entries(dof))
            {
              // between cyclic edges it depends on another node
              own = own && std::find(node.dofs.begin(),
                                     node.dofs.end(),
                                     entry.first) != node.dofs.end();
              if (entry.first == normal)
                value += entry.second;
            }
          if (own && std::abs(value - (dof == normal ? 1. : 0.)) > 1e-10)
            return true;
        }
      return false;
    }
  } // namespace


  double
  ShellMesh::curvature(const unsigned int n) const
  {
    const SurfacePoint &here = nodes[n].surface;
    if (grid.has_lines())
      return std::max(std::abs(here.curvature[0]), std::abs(here.curvature[1]));
    // the change of the normal by the position that fits those around best
    Tensor<2, 2> change, positions;
    for (const unsigned int other : neighbors[n])
      {
        const SurfacePoint &there = nodes[other].surface;
        const Tensor<1, 3>  d = here.to_frame(there.position - here.position);
        const Tensor<1, 3>  normal = here.to_frame(there.frame[2]);
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int b = 0; b < 2; ++b)
            {
              change[a][b] += normal[a] * d[b];
              positions[a][b] += d[a] * d[b];
            }
      }
    const Tensor<2, 2> S = change * invert(positions);
    // the larger singular value
    return (std::hypot(S[0][0] + S[1][1], S[0][1] - S[1][0]) +
            std::hypot(S[0][0] - S[1][1], S[0][1] + S[1][0])) /
           2;
  }


  void
  ShellMesh::add_imperfection(const Imperfection &deviation)
  {
    LA::Vector          V = owned_vector();
    GreatestDeviation   greatest;
    std::vector<double> deviations(nodes.size(), 0.);
    // the formula may have no value at the nodes of one rank alone
    agree_on_errors(communicator, [&]() {
      for (unsigned int n = 0; n < nodes.size(); ++n)
        {
          const Node &node = nodes[n];
          if (holds_normal(node, constraints))
            continue;
          const double w = deviation(node.surface.position, node.alpha);
          deviations[n]  = w;
          if (!node.locally_owned)
            continue;
          V(node.dof(2, MixedElement::mean)) = w;
          greatest.add(w, curvature(n), node.surface.position, node.alpha);
        }
    });
    greatest.check(*surface, communicator);
    set_deviation_of_joints(deviations, V);
    V.compress(VectorOperation::insert);
    constraints.distribute(V);
    imperfection = ghosted_vector();
    imperfection = V;
    check_slope_of_imperfection();
  }


  void
  ShellMesh::set_deviation_of_joints(const std::vector<double> &deviations,
                                     LA::Vector                &V) const
  {
    for (const std::vector<unsigned int> &joint : joints)
      {
        // least squares, the shortest one if several fit
        LAPACKFullMatrix<double> squares(3, 3);
        Vector<double>           products(3), shift(3);
        squares = 0;
        for (const unsigned int n : joint)
          {
            const Tensor<1, 3> &normal = nodes[n].surface.frame[2];
            for (unsigned int i = 0; i < 3; ++i)
              {
                products[i] += deviations[n] * normal[i];
                for (unsigned int j = 0; j < 3; ++j)
                  squares(i, j) += normal[i] * normal[j];
              }
          }
        squares.compute_inverse_svd(1e-3);
        squares.vmult(shift, products);
        const Tensor<1, 3> in_space({shift[0], shift[1], shift[2]});
        for (const unsigned int n : joint)
          {
            const Tensor<1, 3> v = nodes[n].surface.to_frame(in_space);
            for (unsigned int i = 0; i < 3 && nodes[n].locally_owned; ++i)
              V(nodes[n].dof(i, MixedElement::mean)) = v[i];
          }
      }
  }


  void
  ShellMesh::check_slope_of_imperfection() const
  {
    // lengths along the shell are wrong by half its square
    constexpr double limit = 0.3;

    double steepest = 0;
    for (const Cell &cell : wall_elements())
      for (unsigned int v = 0; v < 4; ++v)
        for (const unsigned int w : {v ^ 1, v ^ 2})
          {
            const Node &one = nodes[cell.nodes[v]], &two = nodes[cell.nodes[w]];
            const auto  height = [&](const Node &node) {
              return displacement(imperfection, node, Resultants::inner)[2] /
                       2 +
                     displacement(imperfection, node, Resultants::outer)[2] / 2;
            };
            steepest =
              std::max(steepest,
                       std::abs(height(two) - height(one)) /
                         two.surface.position.distance(one.surface.position));
          }
    steepest = Utilities::MPI::max(steepest, communicator);
    if (!(steepest <= limit))
      throw InputError("the entries of 'Surface/Imperfection' deviate from the "
                       "surface with a slope of " +
                       number_to_string(std::round(1000 * steepest) / 1000) +
                       " between nodes, but it must be at most " +
                       number_to_string(limit) +
                       ", since lengths are taken along the surface.");
  }


  std::shared_ptr<const ShellMesh>
  ShellMesh::with_layup(const Layup &other) const
  {
    const std::shared_ptr<ShellMesh> result(new ShellMesh(*this));
    result->set_layup(other);
    if (grid.has_lines())
      result->strips = Faces(*result->layup, *surface, grid).strips;
    // the strips of a mesh follow from the groups, and from what varies
    else if (layup->groups() != other.groups() ||
             layup->varies() != other.varies())
      return nullptr;
    bool differs = false;
    if (!grid.has_lines())
      try
        {
          std::vector<std::vector<unsigned int>> layers_of_strips;
          result->strips =
            places_of_strips->make_strips(*result->layup, layers_of_strips);
        }
      catch (const InputError &)
        {
          // perhaps on this rank alone: a new mesh checks all cells on all
          differs = true;
        }
    differs = differs || strips.size() != result->strips.size();
    for (unsigned int i = 0; i < strips.size() && !differs; ++i)
      for (unsigned int v = 0; v < 4; ++v)
        differs = differs || result->strips[i].at_vertices[v]->face_heights() !=
                               strips[i].at_vertices[v]->face_heights();
    if (Utilities::MPI::logical_or(differs, communicator))
      return nullptr;
    result->set_wall_stiffness();
    return result;
  }


  std::vector<Cell::Contribution>
  ShellMesh::contributions_to_wall(const Node                  &node,
                                   const std::array<double, 2> &own)
  {
    const double       inner     = node.face_heights[0];
    const double       outer     = node.face_heights[1];
    const double       thickness = outer - inner;
    Cell::Contribution part;
    if (own[0] != inner || own[1] != outer)
      {
        // s and r of section 2 of doc/theory.md: displacements are linear
        // over the wall, and beyond its faces at the node
        part.mean            = (own[1] + own[0] - outer - inner) / thickness;
        part.half_difference = (own[1] - own[0]) / thickness;
      }
    return std::vector<Cell::Contribution>(node.n_layers(), part);
  }


  std::vector<Cell::Contribution>
  ShellMesh::contributions_to_layer(const Node                &node,
                                    const std::vector<double> &own,
                                    const unsigned int         stiffest,
                                    const unsigned int         layer)
  {
    const unsigned int n_layers = node.n_layers();
    const auto         ratio    = [&](const unsigned int k) {
      return (own[k + 1] - own[k]) / (2 * node.half_thickness[k]);
    };

    // the displacement of the middle of the stiffest layer
    std::vector<Cell::Contribution> result(n_layers, {0, 0});
    for (unsigned int k = 0; k < n_layers; ++k)
      result[k].mean = (k < stiffest ? 1 : -1);
    result[stiffest].mean = (own[stiffest] - node.height(stiffest) +
                             own[stiffest + 1] - node.height(stiffest + 1)) /
                            (2 * node.half_thickness[stiffest]);

    // from there to the middle of this one
    if (layer != stiffest)
      for (unsigned int k = std::min(layer, stiffest);
           k <= std::max(layer, stiffest);
           ++k)
        if (node.half_thickness[k] > 0)
          result[k].mean += (layer > stiffest ? 1 : -1) *
                            (k == layer || k == stiffest ? 1 : 2) * ratio(k);
    result[layer].half_difference = ratio(layer);
    return result;
  }


  Node
  ShellMesh::make_node(const GridIndex &index, const Faces &faces) const
  {
    const Faces::Heights &heights = faces.on_lines[index[0]];
    Node                  node;
    node.grid_index   = index;
    node.alpha        = grid.alpha(index);
    node.face_heights = {{heights.front(), heights.back()}};
    for (unsigned int k = 0; k + 1 < heights.size(); ++k)
      node.half_thickness.push_back((heights[k + 1] - heights[k]) / 2);
    node.surface       = surface->evaluate(node.alpha);
    node.number        = grid.node_number(index);
    node.locally_owned = false;
    node.face_is_free  = {{true, true}};
    return node;
  }


  void
  ShellMesh::add_elements(
    const std::array<unsigned int, 4> &cell_nodes,
    const types::global_cell_index     number,
    const types::global_cell_index     first,
    const Column                      &column,
    const std::function<
      ElementGeometry(const std::array<std::array<double, 2>, 4> &)> &geometry)
  {
    const std::size_t first_of_column = cells.size();
    const auto        add             = [&](const unsigned int strip,
                         const unsigned int lowest,
                         const unsigned int highest) {
      Cell local;
      local.nodes    = cell_nodes;
      local.position = cells.size();
      local.strip    = strip;
      local.column   = number;
      local.is_wall  = (lowest == 0 && highest + 1 == n_layers());
      local.is_layer = (lowest == highest);
      local.layer    = lowest;
      local.number   = first + cells.size() - first_of_column;

      ShellFEValues::FaceHeights heights;
      bool                       own_unknowns = (n_layers() > 1);
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Node &node = nodes[cell_nodes[v]];
          local.dofs.insert(
            local.dofs.end(), node.dofs.begin(), node.dofs.end());
          heights[v] = {
            {column.heights[v][lowest], column.heights[v][highest + 1]}};
          own_unknowns = own_unknowns || heights[v] != node.face_heights;
        }
      // most cells of a shell with one layer have the unknowns of their nodes
      // and need no conversion
      if (own_unknowns)
        for (unsigned int v = 0; v < 4; ++v)
          {
            const Node &node = nodes[cell_nodes[v]];
            for (const Cell::Contribution &contribution :
                 local.is_wall
                                      ? contributions_to_wall(node, heights[v])
                                      : contributions_to_layer(
                       node, column.heights[v], column.stiffest[v], lowest))
              local.contributions.push_back(contribution);
          }
      local.geometry = geometry(heights);
      cells.push_back(local);
    };
    add(column.wall, 0, n_layers() - 1);
    if (n_layers() > 1)
      for (unsigned int k = 0; k < n_layers(); ++k)
        if (column.layers[k] != numbers::invalid_unsigned_int)
          add(column.layers[k], k, k);
  }


  void
  ShellMesh::collect_cells_and_nodes(const Faces &faces)
  {
    ShellFEValues fe_values(*surface, formulation, normal_thickness);

    // map from the vertices of the triangulation to the nodes of this rank
    std::vector<unsigned int> node_of_vertex(triangulation->n_vertices(),
                                             numbers::invalid_unsigned_int);

    const auto add_node =
      [&](const DoFHandler<2, 3>::active_cell_iterator &cell,
          const unsigned int                            v,
          const GridIndex                              &grid_index) {
        unsigned int &index = node_of_vertex[cell->vertex_index(v)];
        if (index != numbers::invalid_unsigned_int)
          return index;

        Node node = make_node(grid_index, faces);
        Assert(node.surface.position.distance(cell->vertex(v)) <
                 1e-8 * cell->diameter(),
               ExcMessage("Coarse cells must be numbered as in the grid."));
        for (unsigned int i = 0; i < n_dofs_per_node(); ++i)
          node.dofs.push_back(cell->vertex_dof_index(v, i));
        node.locally_owned = locally_owned.is_element(node.dofs[0]);
        index              = nodes.size();
        nodes.push_back(node);
        return index;
      };

    std::vector<std::set<unsigned int>> adjacent;
    for (const auto &cell : dof_handler->active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;

        const types::global_cell_index number = cell->id().get_coarse_cell_id();
        const GridIndex                cell_index = grid.cell_index(number);
        std::array<unsigned int, 4>    cell_nodes;
        for (unsigned int v = 0; v < 4; ++v)
          cell_nodes[v] = add_node(cell, v, grid.node_of_cell(cell_index, v));
        adjacent.resize(nodes.size());
        for (const unsigned int i : cell_nodes)
          adjacent[i].insert(cell_nodes.begin(), cell_nodes.end());

        // cells of other ranks give nodes around, no elements
        if (!cell->is_locally_owned())
          continue;

        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            {
              const std::array<unsigned int, 2> ends{
                {GeometryInfo<2>::face_to_cell_vertices(f, 0),
                 GeometryInfo<2>::face_to_cell_vertices(f, 1)}};
              const std::array<unsigned int, 2> side{
                {cell_nodes[ends[0]], cell_nodes[ends[1]]}};

              // the coordinate that runs along the side
              const unsigned int a      = 1 - f / 2;
              const double       start  = grid.lines[a][cell_index[a]];
              const double       end    = grid.lines[a][cell_index[a] + 1];
              Point<2>           middle = nodes[side[0]].alpha;
              middle[a]                 = (start + end) / 2;
              BoundarySegment segment{cell->face(f)->boundary_id(),
                                      static_cast<unsigned int>(cells.size()),
                                      ends,
                                      side,
                                      (end - start) *
                                        surface->evaluate(middle).lame[a],
                                      {},
                                      {}};
              for (unsigned int k = 0; k < 2; ++k)
                {
                  // against alpha_2 on the edges alpha_1 min and alpha_2 max
                  segment.axes[k][a]    = (f == 1 || f == 2 ? 1 : -1);
                  segment.curvatures[k] = nodes[side[k]].surface.curvature[a];
                }
              boundary.push_back(segment);
            }

        const unsigned int strip = cell_index[0];
        Column             column;
        column.wall   = strip;
        column.layers = faces.layers[strip];
        for (unsigned int v = 0; v < 4; ++v)
          {
            // the vertices with the larger alpha_1 are the odd ones
            column.heights[v] = faces.of_strips[strip][v % 2];
            column.stiffest[v] =
              faces.stiffest[nodes[cell_nodes[v]].grid_index[0]];
          }
        double wall_thickness = 0;
        for (const Faces::Heights &all : faces.of_strips[strip])
          wall_thickness += (all.back() - all.front()) / 2;
        add_elements(cell_nodes,
                     number,
                     n_layers() == 1 ? number
                                     : cell_index[1] * faces.n_elements.back() +
                                         faces.n_elements[strip],
                     column,
                     [&](const ShellFEValues::FaceHeights &heights) {
                       fe_values.reinit(cell, heights, wall_thickness);
                       return fe_values.get_geometry();
                     });
      }

    for (const auto &set : adjacent)
      neighbors.emplace_back(set.begin(), set.end());
  }


  void
  ShellMesh::add_cyclic_nodes(const Faces &faces)
  {
    const unsigned int n_dofs = n_dofs_per_node();

    // the two lines next to either edge: those on the other side enter the
    // equations of the nodes on an edge
    const unsigned int                last = grid.n_nodes(1) - 1;
    const std::array<unsigned int, 4> lines{{0, 1, last - 1, last}};

    std::map<types::global_cell_index, unsigned int> known;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      known[nodes[n].number] = n;

    // the unknowns of these nodes, from the ranks that own them
    std::vector<types::global_dof_index> dofs(4 * n_dofs * grid.n_nodes(0));
    const auto position = [&](const unsigned int line, const unsigned int i) {
      return n_dofs * (line * grid.n_nodes(0) + i);
    };
    for (unsigned int line = 0; line < 4; ++line)
      for (unsigned int i = 0; i < grid.n_nodes(0); ++i)
        {
          const auto node = known.find(grid.node_number({{i, lines[line]}}));
          if (node != known.end() && nodes[node->second].locally_owned)
            for (unsigned int d = 0; d < n_dofs; ++d)
              dofs[position(line, i) + d] = nodes[node->second].dofs[d];
        }
    // zero on ranks that do not own the node, so that the sum makes all known
    Utilities::MPI::sum(dofs, communicator, dofs);

    const unsigned int n_known = nodes.size();
    for (unsigned int n = 0; n < n_known; ++n)
      for (unsigned int line = 0; line < 4; ++line)
        {
          const GridIndex    at   = nodes[n].grid_index;
          const unsigned int from = (line < 2 ? last : 0);
          if (at[1] != from)
            continue;
          const unsigned int begin = (at[0] == 0 ? 0 : at[0] - 1);
          const unsigned int end   = std::min(at[0] + 2, grid.n_nodes(0));
          for (unsigned int i = begin; i < end; ++i)
            {
              const GridIndex other{{i, lines[line]}};
              if (known.count(grid.node_number(other)) > 0)
                continue;
              Node node = make_node(other, faces);
              for (unsigned int d = 0; d < n_dofs; ++d)
                node.dofs.push_back(dofs[position(line, i) + d]);
              known[node.number] = nodes.size();
              locally_relevant.add_indices(node.dofs.begin(), node.dofs.end());
              neighbors.push_back({static_cast<unsigned int>(nodes.size())});
              nodes.push_back(node);
            }
        }
  }


  MixedElement::NodalVector
  Cell::element_unknowns(const std::vector<double> &values) const
  {
    MixedElement::NodalVector V;
    if (contributions.empty())
      {
        std::copy(values.begin(), values.end(), V.begin_raw());
        return V;
      }
    const unsigned int n_layers = contributions.size() / 4;
    const double      *value    = values.data();
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int i = 0; i < 3; ++i)
        {
          double &mean = V[MixedElement::dof(v, i, MixedElement::mean)];
          double &difference =
            V[MixedElement::dof(v, i, MixedElement::half_difference)];
          mean = *value++;
          for (unsigned int k = 0; k < n_layers; ++k, ++value)
            {
              const Contribution &part = contributions[v * n_layers + k];
              mean += part.mean * *value;
              difference += part.half_difference * *value;
            }
        }
    return V;
  }


  namespace
  {
    /** Move forces on an element to the nodes, see Cell::to_nodes().
     * @param step between the entries of both. */
    void
    move_to_nodes(const std::vector<Cell::Contribution> &contributions,
                  const double                          *forces,
                  double                                *of_nodes,
                  const unsigned int                     step)
    {
      const unsigned int n_layers = contributions.size() / 4;
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int i = 0; i < 3; ++i)
          {
            const double mean =
              forces[step * MixedElement::dof(v, i, MixedElement::mean)];
            const double difference =
              forces[step *
                     MixedElement::dof(v, i, MixedElement::half_difference)];
            *of_nodes = mean;
            of_nodes += step;
            for (unsigned int k = 0; k < n_layers; ++k, of_nodes += step)
              {
                const Cell::Contribution &part =
                  contributions[v * n_layers + k];
                *of_nodes =
                  part.mean * mean + part.half_difference * difference;
              }
          }
    }
  } // namespace


  void
  Cell::to_nodes(const MixedElement::NodalVector &forces,
                 std::vector<double>             &of_nodes) const
  {
    of_nodes.resize(dofs.size());
    if (contributions.empty())
      std::copy(forces.begin_raw(), forces.end_raw(), of_nodes.begin());
    else
      move_to_nodes(contributions, forces.begin_raw(), of_nodes.data(), 1);
  }


  void
  Cell::to_nodes(const MixedElement::NodalMatrix &K,
                 std::vector<double>             &of_nodes) const
  {
    const unsigned int n = dofs.size();
    of_nodes.resize(n * n);
    if (contributions.empty())
      {
        for (unsigned int k = 0; k < n; ++k)
          std::copy(K[k].begin(), K[k].end(), &of_nodes[n * k]);
        return;
      }
    // rows, then columns
    constexpr unsigned int n_own = MixedElement::n_dofs;
    std::vector<double>    rows(n * n_own);
    for (unsigned int l = 0; l < n_own; ++l)
      move_to_nodes(contributions, &K[0][l], &rows[l], n_own);
    for (unsigned int k = 0; k < n; ++k)
      move_to_nodes(contributions, &rows[n_own * k], &of_nodes[n * k], 1);
  }


  double
  Cell::sign_of_face(const unsigned int vertex, const unsigned int face) const
  {
    const double sign = MixedElement::face_sign[face];
    if (contributions.empty())
      return sign;
    // all layers contribute in the same way
    const Contribution &part =
      contributions[vertex * (contributions.size() / 4)];
    return (sign - part.mean) / part.half_difference;
  }


  LA::Vector
  ShellMesh::ghosted_vector() const
  {
    return LA::Vector(locally_owned, locally_relevant, communicator);
  }


  void
  ShellMesh::set_wall_stiffness()
  {
    // section 6 of doc/theory.md: what the softest place of the wall yields to
    // a pressure sets the scale of penetrations
    std::array<double, 2> lowest;
    lowest.fill(std::numeric_limits<double>::infinity());
    for (unsigned int i = 0; i < n_strips(); ++i)
      {
        const Laminate &wall   = strips[i].laminate;
        const double    across = wall.thickness_stiffness(),
                     limit =
                       1000 * wall.membrane_stiffness() / (size() * size());
        lowest[0] = std::min({lowest[0], across, limit});
        // where a membrane limits the stiffness, its part of that across the
        // wall counts once more
        lowest[1] = std::min(
          lowest[1], limit < across ? limit * (limit / across) : across);
      }
    lowest_stiffness          = Utilities::MPI::min(lowest[0], communicator);
    lowest_stiffness_sideways = Utilities::MPI::min(lowest[1], communicator);
  }


  bool
  ShellMesh::prescribes_displacements() const
  {
    return Utilities::MPI::logical_or(!prescribed.empty(), communicator);
  }


  bool
  ShellMesh::prescribes_displacements(const unsigned int factor) const
  {
    return Utilities::MPI::logical_or(
      std::any_of(prescribed.begin(),
                  prescribed.end(),
                  [factor](const PrescribedDisplacement &p) {
                    return factor < p.values.size() && p.values[factor] != 0;
                  }),
      communicator);
  }


  LA::Vector
  ShellMesh::owned_vector() const
  {
    return LA::Vector(locally_owned, communicator);
  }


  Tensor<1, 3>
  ShellMesh::displacement_of_any_face(const LA::Vector  &V,
                                      const Node        &node,
                                      const unsigned int face) const
  {
    // V(dof) searches the number of each entry
    const bool   has_ghosts = (V.trilinos_vector().MyLength() ==
                             static_cast<int>(locally_relevant.n_elements()));
    Tensor<1, 3> v;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int part = 0; part < node.n_parts(); ++part)
        v[i] += Node::sign_of_part(face, part) *
                (has_ghosts ? V.begin()[node.entries[node.position(i, part)]]
                            : V(node.dof(i, part)));
    return v;
  }


  Tensor<1, 3>
  ShellMesh::displacement(const LA::Vector  &V,
                          const Node        &node,
                          const unsigned int face) const
  {
    return displacement_of_any_face(V, node, face * n_layers());
  }


  Point<3>
  ShellMesh::position_of_any_face(const LA::Vector  &V,
                                  const Node        &node,
                                  const unsigned int face) const
  {
    return node.surface.position + node.height(face) * node.surface.frame[2] +
           node.surface.from_frame(displacement_of_any_face(V, node, face));
  }


  Point<3>
  ShellMesh::deformed_position(const LA::Vector  &V,
                               const Node        &node,
                               const unsigned int face) const
  {
    return position_of_any_face(V, node, face * n_layers());
  }


  Point<3>
  ShellMesh::position_at_height(const LA::Vector &V,
                                const Node       &node,
                                const double      height) const
  {
    // displacements are linear in the height within a layer
    unsigned int layer = 0;
    while (layer + 1 < node.n_layers() && height > node.height(layer + 1))
      ++layer;
    const double   low = node.height(layer), high = node.height(layer + 1);
    const double   fraction = (high > low ? (height - low) / (high - low) : 0.);
    const Point<3> inner    = position_of_any_face(V, node, layer),
                   outer    = position_of_any_face(V, node, layer + 1);
    return Point<3>((1 - fraction) * inner + fraction * outer);
  }


  std::pair<unsigned int, unsigned int>
  ShellMesh::layers_of(const unsigned int wall) const
  {
    const unsigned int first = (cells[wall].is_layer ? wall : wall + 1);
    unsigned int       end   = first + 1;
    while (end < cells.size() && cells[end].column == cells[wall].column)
      ++end;
    return {first, end};
  }


  void
  ShellMesh::add_nodal_forces(const Cell                      &cell,
                              const MixedElement::NodalVector &force,
                              LA::Vector &nodal_forces) const
  {
    std::vector<double> on_nodes;
    cell.to_nodes(force, on_nodes);
    nodal_forces.add(cell.dofs.size(), cell.dofs.data(), on_nodes.data());
  }


  void
  ShellMesh::condense(LA::Vector &nodal_forces) const
  {
    for (const auto &line : constraints.get_lines())
      if (locally_owned.is_element(line.index))
        {
          const double force = nodal_forces(line.index);
          for (const auto &entry : line.entries)
            {
              const double part = entry.second * force;
              nodal_forces.add(1, &entry.first, &part);
            }
        }
    // between adding and setting entries, ranks must exchange what they have
    nodal_forces.compress(VectorOperation::add);
    for (const auto &line : constraints.get_lines())
      if (locally_owned.is_element(line.index))
        nodal_forces(line.index) = 0;
    nodal_forces.compress(VectorOperation::insert);
  }


  Tensor<1, 3>
  ShellMesh::force_on_any_face(const LA::Vector  &nodal_forces,
                               const Node        &node,
                               const unsigned int face) const
  {
    // the half differences over the layers below and above the face; beyond
    // the inner and the outer face, the mean takes their place
    const unsigned int below = face, above = face < n_layers() ? face + 1 : 0;
    Tensor<1, 3>       force;
    for (unsigned int i = 0; i < 3; ++i)
      force[i] = (nodal_forces(node.dof(i, below)) +
                  (above == 0 ? 1. : -1.) * nodal_forces(node.dof(i, above))) /
                 2;
    return force;
  }


  MixedElement::NodalVector
  ShellMesh::cell_values(const LA::Vector &V, const Cell &cell) const
  {
    AssertDimension(V.trilinos_vector().MyLength(),
                    static_cast<int>(locally_relevant.n_elements()));
    // not V(dof), which searches the number of each entry
    const double *const entries = V.begin();
    if (cell.contributions.empty())
      {
        MixedElement::NodalVector values;
        for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
          values[i] = entries[cell.positions[i]];
        return values;
      }
    std::vector<double> values;
    for (const unsigned int position : cell.positions)
      values.push_back(entries[position]);
    return cell.element_unknowns(values);
  }


  std::vector<std::vector<double>>
  evaluate_at_nodes(const std::vector<Formula> &formulas, const ShellMesh &mesh)
  {
    const ReferenceSurface          &surface = mesh.get_surface();
    std::vector<std::vector<double>> values;
    agree_on_errors(mesh.communicator, [&]() {
      for (const Node &node : mesh.nodes)
        {
          const std::vector<double> variables =
            surface.formula_variables(node.surface.position, node.alpha);
          values.emplace_back();
          for (const Formula &formula : formulas)
            values.back().push_back(formula(variables));
        }
    });
    return values;
  }
} // namespace Biface
