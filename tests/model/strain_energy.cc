// SPDX-License-Identifier: LGPL-2.1-or-later

// The residual of an unloaded, prestressed shell is minus the derivative of its
// strain energy, with the nonlinear and with the linear theory; a pressure adds
// its work on the inner face.

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
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  void
  test(const std::string   &name,
       const ThicknessLaw   law,
       const StrainTheory   theory,
       const StrainSampling sampling      = StrainSampling::vertices,
       const std::string   &compression   = "E_L",
       const Interpolation  interpolation = Interpolation::components)
  {
    Layup::Parameters parameters;
    parameters.law = law;
    parameters.initial_stresses =
      parse_ply_stresses("stresses", "2 0.1 0, 3 0 0.2, 0 0 0, -1 0.2 0.1");
    auto materials               = cord_ply();
    materials[0].E_L_compression = compression;
    const Layup layup(parameters, materials);
    const auto  mesh = coarse_torus(layup, sampling, false, interpolation);

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

    // the work of a unit pressure
    double     pressure_work = 0;
    LA::Vector ghosted       = mesh->ghosted_vector();
    ghosted                  = direction;
    for (const Cell &cell : mesh->cells)
      for (unsigned int v = 0; v < 4; ++v)
        pressure_work += cell.geometry.weight / 4 *
                         mesh->displacement(ghosted,
                                            mesh->nodes[cell.nodes[v]],
                                            Resultants::inner)[2];
    pressure_work = Utilities::MPI::sum(pressure_work, MPI_COMM_WORLD);
    Loads loads;
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

  test("symmetric law", ThicknessLaw::symmetric, StrainTheory::nonlinear);
  test("full law", ThicknessLaw::full, StrainTheory::nonlinear);
  test("linear theory", ThicknessLaw::symmetric, StrainTheory::linear);
  test("strains as means",
       ThicknessLaw::symmetric,
       StrainTheory::nonlinear,
       StrainSampling::means);
  test("strains as means, linear theory",
       ThicknessLaw::symmetric,
       StrainTheory::linear,
       StrainSampling::means);
  for (const auto theory : {StrainTheory::nonlinear, StrainTheory::linear})
    test(std::string("slack cords") +
           (theory == StrainTheory::linear ? ", linear theory" : ""),
         ThicknessLaw::symmetric,
         theory,
         StrainSampling::vertices,
         "E_L/100");
  test("Cartesian interpolation",
       ThicknessLaw::symmetric,
       StrainTheory::nonlinear,
       StrainSampling::means,
       "E_L",
       Interpolation::Cartesian);
}
