// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_model_displacement_of_point_h
#define biface_tests_model_displacement_of_point_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

#include "../run_analysis.h"

/** The displacement of the middle at a named point at the end of a run, on all
 * ranks. */
inline dealii::Tensor<1, 3>
displacement_of_point(const std::string                   &file,
                      const std::string                   &point,
                      const std::vector<Biface::Override> &overrides)
{
  dealii::Tensor<1, 3> result;
  run_analysis(file,
               overrides,
               [&](const Biface::ShellEquations &equations,
                   const Biface::StepReport &,
                   const Biface::State &state) {
                 const Biface::ShellMesh &mesh = equations.mesh;
                 const unsigned int       n = mesh.node_of_point("test", point);
                 dealii::Tensor<1, 3>     u;
                 if (n < mesh.nodes.size() && mesh.nodes[n].locally_owned)
                   for (const unsigned int face : {0, 1})
                     u += mesh.nodes[n].surface.from_frame(mesh.displacement(
                            state.displacement, mesh.nodes[n], face)) /
                          2;
                 for (unsigned int d = 0; d < 3; ++d)
                   result[d] =
                     dealii::Utilities::MPI::sum(u[d], MPI_COMM_WORLD);
               });
  return result;
}

#endif
