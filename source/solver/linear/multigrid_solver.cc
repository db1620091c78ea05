// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

#include <biface/input/entry_declarations.h>
#include <biface/model/mesh/rigid_motions.h>
#include <biface/solver/linear/multigrid_solver.h>
#include <biface/solver/linear/mumps_solver.h>

#include <ml_epetra_utils.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr const char *set_up_failure =
      "the multigrid preconditioner could not be set up: the tangent may be "
      "singular";


    bool
    on_any_rank(const bool condition, const LA::SparseMatrix &A)
    {
      return Utilities::MPI::logical_or(condition, A.get_mpi_communicator());
    }


    /** A node that the ground holds. */
    struct HeldNode
    {
      std::vector<types::global_dof_index> rows;
      /** The largest one that a translation of the shell exerts on it. */
      Vector<double> force;
    };


    /** The nodes of this rank that are held. */
    std::vector<HeldNode>
    find_held_nodes(const LA::SparseMatrix          &A,
                    const GridLineNodes             &nodes,
                    const std::array<LA::Vector, 3> &translations)
    {
      // an elastic shell exerts forces of the order of round-off
      constexpr double held = 0.5;

      std::array<LA::Vector, 3> forces;
      for (unsigned int i = 0; i < 3; ++i)
        {
          forces[i].reinit(translations[i]);
          A.vmult(forces[i], translations[i]);
        }

      std::vector<HeldNode> held_nodes;
      const IndexSet        rows = A.locally_owned_range_indices();
      for (unsigned int n = 0; n < nodes.n_nodes(); ++n)
        {
          const unsigned int n_rows = nodes.begin[n + 1] - nodes.begin[n];
          HeldNode           node{{}, Vector<double>(n_rows)};
          Vector<double>     force(n_rows);
          double             diagonal = 0;
          const int         *local    = &nodes.rows[nodes.begin[n]];
          for (unsigned int d = 0; d < n_rows; ++d)
            {
              node.rows.push_back(rows.nth_index_in_set(local[d]));
              diagonal = std::max(diagonal, A.diag_element(node.rows[d]));
            }
          for (const LA::Vector &f : forces)
            {
              for (unsigned int d = 0; d < n_rows; ++d)
                force[d] = f.begin()[local[d]];
              if (force.norm_sqr() > node.force.norm_sqr())
                node.force = force;
            }
          if (node.force.l2_norm() > held * diagonal)
            held_nodes.push_back(node);
        }
      return held_nodes;
    }


    /** Make a projection along the displacements by which each of the nodes
     * alone yields to its force with the least energy.
     * @return whether the matrices of all nodes are regular. */
    bool
    make_energy_projection(const std::vector<HeldNode> &nodes,
                           const LA::SparseMatrix      &A,
                           LA::SparseMatrix            &projection)
    {
      // the rest keeps the coarse matrix regular where all nodes are held
      constexpr double truncated = 0.99;

      const IndexSet         rows = A.locally_owned_range_indices();
      DynamicSparsityPattern pattern(rows.size(), rows.size(), rows);
      for (const auto row : rows)
        pattern.add(row, row);
      for (const HeldNode &node : nodes)
        for (const auto row : node.rows)
          for (const auto column : node.rows)
            pattern.add(row, column);
      projection.reinit(rows, rows, pattern, A.get_mpi_communicator());
      for (const auto row : rows)
        projection.set(row, row, 1.);
      projection.compress(VectorOperation::insert);

      bool singular = false;
      for (const HeldNode &node : nodes)
        {
          const unsigned int n = node.rows.size();
          FullMatrix<double> inverse(n, n);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              inverse(i, j) = A.el(node.rows[i], node.rows[j]);
          singular = !invert(inverse);
          if (singular)
            break;
          Vector<double> yielding(n);
          inverse.vmult(yielding, node.force);
          const double work = yielding * node.force;
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              projection.add(node.rows[i],
                             node.rows[j],
                             -truncated * yielding[i] * node.force[j] / work);
        }
      projection.compress(VectorOperation::add);
      return !on_any_rank(singular, A);
    }
  } // namespace


  void
  LinearSolver::Parameters::Multigrid::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      "Number of GMRES iterations after which a linear solve "
                      "has failed.",
                      Patterns::Integer(1));
    prm.add_parameter("Coarsest unknowns",
                      coarsest_unknowns,
                      "Every second mesh line is left out, again and again, "
                      "until at most this number of unknowns is left, for "
                      "which a direct solver is used.",
                      Patterns::Integer(1));
  }


  MultigridSolver::MultigridSolver(const Parameters &parameters,
                                   const ShellMesh  &mesh,
                                   TimerOutput      &timer)
    : parameters(parameters)
    , timer(timer)
    , no_output(std::cout, false)
    , coarse_timer(no_output, TimerOutput::never, TimerOutput::wall_times)
  {
    NestedSpaces spaces =
      make_nested_spaces(mesh, parameters.coarsest_unknowns);
    GridLineNodes nodes = std::move(spaces.nodes);
    for (CoarseSpace &space : spaces.coarse)
      {
        Level &level = levels.emplace_back(std::move(space.interpolation));
        level.nodes  = std::exchange(nodes, std::move(space.nodes));
        level.residual.reinit(level.interpolation.locally_owned_range_indices(),
                              mesh.communicator);
        level.correction = level.residual;
        level.coarse_residual.reinit(
          level.interpolation.locally_owned_domain_indices(),
          mesh.communicator);
        level.coarse_correction = level.coarse_residual;
      }

    // single precision would need iterations of its own in every cycle
    coarsest = std::make_unique<MumpsSolver>(
      mesh.communicator, levels.empty() ? timer : coarse_timer, false);

    const auto motions = rigid_motions(mesh);
    for (unsigned int i = 0; i < translations.size(); ++i)
      {
        translations[i] = mesh.owned_vector();
        std::copy(
          motions[i].begin(), motions[i].end(), translations[i].begin());
      }
  }


  LinearSolverResult
  MultigridSolver::factorize(const LA::SparseMatrix &A, const Symmetry symmetry)
  {
    matrix         = &A;
    this->symmetry = symmetry;
    return levels.empty() ? coarsest->factorize(A, symmetry) : set_up();
  }


  LinearSolverResult
  MultigridSolver::keep_factors(const LA::SparseMatrix &A,
                                const Symmetry          symmetry,
                                const Correction       &correction)
  {
    if (levels.empty())
      return coarsest->keep_factors(A, symmetry, correction);
    if (!coarse_matrices_exist)
      return factorize(A, symmetry);

    matrix                   = &A;
    this->symmetry           = symmetry;
    coarse_matrices_are_kept = true;
    TimerOutput::Scope scope(timer, "Linear solver: multigrid set-up");
    LinearSolverResult result;
    result.success = initialize_smoother(levels.front(), A);
    result.message = set_up_failure;
    return result;
  }


  std::optional<unsigned int>
  MultigridSolver::count_negative_pivots(const LA::SparseMatrix &A,
                                         const bool              often)
  {
    return levels.empty() ? coarsest->count_negative_pivots(A, often)
                          : std::nullopt;
  }


  LinearSolverResult
  MultigridSolver::set_up()
  {
    TimerOutput::Scope scope(timer, "Linear solver: multigrid set-up");
    coarse_matrices_exist    = false;
    coarse_matrices_are_kept = false;

    LinearSolverResult result;
    result.message = set_up_failure;

    const LA::SparseMatrix *on_level = matrix;
    for (Level &level : levels)
      {
        if (!initialize_smoother(level, *on_level))
          return result;
        // coarse functions from here on do not move nodes that the ground
        // holds, so that coarser levels do not know of it
        if (&level == &levels.front() && !truncate_prolongation())
          return result;

        // deal.II's products take longer
        Epetra_CrsMatrix *product = nullptr;
        if (ML_Epetra::ML_Epetra_PtAP(on_level->trilinos_matrix(),
                                      level.prolongation().trilinos_matrix(),
                                      product) != 0)
          return result;
        const std::unique_ptr<const Epetra_CrsMatrix> owner(product);
        level.coarse_matrix = std::make_unique<LA::SparseMatrix>();
        level.coarse_matrix->reinit(*product);
        on_level = level.coarse_matrix.get();
      }

    result = coarsest->factorize(
      *on_level, symmetry == Symmetry::full ? Symmetry::full : Symmetry::none);
    coarse_matrices_exist = result.success;
    // these are not pivots of the tangent
    result.n_negative_pivots.reset();
    return result;
  }


  bool
  MultigridSolver::initialize_smoother(Level &level, const LA::SparseMatrix &A)
  {
    return !on_any_rank(!level.smoother.initialize(A, level.nodes), A);
  }


  bool
  MultigridSolver::truncate_prolongation()
  {
    Level &level = levels.front();
    level.truncated.reset();
    const std::vector<HeldNode> held =
      find_held_nodes(*matrix, level.nodes, translations);
    if (!on_any_rank(!held.empty(), *matrix))
      return true;

    LA::SparseMatrix projection;
    if (!make_energy_projection(held, *matrix, projection))
      return false;
    level.truncated = std::make_unique<LA::SparseMatrix>();
    projection.mmult(*level.truncated, level.interpolation);
    return true;
  }


  void
  MultigridSolver::cycle(const unsigned int l,
                         LA::Vector        &x,
                         const LA::Vector  &b) const
  {
    if (l == levels.size())
      {
        // a failure shows in GMRES, which does not converge
        coarsest->solve(x, b, 0);
        return;
      }

    const Level            &level = levels[l];
    const LA::SparseMatrix &P     = level.prolongation();
    level.smoother.forward_from_zero(x, level.residual, b);
    P.Tvmult(level.coarse_residual, level.residual);
    cycle(l + 1, level.coarse_correction, level.coarse_residual);
    P.vmult(level.correction, level.coarse_correction);
    x += level.correction;
    level.smoother.backward(x, b);
  }


  void
  MultigridSolver::vmult(LA::Vector &x, const LA::Vector &b) const
  {
    cycle(0, x, b);
  }


  LinearSolverResult
  MultigridSolver::solve(LA::Vector       &x,
                         const LA::Vector &b,
                         const double      tolerance)
  {
    if (levels.empty())
      return coarsest->solve(x, b, tolerance);
    return solve(LinearSystem::original, x, b, tolerance);
  }


  LinearSolverResult
  MultigridSolver::solve_transposed(LA::Vector       &x,
                                    const LA::Vector &b,
                                    const double      tolerance)
  {
    if (levels.empty())
      return coarsest->solve_transposed(x, b, tolerance);
    return solve(LinearSystem::transposed, x, b, tolerance);
  }


  LinearSolverResult
  MultigridSolver::solve(const LinearSystem system,
                         LA::Vector        &x,
                         const LA::Vector  &b,
                         const double       tolerance)
  {
    Assert(matrix != nullptr, ExcNotInitialized());

    // where the coarse matrices are those of another matrix, new ones take the
    // time of about so many iterations
    constexpr unsigned int worth_a_set_up = 15;
    if (coarse_matrices_are_kept)
      {
        const LinearSolverResult result =
          iterate(system, x, b, tolerance, worth_a_set_up);
        if (result.success)
          return result;
        const LinearSolverResult new_set_up = set_up();
        if (!new_set_up.success)
          return new_set_up;
      }
    return iterate(system, x, b, tolerance, parameters.max_iterations);
  }


  LinearSolverResult
  MultigridSolver::iterate(const LinearSystem system,
                           LA::Vector        &x,
                           const LA::Vector  &b,
                           const double       tolerance,
                           const unsigned int max_iterations)
  {
    // tolerance of a single run of GMRES; the smoother is in single precision
    constexpr double minimum = 1e-6;
    // each needs the memory of a vector
    constexpr unsigned int iterations_before_restart = 300;

    TimerOutput::Scope scope(timer, "Linear solver: multigrid iterations");

    LinearSolverResult                            result;
    const SystemMatrix                            A{*matrix, system};
    const SolverGMRES<LA::Vector>::AdditionalData vectors(
      iterations_before_restart + 2);
    LA::Vector   residual(b), correction(b);
    unsigned int n_iterations = 0;
    // by the estimates of GMRES, which do not see round-off
    double reached = 1;
    x              = 0;
    while (!result.success)
      {
        // left preconditioning, so that the tolerance refers to the
        // preconditioned residual
        ReductionControl control(max_iterations - n_iterations,
                                 0,
                                 std::max(tolerance / reached, minimum));
        correction = 0;
        try
          {
            SolverGMRES<LA::Vector>(control, vectors)
              .solve(A, correction, residual, *this);
          }
        catch (const SolverControl::NoConvergence &)
          {
            std::ostringstream message;
            message << "GMRES with multigrid did not converge: after "
                    << n_iterations + control.last_step()
                    << " iterations the preconditioned residual was "
                    << reached * control.last_value() / control.initial_value()
                    << " of the initial one (tolerance " << tolerance << ")";
            result.message = message.str();
            result.cause   = FailureCause::linear_iterations;
            break;
          }
        n_iterations += control.last_step();
        x += correction;
        if (control.initial_value() > 0)
          reached *= control.last_value() / control.initial_value();
        result.success = (reached <= tolerance || control.initial_value() == 0);
        if (!result.success)
          A.residual(residual, x, b);
      }
    return result;
  }
} // namespace Biface
