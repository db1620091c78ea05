// SPDX-License-Identifier: LGPL-2.1-or-later

// Time of the work of a Newton iteration in one cell of the bias tire. With the
// arguments 'count N', each part runs N times without timing, for callgrind;
// those are the paper's, and with 'quadrilateral N' the standard ones.

#include <string>

#include <biface/element/follower_pressure.h>
#include <biface/laminate/layup.h>

#include "../element/one_cell.h"
#include <benchmark/benchmark.h>
#include <cord_ply.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** A cell of the tire under displacements without a pattern. */
  struct Setup
  {
    const Laminate            laminate;
    const ModeStiffness       stiffness;
    const ElementGeometry     geometry;
    MixedElement::NodalVector V, dV;
    Modes::Vector             H;
    MixedElement::NodalMatrix K;

    explicit Setup(const Formulation formulation = Formulation::paper)
      : laminate(Layup(Layup::Parameters(), cord_ply()).laminate(0))
      , stiffness(laminate.stiffness(), formulation)
      , geometry(make_cells(torus(),
                            {{"40:45:1", "10:15:1"}},
                            laminate.face_heights(),
                            formulation)[0]
                   .geometry)
    {
      for (unsigned int i = 0; i < MixedElement::n_dofs; ++i)
        {
          V[i]  = 0.3 * some_number(i);
          dV[i] = 0.3 * some_number(100 + i);
        }
      H = stiffness.resultants(MixedElement(geometry, V).strain());
    }

    /** Residual and tangent. */
    void
    assemble()
    {
      const MixedElement element(geometry, V);
      const auto         resultants = stiffness.resultants(element.strain());
      benchmark::DoNotOptimize(
        element.internal_force(resultants, Modes::Vector()));
      for (auto &row : K)
        row.fill(0);
      element.add_tangent(stiffness, H, K);
      benchmark::DoNotOptimize(K);
    }

    /** Resultants of the mixed iteration. */
    void
    update()
    {
      const MixedElement element(geometry, V);
      benchmark::DoNotOptimize(
        stiffness.resultants(element.strain() + element.strain_variation(dV)));
    }

    /** Forces and derivative of a follower pressure. */
    void
    follow()
    {
      const FollowerPressure pressure(geometry, V);
      pressure.add_derivative(0.1, K);
      benchmark::DoNotOptimize(K);
    }
  };


  void
  residual_and_tangent(benchmark::State &state)
  {
    Setup setup;
    for (auto _ : state)
      setup.assemble();
  }
  BENCHMARK(residual_and_tangent);


  void
  residual_and_tangent_of_quadrilateral(benchmark::State &state)
  {
    Setup setup(Formulation::standard);
    for (auto _ : state)
      setup.assemble();
  }
  BENCHMARK(residual_and_tangent_of_quadrilateral);


  void
  update_of_resultants(benchmark::State &state)
  {
    Setup setup;
    for (auto _ : state)
      setup.update();
  }
  BENCHMARK(update_of_resultants);


  void
  follower_pressure(benchmark::State &state)
  {
    Setup setup;
    for (auto _ : state)
      setup.follow();
  }
  BENCHMARK(follower_pressure);
} // namespace


int
main(int argc, char **argv)
{
  if (argc == 3)
    {
      const std::string what = argv[1];
      Setup             setup(what == "quadrilateral" ? Formulation::standard
                                          : Formulation::paper);
      for (int n = std::stoi(argv[2]); n > 0; --n)
        {
          setup.assemble();
          setup.update();
          setup.follow();
        }
      return 0;
    }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
