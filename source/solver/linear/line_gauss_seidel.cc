// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/full_matrix.h>

#include <Epetra_Import.h>

#include <algorithm>
#include <limits>

#include <biface/solver/linear/line_gauss_seidel.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_max = 6;

    using Block = std::array<float, n_max * n_max>;


    inline void
    add_product(const Block &block, const float *x, float *y)
    {
      for (unsigned int j = 0; j < n_max; ++j)
        for (unsigned int i = 0; i < n_max; ++i)
          y[i] += block[n_max * j + i] * x[j];
    }


    inline void
    subtract_product(const Block &block, const float *x, float *y)
    {
      for (unsigned int j = 0; j < n_max; ++j)
        for (unsigned int i = 0; i < n_max; ++i)
          y[i] -= block[n_max * j + i] * x[j];
    }


    Block
    in_single_precision(const FullMatrix<double> &matrix)
    {
      Block block{};
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          block[n_max * j + i] = matrix(i, j);
      return block;
    }
  } // namespace


  bool
  LineGaussSeidel::initialize(const LA::SparseMatrix &A,
                              const GridLineNodes    &nodes)
  {
    matrix      = &A;
    this->nodes = &nodes;

    const unsigned int n_nodes = nodes.n_nodes();
    factors.assign(n_nodes, Factors());
    inverses.resize(n_nodes);
    largest_diagonals.assign(n_nodes, 0);
    blocks.clear();
    columns.clear();
    lower.assign(1, 0);
    upper.clear();

    // local columns start with the local rows, in the same order
    struct Place
    {
      unsigned int node, unknown;
    };
    std::vector<Place>        places(nodes.rows.size());
    std::vector<unsigned int> line_of(n_nodes);
    for (unsigned int l = 0; l + 1 < nodes.line_begin.size(); ++l)
      for (unsigned int n = nodes.line_begin[l]; n < nodes.line_begin[l + 1];
           ++n)
        {
          line_of[n] = l;
          for (unsigned int k = nodes.begin[n]; k < nodes.begin[n + 1]; ++k)
            places[nodes.rows[k]] = {n, k - nodes.begin[n]};
        }

    const Epetra_CrsMatrix   &epetra = A.trilinos_matrix();
    constexpr unsigned int    none   = std::numeric_limits<unsigned int>::max();
    std::vector<unsigned int> neighbors, position(n_nodes, none);
    // of the node before, after elimination
    FullMatrix<double> inverse_before, next_from_before;
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const auto size = [&](const unsigned int m) {
          return nodes.begin[m + 1] - nodes.begin[m];
        };
        AssertIndexRange(size(n), n_max + 1);
        const auto on_line = [&](const unsigned int m) {
          return line_of[m] == line_of[n] &&
                 (m == n || m + 1 == n || m == n + 1);
        };
        const auto for_each_entry = [&](const auto &action) {
          for (unsigned int i = 0; i < size(n); ++i)
            {
              int     n_entries;
              double *values;
              int    *local;
              epetra.ExtractMyRowView(
                nodes.rows[nodes.begin[n] + i], n_entries, values, local);
              for (int k = 0; k < n_entries; ++k)
                if (static_cast<std::size_t>(local[k]) < places.size())
                  action(i, places[local[k]], values[k]);
            }
        };

        neighbors.clear();
        for_each_entry([&](const unsigned int, const Place &place, double) {
          if (!on_line(place.node) && position[place.node] == none)
            {
              position[place.node] = 0;
              neighbors.push_back(place.node);
            }
        });
        std::sort(neighbors.begin(), neighbors.end());
        std::stable_partition(
          neighbors.begin(), neighbors.end(), [&](const unsigned int m) {
            return line_of[m] < line_of[n];
          });
        upper.push_back(lower.back());
        for (const unsigned int m : neighbors)
          {
            upper.back() += (line_of[m] < line_of[n]);
            position[m] = columns.size();
            columns.push_back(m);
          }
        blocks.resize(columns.size(), Block());
        lower.push_back(columns.size());

        const auto couples = [&](const unsigned int m) {
          return m < n_nodes && on_line(m) && size(m) > 0 && size(n) > 0;
        };
        const bool         follows = (n > 0 && couples(n - 1));
        const bool         goes_on = couples(n + 1);
        FullMatrix<double> own(size(n), size(n)),
          before(follows ? size(n) : 0, follows ? size(n - 1) : 0),
          next(goes_on ? size(n) : 0, goes_on ? size(n + 1) : 0);
        for_each_entry(
          [&](const unsigned int i, const Place &place, const double value) {
            if (place.node == n)
              own(i, place.unknown) = value;
            else if (!on_line(place.node))
              blocks[position[place.node]][n_max * place.unknown + i] = value;
            else if (place.node < n)
              before(i, place.unknown) = value;
            else
              next(i, place.unknown) = value;
          });
        for (const unsigned int m : neighbors)
          position[m] = none;
        for (unsigned int i = 0; i < size(n); ++i)
          largest_diagonals[n] = std::max(largest_diagonals[n], own(i, i));

        try
          {
            FullMatrix<double> inverse(own);
            if (size(n) > 0)
              inverse.gauss_jordan();
            inverses[n] = in_single_precision(inverse);
            if (follows)
              {
                FullMatrix<double> back(size(n - 1), size(n));
                inverse_before.mmult(back, next_from_before);
                factors[n].back   = in_single_precision(back);
                factors[n].before = in_single_precision(before);
                FullMatrix<double> change(size(n), size(n));
                before.mmult(change, back);
                own.add(-1, change);
              }
            if (size(n) > 0)
              own.gauss_jordan();
          }
        catch (const ExceptionBase &)
          {
            return false;
          }
        factors[n].inverse = in_single_precision(own);
        inverse_before     = own;
        next_from_before   = next;
      }
    return true;
  }


  std::array<double, 6>
  LineGaussSeidel::solve_node(const unsigned int           n,
                              const std::array<double, 6> &b) const
  {
    std::array<double, 6> x{};
    for (unsigned int i = 0; i < n_max; ++i)
      for (unsigned int j = 0; j < n_max; ++j)
        x[i] += inverses[n][n_max * j + i] * b[j];
    return x;
  }


  void
  LineGaussSeidel::solve_line(const unsigned int  line,
                              std::vector<float> &right_hand_side,
                              std::vector<float> &values) const
  {
    const unsigned int begin = nodes->line_begin[line],
                       end   = nodes->line_begin[line + 1];
    for (unsigned int n = begin; n < end; ++n)
      {
        float *x = &values[n_max * n], *r = &right_hand_side[n_max * n];
        if (n > begin)
          subtract_product(factors[n].before, x - n_max, r);
        std::fill_n(x, n_max, 0.f);
        add_product(factors[n].inverse, r, x);
      }
    for (unsigned int n = end; n-- > begin + 1;)
      subtract_product(
        factors[n].back, &values[n_max * n], &values[n_max * (n - 1)]);
  }


  void
  LineGaussSeidel::forward_from_zero(LA::Vector       &x,
                                     LA::Vector       &residual,
                                     const LA::Vector &b) const
  {
    const unsigned int n_nodes = nodes->n_nodes();
    std::vector<float> values(n_max * n_nodes), rest = by_nodes(b);
    for (unsigned int l = 0; l + 1 < nodes->line_begin.size(); ++l)
      {
        for (unsigned int n = nodes->line_begin[l];
             n < nodes->line_begin[l + 1];
             ++n)
          for (std::size_t k = lower[n]; k < upper[n]; ++k)
            subtract_product(
              blocks[k], &values[n_max * columns[k]], &rest[n_max * n]);
        solve_line(l, rest, values);
      }
    from_nodes(values, x);

    // at each node, what later lines have added since
    std::fill(rest.begin(), rest.end(), 0.f);
    for (unsigned int n = 0; n < n_nodes; ++n)
      for (std::size_t k = upper[n]; k < lower[n + 1]; ++k)
        subtract_product(
          blocks[k], &values[n_max * columns[k]], &rest[n_max * n]);
    subtract_others(x, rest);
    from_nodes(rest, residual);
  }


  void
  LineGaussSeidel::backward(LA::Vector &x, const LA::Vector &b) const
  {
    std::vector<float> values = by_nodes(x), rest = by_nodes(b);
    subtract_others(x, rest);
    for (unsigned int l = nodes->line_begin.size() - 1; l-- > 0;)
      {
        for (unsigned int n = nodes->line_begin[l];
             n < nodes->line_begin[l + 1];
             ++n)
          for (std::size_t k = lower[n]; k < lower[n + 1]; ++k)
            subtract_product(
              blocks[k], &values[n_max * columns[k]], &rest[n_max * n]);
        solve_line(l, rest, values);
      }
    from_nodes(values, x);
  }


  std::vector<float>
  LineGaussSeidel::by_nodes(const LA::Vector &x) const
  {
    std::vector<float> values(n_max * nodes->n_nodes());
    const double      *entries = x.begin();
    for (unsigned int n = 0; n < nodes->n_nodes(); ++n)
      for (unsigned int k = nodes->begin[n]; k < nodes->begin[n + 1]; ++k)
        values[n_max * n + k - nodes->begin[n]] = entries[nodes->rows[k]];
    return values;
  }


  void
  LineGaussSeidel::from_nodes(const std::vector<float> &values,
                              LA::Vector               &x) const
  {
    double *entries = x.begin();
    for (unsigned int n = 0; n < nodes->n_nodes(); ++n)
      for (unsigned int k = nodes->begin[n]; k < nodes->begin[n + 1]; ++k)
        entries[nodes->rows[k]] = values[n_max * n + k - nodes->begin[n]];
  }


  void
  LineGaussSeidel::subtract_others(const LA::Vector   &x,
                                   std::vector<float> &rest) const
  {
    const Epetra_CrsMatrix &A = matrix->trilinos_matrix();
    if (A.Importer() == nullptr)
      return;
    Epetra_Vector at_columns(A.ColMap());
    at_columns.Import(*x.trilinos_vector()(0), *A.Importer(), Insert);

    const int n_own = x.locally_owned_size();
    for (unsigned int n = 0; n < nodes->n_nodes(); ++n)
      for (unsigned int k = nodes->begin[n]; k < nodes->begin[n + 1]; ++k)
        {
          int     n_entries;
          double *values;
          int    *local;
          A.ExtractMyRowView(nodes->rows[k], n_entries, values, local);
          double sum = 0;
          for (int e = 0; e < n_entries; ++e)
            if (local[e] >= n_own)
              sum += values[e] * at_columns[local[e]];
          rest[n_max * n + k - nodes->begin[n]] -= sum;
        }
  }
} // namespace Biface
