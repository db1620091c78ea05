// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/model/constraints.h>
#include <biface/model/named_points.h>
#include <biface/model/shell_mesh.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Equations @f$c^-v^- + c^+v^+ = \bar v@f$ for one component at one
     * node, in reduced form. */
    struct FaceEquations
    {
      std::vector<std::array<double, 3>> rows;

      /** Add an equation. @return whether it is consistent with the others up
       * to round-off. */
      bool
      add(std::array<double, 3> row)
      {
        double scale = std::abs(row[2]);
        for (const auto &old : rows)
          {
            const unsigned int pivot =
              (std::abs(old[1]) >= std::abs(old[0]) ? 1 : 0);
            const double factor = row[pivot] / old[pivot];
            for (unsigned int i = 0; i < 3; ++i)
              row[i] -= factor * old[i];
            row[pivot] = 0;
            scale      = std::max(scale, std::abs(factor * old[2]));
          }
        if (std::abs(row[0]) < 1e-12 && std::abs(row[1]) < 1e-12)
          return std::abs(row[2]) <= 1e-12 * scale;
        rows.push_back(row);
        return true;
      }
    };
  } // namespace


  void
  make_constraints(const Supports                      &supports,
                   const ShellMesh                     &mesh,
                   AffineConstraints<double>           &constraints,
                   std::vector<PrescribedDisplacement> &prescribed)
  {
    // equations for the components of the nodes
    std::map<std::pair<unsigned int, unsigned int>, FaceEquations> equations;
    bool       contradiction = false;
    const auto add           = [&](const unsigned int                   node,
                         const std::vector<SupportCondition> &conditions) {
      for (const SupportCondition &condition : conditions)
        if (!equations[{node, condition.component}].add(
              {{condition.coefficients[0],
                condition.coefficients[1],
                condition.value}}))
          contradiction = true;
    };

    for (unsigned int edge = 0; edge < 4; ++edge)
      {
        for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
          if (mesh.grid.on_edge(mesh.nodes[n].grid_index,
                                static_cast<Edge>(edge)))
            add(n, supports.edges[edge]);
      }
    for (const auto &item : supports.points)
      {
        const unsigned int node =
          node_of_point(mesh, "Supports/Point supports", item.point);
        if (node != numbers::invalid_unsigned_int)
          add(node, item.conditions);
      }
    if (Utilities::MPI::max(static_cast<unsigned int>(contradiction),
                            mesh.communicator) > 0)
      throw InputError("the section 'Supports' prescribes contradictory "
                       "values of a displacement.");

    constraints.reinit(mesh.locally_relevant);
    prescribed.clear();
    for (const auto &item : equations)
      {
        const Node        &node = mesh.nodes[item.first.first];
        const unsigned int i    = item.first.second;
        const auto        &rows = item.second.rows;

        const std::array<types::global_dof_index, 2> dofs{
          {node.dofs[2 * i], node.dofs[2 * i + 1]}};
        const auto prescribe = [&](const unsigned int face,
                                   const double       factor,
                                   const double       value) {
          constraints.add_line(dofs[face]);
          if (factor != 0)
            constraints.add_entry(dofs[face], dofs[1 - face], factor);
          if (value != 0)
            prescribed.push_back(
              {dofs[face],
               factor != 0 ? dofs[1 - face] : numbers::invalid_dof_index,
               factor,
               value});
        };

        if (rows.size() == 1)
          {
            const unsigned int face =
              (std::abs(rows[0][1]) >= std::abs(rows[0][0]) ? 1 : 0);
            prescribe(face,
                      -rows[0][1 - face] / rows[0][face],
                      rows[0][2] / rows[0][face]);
          }
        else
          {
            const double determinant =
              rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
            prescribe(0,
                      0,
                      (rows[0][2] * rows[1][1] - rows[0][1] * rows[1][2]) /
                        determinant);
            prescribe(1,
                      0,
                      (rows[0][0] * rows[1][2] - rows[0][2] * rows[1][0]) /
                        determinant);
          }
      }
    constraints.close();
  }
} // namespace Biface
