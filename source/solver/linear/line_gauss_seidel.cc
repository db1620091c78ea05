// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Epetra_Import.h>

#include <algorithm>
#include <utility>

#include <biface/solver/linear/line_gauss_seidel.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int not_a_neighbor = numbers::invalid_unsigned_int;


    inline void
    add_columns(const float       *block,
                const float       *x,
                const float        factor,
                float             *y,
                const unsigned int n)
    {
      for (unsigned int j = 0; j < n; ++j)
        {
          const float part = factor * x[j];
          for (unsigned int i = 0; i < n; ++i)
            y[i] += block[n * j + i] * part;
        }
    }


    /** y += factor block x, with a block of @p n rows. */
    inline void
    add_product(const float       *block,
                const float       *x,
                const float        factor,
                float             *y,
                const unsigned int n)
    {
      // a length known to the compiler in the most frequent case
      if (n == 6)
        add_columns(block, x, factor, y, 6);
      else
        add_columns(block, x, factor, y, n);
    }


    /** @param block by columns. */
    void
    in_single_precision(const FullMatrix<double> &matrix,
                        float                    *block,
                        const unsigned int        n)
    {
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          block[n * j + i] = matrix(i, j);
    }
  } // namespace


  bool
  LineGaussSeidel::initialize(const LA::SparseMatrix &A,
                              const GridLineNodes    &nodes)
  {
    matrix      = &A;
    this->nodes = &nodes;

    const unsigned int n_nodes = nodes.n_nodes();
    n_max                      = 0;
    for (unsigned int n = 0; n < n_nodes; ++n)
      n_max = std::max(n_max, nodes.begin[n + 1] - nodes.begin[n]);
    block_size = static_cast<std::size_t>(n_max) * n_max;
    factors.assign(n_factors * block_size * n_nodes, 0.f);
    blocks.clear();
    columns.clear();
    lower.assign(1, 0);
    upper.clear();

    std::vector<Place> places(nodes.rows.size());
    for (unsigned int n = 0; n < n_nodes; ++n)
      for (unsigned int k = nodes.begin[n]; k < nodes.begin[n + 1]; ++k)
        places[nodes.rows[k]] = {n, k - nodes.begin[n]};

    std::vector<unsigned int> position(n_nodes, not_a_neighbor);
    for (unsigned int l = 0; l + 1 < nodes.line_begin.size(); ++l)
      {
        const unsigned int begin = nodes.line_begin[l],
                           end   = nodes.line_begin[l + 1];
        // factors of the previous node, after elimination
        FullMatrix<double> inverse, next;
        for (unsigned int n = begin; n < end; ++n)
          {
            Coupling coupling = copy_blocks(n, begin, end, places, position);
            if (!coupling.before.empty())
              {
                FullMatrix<double> back(next.m(), next.n());
                inverse.mmult(back, next);
                in_single_precision(back, factor(n, Factor::back), n_max);
                in_single_precision(
                  coupling.before, factor(n, Factor::before), n_max);
                FullMatrix<double> change(coupling.own.m(), coupling.own.n());
                coupling.before.mmult(change, back);
                coupling.own.add(-1, change);
              }
            if (!invert(coupling.own))
              return false;
            in_single_precision(
              coupling.own, factor(n, Factor::inverse), n_max);
            inverse = std::move(coupling.own);
            next    = std::move(coupling.next);
          }
      }
    return true;
  }


  LineGaussSeidel::Coupling
  LineGaussSeidel::copy_blocks(const unsigned int         n,
                               const unsigned int         begin,
                               const unsigned int         end,
                               const std::vector<Place>  &places,
                               std::vector<unsigned int> &position)
  {
    const auto size = [&](const unsigned int m) {
      return nodes->begin[m + 1] - nodes->begin[m];
    };
    const auto on_line = [&](const unsigned int m) {
      return m >= begin && m < end && (m == n || m + 1 == n || m == n + 1);
    };
    const Epetra_CrsMatrix &A              = matrix->trilinos_matrix();
    const auto              for_each_entry = [&](const auto &action) {
      for (unsigned int i = 0; i < size(n); ++i)
        {
          int     n_entries;
          double *values;
          int    *local;
          A.ExtractMyRowView(
            nodes->rows[nodes->begin[n] + i], n_entries, values, local);
          // local columns start with the local rows, in the same order
          for (int k = 0; k < n_entries; ++k)
            if (static_cast<std::size_t>(local[k]) < places.size())
              action(i, places[local[k]], values[k]);
        }
    };
    for_each_entry([&](const unsigned int, const Place &place, double) {
      if (!on_line(place.node) && position[place.node] == not_a_neighbor)
        {
          position[place.node] = 0;
          columns.push_back(place.node);
        }
    });
    const auto first = columns.begin() + lower.back();
    // earlier lines first, which the forward sweep reads alone
    std::sort(first, columns.end());
    upper.push_back(std::lower_bound(first, columns.end(), begin) -
                    columns.begin());
    for (std::size_t k = lower.back(); k < columns.size(); ++k)
      position[columns[k]] = k;
    lower.push_back(columns.size());
    blocks.resize(block_size * columns.size(), 0.f);

    const auto coupling_with = [&](const unsigned int m, const bool exists) {
      return exists && size(m) > 0 && size(n) > 0
               ? FullMatrix<double>(size(n), size(m))
               : FullMatrix<double>();
    };
    Coupling coupling{coupling_with(n, true),
                      coupling_with(n - 1, n > begin),
                      coupling_with(n + 1, n + 1 < end)};
    for_each_entry([&](const unsigned int i,
                       const Place       &place,
                       const double       value) {
      if (place.node == n)
        coupling.own(i, place.unknown) = value;
      else if (!on_line(place.node))
        blocks[block_size * position[place.node] + n_max * place.unknown + i] =
          value;
      else if (place.node < n)
        coupling.before(i, place.unknown) = value;
      else
        coupling.next(i, place.unknown) = value;
    });
    for (std::size_t k = lower[n]; k < lower[n + 1]; ++k)
      position[columns[k]] = not_a_neighbor;
    return coupling;
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
          add_product(factor(n, Factor::before), x - n_max, -1, r, n_max);
        std::fill_n(x, n_max, 0.f);
        add_product(factor(n, Factor::inverse), r, 1, x, n_max);
      }
    for (unsigned int n = end; n-- > begin + 1;)
      add_product(factor(n, Factor::back),
                  &values[n_max * n],
                  -1,
                  &values[n_max * (n - 1)],
                  n_max);
  }


  void
  LineGaussSeidel::subtract_blocks(const unsigned int        n,
                                   const std::size_t         first,
                                   const std::size_t         last,
                                   const std::vector<float> &values,
                                   std::vector<float>       &rest) const
  {
    for (std::size_t k = first; k < last; ++k)
      add_product(&blocks[block_size * k],
                  &values[n_max * columns[k]],
                  -1,
                  &rest[n_max * n],
                  n_max);
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
          subtract_blocks(n, lower[n], upper[n], values, rest);
        solve_line(l, rest, values);
      }
    from_nodes(values, x);

    // at each node, what later lines have added since
    std::fill(rest.begin(), rest.end(), 0.f);
    for (unsigned int n = 0; n < n_nodes; ++n)
      subtract_blocks(n, upper[n], lower[n + 1], values, rest);
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
          subtract_blocks(n, lower[n], lower[n + 1], values, rest);
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
          // the columns of other ranks come after the own ones
          for (int e = 0; e < n_entries; ++e)
            if (local[e] >= n_own)
              sum += values[e] * at_columns[local[e]];
          rest[n_max * n + k - nodes->begin[n]] -= sum;
        }
  }
} // namespace Biface
