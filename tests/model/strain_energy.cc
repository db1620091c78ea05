// SPDX-License-Identifier: LGPL-2.1-or-later

// The residual of an unloaded, prestressed shell is minus the derivative of its
// strain energy, with the nonlinear and with the linear theory; a dead pressure
// adds its work on the inner face.

#include <biface/laminate/layup.h>
#include <biface/model/contact/contact_interaction.h>
#include <biface/model/contact/contact_pair.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/strain_theory.h>

#include "coarse_torus.h"
#include <cord_ply.h>
#include <name_of.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The work of a unit pressure on the undeformed inner face, which is
   * bilinear in each cell; with the paper's formulation on the middle surface,
   * by the trapezoidal rule. */
  double
  work_of_pressure(const ShellMesh &mesh, const LA::Vector &displacement)
  {
    LA::Vector ghosted = mesh.ghosted_vector();
    ghosted            = displacement;
    double sum         = 0;
    for (const Cell &cell : mesh.cells)
      {
        std::array<Tensor<1, 3>, 4> x, v;
        for (unsigned int q = 0; q < 4; ++q)
          {
            const Node        &node = mesh.nodes[cell.nodes[q]];
            const Tensor<1, 3> components =
              mesh.displacement(ghosted, node, Resultants::inner);
            if (mesh.formulation == Formulation::paper)
              sum += cell.geometry.weight / 4 * components[2];
            x[q] = node.surface.position +
                   node.face_heights[Resultants::inner] * node.surface.frame[2];
            v[q] = node.surface.from_frame(components);
          }
        if (mesh.formulation == Formulation::paper)
          continue;
        for (const double s : {-1., 1.})
          for (const double t : {-1., 1.})
            {
              const double a = (1 + s / std::sqrt(3)) / 2,
                           b = (1 + t / std::sqrt(3)) / 2;
              const Tensor<1, 3> area =
                cross_product_3d((1 - b) * (x[1] - x[0]) + b * (x[3] - x[2]),
                                 (1 - a) * (x[2] - x[0]) + a * (x[3] - x[1]));
              sum += ((1 - b) * ((1 - a) * v[0] + a * v[1]) +
                      b * ((1 - a) * v[2] + a * v[3])) *
                     area / 4;
            }
      }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }


  void
  test(const std::string &name,
       const Formulation  formulation,
       const StrainTheory theory,
       const std::string &compression = "E_L")
  {
    Layup::Parameters parameters;
    parameters.initial_stresses =
      parse_ply_stresses("stresses", "2 0.1 0, 3 0 0.2, 0 0 0, -1 0.2 0.1");
    auto materials               = cord_ply();
    materials[0].E_L_compression = compression;
    const Layup layup(parameters, materials);
    const auto  mesh = coarse_torus(layup, formulation);

    const ContactInteraction contact(*mesh, ContactParameters());
    PressureLoad             pressure;
    pressure.kind = PressureKind::dead;
    ShellEquations equations(
      *mesh, make_force_terms(*mesh, contact, DeadLoads(), pressure));
    State state = at(equations, State(*mesh), some_displacement(*mesh, 0.2, 1));
    equations.internal_forces().take_as_prestress(state);
    state = at(equations, state, some_displacement(*mesh, 0.2, 2));
    InternalForces::set_theory(theory, state);
    if (theory == StrainTheory::linear)
      state = at(equations, state, some_displacement(*mesh, 0.2, 5));

    const LA::Vector direction = some_displacement(*mesh, 1, 3);
    equations.assemble(state, Loads());
    const double work  = equations.residual() * direction;
    const double scale = equations.residual().l2_norm() * direction.l2_norm();

    // two steps cancel the cubic part: exact, since the energy is quartic; with
    // slack cords, as long as few of them change
    const double step   = (compression == "E_L" ? 1e-3 : 1e-5);
    LA::Vector   V      = mesh->owned_vector();
    double       change = 0;
    for (const double s : {-2., -1., 1., 2.})
      {
        V = state.displacement;
        V.add(s * step, direction);
        const double energy =
          equations.internal_forces().strain_energy(at(equations, state, V));
        change +=
          (std::abs(s) == 1 ? 2. / 3 * s : -1. / 24 * s) * energy / step;
      }

    const double pressure_work = work_of_pressure(*mesh, direction);
    Loads        loads;
    loads.pressure = 0.7;
    equations.assemble(state, loads);
    const double loaded_work = equations.residual() * direction;

    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::cout << name << std::endl;
        check_range(
          "  work in the energy's direction", std::abs(work) / scale, 0.01, 1);
        check_small("  change of the energy", work + change, 1e-9, scale);
        check_small("  work of a pressure",
                    loaded_work - work - 0.7 * pressure_work,
                    1e-12,
                    scale);
      }
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  test("nonlinear theory", Formulation::paper, StrainTheory::nonlinear);
  test("linear theory", Formulation::paper, StrainTheory::linear);
  for (const auto formulation : {Formulation::standard, Formulation::vertices})
    for (const auto theory : {StrainTheory::nonlinear, StrainTheory::linear})
      test("formulation: " + name_of(formulation) +
             (theory == StrainTheory::linear ? ", linear theory" : ""),
           formulation,
           theory);
  for (const auto theory : {StrainTheory::nonlinear, StrainTheory::linear})
    test(std::string("slack cords") +
           (theory == StrainTheory::linear ? ", linear theory" : ""),
         Formulation::paper,
         theory,
         "E_L/100");
}
