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
    constexpr unsigned int n_unknowns = 6;

    /** Relative size of what remains of an equation that follows from others.
     */
    constexpr double roundoff = 1e-10;


    /** A linear equation for the unknowns of a node. */
    struct Equation
    {
      Tensor<1, n_unknowns> coefficients;
      double                value;
    };


    /** An equation for the displacements of the faces as one for the unknowns
     * of a node, in the order of Node::dofs. */
    Equation
    for_unknowns(const SupportEquation &equation)
    {
      Equation result{{}, equation.value};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int face = 0; face < 2; ++face)
          {
            const double c = equation.coefficients[2 * i + face];
            result.coefficients[MixedElement::dof(0, i, MixedElement::mean)] +=
              c;
            result.coefficients[MixedElement::dof(
              0, i, MixedElement::half_difference)] +=
              MixedElement::face_sign[face] * c;
          }
      return result;
    }


    /** The equations of all supports at a node. */
    class NodalEquations
    {
    public:
      /** Add an equation unless it follows from the others. @return whether it
       * is consistent with them. */
      bool
      add(const SupportEquation &equation)
      {
        Equation     remainder = for_unknowns(equation);
        const double norm      = remainder.coefficients.norm();
        double       scale     = std::abs(remainder.value);
        // twice, since the first pass leaves round-off of what it removes
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (const Equation &other : orthonormal)
            {
              const double part = remainder.coefficients * other.coefficients;
              remainder.coefficients -= part * other.coefficients;
              remainder.value -= part * other.value;
              scale = std::max(scale, std::abs(part * other.value));
            }
        const double left = remainder.coefficients.norm();
        if (left <= roundoff * norm)
          return std::abs(remainder.value) <= roundoff * scale;

        orthonormal.push_back(
          {remainder.coefficients / left, remainder.value / left});
        independent.push_back(equation);
        return true;
      }

      const std::vector<SupportEquation> &
      equations() const
      {
        return independent;
      }

      /** The equations solved for one unknown each: its coefficient is 1 and
       * vanishes in the others. @return with the positions of the unknowns. */
      std::vector<std::pair<unsigned int, Equation>>
      solved() const
      {
        std::vector<Equation> rows;
        for (const SupportEquation &equation : independent)
          rows.push_back(for_unknowns(equation));

        std::vector<std::pair<unsigned int, Equation>> result;
        while (!rows.empty())
          {
            // of equal coefficients up to round-off, the last one
            auto         pivot_row = rows.begin();
            unsigned int pivot     = 0;
            double       greatest  = 0;
            for (auto row = rows.begin(); row != rows.end(); ++row)
              for (unsigned int i = n_unknowns; i-- > 0;)
                if (std::abs(row->coefficients[i]) > (1 + roundoff) * greatest)
                  {
                    greatest  = std::abs(row->coefficients[i]);
                    pivot_row = row;
                    pivot     = i;
                  }
            Equation solution = *pivot_row;
            rows.erase(pivot_row);
            const double factor = solution.coefficients[pivot];
            solution.coefficients /= factor;
            solution.value /= factor;

            const auto eliminate = [&](Equation &row) {
              const double part = row.coefficients[pivot];
              row.coefficients -= part * solution.coefficients;
              row.value -= part * solution.value;
              row.coefficients[pivot] = 0;
            };
            for (Equation &row : rows)
              eliminate(row);
            for (auto &other : result)
              eliminate(other.second);
            result.emplace_back(pivot, solution);
          }
        return result;
      }

    private:
      std::vector<SupportEquation> independent;
      /** The same equations, orthonormal. */
      std::vector<Equation> orthonormal;
    };


    SupportEquation
    equation_of(const SupportCondition &condition,
                const SurfacePoint     &point,
                const Tensor<1, 3>     &axis,
                const unsigned int      body)
    {
      const Tensor<1, 3> unit = direction(condition.component, point, axis);
      SupportEquation    equation{{}, condition.value, body};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int face = 0; face < 2; ++face)
          equation.coefficients[2 * i + face] =
            condition.coefficients[face] * unit[i];
      return equation;
    }


    /** Throw InputError if the surface has no such components. */
    void
    check_components(const std::string                   &entry,
                     const std::vector<SupportCondition> &conditions,
                     const ReferenceSurface              &surface)
    {
      for (const SupportCondition &condition : conditions)
        check_component(entry, condition.component, surface);
    }
  } // namespace


  void
  make_constraints(const Supports                      &supports,
                   const ShellMesh                     &mesh,
                   AffineConstraints<double>           &constraints,
                   std::vector<PrescribedDisplacement> &prescribed,
                   SupportedNodes                      &supported)
  {
    const ReferenceSurface                &surface = mesh.get_surface();
    const Tensor<1, 3>                     axis    = surface.axis();
    std::map<unsigned int, NodalEquations> equations;
    bool                                   contradiction = false;
    const auto                             add = [&](const unsigned int                   node,
                         const std::vector<SupportCondition> &conditions) {
      for (const SupportCondition &condition : conditions)
        if (!equations[node].add(equation_of(condition,
                                             mesh.nodes[node].surface,
                                             axis,
                                             supported.bodies.size() - 1)))
          contradiction = true;
    };

    supported = SupportedNodes();
    for (const auto &item : supports.points)
      {
        check_components("Supports/Point supports", item.conditions, surface);
        supported.bodies.push_back("point " + item.point);
        const unsigned int node =
          node_of_point(mesh, "Supports/Point supports", item.point);
        if (node != numbers::invalid_unsigned_int)
          add(node, item.conditions);
      }
    for (unsigned int edge = 0; edge < 4; ++edge)
      if (!supports.edges[edge].empty())
        {
          check_components(
            "Supports/" + edge_names[edge], supports.edges[edge], surface);
          supported.bodies.push_back(edge_names[edge]);
          for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
            if (mesh.grid.on_edge(mesh.nodes[n].grid_index,
                                  static_cast<Edge>(edge)))
              add(n, supports.edges[edge]);
        }
    if (Utilities::MPI::max(static_cast<unsigned int>(contradiction),
                            mesh.communicator) > 0)
      throw InputError("the section 'Supports' prescribes contradictory "
                       "values of a displacement.");

    constraints.reinit(mesh.locally_relevant);
    prescribed.clear();
    for (const auto &item : equations)
      {
        const Node &node = mesh.nodes[item.first];
        supported.items.push_back({item.first, item.second.equations()});
        for (const auto &row : item.second.solved())
          {
            const auto dof = node.dofs[row.first];
            constraints.add_line(dof);
            for (unsigned int i = 0; i < n_unknowns; ++i)
              if (i != row.first &&
                  std::abs(row.second.coefficients[i]) > roundoff)
                constraints.add_entry(
                  dof, node.dofs[i], -row.second.coefficients[i]);
            if (row.second.value != 0)
              prescribed.push_back({dof, row.second.value});
          }
      }
    constraints.close();
  }
} // namespace Biface
