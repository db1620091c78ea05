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
    /** Equations @f$\bar c\bar v + \tilde c\tilde v = v_0@f$ for the two
     * unknowns of one component at one node, in reduced form. */
    struct NodalEquations
    {
      std::vector<std::array<double, 3>> rows;

      /** The unknown that an equation determines: the mean if possible. */
      static unsigned int
      pivot_of(const std::array<double, 3> &row)
      {
        return std::abs(row[0]) >= std::abs(row[1]) ? 0 : 1;
      }

      /** Add an equation. @return whether it is consistent with the others up
       * to round-off. */
      bool
      add(std::array<double, 3> row)
      {
        double scale = std::abs(row[2]);
        for (const auto &old : rows)
          {
            const unsigned int pivot  = pivot_of(old);
            const double       factor = row[pivot] / old[pivot];
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
    std::map<std::pair<unsigned int, unsigned int>, NodalEquations> equations;
    bool       contradiction = false;
    const auto add           = [&](const unsigned int                   node,
                         const std::vector<SupportCondition> &conditions) {
      for (const SupportCondition &condition : conditions)
        if (!equations[{node, condition.component}].add(
              {{condition.coefficients[Resultants::outer] +
                  condition.coefficients[Resultants::inner],
                condition.coefficients[Resultants::outer] -
                  condition.coefficients[Resultants::inner],
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
          {node.dof(i, MixedElement::mean),
           node.dof(i, MixedElement::half_difference)}};
        const auto prescribe = [&](const unsigned int part,
                                   const double       factor,
                                   const double       value) {
          constraints.add_line(dofs[part]);
          if (factor != 0)
            constraints.add_entry(dofs[part], dofs[1 - part], factor);
          if (value != 0)
            prescribed.push_back(
              {dofs[part],
               factor != 0 ? dofs[1 - part] : numbers::invalid_dof_index,
               factor,
               value});
        };

        if (rows.size() == 1)
          {
            const unsigned int part = NodalEquations::pivot_of(rows[0]);
            prescribe(part,
                      -rows[0][1 - part] / rows[0][part],
                      rows[0][2] / rows[0][part]);
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
