// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_solver_linear_line_gauss_seidel_h
#define biface_solver_linear_line_gauss_seidel_h

#include <deal.II/lac/full_matrix.h>

#include <cstddef>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/model/mesh/coarse_spaces.h>

namespace Biface
{
  /**
   * Gauss-Seidel iterations that solve for all unknowns of a grid line at once,
   * by elimination of its nodes one after the other: the smoothers before and
   * after the coarser levels of multigrid. Lines along the short sides of the
   * cells make them independent of the aspect ratio, see make_nested_spaces().
   * Between ranks they are Jacobi iterations.
   *
   * The matrix is copied in single precision, in the order in which it is
   * needed, since the time is that of reading it.
   */
  class LineGaussSeidel
  {
  public:
    /** Copy a matrix and eliminate along its lines.
     * @param A,nodes kept by reference.
     * @return whether no line has a singular matrix. */
    bool
    initialize(const LA::SparseMatrix &A, const GridLineNodes &nodes);

    /** A sweep from the first line to the last one that starts from zero.
     * @param residual @f$b-Ax@f$ after it. */
    void
    forward_from_zero(LA::Vector       &x,
                      LA::Vector       &residual,
                      const LA::Vector &b) const;

    /** A sweep from the last line to the first one. */
    void
    backward(LA::Vector &x, const LA::Vector &b) const;

  private:
    /** The place of an unknown: its node, and its number among the unknowns of
     * the node. */
    struct Place
    {
      unsigned int node, unknown;
    };

    /** The matrices that couple a node with itself and its neighbors on the
     * line; empty where there is no neighbor. */
    struct Coupling
    {
      dealii::FullMatrix<double> own, before, next;
    };

    /** Append the blocks of the node @p n, which belongs to the line from
     * @p begin to @p end.
     * @param places of all rows of this rank.
     * @param position for each node, of its block among those of @p n; for the
     * time of this function. */
    Coupling
    copy_blocks(const unsigned int         n,
                const unsigned int         begin,
                const unsigned int         end,
                const std::vector<Place>  &places,
                std::vector<unsigned int> &position);

    /** Subtract the products of the blocks from @p first to @p last of the node
     * @p n.
     * @param values,rest @p n_max for each node. */
    void
    subtract_blocks(const unsigned int        n,
                    const std::size_t         first,
                    const std::size_t         last,
                    const std::vector<float> &values,
                    std::vector<float>       &rest) const;

    /** Solve for the unknowns of a line, whose right hand side is replaced.
     * @param values @p n_max for each node. */
    void
    solve_line(const unsigned int  line,
               std::vector<float> &right_hand_side,
               std::vector<float> &values) const;

    /** Subtract the product of the matrix with the unknowns of other ranks.
     * @param rest @p n_max for each node. */
    void
    subtract_others(const LA::Vector &x, std::vector<float> &rest) const;

    /** The entries of a vector in single precision, @p n_max for each node. */
    std::vector<float>
    by_nodes(const LA::Vector &x) const;

    void
    from_nodes(const std::vector<float> &values, LA::Vector &x) const;

    const LA::SparseMatrix *matrix = nullptr;
    const GridLineNodes    *nodes  = nullptr;

    /** The largest number of unknowns of a node. All blocks have as many rows
     * and columns; those of nodes with fewer unknowns are padded with zeros. */
    unsigned int n_max      = 0;
    std::size_t  block_size = 0;

    /** The blocks that couple a node of this rank with others than its
     * neighbors on the line, each by columns, and the node of each block. The
     * blocks of the node @p n with earlier lines start at number @p lower[n],
     * all others at @p upper[n]. */
    std::vector<float>        blocks;
    std::vector<unsigned int> columns;
    std::vector<std::size_t>  lower, upper;

    /** The factors of the elimination along each line: the inverse after
     * elimination of the previous nodes, the block with the previous node, and
     * the product of the inverse of that node with the opposite block. */
    enum class Factor
    {
      inverse,
      before,
      back
    };
    static constexpr unsigned int n_factors = 3;
    /** The factors of all nodes, node by node: three blocks each, in the order
     * of Factor. */
    std::vector<float> factors;

    float *
    factor(const unsigned int node, const Factor factor)
    {
      return &factors[(n_factors * node + static_cast<unsigned int>(factor)) *
                      block_size];
    }

    const float *
    factor(const unsigned int node, const Factor factor) const
    {
      return &factors[(n_factors * node + static_cast<unsigned int>(factor)) *
                      block_size];
    }
  };
} // namespace Biface

#endif
