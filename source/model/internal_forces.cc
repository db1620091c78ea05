// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/internal_forces.h>

namespace Biface
{
  using namespace dealii;

  InternalForces::InternalForces(const ShellMesh &mesh)
    : mesh(mesh), symmetric_stiffness(mesh.strips[0].laminate.is_symmetric())
  {
    for (const Strip &strip : mesh.strips)
      stiffness.emplace_back(strip.laminate.stiffness(), mesh.sampling);
    history.initial_strains.resize(mesh.cells.size());
    history.initial_resultants = resultants_of_laminate();
  }


  std::vector<Modes::Vector>
  InternalForces::resultants_of_laminate() const
  {
    std::vector<Modes::Vector> resultants;
    for (const Cell &cell : mesh.cells)
      resultants.push_back(
        Modes::constant(mesh.strips[cell.strip].laminate.initial_resultants()));

    const auto          &given = mesh.layup.get_initial_resultants();
    std::vector<Formula> formulas;
    for (const InitialResultant &resultant : given)
      formulas.push_back(resultant.value);
    const auto values = evaluate_at_nodes(formulas, mesh);
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        std::array<Resultants::Vector, 4> at_vertices;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int r = 0; r < given.size(); ++r)
            at_vertices[v][given[r].index] += values[mesh.cells[c].nodes[v]][r];
        resultants[c] += Modes::from_vertices(at_vertices);
      }
    return resultants;
  }


  void
  InternalForces::add(const CellState &at, CellForces &forces) const
  {
    const MixedElement  element(at.cell.geometry, at.V);
    const Modes::Vector H = stiffness_of(at.cell).resultants(element.strain());
    if (forces.with_tangent)
      element.add_tangent(stiffness_of(at.cell),
                          total_resultants(at.state, at.index),
                          forces.tangent);
    const MixedElement::NodalVector force =
      element.internal_force(H, history.initial_resultants[at.index]);
    forces.force -= force;
    forces.square += force.norm_square();
  }


  LA::Vector
  InternalForces::forces_of(const std::vector<Modes::Vector> &resultants) const
  {
    LA::Vector forces = mesh.owned_vector();
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const MixedElement undeformed(mesh.cells[c].geometry,
                                      MixedElement::NodalVector());
        mesh.add_nodal_forces(
          mesh.cells[c],
          undeformed.internal_force(resultants[c], Modes::Vector()),
          forces);
      }
    forces.compress(VectorOperation::add);
    return forces;
  }


  LA::Vector
  InternalForces::unlisted_forces() const
  {
    LA::Vector forces = forces_of(history.initial_resultants);
    add_constant_forces(forces);
    return forces;
  }


  LA::Vector
  InternalForces::unbalanced_forces() const
  {
    const std::vector<Modes::Vector> given = resultants_of_laminate();
    std::vector<Modes::Vector>       since = history.initial_resultants;
    for (unsigned int c = 0; c < since.size(); ++c)
      since[c] -= given[c];
    LA::Vector forces = forces_of(since);
    add_constant_forces(forces);
    return forces;
  }


  void
  InternalForces::add_constant_forces(LA::Vector &nodal_forces) const
  {
    if (history.balancing_forces.size() > 0)
      nodal_forces.add(1, history.balancing_forces);
  }


  MixedElement::NodalVector
  InternalForces::tangent_product(const CellState                 &at,
                                  const MixedElement::NodalVector &dV) const
  {
    return MixedElement(at.cell.geometry, at.V)
      .tangent_product(
        stiffness_of(at.cell), total_resultants(at.state, at.index), dV);
  }


  void
  InternalForces::set_theory(const StrainTheory theory, const State &state)
  {
    if (theory == StrainTheory::linear)
      history.linearization_point = state;
    else
      history.linearization_point.reset();
  }


  void
  InternalForces::take_as_prestress(State &state)
  {
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        history.initial_resultants[c] += state.resultants[c];
        history.initial_strains[c] = total_strains(state, c);
      }
    state = State(mesh);
    history.linearization_point.reset();
  }


  void
  InternalForces::balance(const LA::Vector &loads)
  {
    history.balancing_forces = loads;
    history.balancing_forces *= -1;
  }


  Modes::Vector
  InternalForces::strains(const State &state, const Cell &cell) const
  {
    const auto V = mesh.cell_values(state.displacement, cell);
    if (!history.linearization_point)
      return MixedElement(cell.geometry, V).strain();

    const auto V_0 =
      mesh.cell_values(history.linearization_point->displacement, cell);
    const MixedElement element(cell.geometry, V_0);
    return element.strain() + element.strain_variation(V - V_0);
  }


  Modes::Vector
  InternalForces::total_strains(const State &state, const unsigned int c) const
  {
    return strains(state, mesh.cells[c]) + history.initial_strains[c];
  }


  void
  InternalForces::settle_resultants(State &state) const
  {
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        state.resultants[c] =
          stiffness_of(cell).resultants(strains(state, cell));
      }
  }


  void
  InternalForces::predict_resultants(State            &state,
                                     const LA::Vector &increment) const
  {
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell        &cell = mesh.cells[c];
        const MixedElement element(cell.geometry,
                                   mesh.cell_values(state.displacement, cell));
        state.resultants[c] = stiffness_of(cell).resultants(
          element.strain() +
          element.strain_variation(mesh.cell_values(increment, cell)));
      }
  }


  double
  InternalForces::strain_energy(const unsigned int               c,
                                const MixedElement::NodalVector &V) const
  {
    const Cell         &cell = mesh.cells[c];
    const MixedElement  element(cell.geometry, V);
    const Modes::Vector E = element.strain();
    return cell.geometry.weight *
           (Modes::mean_product(stiffness_of(cell).resultants(E), E) / 2 +
            Modes::mean_product(history.initial_resultants[c],
                                element.nonlinear_strain()));
  }


  double
  InternalForces::strain_energy(const State &state) const
  {
    double     energy = 0;
    CellForces forces;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        const auto  V    = mesh.cell_values(state.displacement, cell);
        if (!history.linearization_point)
          {
            energy += strain_energy(c, V);
            continue;
          }

        const State    &base = *history.linearization_point;
        const auto      V_0  = mesh.cell_values(base.displacement, cell);
        const auto      dV   = V - V_0;
        const Loads     none;
        const CellState at{c, cell, V_0, base, none};
        forces.clear();
        add(at, forces);
        energy += strain_energy(c, V_0) - forces.force * dV +
                  tangent_product(at, dV) * dV / 2;
      }
    return Utilities::MPI::sum(energy, mesh.communicator);
  }
} // namespace Biface
