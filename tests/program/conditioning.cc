// SPDX-License-Identifier: LGPL-2.1-or-later

// The condition number of the tangent of a clamped plate grows as (L/h)^2 in
// the mean and half the difference of the displacements of the faces, as for
// any shell with shear, and as (L/h)^4 in the displacements of the faces
// themselves. Rows and columns are scaled to a diagonal of one.

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>
#include <iomanip>

#include <biface/stepping/step_report.h>

#include "../run_analysis.h"
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  double
  condition_number(const FullMatrix<double> &K)
  {
    LAPACKFullMatrix<double> scaled(K.m(), K.m());
    for (unsigned int i = 0; i < K.m(); ++i)
      for (unsigned int j = 0; j < K.m(); ++j)
        scaled(i, j) = K(i, j) / std::sqrt(K(i, i) * K(j, j));
    Vector<double>           eigenvalues;
    LAPACKFullMatrix<double> eigenvectors(K.m(), K.m());
    scaled.compute_eigenvalues();
    double least = 1e300, largest = 0;
    for (unsigned int i = 0; i < K.m(); ++i)
      {
        least   = std::min(least, std::abs(scaled.eigenvalue(i)));
        largest = std::max(largest, std::abs(scaled.eigenvalue(i)));
      }
    return largest / least;
  }


  /** The condition numbers of the stiffness of a plate of side 1 with a given
   * thickness, in the unknowns of the program and in the displacements of the
   * faces. */
  std::array<double, 2>
  condition_numbers(const std::string &thickness)
  {
    std::array<double, 2> result{};
    run_analysis(
      DATA_DIR "/../verification/clamped_plate.prm",
      {"Laminate/Plies=plate: " + thickness + " @ 0",
       "Mesh/Intervals alpha_1=0:0.5:6",
       "Mesh/Intervals alpha_2=0:0.5:6"},
      [&](const ShellEquations &equations, const StepReport &, const State &) {
        std::vector<types::global_dof_index> free;
        for (types::global_dof_index i = 0;
             i < equations.mesh.locally_owned.size();
             ++i)
          if (!equations.mesh.constraints.is_constrained(i))
            free.push_back(i);
        const unsigned int n = free.size();
        FullMatrix<double> K(n), T(n), KT(n), faces(n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            K(i, j) = equations.tangent().el(free[i], free[j]);
        // supports leave both unknowns of a component free, or none
        for (unsigned int i = 0; i < n; i += 2)
          {
            AssertThrow(free[i] % 2 == 0 && free[i + 1] == free[i] + 1,
                        ExcInternalError());
            T(i, i) = T(i, i + 1) = T(i + 1, i + 1) = 0.5;
            T(i + 1, i)                             = -0.5;
          }
        K.mmult(KT, T);
        T.Tmmult(faces, KT);
        result = {{condition_number(K), condition_number(faces)}};
      });
    return result;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                       thick = condition_numbers("1e-2"),
             thin                        = condition_numbers("1e-3");
  check_range("growth in means and differences, from h = 1e-2 to 1e-3",
              thin[0] / thick[0],
              80,
              120);
  check_range(
    "growth in displacements of the faces", thin[1] / thick[1], 5e3, 2e4);
  if (argc > 1)
    for (const std::string h : {"1e-1", "1e-2", "1e-3", "1e-4", "1e-5"})
      {
        const auto numbers = condition_numbers(h);
        std::cout << "| " << h << " | " << std::setprecision(2) << numbers[1]
                  << " | " << numbers[0] << " |" << std::endl;
      }
}
