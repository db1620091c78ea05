// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/model/equations/shell_equations.h>
#include <biface/model/quantities/point_displacement.h>
#include <biface/model/state/loads.h>
#include <biface/model/time/inertia.h>
#include <biface/output/csv.h>
#include <biface/output/probes_file.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  ProbesFile::ProbesFile(ResultsDirectory     &directory,
                         const ShellEquations &equations)
    : StepTable(
        "probes.csv",
        std::string("step,stage,load_factor,name,face,u_x,u_y,u_z,"
                    "u_1,u_2,u_3") +
          (Inertia::is_among(equations.get_terms()) ? ",v_x,v_y,v_z" : ""),
        (2 + equations.mesh.n_layers()) * equations.mesh.points.size(),
        directory,
        equations)
    , with_velocities(Inertia::is_among(equations.get_terms()))
  {}


  bool
  ProbesFile::is_wanted() const
  {
    return !equations.mesh.points.empty();
  }


  void
  ProbesFile::write(const StepReport &report, const State &state)
  {
    std::string lines;
    for (const NamedPoint &point : equations.mesh.points)
      {
        const PointDisplacement u =
          displacement_at(point, state.displacement, equations.mesh);
        std::vector<std::vector<Tensor<1, 3>>> vectors = {u.global, u.local};
        const bool moves = (state.velocity.size() > 0);
        if (moves)
          vectors.push_back(
            displacement_at(point, state.velocity, equations.mesh).global);
        const auto add = [&](const std::string         &face,
                             const std::vector<double> &shares) {
          lines += std::to_string(report.step) + ',' + report.stage + ',' +
                   csv_number(report.loads->factors[0]) + ',' + point.name +
                   ',' + face;
          for (const auto &faces : vectors)
            {
              Tensor<1, 3> value;
              for (unsigned int k = 0; k < shares.size(); ++k)
                value += shares[k] * faces[k];
              for (unsigned int i = 0; i < 3; ++i)
                lines += ',' + csv_number(value[i]);
            }
          // a shell at rest has no motion: its fields stay empty
          if (with_velocities && !moves)
            lines += ",,,";
          lines += '\n';
        };
        add("inner", {1});
        add("outer", {0, 1});
        add("middle", {0.5, 0.5});
        for (unsigned int face = 1; face < equations.mesh.n_layers(); ++face)
          {
            // the faces between layers come after the inner and the outer one
            std::vector<double> shares(face + 2);
            shares.back() = 1;
            add("face_" + std::to_string(face), shares);
          }
      }
    append(lines);
  }
} // namespace Biface
