// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <utility>

#include <biface/model/equations/shell_equations.h>
#include <biface/output/csv.h>
#include <biface/output/mode_vtu.h>
#include <biface/solver/modal_analysis.h>
#include <biface/stepping/buckling.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    names_of_data(const unsigned int n_parts)
    {
      std::vector<std::string> names(3, "mode");
      if (n_parts > 1)
        names.resize(6, "mode_imaginary");
      names.push_back("outer_face");
      return names;
    }
  } // namespace


  ModePatches::ModePatches(const ShellMesh                       &mesh,
                           const LA::Vector                      &displacement,
                           const std::vector<const LA::Vector *> &shape)
    : VertexPatches<2>(names_of_data(shape.size()))
  {
    for (const Cell &cell : mesh.wall_elements())
      for (unsigned int face = 0; face <= mesh.n_layers(); ++face)
        {
          Patch patch = new_patch();
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Node &node = mesh.nodes[cell.nodes[v]];
              // modes are motions about the deformed shell
              patch.vertices[v] =
                mesh.position_of_any_face(displacement, node, face);
              for (unsigned int part = 0; part < shape.size(); ++part)
                {
                  const Tensor<1, 3> u = node.surface.from_frame(
                    mesh.displacement_of_any_face(*shape[part], node, face));
                  for (unsigned int i = 0; i < 3; ++i)
                    patch.data(3 * part + i, v) = u[i];
                }
              patch.data(3 * shape.size(), v) = face;
            }
          patches.push_back(patch);
        }
  }


  ShapesVtu::ShapesVtu(const std::string    &name,
                       const bool            wanted,
                       ResultsDirectory     &directory,
                       const ShellEquations &equations)
    : ParaViewFiles(name + "-*.pvd", wanted, directory, equations), prefix(name)
  {}


  void
  ShapesVtu::write_shapes(
    const unsigned int                                  step,
    const State                                        &state,
    const std::vector<std::vector<const LA::Vector *>> &shapes)
  {
    std::vector<std::pair<double, std::string>> times_and_names;
    for (unsigned int i = 0; i < shapes.size(); ++i)
      {
        const std::string file = prefix + "-" +
                                 Utilities::int_to_string(step, 4) + "-" +
                                 Utilities::int_to_string(i + 1, 3) + ".vtu";
        ModePatches patches(equations.mesh, state.displacement, shapes[i]);
        write_texts_of_ranks(
          directory.path(file),
          vtu_of_rank(patches,
                      i + 1,
                      directory.units,
                      Utilities::MPI::this_mpi_process(communicator),
                      Utilities::MPI::n_mpi_processes(communicator)),
          communicator);
        times_and_names.emplace_back(i + 1, file);
      }
    write_list(path(step), times_and_names);
  }


  ModeVtu::ModeVtu(const ShellVtu::Parameters &parameters,
                   const std::vector<Stage>   &stages,
                   ResultsDirectory           &directory,
                   const ShellEquations       &equations)
    : ShapesVtu(
        "modes", parameters.write && any_modes(stages), directory, equations)
  {}


  void
  ModeVtu::write(const StepReport &report, const State &state)
  {
    std::vector<std::vector<const LA::Vector *>> shapes;
    for (const VibrationMode &mode : report.modes->modes)
      {
        shapes.push_back({&mode.shape});
        if (mode.imaginary.size() > 0)
          shapes.back().push_back(&mode.imaginary);
      }
    write_shapes(report.step, state, shapes);
  }


  BucklingVtu::BucklingVtu(const ShellVtu::Parameters &parameters,
                           const std::vector<Stage>   &stages,
                           ResultsDirectory           &directory,
                           const ShellEquations       &equations)
    : ShapesVtu("buckling",
                parameters.write && any_buckling(stages),
                directory,
                equations)
  {}


  void
  BucklingVtu::write(const StepReport &report, const State &state)
  {
    std::vector<std::vector<const LA::Vector *>> shapes;
    for (const BucklingMode &mode : report.buckling->modes)
      shapes.push_back({&mode.shape});
    write_shapes(report.step, state, shapes);
  }
} // namespace Biface
