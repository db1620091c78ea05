// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_ply_results_h
#define biface_output_ply_results_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

#include <biface/laminate/layup.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  /** The criteria whose failure indices are asked for. */
  struct FailureCriteria
  {
    bool maximum_stress = false;
    bool tsai_wu        = false;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Which materials lack the strengths that the criteria need: a sentence
     * each. */
    std::vector<std::string>
    warnings(const Layup &layup) const;
  };


  /** Strains and stresses at a point within a ply, in the frame of the shell.
   */
  struct PlyState
  {
    dealii::SymmetricTensor<2, 3> strain;
    /** Unit: force/area. */
    dealii::SymmetricTensor<2, 3> stress;

    /**
     * @param laminate at the point.
     * @param ply position in it.
     * @param fraction of the ply's thickness at which the point lies.
     * @param E the strains of the faces there, see Resultants.
     */
    PlyState(const Laminate           &laminate,
             const unsigned int        ply,
             const double              fraction,
             const Resultants::Vector &E);
  };


  /** Names of what ply_values() returns. */
  std::vector<std::string>
  ply_value_names(const FailureCriteria &criteria);

  /**
   * What is reported of a point within a ply: strains and stresses in the
   * frame of the shell, then in the axes of the ply, then the failure indices
   * asked for. Shear strains are engineering ones, twice the components. Where
   * the ply has no strengths, its indices are not numbers.
   *
   * @param angle of the ply, radians.
   */
  std::vector<double>
  ply_values(const PlyState        &state,
             const double           angle,
             const PlyDescription  &ply,
             const FailureCriteria &criteria);

} // namespace Biface

#endif
