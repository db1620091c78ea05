// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <limits>

#include <biface/input/parameter_tools.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/quantities/forces_on_shell.h>
#include <biface/model/quantities/point_displacement.h>
#include <biface/model/state/loads.h>
#include <biface/solver/fixed_contact_tangent.h>
#include <biface/solver/harmonic_response.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** An excitation at a frequency. */
    struct Excited
    {
      /** The forces, regardless of supports. */
      Amplitudes forces;
      /** What supports prescribe, in the unknowns that they hold. */
      LA::Vector prescribed;
    };


    /** @param loads the forces of Excitation::loads. */
    Excited
    excite(const HarmonicSystem &system,
           const ShellMesh      &mesh,
           const Excitation     &excitation,
           const LA::Vector     &loads)
    {
      Excited result{system.zero(), mesh.owned_vector()};
      if (excitation.loads)
        {
          result.forces.add(1, loads);
          for (const PrescribedDisplacement &p : mesh.prescribed)
            if (mesh.locally_owned.is_element(p.dof))
              for (unsigned int i = 0; i < p.values.size(); ++i)
                result.prescribed(p.dof) +=
                  factor_at(excitation.loads->factors, i) * p.values[i];
          result.prescribed.compress(VectorOperation::add);
          return result;
        }
      const LA::Vector &moves = system.get_translations()[excitation.direction];
      Amplitudes        relative = system.zero();
      relative.add(1, moves);
      // relative to a body that moves, the shell goes the other way
      const double sign = (excitation.moves_supports() ? 1 : -1);
      for (unsigned int b = 0; b < system.n_bodies(); ++b)
        if (excitation.moves_supports() ||
            excitation.bodies.count(system.number_of_body(b)) > 0)
          system.add_contact(b, relative, sign, result.forces);
      if (excitation.moves_supports())
        {
          system.add_inertia(moves, result.forces);
          system.add_inertia_of_air(excitation.direction, result.forces);
        }
      return result;
    }


    /** The names of FrequencyResponse::outputs in the order of outputs_at(). */
    std::vector<FrequencyResponse::Output>
    outputs_of(const HarmonicSystem &system, const ShellMesh &mesh)
    {
      std::vector<FrequencyResponse::Output> result;
      for (const NamedPoint &point : mesh.points)
        for (const char *face : {"inner", "outer"})
          result.push_back({point.name, face});
      for (const std::string &support : mesh.supported.bodies)
        result.push_back({support, "force"});
      for (unsigned int b = 0; b < system.n_bodies(); ++b)
        result.push_back({system.name_of_body(b), "force"});
      if (system.has_air())
        result.push_back({"rim on air", "force"});
      return result;
    }


    FrequencyResponse::Value
    value(const Tensor<1, 3> &real, const Tensor<1, 3> &imaginary)
    {
      FrequencyResponse::Value result;
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = {real[d], imaginary[d]};
      return result;
    }


    /** The outputs of a solution. */
    std::vector<FrequencyResponse::Value>
    outputs_at(const HarmonicSystem &system,
               const ShellMesh      &mesh,
               const Excitation     &excitation,
               const Excited        &excited,
               const Amplitudes     &solution)
    {
      Amplitudes u = solution;
      u.real += excited.prescribed;
      // what is missing on all unknowns: forces of supports
      Amplitudes missing = system.product(u);
      missing.add(-1, excited.forces);
      Amplitudes moved = u;
      if (excitation.moves_supports())
        moved.add(1, system.get_translations()[excitation.direction]);

      std::vector<FrequencyResponse::Value> values;
      LA::Vector real = mesh.ghosted_vector(), imaginary(real);
      real            = moved.real;
      imaginary       = moved.imaginary;
      for (const NamedPoint &point : mesh.points)
        {
          const auto of_real      = displacement_at(point, real, mesh),
                     of_imaginary = displacement_at(point, imaginary, mesh);
          for (unsigned int face = 0; face < 2; ++face)
            values.push_back(
              value(of_real.global[face], of_imaginary.global[face]));
        }

      const LA::Vector &shape   = system.shape().displacement;
      const auto        of_real = forces_of_supports(mesh, shape, missing.real),
                 of_imaginary =
                   forces_of_supports(mesh, shape, missing.imaginary);
      for (unsigned int k = 0; k < of_real.size(); ++k)
        values.push_back(value(of_real[k].force, of_imaginary[k].force));

      for (unsigned int b = 0; b < system.n_bodies(); ++b)
        {
          Amplitudes relative = moved;
          if (excitation.bodies.count(system.number_of_body(b)) > 0)
            relative.add(-1, system.get_translations()[excitation.direction]);
          Amplitudes force = system.zero();
          system.add_contact(b, relative, 1, force);
          FrequencyResponse::Value sum;
          for (unsigned int d = 0; d < 3; ++d)
            sum[d] = force * system.get_translations()[d];
          values.push_back(sum);
        }
      if (system.has_air())
        values.push_back(system.force_of_rim(
          u,
          excitation.moves_supports()
            ? std::optional<unsigned int>(excitation.direction)
            : std::nullopt));
      return values;
    }
  } // namespace


  FrequencyResponse
  HarmonicResponse::compute(const State   &state,
                            const Loads   &loads,
                            const Request &request)
  {
    TimerOutput::Scope scope(timer, "Response");
    const ShellMesh   &mesh = equations.mesh;
    HarmonicSystem     system(
      equations, contact, air, state, loads, request.losses, timer);

    const Loads             alone = FixedContactTangent::without_bodies(loads);
    std::vector<LA::Vector> forces;
    for (const Excitation &excitation : request.excitations)
      forces.push_back(
        excitation.loads
          ? equations.nodal_load_rates(system.shape(), alone, *excitation.loads)
          : mesh.owned_vector());

    FrequencyResponse result;
    result.frequencies = request.frequencies;
    result.outputs     = outputs_of(system, mesh);
    for (const Excitation &excitation : request.excitations)
      result.excitations.push_back(excitation.name);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const FrequencyResponse::Value unknown{
      {{nan, nan}, {nan, nan}, {nan, nan}}};
    for (const double frequency : request.frequencies)
      {
        std::vector<std::vector<FrequencyResponse::Value>> &values =
          result.values.emplace_back(request.excitations.size());
        std::string             why = system.set_frequency(frequency);
        std::vector<Excited>    excited;
        std::vector<Amplitudes> x;
        if (why.empty())
          {
            for (unsigned int i = 0; i < request.excitations.size(); ++i)
              {
                excited.push_back(
                  excite(system, mesh, request.excitations[i], forces[i]));
                x.push_back(excited[i].forces);
                if (excited[i].prescribed.linfty_norm() == 0)
                  continue;
                Amplitudes prescribed = system.zero();
                prescribed.add(1, excited[i].prescribed);
                x[i].add(-1, system.product(prescribed));
              }
            why = system.solve(x);
          }
        // a frequency at which the system is singular leaves the others as they
        // are
        for (unsigned int i = 0; i < request.excitations.size(); ++i)
          if (why.empty())
            values[i] = outputs_at(
              system, mesh, request.excitations[i], excited[i], x[i]);
          else
            values[i].assign(result.outputs.size(), unknown);
        if (!why.empty())
          {
            result.message = why + " (" + number_to_string(frequency) + ")";
            ++result.n_failed;
          }
      }
    return result;
  }
} // namespace Biface
