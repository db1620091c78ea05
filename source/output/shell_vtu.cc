// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/input/entry_declarations.h>
#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/equations/shell_equations.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/placed_body.h>
#include <biface/output/ply_results.h>
#include <biface/output/shell_vtu.h>
#include <biface/stepping/step_report.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    dataset_names(const Layup &layup, const bool moves, const bool rolls)
    {
      std::vector<std::string> names{"displacement",
                                     "displacement",
                                     "displacement",
                                     "contact_pressure",
                                     "active",
                                     "outer_face",
                                     "H_11",
                                     "H_22",
                                     "H_12",
                                     "H_13",
                                     "H_23",
                                     "H_33",
                                     "slipping",
                                     "friction",
                                     "friction",
                                     "friction"};
      names.insert(
        names.end(), FaceStress::names.begin(), FaceStress::names.end());
      if (layup.has_slack_cords())
        names.emplace_back("slack_cords");
      if (layup.n_layers() > 1)
        names.emplace_back("layer");
      if (moves)
        names.insert(names.end(), 3, "velocity");
      if (rolls)
        names.insert(names.end(), 3, "slip_velocity");
      return names;
    }
  } // namespace


  FacePatches::FacePatches(const ShellEquations            &equations,
                           const State                     &state,
                           const Loads                     &loads,
                           const std::vector<Tensor<1, 3>> &slip_velocities)
    : VertexPatches<2>(dataset_names(equations.mesh.get_layup(),
                                     state.velocity.size() > 0,
                                     !slip_velocities.empty()))
  {
    using namespace Resultants;

    const ShellMesh                     &mesh  = equations.mesh;
    const bool                           moves = (state.velocity.size() > 0);
    std::map<unsigned int, ContactState> zones;
    for (const auto &[number, body] : loads.bodies)
      zones[number] = contact_at_nodes(mesh, state, number, *body);
    for (const unsigned int c : mesh.layers)
      {
        const Cell &cell = mesh.cells[c];
        // whether nothing of the wall is beyond
        const bool is_last = (c + 1 == mesh.cells.size() ||
                              mesh.cells[c + 1].column != cell.column);
        const auto H =
          equations.internal_forces().total_resultants_at_vertices(state, c);
        const auto E =
          equations.internal_forces().strains_at_vertices(state, c);
        const auto slack =
          equations.internal_forces().slack_fractions(state, c);

        for (unsigned int face = 0; face < 2; ++face)
          {
            const bool is_outer = (is_last && face == outer);
            const bool is_face  = (is_outer || (cell.layer == 0 && face == 0));
            Patch      patch    = new_patch();
            for (unsigned int v = 0; v < 4; ++v)
              {
                const Node &node  = mesh.nodes[cell.nodes[v]];
                patch.vertices[v] = mesh.position_of_any_face(
                  state.displacement, node, cell.layer + face);
                const auto of_face = [&](const LA::Vector &vector) {
                  return node.surface.from_frame(mesh.displacement_of_any_face(
                    vector, node, cell.layer + face));
                };
                const Tensor<1, 3> u = of_face(state.displacement);

                unsigned int d = 0;
                for (unsigned int i = 0; i < 3; ++i)
                  patch.data(d++, v) = u[i];
                // of all bodies on this face
                double       pressure = 0;
                bool         active = false, slipping = false;
                Tensor<1, 3> friction;
                // between layers, nothing touches
                if (is_face)
                  for (const auto &[number, body] : loads.bodies)
                    if (body->face == (is_outer ? outer : inner))
                      {
                        const ContactState &zone = zones.at(number);
                        pressure += zone.pressure(cell.nodes[v]);
                        active = active || zone.active[cell.nodes[v]];
                        slipping =
                          slipping || slips(zone, body.get(), cell.nodes[v]);
                        friction +=
                          contact_traction(
                            zone, body.get(), cell.nodes[v], patch.vertices[v])
                            .friction;
                      }
                patch.data(d++, v) = pressure;
                patch.data(d++, v) = active;
                patch.data(d++, v) = is_outer;
                for (unsigned int ab = 0; ab < 3; ++ab)
                  patch.data(d++, v) = H[v][tangential(ab, face)];
                for (unsigned int a = 0; a < 2; ++a)
                  patch.data(d++, v) = H[v][transverse(a, face)];
                patch.data(d++, v) = H[v][thickness];
                patch.data(d++, v) = slipping;
                for (unsigned int i = 0; i < 3; ++i)
                  patch.data(d++, v) = friction[i];
                for (const double stress :
                     FaceStress(*mesh.strips[cell.strip].at_vertices[v],
                                static_cast<Face>(face),
                                E[v])
                       .values())
                  patch.data(d++, v) = stress;
                if (mesh.get_layup().has_slack_cords())
                  patch.data(d++, v) = slack[v];
                if (mesh.n_layers() > 1)
                  patch.data(d++, v) = cell.layer + 1;
                if (moves)
                  {
                    const Tensor<1, 3> velocity = of_face(state.velocity);
                    for (unsigned int i = 0; i < 3; ++i)
                      patch.data(d++, v) = velocity[i];
                  }
                if (!slip_velocities.empty())
                  for (unsigned int i = 0; i < 3; ++i)
                    patch.data(d++, v) =
                      (is_outer ? slip_velocities[cell.nodes[v]][i] : 0.);
              }
            patches.push_back(patch);
          }
      }
  }


  void
  ShellVtu::Parameters::add_parameters(EntryDeclarations &prm)
  {
    prm.add_parameter("Write VTU",
                      write,
                      "Whether to write both faces for ParaView.",
                      Patterns::Bool());
  }


  ShellVtu::ShellVtu(const Parameters     &parameters,
                     ResultsDirectory     &directory,
                     const ShellEquations &equations)
    : VtuSeries("shell", parameters.write, directory, equations)
  {}


  void
  ShellVtu::write(const StepReport &report, const State &state)
  {
    write_patches<2>(std::make_unique<FacePatches>(
                       equations, state, *report.loads, report.slip_velocities),
                     report.step);
  }
} // namespace Biface
