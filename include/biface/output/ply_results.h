// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_ply_results_h
#define biface_output_ply_results_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/laminate/interlaminar_shear.h>
#include <biface/laminate/laminate.h>
#include <biface/laminate/resultants.h>

namespace Biface
{
  struct FailureCriteria;
  class Layup;
  class ShellEquations;
  struct State;


  /** Strains and stresses at a point within a ply, in the frame of the shell.
   */
  struct PlyState
  {
    dealii::SymmetricTensor<2, 3> strain;
    /** The second Piola-Kirchhoff stress. Unit: force/area. */
    dealii::SymmetricTensor<2, 3> stress;
    /** The transverse shear stresses in equilibrium with bending, see
     * EquilibriumShear; NaN where a law is not linear. Unit: force/area. */
    dealii::Tensor<1, 2> interlaminar;
    /** Whether the cords are slack, see Laminate::is_slack(). */
    bool slack;

    /**
     * @param laminate the laminate at the point.
     * @param ply the position of the ply in it.
     * @param fraction the position in the ply as a fraction of its thickness.
     * @param E the strains of the faces at the point, see Resultants.
     * @param interlaminar see there.
     */
    PlyState(const Laminate             &laminate,
             const unsigned int          ply,
             const double                fraction,
             const StrainsOfPlies       &E,
             const dealii::Tensor<1, 2> &interlaminar);

    /** The stress in the axes of the ply that failure criteria take: with a law
     * for large strains that of cauchy_stress(). */
    dealii::SymmetricTensor<2, 3>
    failure_stress(const Ply &ply) const;
  };


  /** The stress on a face of a laminate, in the frame of the shell. Unit:
   * force/area. */
  struct FaceStress
  {
    /** The second Piola-Kirchhoff stress. */
    dealii::SymmetricTensor<2, 3> stress;
    /** The Cauchy stress where a law is one for large strains, otherwise the
     * second Piola-Kirchhoff stress. */
    dealii::SymmetricTensor<2, 3> true_stress;

    static constexpr std::array<const char *, 4> names{
      {"s_11", "s_22", "s_12", "von_mises"}};

    FaceStress() = default;

    /** @param E the strains of the faces at a point, see Resultants. */
    FaceStress(const Laminate        &laminate,
               const Resultants::Face face,
               const StrainsOfPlies  &E);

    /** The components in the order of the names; the last one is the equivalent
     * stress of @p true_stress. */
    std::array<double, 4>
    values() const;
  };


  /** The transverse shear stresses of a state in equilibrium with bending:
   * those of Laminate::interlaminar_stress(), or with several layers those of
   * InterlaminarShear. */
  class EquilibriumShear
  {
  public:
    /** All arguments are kept by reference. */
    EquilibriumShear(const ShellEquations &equations, const State &state)
      : equations(equations), state(state)
    {}

    /** The transverse shear stresses within a ply at a vertex of a cell. Unit:
     * force/area.
     * @param layer the position of the layer in ShellMesh::cells.
     * @param ply,fraction see PlyState. */
    dealii::Tensor<1, 2>
    stress(const unsigned int layer,
           const unsigned int vertex,
           const unsigned int ply,
           const double       fraction);

  private:
    const ShellEquations &equations;
    const State          &state;

    /** The distributions of shear over walls of several layers, by the
     * innermost layer at a place, see Strip::at_vertices. */
    std::map<const Laminate *, InterlaminarShear> of_walls;

    /** The wall whose strains are at hand, and the strains of its layers at
     * their vertices. */
    std::optional<unsigned int>                wall;
    std::vector<std::array<StrainsOfPlies, 4>> strains;
  };


  /** The names of the values returned by ply_values(). */
  std::vector<std::string>
  ply_value_names(const FailureCriteria &criteria, const Layup &layup);

  /**
   * The results at a point within a ply: strains and stresses in the frame of
   * the shell, then in the axes of the ply, then the requested failure indices,
   * then the interlaminar stresses. If there are cords in @p layup, the tension
   * of a cord follows, if the whole thickness of the ply had the stress at the
   * point, and if they can go slack, whether they are; and if a law in it is
   * one for large strains, the Cauchy stresses in axes of the ply that turn
   * with it. Shear strains are
   * engineering strains, twice the components. Without strengths of the ply the
   * indices are NaN, and without cords their tension.
   *
   * @param ply of the layup.
   */
  std::vector<double>
  ply_values(const PlyState        &state,
             const Ply             &ply,
             const FailureCriteria &criteria,
             const Layup           &layup);

} // namespace Biface

#endif
