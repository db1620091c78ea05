// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_plies_vtu_h
#define biface_output_plies_vtu_h

#include <biface/output/requested_criteria.h>
#include <biface/output/vtu_series.h>

namespace Biface
{
  class EntryDeclarations;
  struct HeatOfPlies;


  /**
   * The plies of the deformed shell: one hexahedron per ply of every locally
   * owned cell, between the two sides of the ply. Data: the displacement, the
   * unit vector along the deformed fibers, the number of the ply (from 1 at the
   * inner face), ply_values(), and in a laminate that loses energy in rolling
   * the HeatOfPlies.
   */
  class PlyPatches : public VertexPatches<3>
  {
  public:
    /** @param heat null for none.
     * @param temperature of all plies, where it is not computed. */
    PlyPatches(const ShellEquations  &equations,
               const State           &state,
               const FailureCriteria &criteria,
               const HeatOfPlies     *heat        = nullptr,
               const double           temperature = 0);
  };


  /** plies-NNNN.vtu and plies.pvd: the plies of the deformed shell. */
  class PliesVtu : public VtuSeries
  {
  public:
    struct Parameters
    {
      bool write = false;

      void
      add_parameters(EntryDeclarations &prm);
    };

    PliesVtu(const Parameters      &parameters,
             const FailureCriteria &criteria,
             ResultsDirectory      &directory,
             const ShellEquations  &equations);

    std::vector<std::string>
    warnings() const override;

  private:
    void
    write(const StepReport &report, const State &state) override;

    const FailureCriteria criteria;
  };
} // namespace Biface

#endif
