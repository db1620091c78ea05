// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <cmath>

#include <biface/solver/shell_with_air.h>

namespace Biface
{
  using namespace dealii;

  ShellWithAir::ShellWithAir(const ShellMesh  &mesh,
                             const MassMatrix &mass,
                             const AirMotion  &air)
    : mesh(mesh)
    , mass(mass)
    , air(air)
    , owned(mesh.locally_owned.size() + air.sections.size())
    , is_last(AirMotion::is_on_this_rank(mesh.communicator))
  {
    owned.add_indices(mesh.locally_owned);
    if (is_last)
      owned.add_range(mesh.locally_owned.size(), owned.size());
    owned.compress();
  }


  LA::Vector
  ShellWithAir::join(const LA::Vector &u, const std::vector<double> &q) const
  {
    LA::Vector x(owned, mesh.communicator);
    std::copy(u.begin(), u.end(), x.begin());
    if (is_last)
      std::copy(q.begin(), q.end(), x.begin() + (u.end() - u.begin()));
    return x;
  }


  LA::Vector
  ShellWithAir::with_arbitrary_air(const LA::Vector &u) const
  {
    // moved volumes of the order of the expansion of the pieces
    std::vector<double> q(air.sections.size(), 0.);
    double              largest = 0;
    for (const double expansion : this->expansion(u, q))
      largest = std::max(largest, std::abs(expansion));
    for (unsigned int j = 0; j < q.size(); ++j)
      q[j] = largest * std::sin(1 + 1.7 * j);
    return join(u, q);
  }


  LA::Vector
  ShellWithAir::of_shell(const LA::Vector &x) const
  {
    LA::Vector u = mesh.owned_vector();
    std::copy(x.begin(), x.begin() + (u.end() - u.begin()), u.begin());
    return u;
  }


  std::vector<double>
  ShellWithAir::of_air(const LA::Vector &x) const
  {
    std::vector<double> q(air.sections.size());
    if (is_last)
      std::copy(x.end() - q.size(), x.end(), q.begin());
    Utilities::MPI::sum(q, mesh.communicator, q);
    return q;
  }


  void
  ShellWithAir::multiply_mass(LA::Vector &product, const LA::Vector &x) const
  {
    LA::Vector u = of_shell(x), of_u(u);
    mass.vmult(of_u, u);
    std::vector<double> q = of_air(x);
    for (unsigned int j = 0; j < q.size(); ++j)
      q[j] *= air.sections[j].inertia;
    product = join(of_u, q);
  }


  std::vector<LA::Vector>
  ShellWithAir::circulation() const
  {
    if (!air.is_closed)
      return {};
    return {
      join(mesh.owned_vector(), std::vector<double>(air.sections.size(), 1.))};
  }


  double
  ShellWithAir::part_of_shell(const LA::Vector &x) const
  {
    const LA::Vector u = of_shell(x);
    LA::Vector       of_u(u), of_all(x);
    mass.vmult(of_u, u);
    multiply_mass(of_all, x);
    return (of_u * u) / (of_all * x);
  }


  Tensor<1, 3>
  ShellWithAir::momentum_of_air(const LA::Vector &x) const
  {
    const std::vector<double> q = of_air(x);
    Tensor<1, 3>              momentum;
    for (unsigned int j = 0; j < q.size(); ++j)
      momentum += q[j] * air.sections[j].inertia * air.sections[j].area *
                  air.sections[j].direction;
    return momentum;
  }


  LA::Vector
  ShellWithAir::gradient(const unsigned int piece) const
  {
    LA::Vector g = mesh.owned_vector();
    for (const auto &[dof, value] : air.gradients[piece])
      g(dof) = value;
    g.compress(VectorOperation::insert);
    mesh.condense(g);
    g.compress(VectorOperation::add);
    mesh.constraints.set_zero(g);
    return g;
  }


  std::vector<double>
  ShellWithAir::expansion(const LA::Vector          &u,
                          const std::vector<double> &q) const
  {
    // constrained entries of u are those of the free ones
    LA::Vector all = u;
    mesh.constraints.distribute(all);
    std::vector<double> result(air.compliances.size());
    for (unsigned int c = 0; c < result.size(); ++c)
      for (const auto &[dof, value] : air.gradients[c])
        result[c] += value * all(dof);
    Utilities::MPI::sum(result, mesh.communicator, result);
    for (unsigned int j = 0; j < q.size(); ++j)
      {
        result[air.sections[j].from] += q[j];
        result[air.sections[j].to] -= q[j];
      }
    return result;
  }


  bool
  ShellWithAir::prepare(const Solve &solve, const double shift)
  {
    Assert(shift < 0, ExcInternalError());
    this->shift = shift;
    per_pressure.clear();
    const unsigned int n = air.compliances.size();
    inverse.reinit(n, n);
    for (unsigned int c = 0; c < n; ++c)
      {
        LA::Vector u = mesh.owned_vector();
        if (!solve(u, gradient(c)))
          return false;
        const std::vector<double> column = expansion(u, {});
        for (unsigned int d = 0; d < n; ++d)
          inverse(d, c) = column[d];
        inverse(c, c) += air.compliances[c];
        per_pressure.push_back(u);
      }
    // volumes in sections are eliminated: differences of pressure drive them
    for (const AirMotion::Section &section : air.sections)
      {
        const double mobility = -1 / (shift * section.inertia);
        inverse(section.from, section.from) += mobility;
        inverse(section.to, section.to) += mobility;
        inverse(section.from, section.to) -= mobility;
        inverse(section.to, section.from) -= mobility;
      }
    return invert(inverse);
  }


  bool
  ShellWithAir::solve(LA::Vector       &x,
                      const LA::Vector &b,
                      const Solve      &solve) const
  {
    LA::Vector u = mesh.owned_vector();
    if (!solve(u, of_shell(b)))
      return false;
    std::vector<double> q = of_air(b);
    for (unsigned int j = 0; j < q.size(); ++j)
      q[j] /= -shift * air.sections[j].inertia;
    const std::vector<double> expands = expansion(u, q);
    dealii::Vector<double>    of_pieces(expands.begin(), expands.end()),
      pressures(expands.size());
    inverse.vmult(pressures, of_pieces);
    for (unsigned int c = 0; c < expands.size(); ++c)
      u.add(-pressures(c), per_pressure[c]);
    for (unsigned int j = 0; j < q.size(); ++j)
      q[j] -=
        (pressures(air.sections[j].from) - pressures(air.sections[j].to)) /
        (-shift * air.sections[j].inertia);
    x = join(u, q);
    return true;
  }
} // namespace Biface
