// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_profile_file_h
#define biface_output_profile_file_h

#include <vector>

#include <biface/output/result_file.h>

namespace Biface
{
  class EntryDeclarations;


  /** profile-NNNN.csv: the deformed contour along a coordinate line. */
  class ProfileFile : public ResultFile
  {
  public:
    struct Parameters
    {
      /** The coordinate @f$\alpha_2@f$ of the line, in the user's unit; the
       * nearest grid line is used. */
      double alpha_2 = 0;

      void
      add_parameters(EntryDeclarations &prm);
    };

    ProfileFile(const Parameters     &parameters,
                ResultsDirectory     &directory,
                const ShellEquations &equations);

  private:
    void
    write(const StepReport &report, const State &state) override;

    /** The coordinate @f$\alpha_2@f$ of the nearest grid line. */
    double
    find_line() const;

    /** Call a function with each layer, node of the line, laminate and strains
     * at a corner of a cell that lies on the line. */
    template <typename Function>
    void
    for_corners(const State &state, const Function &function) const;

    /** The tension of the fibers or cords, see TensionMembers, at all nodes of
     * the line: `[i * n + p]` in the n plies at the i-th node; NaN where the
     * ply has none or does not cover the node. The means of the cells around
     * the node. Must be called on all ranks. */
    std::vector<double>
    tensions(const State &state) const;

    /** The values of FaceStress on the outer, then on the inner face, at all
     * nodes of the line, the means of the cells around them. Must be called on
     * all ranks. */
    std::vector<double>
    stresses(const State &state) const;

    /** The height above the reference surface of the middle of the plies with
     * fibers, of all plies if there are none. Unit: length. */
    double
    carcass_height(const Node &node) const;

    const Parameters parameters;
    const double     line;
  };
} // namespace Biface

#endif
