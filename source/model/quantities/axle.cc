// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <string>

#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/quantities/axle.h>
#include <biface/model/state/loads.h>

namespace Biface
{
  using namespace dealii;

  Tensor<1, 3>
  displacement_of_axle(const ShellMesh           &mesh,
                       const std::vector<double> &factors)
  {
    Tensor<1, 3> sum;
    for (const SupportMotion &motion : mesh.supported.motions)
      if (motion.kind == SupportMotion::Kind::translation)
        sum +=
          factor_at(factors, motion.factor) * motion.amount * motion.direction;
    const auto        &bodies = mesh.supported.bodies;
    const unsigned int n_edges =
      std::count_if(bodies.begin(), bodies.end(), [](const std::string &name) {
        return name == "alpha_1 min" || name == "alpha_1 max";
      });
    return n_edges > 0 ? sum / n_edges : Tensor<1, 3>();
  }


  Tensor<1, 3>
  displacement_of_axle(const ShellMesh &mesh, const Loads &loads)
  {
    std::vector<double> factors;
    for (unsigned int i = 0; i < loads.factors.size(); ++i)
      factors.push_back(loads.factors[i] -
                        factor_at(loads.factors_of_shape, i));
    return displacement_of_axle(mesh, factors);
  }
} // namespace Biface
