// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <valarray>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/model/mesh/constraints.h>
#include <biface/model/mesh/mesh_nodes.h>
#include <biface/model/mesh/supports.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Relative size of what remains of an equation that follows from others.
     */
    constexpr double roundoff = 1e-10;
    constexpr double epsilon  = std::numeric_limits<double>::epsilon();


    /** A linear equation for the unknowns of a node or a joint. */
    struct Equation
    {
      std::valarray<double> coefficients;
      /** See SupportEquation. */
      std::valarray<double> values;
    };


    double
    product(const std::valarray<double> &a, const std::valarray<double> &b)
    {
      return (a * b).sum();
    }


    /** An equation for the displacements of the faces as one for the unknowns
     * of the nodes, in the order of Node::dofs. */
    Equation
    for_unknowns(const SupportEquation &equation, const unsigned int n_faces)
    {
      const unsigned int n = equation.coefficients.size();
      Equation           result{std::valarray<double>(0., n), equation.values};
      // by node and component
      for (unsigned int begin = 0; begin < n; begin += n_faces)
        for (unsigned int face = 0; face < n_faces; ++face)
          for (unsigned int part = 0; part < n_faces; ++part)
            result.coefficients[begin + part] +=
              Node::sign_of_part(face, part) *
              equation.coefficients[begin + face];
      return result;
    }


    /** The equations of all supports at a node, or at the nodes of a joint. */
    class NodalEquations
    {
    public:
      /** @param n_faces the number of faces of a node. */
      NodalEquations(const unsigned int n_faces) : n_faces(n_faces)
      {}

      /** Add an equation unless it follows from the others. @return whether it
       * is consistent with them. */
      bool
      add(const SupportEquation &equation)
      {
        Equation     remainder = for_unknowns(equation, n_faces);
        const double norm =
          std::sqrt(product(remainder.coefficients, remainder.coefficients));
        // sizes of the values that cancel, and of all prescribed displacements
        const std::size_t     n_values = remainder.values.size();
        std::valarray<double> scale    = std::abs(remainder.values);
        std::valarray<double> size(0., n_values);
        // twice, since the first pass leaves round-off of what it removes
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (const Equation &other : orthonormal)
            {
              const double part =
                product(remainder.coefficients, other.coefficients);
              remainder.coefficients -= part * other.coefficients;
              remainder.values -= part * other.values;
              for (std::size_t i = 0; i < n_values; ++i)
                {
                  scale[i] =
                    std::max(scale[i], std::abs(part * other.values[i]));
                  size[i] = std::max(size[i], std::abs(other.values[i]));
                }
            }
        const double left =
          std::sqrt(product(remainder.coefficients, remainder.coefficients));
        if (left <= roundoff * norm)
          {
            // what the coefficients that are left, of round-off, contribute
            for (std::size_t i = 0; i < n_values; ++i)
              if (!(std::abs(remainder.values[i]) <=
                    roundoff * scale[i] +
                      (left + 100 * epsilon * norm) * size[i]))
                return false;
            return true;
          }

        orthonormal.push_back(
          {remainder.coefficients / left, remainder.values / left});
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
          rows.push_back(for_unknowns(equation, n_faces));

        std::vector<std::pair<unsigned int, Equation>> result;
        while (!rows.empty())
          {
            // if coefficients are equal up to round-off, the last one is taken
            auto         pivot_row = rows.begin();
            unsigned int pivot     = 0;
            double       maximum   = 0;
            for (auto row = rows.begin(); row != rows.end(); ++row)
              for (unsigned int i = row->coefficients.size(); i-- > 0;)
                if (std::abs(row->coefficients[i]) > (1 + roundoff) * maximum)
                  {
                    maximum   = std::abs(row->coefficients[i]);
                    pivot_row = row;
                    pivot     = i;
                  }
            Equation solution = *pivot_row;
            rows.erase(pivot_row);
            const double factor = solution.coefficients[pivot];
            solution.coefficients /= factor;
            solution.values /= factor;

            const auto eliminate = [&](Equation &row) {
              const double part = row.coefficients[pivot];
              row.coefficients -= part * solution.coefficients;
              row.values -= part * solution.values;
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
      const unsigned int           n_faces;
      std::vector<SupportEquation> independent;
      /** The same equations, orthonormal. */
      std::vector<Equation> orthonormal;
    };


    /** The equations of a condition at a node: one, or one for each face that
     * it holds beside the inner one.
     * @param n_factors the number of factors of values. */
    std::vector<SupportEquation>
    equations_of(const SupportCondition &condition,
                 const Node             &node,
                 const ReferenceSurface &surface,
                 const unsigned int      body,
                 const double            share,
                 const unsigned int      n_factors)
    {
      const Tensor<1, 3> unit =
        direction(condition.component, node.surface, surface.axis());
      const auto value_at = [&](const double height) {
        if (!condition.formula)
          return condition.value;
        return (*condition.formula)(surface.formula_variables(
          node.surface.position + height * node.surface.frame[2], node.alpha));
      };
      const unsigned int n_faces = node.n_parts();
      SupportEquation    equation{std::valarray<double>(0., 3 * n_faces),
                               std::valarray<double>(0., n_factors),
                               body,
                               share};
      // a formula is evaluated where the condition holds the wall: at a face or
      // in the middle
      const double inner = node.height(0), outer = node.height(n_faces - 1);
      equation.values[condition.factor] =
        value_at(condition.coefficients[0] == 0   ? outer
                 : condition.coefficients[1] == 0 ? inner
                                                  : (inner + outer) / 2);
      const auto set = [&](const unsigned int face, const double value) {
        for (unsigned int i = 0; i < 3; ++i)
          equation.coefficients[n_faces * i + face] = value * unit[i];
      };
      for (unsigned int face = 0; face < 2; ++face)
        set(face * (n_faces - 1), condition.coefficients[face]);
      if (condition.value != 0 || condition.formula)
        equation.factor = condition.factor;
      std::vector<SupportEquation> equations{equation};

      const bool of_outer = condition.coefficients[1] != 0;
      if (condition.holds_all_faces && of_outer)
        for (unsigned int face = 1; face + 1 < n_faces; ++face)
          {
            equation.coefficients = 0;
            set(face, condition.coefficients[1]);
            equation.values[condition.factor] = value_at(node.height(face));
            equations.push_back(equation);
          }
      return equations;
    }


    /** The equations by which the faces of layers that do not exist at a node
     * stay together. */
    std::vector<SupportEquation>
    equations_of_absent_layers(const Node &node, const unsigned int n_factors)
    {
      const unsigned int           n_faces = node.n_parts();
      std::vector<SupportEquation> equations;
      for (unsigned int k = 0; k < node.n_layers(); ++k)
        if (node.half_thickness[k] == 0)
          for (unsigned int i = 0; i < 3; ++i)
            {
              SupportEquation equation{std::valarray<double>(0., 3 * n_faces),
                                       std::valarray<double>(0., n_factors),
                                       numbers::invalid_unsigned_int,
                                       1};
              equation.coefficients[n_faces * i + k]     = -0.5;
              equation.coefficients[n_faces * i + k + 1] = 0.5;
              equations.push_back(equation);
            }
      return equations;
    }


    /** Put an equation for one node among those for the nodes of a joint.
     * @param position that of the node in the joint. */
    SupportEquation
    in_joint(const SupportEquation &equation,
             const unsigned int     position,
             const unsigned int     n_nodes)
    {
      const unsigned int n      = equation.coefficients.size();
      SupportEquation    result = equation;
      result.coefficients       = std::valarray<double>(0., n * n_nodes);
      result.coefficients[std::slice(n * position, n, 1)] =
        equation.coefficients;
      return result;
    }


    /** The equations of the nodes of a joint: their points on the reference
     * surface have the same displacement, and faces of layers lie on the
     * straight lines between the inner and the outer face. */
    std::vector<SupportEquation>
    equations_of_joint(const std::vector<unsigned int> &joint,
                       const MeshNodes                 &mesh,
                       const unsigned int               n_factors)
    {
      std::vector<SupportEquation> equations;
      const unsigned int           n_faces = mesh.nodes[joint[0]].n_parts();
      const unsigned int           last    = n_faces - 1;
      // the parts of the inner and the outer face in the displacement at a
      // height
      const auto parts = [last](const Node &node, const double height) {
        const double inner = node.height(0), outer = node.height(last);
        return std::array<double, 2>{{(outer - height) / (outer - inner),
                                      (height - inner) / (outer - inner)}};
      };
      const SupportEquation empty{
        std::valarray<double>(0., 3 * n_faces * joint.size()),
        std::valarray<double>(0., n_factors),
        numbers::invalid_unsigned_int,
        1};
      const auto add_point = [&](SupportEquation   &equation,
                                 const unsigned int k,
                                 const unsigned int d,
                                 const double       sign) {
        const Node &node = mesh.nodes[joint[k]];
        const auto  part = parts(node, 0);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int face = 0; face < 2; ++face)
            equation.coefficients[n_faces * (3 * k + i) + face * last] +=
              sign * part[face] * node.surface.frame[i][d];
      };
      for (unsigned int k = 1; k < joint.size(); ++k)
        for (unsigned int d = 0; d < 3; ++d)
          {
            SupportEquation equation = empty;
            add_point(equation, 0, d, -1);
            add_point(equation, k, d, 1);
            equations.push_back(equation);
          }
      for (unsigned int k = 0; k < joint.size(); ++k)
        for (unsigned int face = 1; face < last; ++face)
          {
            const Node &node = mesh.nodes[joint[k]];
            const auto  part = parts(node, node.height(face));
            for (unsigned int i = 0; i < 3; ++i)
              {
                SupportEquation    equation         = empty;
                const unsigned int begin            = n_faces * (3 * k + i);
                equation.coefficients[begin + face] = 1;
                equation.coefficients[begin] -= part[0];
                equation.coefficients[begin + last] -= part[1];
                equations.push_back(equation);
              }
          }
      return equations;
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


    /** The number of factors of prescribed displacements. */
    unsigned int
    number_of_factors(const Supports &supports)
    {
      unsigned int last = 0;
      const auto   see = [&last](const std::vector<SupportCondition> &support) {
        for (const SupportCondition &condition : support)
          last = std::max(last, condition.factor);
      };
      for (const auto &edge : supports.edges)
        see(edge);
      for (const PointSupport &point : supports.points)
        see(point.conditions);
      for (const EdgeSupport &edge : supports.named_edges)
        see(edge.conditions);
      return last + 1;
    }


    bool
    is_zero(const std::valarray<double> &values)
    {
      return std::all_of(std::begin(values),
                         std::end(values),
                         [](const double value) { return value == 0; });
    }


    /** The nodes of cyclic edges: those on the edge alpha_2 min by those on
     * alpha_2 max with the same displacements. */
    std::map<unsigned int, unsigned int>
    cyclic_pairs(const MeshNodes &mesh)
    {
      std::map<unsigned int, unsigned int> by_line, pairs;
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.grid.on_edge(mesh.nodes[n].grid_index, Edge::alpha_2_min))
          by_line[mesh.nodes[n].grid_index[0]] = n;
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.grid.on_edge(mesh.nodes[n].grid_index, Edge::alpha_2_max))
          {
            const auto first = by_line.find(mesh.nodes[n].grid_index[0]);
            if (first != by_line.end())
              pairs[n] = first->second;
          }
      return pairs;
    }
  } // namespace


  void
  make_constraints(const Supports                      &supports,
                   const MeshNodes                     &mesh,
                   AffineConstraints<double>           &constraints,
                   std::vector<PrescribedDisplacement> &prescribed,
                   SupportedNodes                      &supported)
  {
    const ReferenceSurface                &surface = mesh.get_surface();
    std::map<unsigned int, NodalEquations> equations;
    bool                                   contradiction = false;
    std::map<unsigned int, unsigned int>   first_of;
    std::set<unsigned int>                 is_first;
    if (supports.is_cyclic())
      first_of = cyclic_pairs(mesh);
    for (const auto &pair : first_of)
      is_first.insert(pair.second);
    // the nodes of a joint, and the position of a node in its joint
    std::map<unsigned int,
             std::pair<const std::vector<unsigned int> *, unsigned>>
      joint_of;
    for (const auto &joint : mesh.joints)
      for (unsigned int k = 0; k < joint.size(); ++k)
        joint_of[joint[k]] = {&joint, k};
    // by the first node of a joint
    const auto equations_at = [&](const unsigned int node) -> NodalEquations & {
      return equations.try_emplace(node, mesh.nodes[node].n_parts())
        .first->second;
    };
    const auto add_equation = [&](const unsigned int     node,
                                  const SupportEquation &equation) {
      const auto joint = joint_of.find(node);
      if (joint == joint_of.end())
        return equations_at(node).add(equation);
      const auto &[nodes, position] = joint->second;
      return equations_at((*nodes)[0])
        .add(in_joint(equation, position, nodes->size()));
    };
    // the second node of a cyclic pair has the displacements of the first,
    // which therefore obeys the supports of both
    const unsigned int n_factors = number_of_factors(supports);
    const auto         add = [&](const unsigned int                   node,
                         const std::vector<SupportCondition> &conditions,
                         const bool                           both_sides) {
      const auto   pair   = first_of.find(node);
      const bool   paired = pair != first_of.end();
      const double share  = (!both_sides ? (paired ? 0. : 1.) : 0.5);
      for (const SupportCondition &condition : conditions)
        for (const SupportEquation &equation :
             equations_of(condition,
                          mesh.nodes[node],
                          surface,
                          supported.bodies.size() - 1,
                          share,
                          n_factors))
          if (!add_equation(paired ? pair->second : node, equation))
            contradiction = true;
    };

    supported = SupportedNodes();
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      if (first_of.count(n) == 0)
        for (const SupportEquation &equation :
             equations_of_absent_layers(mesh.nodes[n], n_factors))
          add_equation(n, equation);
    for (const auto &joint : mesh.joints)
      for (const SupportEquation &equation :
           equations_of_joint(joint, mesh, n_factors))
        equations_at(joint[0]).add(equation);
    for (const auto &item : supports.points)
      {
        check_components("Supports/Point supports", item.conditions, surface);
        supported.bodies.push_back("point " + item.point);
        const unsigned int node =
          mesh.node_of_point("Supports/Point supports", item.point);
        // formulas are evaluated where the nodes are, and may fail on some
        // ranks only
        agree_on_errors(mesh.communicator, [&]() {
          if (node != numbers::invalid_unsigned_int)
            add(node, item.conditions, false);
        });
      }
    const auto add_edge = [&](const std::string                   &entry,
                              const unsigned int                   edge,
                              const std::vector<SupportCondition> &conditions) {
      check_components(entry, conditions, surface);
      supported.bodies.push_back(mesh.edges[edge].name);
      agree_on_errors(mesh.communicator, [&]() {
        for (const unsigned int n : mesh.edges[edge].nodes)
          add(n, conditions, first_of.count(n) > 0 || is_first.count(n) > 0);
      });
    };
    for (unsigned int edge = 0; edge < 4; ++edge)
      if (!supports.edges[edge].empty())
        add_edge("Supports/" + edge_names[edge], edge, supports.edges[edge]);
    const std::string entry = "Supports/Edge supports";
    for (const EdgeSupport &support : supports.named_edges)
      add_edge(entry,
               mesh.find_edge(entry, support.text, support.edge),
               support.conditions);
    if (supports.is_cyclic())
      for (unsigned int i = 0; i < 2; ++i)
        {
          supported.cyclic_bodies[i] = supported.bodies.size();
          supported.bodies.push_back(edge_names[2 + i]);
        }
    // an item also for pairs that no support holds
    std::map<unsigned int, unsigned int> second_of;
    for (const auto &pair : first_of)
      {
        second_of[pair.second] = pair.first;
        equations_at(pair.second);
      }
    if (Utilities::MPI::logical_or(contradiction, mesh.communicator))
      throw InputError("the section 'Supports' prescribes contradictory "
                       "values of a displacement.");

    constraints.reinit(mesh.locally_relevant);
    prescribed.clear();
    for (const auto &item : equations)
      {
        const auto                      joint = joint_of.find(item.first);
        const std::vector<unsigned int> nodes =
          (joint == joint_of.end() ? std::vector<unsigned int>{item.first}
                                   : *joint->second.first);
        std::vector<types::global_dof_index> dofs;
        for (const unsigned int n : nodes)
          dofs.insert(
            dofs.end(), mesh.nodes[n].dofs.begin(), mesh.nodes[n].dofs.end());
        const auto         second = second_of.find(item.first);
        const unsigned int partner =
          (second != second_of.end() ? second->second
                                     : numbers::invalid_unsigned_int);
        supported.items.push_back({nodes, partner, item.second.equations()});

        const unsigned int                 n_unknowns = dofs.size();
        std::vector<std::valarray<double>> values(n_unknowns);
        for (const auto &row : item.second.solved())
          {
            values[row.first] = row.second.values;
            const auto dof    = dofs[row.first];
            constraints.add_line(dof);
            for (unsigned int i = 0; i < n_unknowns; ++i)
              if (i != row.first &&
                  std::abs(row.second.coefficients[i]) > roundoff)
                constraints.add_entry(
                  dof, dofs[i], -row.second.coefficients[i]);
            if (!is_zero(row.second.values))
              prescribed.push_back({dof, row.second.values});
          }
        if (partner != numbers::invalid_unsigned_int)
          for (unsigned int i = 0; i < n_unknowns; ++i)
            {
              const auto dof = mesh.nodes[partner].dofs[i];
              constraints.add_line(dof);
              constraints.add_entry(dof, dofs[i], 1);
              if (!is_zero(values[i]))
                prescribed.push_back({dof, values[i]});
            }
      }
    constraints.close();
  }
} // namespace Biface
