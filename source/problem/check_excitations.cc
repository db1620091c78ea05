// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/problem/check_excitations.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** For each direction, whether the shell is a part with a plane of symmetry
     * that is not parallel to it. */
    std::array<bool, 3>
    across_symmetry(const Parameters &parameters, const ShellMesh &mesh)
    {
      std::array<double, 3> largest{};
      for (const BoundarySegment &segment : mesh.boundary)
        for (unsigned int edge = 0; edge < 4; ++edge)
          if (mesh.grid.has_lines() && segment.is_on(static_cast<Edge>(edge)) &&
              parameters.supports.is_symmetric(edge))
            for (unsigned int d = 0; d < 3; ++d)
              largest[d] = std::max(
                largest[d],
                std::abs(
                  mesh.nodes[segment.nodes[0]].surface.frame[edge / 2][d]));
      std::array<bool, 3> result{};
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = !mesh.symmetry_planes[d].empty() ||
                    Utilities::MPI::max(largest[d], mesh.communicator) > 1e-6;
      return result;
    }
  } // namespace


  void
  check_excitations(const Parameters &parameters, const ShellMesh &mesh)
  {
    const std::array<bool, 3> crosses = across_symmetry(parameters, mesh);
    for (unsigned int i = 0; i < parameters.stages.size(); ++i)
      for (const std::string &excitation : parameters.stages[i].excitations)
        {
          const auto motion =
            StageResponse::motion(excitation, parameters.stages[i]);
          if (!motion)
            continue;
          const auto refuse = [&](const bool wrong, const std::string &why) {
            if (wrong)
              throw InputError("Stage " + std::to_string(i + 1) +
                                 "/Excitations",
                               excitation,
                               why);
          };
          refuse(parameters.supports.is_cyclic() &&
                   std::abs(mesh.get_surface().axis()[motion->second]) <
                     1 - 1e-9,
                 "a sector with cyclic edges can only move along its axis");
          refuse(crosses[motion->second],
                 "a part of a shell cannot move across its plane of symmetry");
          refuse(motion->first == "supports" && mesh.supported.bodies.empty(),
                 "there are no supports");
        }
  }
} // namespace Biface
