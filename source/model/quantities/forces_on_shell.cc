// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>

#include <biface/model/equations/shell_equations.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/state/load_rates.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** What follows the supports in bodies_on_shell(). */
    enum Other
    {
      ground,
      loads_of_shell,
      prestress,
      interpolation,
      n_others
    };

    constexpr const char *ground_name = "foundation";

    /** By the face, from the inner to the outer one, in the frame of a node;
     * those of several nodes one after the other. */
    using FaceForces = std::vector<Tensor<1, 3>>;


    FaceForces
    face_forces(const ShellMesh  &mesh,
                const LA::Vector &nodal_forces,
                const Node       &node)
    {
      FaceForces forces;
      for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
        forces.push_back(mesh.force_on_any_face(nodal_forces, node, face));
      return forces;
    }


    /** The force of an equation of a support on a node: a multiple of its
     * coefficients. */
    struct ForceOfEquation
    {
      double     multiplier;
      FaceForces forces;
    };


    /** The forces of single equations of supports on a node. */
    std::vector<ForceOfEquation>
    support_forces(const std::vector<SupportEquation> &equations,
                   const FaceForces                   &total,
                   const unsigned int                  n_faces)
    {
      const unsigned int n           = equations.size();
      const auto         coefficient = [&](const unsigned int k,
                                   const unsigned int i,
                                   const unsigned int face) {
        const unsigned int node = face / n_faces;
        return equations[k]
          .coefficients[n_faces * (3 * node + i) + face % n_faces];
      };

      // a pair of nodes on cyclic edges without another support
      if (n == 0)
        return {};
      // equations at a node need not be orthogonal: their multipliers follow
      // from the work of the missing forces on all of them
      FullMatrix<double> products(n, n);
      Vector<double>     work(n), multipliers(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          for (unsigned int l = 0; l < n; ++l)
            products(k, l) =
              (equations[k].coefficients * equations[l].coefficients).sum();
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int face = 0; face < total.size(); ++face)
              work(k) += coefficient(k, i, face) * total[face][i];
        }
      products.gauss_jordan();
      products.vmult(multipliers, work);

      std::vector<ForceOfEquation> result;
      for (unsigned int k = 0; k < n; ++k)
        {
          FaceForces forces(total.size());
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int face = 0; face < total.size(); ++face)
              forces[face][i] = multipliers(k) * coefficient(k, i, face);
          result.push_back({multipliers(k), forces});
        }
      return result;
    }


    struct SupportForce
    {
      unsigned int body;
      unsigned int node;
      FaceForces   forces;
      /** The load factor of the displacement that is prescribed, if any, and
       * the work on it at the factor 1, in one of the parts of an equation. */
      unsigned int factor = numbers::invalid_unsigned_int;
      double       work   = 0;
    };

    FaceForces
    scaled(const double factor, const FaceForces &forces)
    {
      FaceForces result(forces);
      for (Tensor<1, 3> &force : result)
        force *= factor;
      return result;
    }


    FaceForces
    sum(const FaceForces &a, const FaceForces &b)
    {
      FaceForces result(a);
      for (unsigned int face = 0; face < a.size(); ++face)
        result[face] += b[face];
      return result;
    }


    /** The forces of the supports at a node, and at its partner, if the edges
     * are cyclic: there, the forces of both in their frames are those of the
     * supports, and what is opposite at the two is passed on to the next
     * sector. */
    std::vector<SupportForce>
    support_forces(const ShellMesh            &mesh,
                   const SupportedNodes::Item &item,
                   const LA::Vector           &nodal_forces)
    {
      const bool paired = item.partner != numbers::invalid_unsigned_int;
      FaceForces here;
      for (const unsigned int node : item.nodes)
        {
          const FaceForces own =
            face_forces(mesh, nodal_forces, mesh.nodes[node]);
          here.insert(here.end(), own.begin(), own.end());
        }
      FaceForces there(here.size());
      if (paired)
        there = face_forces(mesh, nodal_forces, mesh.nodes[item.partner]);

      std::vector<SupportForce> result;
      FaceForces                rest = here, rest_there = there;
      const unsigned int        n_faces = mesh.n_layers() + 1;
      const auto                held =
        support_forces(item.equations, sum(here, there), n_faces);
      for (unsigned int k = 0; k < held.size(); ++k)
        {
          // a support of one edge holds both nodes of a cyclic pair, each with
          // its share
          const SupportEquation &equation = item.equations[k];
          const double           share    = paired ? equation.share : 1.;
          // faces that stay together exchange forces
          if (equation.body == numbers::invalid_unsigned_int)
            {
              rest = sum(rest, scaled(-1, held[k].forces));
              continue;
            }
          const unsigned int first = result.size();
          for (unsigned int i = 0; i < item.nodes.size(); ++i)
            {
              const auto begin = held[k].forces.begin() + n_faces * i;
              result.push_back(
                {equation.body,
                 item.nodes[i],
                 scaled(share, FaceForces(begin, begin + n_faces))});
            }
          rest = sum(rest, scaled(-share, held[k].forces));
          if (paired)
            {
              result.push_back({equation.body,
                                item.partner,
                                scaled(1 - share, held[k].forces)});
              rest_there = sum(rest_there, scaled(share - 1, held[k].forces));
            }
          if (equation.factor != numbers::invalid_unsigned_int)
            {
              result[first].factor = equation.factor;
              result[first].work =
                held[k].multiplier * equation.values[equation.factor];
            }
        }
      if (paired)
        {
          const FaceForces passed_on =
            sum(scaled(0.5, rest), scaled(-0.5, rest_there));
          result.push_back(
            {mesh.supported.cyclic_bodies[0], item.nodes[0], passed_on});
          result.push_back({mesh.supported.cyclic_bodies[1],
                            item.partner,
                            scaled(-1, passed_on)});
        }
      return result;
    }


    /** Adds nodal forces to the resultants of bodies. */
    class Resultant
    {
    public:
      /** @param displacement gives the positions of the faces. */
      Resultant(const ShellMesh   &mesh,
                const LA::Vector  &displacement,
                const unsigned int n_bodies)
        : mesh(mesh)
        , displacement(displacement)
        , sums(6 * n_bodies)
        , works(mesh.supported.motions.size())
      {}

      void
      add(const SupportForce &part)
      {
        add(part.body, mesh.nodes[part.node], part.forces);
        const std::vector<SupportMotion> &motions = mesh.supported.motions;
        for (unsigned int m = 0; m < motions.size(); ++m)
          if (motions[m].body == part.body && motions[m].factor == part.factor)
            works[m] += part.work;
      }

      void
      add(const unsigned int body,
          const Node        &node,
          const FaceForces  &forces,
          const double       factor = 1)
      {
        for (unsigned int face = 0; face < forces.size(); ++face)
          {
            const Tensor<1, 3> force =
              factor * node.surface.from_frame(forces[face]);
            const Tensor<1, 3> moment = cross_product_3d(
              mesh.position_of_any_face(displacement, node, face), force);
            for (unsigned int i = 0; i < 3; ++i)
              {
                sums[6 * body + i] += force[i];
                sums[6 * body + 3 + i] += moment[i];
              }
          }
      }

      /** The sums on all ranks. */
      std::vector<ForceOnShell>
      on_all_ranks(const std::vector<std::string> &bodies)
      {
        Utilities::MPI::sum(sums, mesh.communicator, sums);
        if (!works.empty())
          Utilities::MPI::sum(works, mesh.communicator, works);
        std::vector<ForceOnShell> result;
        for (unsigned int b = 0; b < bodies.size(); ++b)
          {
            result.push_back({bodies[b], {}, {}, {}});
            for (unsigned int i = 0; i < 3; ++i)
              {
                result[b].force[i]  = sums[6 * b + i];
                result[b].moment[i] = sums[6 * b + 3 + i];
              }
          }
        for (unsigned int m = 0; m < works.size(); ++m)
          {
            const SupportMotion &motion = mesh.supported.motions[m];
            result[motion.body].along_motions.push_back(
              motion.multiple * works[m] / motion.amount);
          }
        return result;
      }

    private:
      const ShellMesh    &mesh;
      const LA::Vector   &displacement;
      std::vector<double> sums;
      /** The works of the supports on their motions at the load factor 1. */
      std::vector<double> works;
    };
  } // namespace


  namespace
  {
    /** The displacements of the shape in which the forces act. */
    const LA::Vector &
    shape_of_forces(const State &state)
    {
      const auto &base = state.linearization_point;
      return base ? base->displacement : state.displacement;
    }
  } // namespace


  std::vector<std::string>
  bodies_on_shell(const ShellEquations &equations)
  {
    std::vector<std::string> bodies = equations.mesh.supported.bodies;
    for (const char *name :
         {ground_name, "loads", "prestress", "interpolation"})
      bodies.emplace_back(name);
    for (const ForceTerm *term : equations.get_terms())
      if (!term->other_body().empty())
        bodies.push_back(term->other_body());
    return bodies;
  }


  std::vector<ForceOnShell>
  forces_on_shell(const ShellEquations &equations,
                  const State          &state,
                  const NodalForces    &forces)
  {
    const ShellMesh               &mesh     = equations.mesh;
    const InternalForces          &internal = equations.internal_forces();
    const std::vector<std::string> bodies   = bodies_on_shell(equations);
    const unsigned int             n        = mesh.supported.bodies.size();

    // by the body
    std::array<LA::Vector, n_others> others;
    others[ground]         = forces[ForceTerm::Source::ground];
    others[loads_of_shell] = forces[ForceTerm::Source::loads];
    others[loads_of_shell] += forces[ForceTerm::Source::damping];
    others[interpolation] = forces[ForceTerm::Source::shell];
    others[prestress]     = internal.unlisted_forces(state);
    // constant forces of the prestress are among those of the shell, but are no
    // error of the interpolation
    others[interpolation] -= others[prestress];

    Resultant resultant(mesh, shape_of_forces(state), bodies.size());
    for (const Node &node : mesh.nodes)
      if (node.locally_owned)
        for (unsigned int b = 0; b < n_others; ++b)
          resultant.add(n + b, node, face_forces(mesh, others[b], node));

    unsigned int position = n + n_others;
    for (const ForceTerm *term : equations.get_terms())
      if (!term->other_body().empty())
        {
          const LA::Vector &of_body = forces.of_bodies.at(term->other_body());
          for (const Node &node : mesh.nodes)
            if (node.locally_owned)
              resultant.add(position, node, face_forces(mesh, of_body, node));
          others[ground] += of_body;
          ++position;
        }

    // what is missing at the supports, which take up the prestress there
    LA::Vector missing_here = mesh.owned_vector();
    for (const Other b : {ground, loads_of_shell, interpolation})
      missing_here -= others[b];
    LA::Vector missing = mesh.ghosted_vector(), initial = missing;
    missing = missing_here;
    initial = others[prestress];
    for (const SupportedNodes::Item &item : mesh.supported.items)
      if (mesh.nodes[item.nodes[0]].locally_owned)
        for (const auto &part : support_forces(mesh, item, missing))
          resultant.add(part);
    for (const SupportedNodes::Item &item : mesh.supported.items)
      if (mesh.nodes[item.nodes[0]].locally_owned)
        for (const auto &part : support_forces(mesh, item, initial))
          resultant.add(n + prestress, mesh.nodes[part.node], part.forces, -1);
    return resultant.on_all_ranks(bodies);
  }


  std::vector<ForceOnShell>
  forces_of_supports(const ShellMesh  &mesh,
                     const LA::Vector &displacement,
                     const LA::Vector &missing)
  {
    const std::vector<std::string> &bodies = mesh.supported.bodies;
    Resultant  resultant(mesh, displacement, bodies.size());
    LA::Vector readable = mesh.ghosted_vector();
    readable            = missing;
    for (const SupportedNodes::Item &item : mesh.supported.items)
      if (mesh.nodes[item.nodes[0]].locally_owned)
        for (const auto &part : support_forces(mesh, item, readable))
          resultant.add(part);
    return resultant.on_all_ranks(bodies);
  }


  std::vector<SupportReaction>
  support_reactions(const ShellMesh                 &mesh,
                    const Loads                     &loads,
                    const std::vector<ForceOnShell> &forces)
  {
    const std::vector<SupportMotion> &motions = mesh.supported.motions;
    std::vector<SupportReaction>      result;
    for (unsigned int m = 0; m < motions.size(); ++m)
      {
        const SupportMotion &motion = motions[m];
        // those of a body follow each other
        unsigned int position = 0;
        for (unsigned int k = 0; k < m; ++k)
          position += (motions[k].body == motion.body);
        result.push_back({motion.displacement_at(
                            factor_at(loads.factors, motion.factor) -
                            factor_at(loads.factors_of_shape, motion.factor)),
                          forces[motion.body].along_motions[position]});
      }
    return result;
  }


  std::vector<ForceOnShell>
  interpolated_forces(const std::vector<ForceOnShell> &first,
                      const std::vector<ForceOnShell> &second,
                      const double                     position)
  {
    std::vector<ForceOnShell> result = second;
    for (unsigned int b = 0; b < result.size(); ++b)
      {
        result[b].force += (position - 1) * (second[b].force - first[b].force);
        result[b].moment +=
          (position - 1) * (second[b].moment - first[b].moment);
        for (unsigned int m = 0; m < result[b].along_motions.size(); ++m)
          result[b].along_motions[m] +=
            (position - 1) *
            (second[b].along_motions[m] - first[b].along_motions[m]);
      }
    return result;
  }


  const ForceOnShell &
  force_of_ground(const std::vector<ForceOnShell> &forces)
  {
    return *std::find_if(
      forces.begin(), forces.end(), [](const ForceOnShell &item) {
        return item.body == ground_name;
      });
  }
} // namespace Biface
