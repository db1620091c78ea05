// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <biface/model/shell_equations.h>

namespace Biface
{
  using namespace dealii;

  State
  ShellEquations::initial_state() const
  {
    State state;
    state.displacement = mesh.ghosted_vector();
    state.resultants.resize(mesh.cells.size());
    state.active.resize(mesh.nodes.size(), 0);
    return state;
  }


  void
  ShellEquations::set_theory(const StrainTheory theory, const State &state)
  {
    if (theory == StrainTheory::linear)
      linearization_point = state;
    else
      linearization_point.reset();
  }


  void
  ShellEquations::take_as_prestress(State &state)
  {
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        initial_resultants[c] += state.resultants[c];
        initial_strains[c] = total_strains(state, c);
      }
    state = initial_state();
  }


  void
  ShellEquations::restore(const History &history)
  {
    initial_resultants  = history.initial_resultants;
    initial_strains     = history.initial_strains;
    linearization_point = history.linearization_point;
  }


  void
  ShellEquations::update(State                &state,
                         const LA::Vector     &increment,
                         const NewtonIteration iteration) const
  {
    if (iteration == NewtonIteration::mixed && !linearization_point)
      {
        LA::Vector ghosted_increment = mesh.ghosted_vector();
        ghosted_increment            = increment;
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          {
            const Cell        &cell = mesh.cells[c];
            const MixedElement element(
              cell.geometry, mesh.cell_values(state.displacement, cell));
            state.resultants[c] = stiffness_of(cell).resultants(
              element.strain() + element.strain_variation(
                                   mesh.cell_values(ghosted_increment, cell)));
          }
      }

    LA::Vector displacement = mesh.owned_vector();
    displacement            = state.displacement;
    displacement += increment;
    state.displacement = displacement;

    if (iteration == NewtonIteration::substituted || linearization_point)
      settle_resultants(state);
  }


  Modes::Vector
  ShellEquations::strains(const State &state, const Cell &cell) const
  {
    const auto V = mesh.cell_values(state.displacement, cell);
    if (!linearization_point)
      return MixedElement(cell.geometry, V).strain();

    const auto V_0 = mesh.cell_values(linearization_point->displacement, cell);
    const MixedElement element(cell.geometry, V_0);
    return element.strain() + element.strain_variation(V - V_0);
  }


  Modes::Vector
  ShellEquations::total_strains(const State &state, const unsigned int c) const
  {
    return strains(state, mesh.cells[c]) + initial_strains[c];
  }


  void
  ShellEquations::settle_resultants(State &state) const
  {
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        state.resultants[c] =
          stiffness_of(cell).resultants(strains(state, cell));
      }
  }


  double
  ShellEquations::strain_energy(const State &state) const
  {
    double energy = 0;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell         &cell = mesh.cells[c];
        const MixedElement  element(cell.geometry,
                                   mesh.cell_values(state.displacement, cell));
        const Modes::Vector E = element.strain();
        energy +=
          cell.geometry.weight *
          (Modes::mean_product(stiffness_of(cell).resultants(E), E) / 2 +
           Modes::mean_product(initial_resultants[c],
                               element.nonlinear_strain()));
      }
    return Utilities::MPI::sum(energy, mesh.communicator);
  }
} // namespace Biface
