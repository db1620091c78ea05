// SPDX-License-Identifier: LGPL-2.1-or-later

// A force term that is defined in one file and remembers, a bedding of springs
// with dampers in series, relaxes as the implicit Euler method says,
// 1/(1+T/(n tau))^n in n steps of the time T, also from a copy of the state.

#include <biface/laminate/layup.h>
#include <biface/model/forces/force_term.h>
#include <biface/model/forces/nodal_forces.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  class MaxwellBedding : public ForceTerm
  {
  public:
    MaxwellBedding(const ShellMesh &mesh,
                   const double     stiffness,
                   const double     relaxation_time)
      : mesh(mesh), stiffness(stiffness), relaxation_time(relaxation_time)
    {}

    std::string
    name() const override
    {
      return "Maxwell bedding";
    }

    bool
    acts_on(const unsigned int, const State &, const Loads &) const override
    {
      return true;
    }

    void
    add(const CellState &at, CellForces &forces) const override
    {
      const double sign = MixedElement::face_sign[Resultants::inner];
      for (unsigned int v = 0; v < 4; ++v)
        {
          const double area = vertex_area(at.cell, v, Resultants::inner);
          Tensor<1, 3> force;
          Tensor<2, 3> derivative;
          force[2] = -area * stiffness * spring(at.state, at.cell.nodes[v]);
          derivative[2][2] = area * stiffness;
          MixedElement::add_force(force, v, sign, forces.load);
          MixedElement::add_stiffness(
            derivative, v, sign, v, sign, forces.tangent);
        }
    }

    void
    commit_step(const State &,
                const Loads &,
                const TimeInterval &time,
                State              &after) const override
    {
      const double     part = (time.end - time.start) / relaxation_time;
      Table<2, double> now(mesh.nodes.size(), 1);
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        now[n][0] = displacement(after, n) - spring(after, n) / (1 + part);
      after.terms[name()].at_nodes = now;
    }

  private:
    double
    displacement(const State &state, const unsigned int node) const
    {
      return mesh.displacement(
        state.displacement, mesh.nodes[node], Resultants::inner)[2];
    }

    /** The extension of the spring: that of the damper is remembered. */
    double
    spring(const State &state, const unsigned int node) const
    {
      const auto term = state.terms.find(name());
      return displacement(state, node) -
             (term == state.terms.end() ? 0. : term->second.at_nodes[node][0]);
    }

    const ShellMesh &mesh;
    const double     stiffness, relaxation_time;
  };
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  constexpr double       time = 2, relaxation_time = 0.7;
  constexpr unsigned int n_steps = 5;

  const Layup layup(Layup::Parameters(), cord_ply());
  const auto  mesh = coarse_torus(layup);
  ForceTerms  terms;
  terms.push_back(
    std::make_unique<MaxwellBedding>(*mesh, 0.3, relaxation_time));
  const ShellEquations equations(*mesh, std::move(terms));

  const Loads loads;
  State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
  const auto force = [&](const State &of) {
    return equations.nodal_forces(of, loads)[ForceTerm::Source::loads]
      .l2_norm();
  };
  const double at_once = force(state);
  const State  copy    = state;
  const auto   relax   = [&](State &of) {
    for (unsigned int i = 0; i < n_steps; ++i)
      equations.commit_step(
        of, loads, {i * time / n_steps, (i + 1) * time / n_steps}, of);
    return force(of);
  };
  const double relaxed = relax(state);
  State        other   = copy;
  const double of_copy = force(copy), relaxed_copy = relax(other);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return 0;

  const double expected =
    at_once / std::pow(1 + time / (n_steps * relaxation_time), n_steps);
  check_small("relaxed force", relaxed - expected, 1e-12, expected);
  check_small("force in a copy", of_copy - at_once, 1e-14, at_once);
  check_small("relaxed copy", relaxed_copy - expected, 1e-12, expected);
}
