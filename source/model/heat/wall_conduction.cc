// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <biface/model/heat/wall_conduction.h>

namespace Biface
{
  using namespace dealii;

  HeatFilm
  HeatFilm::mean(const HeatFilm &a, const HeatFilm &b, const double part_of_b)
  {
    // the mean flux of a surface that meets both in turn, each for its part of
    // the time
    const double of_a = (1 - part_of_b) * a.coefficient,
                 of_b = part_of_b * b.coefficient;
    HeatFilm result;
    result.coefficient = of_a + of_b;
    if (result.coefficient > 0)
      result.temperature =
        (of_a * a.temperature + of_b * b.temperature) / result.coefficient;
    return result;
  }


  namespace
  {
    constexpr unsigned int inner_side = 0, outer_side = 1, ends = 2;

    void
    make_triangulation(const WallSection &section, Triangulation<2> &wall)
    {
      const unsigned int n_lines = section.vertices.size(0),
                         n_faces = section.vertices.size(1);
      std::vector<Point<2>>    vertices;
      std::vector<CellData<2>> cells;
      SubCellData              boundary;
      const auto number = [&](const unsigned int i, const unsigned int p) {
        return i * n_faces + p;
      };
      for (unsigned int i = 0; i < n_lines; ++i)
        for (unsigned int p = 0; p < n_faces; ++p)
          vertices.push_back(section.vertices(i, p));
      for (unsigned int i = 0; i + 1 < n_lines; ++i)
        {
          for (unsigned int p = 0; p + 1 < n_faces; ++p)
            {
              CellData<2> cell;
              cell.vertices    = {number(i, p),
                                  number(i + 1, p),
                                  number(i, p + 1),
                                  number(i + 1, p + 1)};
              cell.material_id = 0;
              cells.push_back(cell);
            }
          for (const unsigned int face : {inner_side, outer_side})
            {
              CellData<1>        segment;
              const unsigned int p = (face == inner_side ? 0 : n_faces - 1);
              segment.vertices     = {number(i, p), number(i + 1, p)};
              segment.boundary_id  = face;
              boundary.boundary_lines.push_back(segment);
            }
        }
      // an id of their own, for which no film is assembled: the ends are
      // insulated
      for (const unsigned int i : {0u, n_lines - 1})
        for (unsigned int p = 0; p + 1 < n_faces; ++p)
          {
            CellData<1> segment;
            segment.vertices    = {number(i, p), number(i, p + 1)};
            segment.boundary_id = ends;
            boundary.boundary_lines.push_back(segment);
          }
      wall.create_triangulation(vertices, cells, boundary);
    }
  } // namespace


  WallTemperatures
  steady_temperatures(const WallSection &section)
  {
    const unsigned int n_strips = section.conductivity.size(0),
                       n_plies  = section.conductivity.size(1);
    Triangulation<2> wall;
    make_triangulation(section, wall);
    // quadratic, since a ply is one cell thick
    const FE_Q<2> fe(2);
    DoFHandler<2> dof_handler(wall);
    dof_handler.distribute_dofs(fe);
    DynamicSparsityPattern pattern(dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, pattern);
    SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    SparseMatrix<double> matrix(sparsity);
    Vector<double>       rhs(dof_handler.n_dofs()), T(dof_handler.n_dofs());

    const QGauss<2>                      quadrature(3);
    const QGauss<1>                      on_faces(3);
    FEValues<2>                          values(fe,
                       quadrature,
                       update_values | update_gradients |
                         update_quadrature_points | update_JxW_values);
    FEFaceValues<2>                      face_values(fe,
                                on_faces,
                                update_values | update_quadrature_points |
                                  update_JxW_values);
    const unsigned int                   n = fe.n_dofs_per_cell();
    FullMatrix<double>                   of_cell(n, n);
    Vector<double>                       forces(n);
    std::vector<types::global_dof_index> dofs(n);
    // the angle around the axis is left out everywhere
    const auto radius = [](const auto &values, const unsigned int q) {
      return values.quadrature_point(q)[1];
    };
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        // cells have the order in which they were made
        const unsigned int strip = cell->index() / n_plies,
                           ply   = cell->index() % n_plies;
        values.reinit(cell);
        of_cell = 0;
        forces  = 0;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          for (unsigned int i = 0; i < n; ++i)
            {
              const double weight = radius(values, q) * values.JxW(q);
              forces(i) +=
                weight * section.source(strip, ply) * values.shape_value(i, q);
              for (unsigned int j = 0; j < n; ++j)
                of_cell(i, j) +=
                  weight * section.conductivity(strip, ply) *
                  (values.shape_grad(i, q) * values.shape_grad(j, q));
            }
        for (const auto f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() != ends)
            {
              const HeatFilm &film =
                section.films[cell->face(f)->boundary_id()][strip];
              face_values.reinit(cell, f);
              for (unsigned int q = 0; q < on_faces.size(); ++q)
                for (unsigned int i = 0; i < n; ++i)
                  {
                    const double weight =
                      radius(face_values, q) * face_values.JxW(q) *
                      film.coefficient * face_values.shape_value(i, q);
                    forces(i) += weight * film.temperature;
                    for (unsigned int j = 0; j < n; ++j)
                      of_cell(i, j) += weight * face_values.shape_value(j, q);
                  }
            }
        cell->get_dof_indices(dofs);
        matrix.add(dofs, of_cell);
        rhs.add(dofs, forces);
      }
    SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.vmult(T, rhs);

    WallTemperatures result;
    result.plies.reinit(n_strips, n_plies);
    for (std::vector<double> &face : result.faces)
      face.resize(n_strips);
    std::vector<double> at_points(quadrature.size()), at_face(on_faces.size());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const unsigned int strip = cell->index() / n_plies;
        values.reinit(cell);
        values.get_function_values(T, at_points);
        double sum = 0, volume = 0;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            sum += radius(values, q) * values.JxW(q) * at_points[q];
            volume += radius(values, q) * values.JxW(q);
          }
        result.plies(strip, cell->index() % n_plies) = sum / volume;
        for (const auto f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() != ends)
            {
              face_values.reinit(cell, f);
              face_values.get_function_values(T, at_face);
              double on_face = 0, area = 0;
              for (unsigned int q = 0; q < on_faces.size(); ++q)
                {
                  const double weight =
                    radius(face_values, q) * face_values.JxW(q);
                  on_face += weight * at_face[q];
                  area += weight;
                }
              result.faces[cell->face(f)->boundary_id()][strip] =
                on_face / area;
            }
      }
    return result;
  }
} // namespace Biface
