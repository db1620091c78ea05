// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

#include <biface/contact/rolling.h>
#include <biface/element/nonlinear_plies.h>
#include <biface/element/quadrilateral.h>
#include <biface/element/recovered_strains.h>
#include <biface/input/formula.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/stiffness_along.h>
#include <biface/model/forces/internal_forces.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/step_in_time.h>
#include <biface/model/state/strain_theory.h>

namespace Biface
{
  using namespace dealii;

  InternalForces::InternalForces(const ShellMesh &mesh)
    : mesh(mesh)
    , transport(mesh, nonlinear)
    , symmetric_stiffness(mesh.strips[0].laminate.is_symmetric())
  {
    for (const Strip &strip : mesh.strips)
      add_laws(strip.laminate, nullptr, stiffness, nonlinear);
    if (std::any_of(mesh.cells.begin(), mesh.cells.end(), [](const Cell &cell) {
          return cell.geometry.tangents() != nullptr;
        }))
      for (const Cell &cell : mesh.cells)
        add_laws(mesh.strips[cell.strip].laminate,
                 cell.geometry.tangents(),
                 stiffness_of_cells,
                 nonlinear_of_cells);
    of_laminate = resultants_of_laminate();
    // stresses follow from the strains since the imperfect shape, which is free
    // of stress (section 1 of doc/theory.md)
    if (mesh.imperfection.size() > 0)
      {
        of_imperfection.resize(mesh.cells.size());
        for (const unsigned int c : mesh.layers)
          of_imperfection[c] =
            MixedElement(mesh.cells[c].geometry,
                         mesh.cell_values(mesh.imperfection, mesh.cells[c]))
              .strain();
      }
  }


  void
  InternalForces::add_laws(const Laminate              &laminate,
                           const CellTangents          *tangents,
                           std::vector<ModeStiffness>  &linear,
                           std::vector<NonlinearPlies> &others) const
  {
    others.emplace_back(laminate, mesh.formulation, tangents);
    // the points of the plies have the whole stiffness: nothing linear is
    // left beside them
    if (others.back().is_whole_law())
      {
        linear.emplace_back(Resultants::Matrix(), mesh.formulation);
        return;
      }
    linear.emplace_back(laminate.stiffness(), mesh.formulation, tangents);
    if (mesh.normal_thickness)
      // section 4 of doc/theory.md, "Nearly incompressible layers":
      // positive whatever cords are slack
      linear.back().release_thickness_strain(
        laminate.stiffness_of_slack_cords(), tangents);
  }


  std::vector<Modes::Vector>
  InternalForces::resultants_of_laminate() const
  {
    std::vector<Modes::Vector> of_strips;
    for (const Strip &strip : mesh.strips)
      of_strips.push_back(Modes::constant(strip.laminate.initial_resultants()));
    std::vector<Modes::Vector> resultants(mesh.cells.size());
    for (const unsigned int c : mesh.layers)
      resultants[c] = of_strips[mesh.cells[c].strip];

    // formulas vary within strips: they are added at the nodes
    const auto          &given = mesh.get_layup().get_initial_resultants();
    std::vector<Formula> formulas;
    for (const InitialResultant &resultant : given)
      formulas.push_back(resultant.value);
    const auto values = evaluate_at_nodes(formulas, mesh);
    for (const unsigned int c : mesh.layers)
      {
        std::array<Resultants::Vector, 4> at_vertices;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int r = 0; r < given.size(); ++r)
            at_vertices[v][given[r].index] += values[mesh.cells[c].nodes[v]][r];
        resultants[c] += Modes::from_vertices(at_vertices);
      }
    return resultants;
  }


  InternalForces::~InternalForces() = default;


  bool
  InternalForces::is_symmetric(const Loads &loads) const
  {
    // around a rolling wheel a particle remembers what is behind it and not
    // what is ahead, so that forces have no potential
    return symmetric_stiffness &&
           !(loads.rolling && mesh.get_layup().relaxes());
  }


  const NonlinearPlies &
  InternalForces::nonlinear_plies(const Cell &cell) const
  {
    return nonlinear_of_cells.empty() ? nonlinear[cell.strip]
                                      : nonlinear_of_cells[cell.position];
  }


  void
  InternalForces::add(const CellState &at, CellForces &forces) const
  {
    const MixedElement    element(at.cell.geometry, at.V);
    const Modes::Vector   E         = strains_of(element, at.index);
    const auto           &predicted = at.state.predicted_strains;
    const NonlinearPlies &plies     = nonlinear_plies(at.cell);
    const Modes::Vector  &at_strain =
      predicted.empty() ? E : predicted[at.index];
    Modes::Vector H;
    if (plies.is_whole_law() && (forces.with_tangent || !predicted.empty()))
      {
        // such laws have no prestress
        // in the mixed iteration the forces are those of the law that the
        // tangent linearizes, section 7 of doc/theory.md
        const HistoryOfPlies past = history(at.state, at.index);
        const auto           law  = plies.linearize(at_strain, past);
        H                         = plies.resultants(law, E, past);
        if (forces.with_tangent)
          element.add_tangent(stiffness_of(at.cell),
                              total_resultants(at.state, at.index),
                              forces.tangent,
                              &law.stiffness);
      }
    else
      {
        H = resultants_of(at.state, at.index, E);
        if (forces.with_tangent)
          add_tangent(element, at, at_strain, forces);
      }
    const MixedElement::NodalVector force =
      element.internal_force(H, initial_resultants(at.state)[at.index]);
    forces.force -= force;
    forces.square += force.norm_square();
  }


  std::optional<Modes::Matrix>
  InternalForces::initial_stiffness(const Cell &cell) const
  {
    const NonlinearPlies &plies = nonlinear_plies(cell);
    if (plies.all_linear())
      return {};
    Modes::Matrix result;
    plies.stiffness(Modes::Vector(), result);
    return result;
  }


  Modes::Vector
  InternalForces::initial_law(const Cell                         &cell,
                              const std::optional<Modes::Matrix> &of_plies,
                              const Modes::Vector                &E) const
  {
    Modes::Vector H = stiffness_of(cell).resultants(E);
    if (of_plies)
      H += NonlinearPlies::resultants(*of_plies, E);
    return H;
  }


  Modes::Vector
  InternalForces::resultants_over_step(
    const CellState                    &end,
    const std::optional<Modes::Matrix> &of_plies,
    const Modes::Vector                &E_0,
    const Modes::Vector                &E_1,
    const Modes::Vector                &change) const
  {
    const unsigned int c = end.index;
    Modes::Vector      H = resultants_of(end.state, c, (E_0 + E_1) / 2);
    if (!of_plies)
      return H;
    // Gonzalez's discrete gradient, with the law at small strains as the metric
    const Modes::Vector correction = initial_law(end.cell, of_plies, change);
    const double        square     = Modes::mean_product(correction, change),
                 energy_0          = energy_of(end.state, c, E_0),
                 energy_1          = energy_of(end.state, c, E_1),
                 missing = energy_1 - energy_0 - Modes::mean_product(H, change);
    // what is left of the difference by round-off is no force
    constexpr double roundoff = 64 * std::numeric_limits<double>::epsilon();
    if (square > 0 && std::abs(missing) >
                        roundoff * (std::abs(energy_0) + std::abs(energy_1)))
      H += missing / square * correction;
    return H;
  }


  void
  InternalForces::add_over_step(const CellState &start,
                                const CellState &end,
                                CellForces      &forces) const
  {
    const double        part   = end.state.step->weight_of_end();
    const unsigned int  c      = end.index;
    const Modes::Vector E_0    = strains_of({end.cell.geometry, start.V}, c),
                        E_1    = strains_of({end.cell.geometry, end.V}, c),
                        change = E_1 - E_0,
                        &H_0   = initial_resultants(end.state)[c];
    const auto    of_plies     = initial_stiffness(end.cell);
    Modes::Vector H = resultants_over_step(end, of_plies, E_0, E_1, change);
    if (part != 0.5)
      H += (part - 0.5) * initial_law(end.cell, of_plies, change);
    const MixedElement              element(end.cell.geometry, start.V, end.V);
    const MixedElement::NodalVector force = element.internal_force(H, H_0);
    forces.force -= force;
    forces.square += force.norm_square();
    if (!forces.with_tangent)
      return;

    // kappa times the tangent halfway for resultants divided by 2 kappa;
    // symmetric, with the derivative of the strains halfway instead of that at
    // the end: forces of stiff strains have the right directions
    CellForces halfway;
    halfway.clear();
    NonlinearPlies::Stiffness of_step;
    if (of_plies)
      {
        nonlinear_plies(end.cell).stiffness(initial_strain(end.state, c) +
                                              (E_0 + E_1) / 2,
                                            of_step,
                                            history(end.state, c));
        for (unsigned int m = 0; m < Modes::n; ++m)
          for (unsigned int n = 0; n < Modes::n; ++n)
            of_step[m][n] =
              (of_step[m][n] / 2 + (part - 0.5) * (*of_plies)[m][n]) / part;
      }
    element.add_tangent(stiffness_of(end.cell),
                        (H + H_0) / (2 * part),
                        halfway.tangent,
                        of_plies ? &of_step : nullptr);
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        forces.tangent[i][j] += part * halfway.tangent[i][j];
  }


  double
  InternalForces::dissipated_energy(const State &state) const
  {
    const StepInTime &step = *state.step;
    double            sum  = 0;
    for (const unsigned int c : mesh.layers)
      {
        const Modes::Vector change = strains(state, c) - strains(step.start, c);
        sum += mesh.cells[c].geometry.weight *
               Modes::mean_product(initial_law(mesh.cells[c],
                                               initial_stiffness(mesh.cells[c]),
                                               change),
                                   change);
      }
    return (step.weight_of_end() - 0.5) * sum;
  }


  void
  InternalForces::add_linearized(const CellState                 &at,
                                 const MixedElement::NodalVector &dV,
                                 CellForces                      &forces) const
  {
    const MixedElement element(at.cell.geometry, at.V);
    Modes::Vector      E = strains_of(element, at.index);
    Modes::Vector      H = resultants_of(at.state, at.index, E);
    if (!nonlinear_plies(at.cell).all_linear())
      {
        const Modes::Vector dE = element.strain_variation(dV);
        E += dE;
        // the product with the tangent below contains the second term
        H = resultants_of(at.state, at.index, E) -
            stiffness_of(at.cell).resultants(dE);
      }
    if (forces.with_tangent)
      add_tangent(element, at, E, forces);
    forces.force -=
      element.internal_force(H, initial_resultants(at.state)[at.index]);
    forces.force -= linear_tangent_product(at, dV);
  }


  Modes::Vector
  InternalForces::resultants_of(const State         &state,
                                const unsigned int   c,
                                const Modes::Vector &E) const
  {
    const Cell           &cell   = mesh.cells[c];
    const Modes::Vector   linear = stiffness_of(cell).resultants(E);
    const NonlinearPlies &plies  = nonlinear_plies(cell);
    if (plies.all_linear())
      return linear;
    if (!state.prestress)
      return linear + plies.resultants(E, history(state, c));
    // only the change since the start: the resultants before are those of the
    // prestress, which are counted apart
    const Modes::Vector E_0 = initial_strain(state, c);
    return linear + (plies.resultants(E_0 + E) - plies.resultants(E_0));
  }


  double
  InternalForces::energy_of(const State         &state,
                            const unsigned int   c,
                            const Modes::Vector &E) const
  {
    const Cell  &cell = mesh.cells[c];
    const double linear =
      Modes::mean_product(stiffness_of(cell).resultants(E), E) / 2;
    const NonlinearPlies &plies = nonlinear_plies(cell);
    if (plies.all_linear())
      return linear;
    // likewise, without the linear part, the work of the resultants of the
    // prestress
    const Modes::Vector E_0 = initial_strain(state, c);
    return linear + (plies.energy(E_0 + E) - plies.energy(E_0) -
                     Modes::mean_product(plies.resultants(E_0), E));
  }


  std::string
  InternalForces::name() const
  {
    return mesh.get_layup().relaxes() ? "relaxation" : "";
  }


  void
  InternalForces::start_stage(const Loads &, State &state) const
  {
    // what has relaxed in the stages before goes on
    if (name().empty() || state.terms.count(name()) > 0)
      return;
    unsigned int n = 0;
    for (const NonlinearPlies &plies : nonlinear)
      n = std::max(n, plies.n_internal());
    // the same on ranks without cells
    n = Utilities::MPI::max(n, mesh.communicator);
    state.terms[name()].at_cells.reinit(mesh.cells.size(), n);
  }


  void
  InternalForces::commit_step(const State &,
                              const Loads &,
                              const TimeInterval &,
                              State &after) const
  {
    if (!name().empty())
      {
        Table<2, double> &internal = after.terms.at(name()).at_cells;
        for (const unsigned int c : mesh.layers)
          if (internal.size(1) > 0)
            nonlinear_plies(mesh.cells[c])
              .commit(
                total_strains(after, c), history(after, c), &internal(c, 0));
      }
    // no time passes in the state at the end of a step, in which modes and
    // buckling have the instantaneous moduli
    after.time_step = TimeStep();
    after.transport_velocity.reset();
  }


  std::string
  InternalForces::prepare(const Loads &loads, State &state) const
  {
    const auto found = state.terms.find("relaxation");
    if (!loads.rolling || found == state.terms.end())
      return {};
    // internal variables depend on all cells around the axle, so that they are
    // set before any cell is assembled
    state.transport_velocity = loads.rolling->angular_velocity;
    return transport.set_internal_variables(
      [&](const unsigned int c) { return total_strains(state, c); },
      state,
      found->second.at_cells);
  }


  std::unique_ptr<const NonlocalStiffness>
  InternalForces::nonlocal_stiffness(const State &state) const
  {
    if (!state.transport_velocity)
      return nullptr;
    return transport.stiffness(
      [&](const unsigned int c) { return total_strains(state, c); },
      state,
      state.terms.at("relaxation").at_cells);
  }


  std::vector<std::vector<double>>
  InternalForces::losses(const State &state,
                         const double angular_velocity) const
  {
    Table<2, double> internal = state.terms.at("relaxation").at_cells;
    // around the axle those of a point are of the point behind it, from which a
    // step in time leads here
    if (state.transport_velocity)
      for (const unsigned int c : mesh.layers)
        nonlinear_plies(mesh.cells[c])
          .commit(total_strains(state, c), history(state, c), &internal(c, 0));
    return transport.losses(
      [&](const unsigned int c) { return total_strains(state, c); },
      internal,
      angular_velocity);
  }


  HistoryOfPlies
  InternalForces::history(const State &state, const unsigned int c) const
  {
    const auto found = state.terms.find("relaxation");
    if (found == state.terms.end() || found->second.at_cells.size(1) == 0)
      return {};
    return transport.history(state, found->second.at_cells, c);
  }


  bool
  InternalForces::is_nonlinear() const
  {
    return std::any_of(nonlinear.begin(),
                       nonlinear.end(),
                       [](const auto &plies) { return !plies.all_linear(); });
  }


  void
  InternalForces::add_tangent(const MixedElement  &element,
                              const CellState     &at,
                              const Modes::Vector &E,
                              CellForces          &forces) const
  {
    const Modes::Vector       H     = total_resultants(at.state, at.index);
    const NonlinearPlies     &plies = nonlinear_plies(at.cell);
    NonlinearPlies::Stiffness added;
    const bool                any = !plies.all_linear() &&
                     plies.stiffness(initial_strain(at.state, at.index) + E,
                                     added,
                                     history(at.state, at.index));
    element.add_tangent(
      stiffness_of(at.cell), H, forces.tangent, any ? &added : nullptr);
  }


  void
  InternalForces::add_law(const State               &state,
                          const unsigned int         c,
                          const Laminate            &laminate,
                          const double               factor,
                          MixedElement::NodalMatrix &K) const
  {
    const Cell                 &cell = mesh.cells[c];
    std::vector<ModeStiffness>  linear;
    std::vector<NonlinearPlies> others;
    add_laws(laminate, cell.geometry.tangents(), linear, others);
    const MixedElement        element(cell.geometry,
                               mesh.cell_values(state.displacement, cell));
    NonlinearPlies::Stiffness added;
    const bool                any =
      !others[0].all_linear() &&
      others[0].stiffness(
        initial_strain(state, c) + strains_of(element, c), added, {});
    MixedElement::NodalMatrix of_law{};
    element.add_tangent(
      linear[0], Modes::Vector(), of_law, any ? &added : nullptr);
    for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
      for (unsigned int j = 0; j < MixedElement::n_dofs; ++j)
        K[i][j] += factor * of_law[i][j];
  }


  void
  InternalForces::add_damping(const State               &state,
                              const unsigned int         c,
                              MixedElement::NodalMatrix &C) const
  {
    const Cell                        &cell = mesh.cells[c];
    const MixedElement                 element(cell.geometry,
                               mesh.cell_values(state.displacement, cell));
    const std::optional<Modes::Matrix> of_plies = initial_stiffness(cell);
    element.add_tangent(
      stiffness_of(cell), Modes::Vector(), C, of_plies ? &*of_plies : nullptr);
  }


  LA::Vector
  InternalForces::forces_of(const std::vector<Modes::Vector> &resultants) const
  {
    LA::Vector forces = mesh.owned_vector();
    // initial resultants are balanced by constant forces B_0^T H_0 in the
    // undeformed shape, section 3 of doc/theory.md
    for (const unsigned int c : mesh.layers)
      mesh.add_nodal_forces(
        mesh.cells[c], undeformed_forces(c, resultants[c]), forces);
    forces.compress(VectorOperation::add);
    return forces;
  }


  MixedElement::NodalVector
  InternalForces::undeformed_forces(const unsigned int   cell,
                                    const Modes::Vector &resultants) const
  {
    const MixedElement undeformed(mesh.cells[cell].geometry,
                                  MixedElement::NodalVector());
    return undeformed.internal_force(resultants, Modes::Vector());
  }


  LA::Vector
  InternalForces::unlisted_forces(const State &state) const
  {
    LA::Vector forces = forces_of(initial_resultants(state));
    add_constant_forces(state, forces);
    return forces;
  }


  LA::Vector
  InternalForces::unbalanced_forces(const State &state) const
  {
    std::vector<Modes::Vector> since = initial_resultants(state);
    for (unsigned int c = 0; c < since.size(); ++c)
      // those of the laminate are balanced by loads that are no part of the
      // model
      since[c] -= of_laminate[c];
    LA::Vector forces = forces_of(since);
    add_constant_forces(state, forces);
    return forces;
  }


  void
  InternalForces::add_constant_forces(const State &state,
                                      LA::Vector  &nodal_forces) const
  {
    if (state.prestress && state.prestress->balancing_forces.size() > 0)
      nodal_forces.add(1, state.prestress->balancing_forces);
  }


  MixedElement::NodalVector
  InternalForces::linear_tangent_product(
    const CellState &at, const MixedElement::NodalVector &dV) const
  {
    return MixedElement(at.cell.geometry, at.V)
      .tangent_product(
        stiffness_of(at.cell), total_resultants(at.state, at.index), dV);
  }


  void
  InternalForces::set_theory(const StrainTheory theory, State &state)
  {
    state.linearization_point = nullptr;
    if (theory == StrainTheory::linear)
      state.linearization_point = std::make_shared<const State>(state);
  }


  State
  InternalForces::in_shape_of_tangent(const State &state) const
  {
    // section 8 of doc/theory.md: the shape about which the strains are
    // linearized, with the resultants at the end of the stage
    State result = state;
    if (!state.linearization_point)
      return result;
    result.displacement = state.linearization_point->displacement;
    result.predicted_strains.clear();
    if (is_nonlinear())
      {
        result.predicted_strains.resize(mesh.cells.size());
        for (const unsigned int c : mesh.layers)
          result.predicted_strains[c] = strains(state, c);
      }
    result.linearization_point = nullptr;
    return result;
  }


  void
  InternalForces::take_as_prestress(State &state) const
  {
    auto prestress = std::make_shared<Prestress>();
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        prestress->resultants.push_back(total_resultants(state, c));
        prestress->strains.push_back(total_strains(state, c));
      }
    if (state.prestress)
      prestress->balancing_forces = state.prestress->balancing_forces;
    // the undeformed shell under the resultants that were reached, section 5 of
    // doc/theory.md, "Known stressed shapes"
    state = State(mesh, state.contacts.size(), state.ground().per_cell);
    state.prestress = prestress;
  }


  void
  InternalForces::balance(const LA::Vector &loads, State &state) const
  {
    Assert(state.prestress, ExcNotInitialized());
    auto prestress              = std::make_shared<Prestress>(*state.prestress);
    prestress->balancing_forces = loads;
    prestress->balancing_forces *= -1;
    state.prestress = prestress;
  }


  Modes::Vector
  InternalForces::strains(const State &state, const unsigned int c) const
  {
    const Cell &cell = mesh.cells[c];
    const auto  V    = mesh.cell_values(state.displacement, cell);
    if (!state.linearization_point)
      return strains_of(MixedElement(cell.geometry, V), c);

    const auto V_0 =
      mesh.cell_values(state.linearization_point->displacement, cell);
    const MixedElement element(cell.geometry, V_0);
    return strains_of(element, c) + element.strain_variation(V - V_0);
  }


  Modes::Vector
  InternalForces::total_strains(const State &state, const unsigned int c) const
  {
    return mesh.cells[c].is_layer ? strains(state, c) + initial_strain(state, c)
                                  : Modes::Vector();
  }


  std::array<StrainsOfPlies, 4>
  InternalForces::strains_at_vertices(const State       &state,
                                      const unsigned int c) const
  {
    const Cell           &cell  = mesh.cells[c];
    const NonlinearPlies &plies = nonlinear_plies(cell);
    const Modes::Vector   E     = total_strains(state, c);
    auto            result   = plies.strains_at_vertices(E, history(state, c));
    const Laminate &laminate = mesh.strips[cell.strip].laminate;
    // nonlinear laws have the strains of the energy
    if (const CellTangents *tangents = cell.geometry.tangents();
        tangents && plies.all_linear() && is_isotropic(laminate))
      {
        const auto recovered =
          recovered_strains(*tangents, E, laminate.stiffness());
        for (unsigned int v = 0; v < 4; ++v)
          result[v].E = recovered[v];
      }
    return result;
  }


  std::array<Resultants::Vector, 4>
  InternalForces::total_strains_at_vertices(const State       &state,
                                            const unsigned int c) const
  {
    const Modes::Vector E        = total_strains(state, c);
    const CellTangents *tangents = mesh.cells[c].geometry.tangents();
    return tangents ? tangents->strains_at_vertices(E) : Modes::at_vertices(E);
  }


  std::array<Resultants::Vector, 4>
  InternalForces::total_resultants_at_vertices(const State       &state,
                                               const unsigned int c) const
  {
    const Modes::Vector H        = total_resultants(state, c);
    const CellTangents *tangents = mesh.cells[c].geometry.tangents();
    return tangents ? tangents->resultants_at_vertices(H)
                    : Modes::at_vertices(H);
  }


  void
  InternalForces::settle_resultants(State &state) const
  {
    for (const unsigned int c : mesh.layers)
      state.resultants[c] = resultants_of(state, c, strains(state, c));
    state.predicted_strains.clear();
  }


  void
  InternalForces::predict_resultants(State            &state,
                                     const LA::Vector &increment) const
  {
    const bool first = state.predicted_strains.empty();
    if (is_nonlinear())
      state.predicted_strains.resize(mesh.cells.size());
    for (const unsigned int c : mesh.layers)
      {
        const Cell        &cell = mesh.cells[c];
        const MixedElement element(cell.geometry,
                                   mesh.cell_values(state.displacement, cell));
        const auto         dV = mesh.cell_values(increment, cell);
        Modes::Vector E = strains_of(element, c) + element.strain_variation(dV);
        // linearized about the strains of the last prediction, as the tangent
        // was, so that the resultants are those of the linear system
        if (nonlinear_plies(cell).is_whole_law())
          {
            const NonlinearPlies &plies = nonlinear_plies(cell);
            const HistoryOfPlies  past  = history(state, c);
            state.resultants[c]         = plies.resultants(
              plies.linearize(first ? strains_of(element, c)
                                    : state.predicted_strains[c],
                              past),
              E,
              past);
            state.predicted_strains[c] = E;
            continue;
          }
        state.resultants[c] = resultants_of(state, c, E);
        if (mesh.formulation != Formulation::standard)
          {
            const Modes::Vector H         = total_resultants(state, c);
            const Modes::Vector hourglass = element.hourglass_strain(dV);
            for (unsigned int a = 0; a < 2; ++a)
              {
                const unsigned int inner =
                  Resultants::tangential(a, Resultants::inner);
                const unsigned int outer =
                  Resultants::tangential(a, Resultants::outer);
                // section 7 of doc/theory.md: in elements under tension the
                // term would only cost iterations
                if (H[inner] + H[outer] < 0)
                  for (const unsigned int i : {inner, outer})
                    E[i] += hourglass[i];
              }
            state.resultants[c] = resultants_of(state, c, E);
          }
        if (!state.predicted_strains.empty())
          state.predicted_strains[c] = E;
      }
  }


  std::array<double, Modes::n_gauss_points>
  InternalForces::slack_fractions(const State       &state,
                                  const unsigned int c) const
  {
    const NonlinearPlies &plies     = nonlinear_plies(mesh.cells[c]);
    const double          thickness = plies.thickness_of_cords();
    if (thickness == 0)
      return {};
    auto fractions = plies.slack_thickness(total_strains(state, c));
    for (double &fraction : fractions)
      fraction /= thickness;
    return fractions;
  }


  double
  InternalForces::slack_fraction(const State &state) const
  {
    double slack = 0, all = 0;
    for (const unsigned int c : mesh.layers)
      {
        const Cell  &cell = mesh.cells[c];
        const double volume =
          cell.geometry.weight * nonlinear_plies(cell).thickness_of_cords();
        for (const double fraction : slack_fractions(state, c))
          slack += volume * fraction / Modes::n_gauss_points;
        all += volume;
      }
    slack = Utilities::MPI::sum(slack, mesh.communicator);
    all   = Utilities::MPI::sum(all, mesh.communicator);
    return all > 0 ? slack / all : 0.;
  }


  double
  InternalForces::strain_energy(const State                     &state,
                                const unsigned int               c,
                                const MixedElement::NodalVector &V) const
  {
    const Cell         &cell = mesh.cells[c];
    const MixedElement  element(cell.geometry, V);
    const Modes::Vector E = strains_of(element, c);
    return cell.geometry.weight *
           (energy_of(state, c, E) +
            Modes::mean_product(initial_resultants(state)[c],
                                element.nonlinear_strain()));
  }


  double
  InternalForces::strain_energy(const State &state) const
  {
    // with what has relaxed, stresses are no derivatives of an energy of the
    // strains alone
    if (mesh.get_layup().relaxes())
      return std::numeric_limits<double>::quiet_NaN();
    double     energy = 0;
    CellForces forces;
    for (const unsigned int c : mesh.layers)
      {
        const Cell &cell = mesh.cells[c];
        const auto  V    = mesh.cell_values(state.displacement, cell);
        if (!state.linearization_point)
          {
            energy += strain_energy(state, c, V);
            continue;
          }

        // the energy to second order about the state of the linearization,
        // whose derivative are the linearized forces
        const State    &base = *state.linearization_point;
        const auto      V_0  = mesh.cell_values(base.displacement, cell);
        const auto      dV   = V - V_0;
        const Loads     none;
        const CellState at{c, cell, V_0, base, none};
        forces.clear();
        add(at, forces);
        energy += strain_energy(base, c, V_0) - forces.force * dV +
                  linear_tangent_product(at, dV) * dV / 2;
        if (nonlinear_plies(cell).all_linear())
          continue;
        // the energy is quadratic but for the plies that are not linear
        const MixedElement  element(cell.geometry, V_0);
        const Modes::Vector E      = strains_of(element, c);
        const Modes::Vector dE     = element.strain_variation(dV);
        const auto          linear = [&](const Modes::Vector &E) {
          return stiffness_of(cell).resultants(E);
        };
        energy += cell.geometry.weight *
                  (energy_of(state, c, E + dE) - energy_of(state, c, E) -
                   Modes::mean_product(resultants_of(state, c, E), dE) -
                   Modes::mean_product(linear(dE), dE) / 2);
      }
    return Utilities::MPI::sum(energy, mesh.communicator);
  }
} // namespace Biface
