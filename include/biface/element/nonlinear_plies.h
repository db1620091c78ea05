// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_nonlinear_plies_h
#define biface_element_nonlinear_plies_h

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <biface/element/modes.h>
#include <biface/laminate/cord_law.h>
#include <biface/laminate/laminate.h>
#include <biface/laminate/relaxation.h>

namespace Biface
{
  /** The internal variables of an element at the last equilibrium, null where
   * nothing has relaxed, and the step since then. */
  struct HistoryOfPlies
  {
    const double *internal = nullptr;
    /** The step since the last equilibrium, by Gauss point. */
    std::array<TimeStep, Modes::n_gauss_points> steps{};
    /** The temperatures of the plies, instead of that of the steps, unless it
     * is empty. */
    std::vector<double> temperatures{};
  };


  /** A stress of plies that relaxes, at each Gauss point of an element: the
   * stresses of a point, the stress of cords, or the part of a ply in the
   * stresses of the thickness strains that vary. */
  struct RelaxingStress
  {
    std::shared_ptr<const Relaxation> relaxation;
    unsigned int                      n_components;
    /** The position of the ply in Laminate::get_plies(). */
    unsigned int ply;
    /** The thickness on which the stresses do work; 1 if they are resultants.
     * Unit: length. */
    double thickness;

    /** The number of internal variables of the stress at a Gauss point. */
    unsigned int
    n_internal() const
    {
      return n_components * (relaxation->n_terms() + 1);
    }
  };


  /**
   * What plies that are not linear add to the resultants of ModeStiffness: that
   * of PlyPoints and that of cords.
   *
   * The points of PlyPoints have one thickness stress in the whole element,
   * which follows from the constant mode of the thickness strain; otherwise
   * nearly incompressible layers, which are stretched where a stack of them
   * bends, would lock. The modes m by which the thickness strain varies have
   * the energy @f$\tfrac12 w_mD'_{33}\eta_m^2@f$ instead, with
   * @f$\eta_m=\sum_s D'_{3s}/D'_{33}\,E^m_s/(1+2E^0_s)@f$ over the strains 11,
   * 22 and 33, relative to their means, and the twist, and the initial matrix
   * @f$\mathbf D'@f$ of ModeStiffness::release_thickness_strain(): at small
   * strains all together are its law. A ply that relaxes has the part of this
   * stiffness that it has of the thickness: at the Gauss points, where the
   * function of the mode is @f$f_m@f$, the stress
   * @f$D'_{33}f_m\eta_m@f$ on the strain @f$f_m\eta_m@f$.
   *
   * The strains of the modes are evaluated at the 2x2 Gauss points of the
   * element, each with its own law. These points integrate products of modes
   * exactly, so that the energy of an element is
   * @f[
   *   w\Bigl(\tfrac12\sum_m w_m\,E_m\,(\mathbf D\mathbf E)_m
   *   +\sum_{g=1}^4\tfrac14\,\psi(\mathbf E_g)\Bigr) .
   * @f]
   * With one law per element, or with those at the vertices, the forces would
   * have no energy: modes are no sums over the vertices with the weights of the
   * energy.
   */
  class NonlinearPlies
  {
  public:
    /** The derivative of resultants() by the strains, the rows times the
     * weights of their modes: symmetric. Unit: force/length. */
    using Stiffness = Modes::Matrix;

    /** The plies of a laminate that are not linear.
     * @param formulation the set of strain modes.
     * @param tangents of the cell, see ModeStiffness; the mean strains in
     * @f$\eta_m@f$ are those along them. */
    explicit NonlinearPlies(
      const Laminate     &laminate,
      const Formulation   formulation = Formulation::standard,
      const CellTangents *tangents    = nullptr);

    /** Whether all plies are linear. */
    bool
    all_linear() const
    {
      return !points && cords.empty();
    }

    /** Whether there are PlyPoints, which are the whole law. */
    bool
    is_whole_law() const
    {
      return points != nullptr;
    }

    /** The energy of the plies per area. Unit: force/length.
     * @param E the modes of all strains, including initial ones. */
    double
    energy(const Modes::Vector &E, const HistoryOfPlies &history = {}) const;

    /** The derivative of energy() by the strains. Unit: force/length. */
    Modes::Vector
    resultants(const Modes::Vector  &E,
               const HistoryOfPlies &history = {}) const;

    /** The second derivative of energy() by the strains.
     * @return whether it is not zero. */
    bool
    stiffness(const Modes::Vector  &E,
              Stiffness            &result,
              const HistoryOfPlies &history = {}) const;

    /** The resultants of strains with a constant stiffness. */
    static Modes::Vector
    resultants(const Stiffness &stiffness, const Modes::Vector &E);

    /** The law about given strains. */
    struct Linearization
    {
      Modes::Vector E, resultants;
      Stiffness     stiffness;
    };
    Linearization
    linearize(const Modes::Vector &E, const HistoryOfPlies &history) const;

    /** The resultants of other strains by this law, where cords that are slack
     * on one side only have their own ones: an iteration would go from one
     * pattern to another. */
    Modes::Vector
    resultants(const Linearization  &law,
               const Modes::Vector  &E,
               const HistoryOfPlies &history) const;

    /** The strains at the vertices. With PlyPoints, the thickness strain is the
     * one that belongs to the thickness stress of the element. Relaxed stresses
     * are those of the Gauss point next to each vertex. */
    std::array<StrainsOfPlies, 4>
    strains_at_vertices(const Modes::Vector  &E,
                        const HistoryOfPlies &history = {}) const;

    /** The stresses that relax at a Gauss point. */
    const std::vector<RelaxingStress> &
    relaxing_stresses() const
    {
      return relaxing;
    }

    /** The number of components of all stresses that relax at a Gauss point. */
    unsigned int
    n_relaxing_components() const;

    /** The number of internal variables of an element: at each Gauss point
     * those of InternalStresses of each RelaxingStress. */
    unsigned int
    n_internal() const;

    /** The components of the stresses that relax, without relaxation, at each
     * Gauss point, and the strains on which they do work.
     * @param strains unless it is null. */
    void
    elastic_stresses(const Modes::Vector  &E,
                     const HistoryOfPlies &history,
                     std::vector<double>  &stresses,
                     std::vector<double>  *strains = nullptr) const;

    /** The components that the internal variables add to the stresses that
     * relax in a step, at each Gauss point. */
    std::vector<double>
    added_stresses(const HistoryOfPlies &history) const;

    /** Set the internal variables after a step.
     * @param history with those before it.
     * @param internal may be the same. */
    void
    commit(const Modes::Vector  &E,
           const HistoryOfPlies &history,
           double               *internal) const;

    /** The steps of the plies that relax, by their positions in the laminate,
     * at each Gauss point. */
    using Steps = std::array<std::map<unsigned int, Relaxation::Step>,
                             Modes::n_gauss_points>;

    /** The changes of elastic_stresses() with the strains, and of resultants
     * with the stresses that are added by relaxation, about given strains. */
    class Changes
    {
    public:
      /** The changes about the strains @p E.
       * @param plies kept by reference. */
      Changes(const NonlinearPlies &plies,
              const Modes::Vector  &E,
              const HistoryOfPlies &history);

      /** The change of the elastic stresses with the strains.
       * @param added the change of what is added to the stresses. */
      void
      elastic_stresses(const Modes::Vector       &dE,
                       const std::vector<double> &added,
                       std::vector<double>       &stresses) const;

      Modes::Vector
      resultants(const std::vector<double> &added) const;

      /** The components that other internal variables add to the stresses in
       * the same step. */
      std::vector<double>
      added_stresses(const double *internal) const
      {
        return plies.added_stresses(steps, internal);
      }

    private:
      /** The part of the added components that belongs to the stresses of
       * PlyPoints. */
      std::vector<PointStrains::Vector>
      added_at_points(const std::vector<double> &added) const;

      const NonlinearPlies             &plies;
      const Steps                       steps;
      std::optional<PlyPoints::Changes> points;
      /** The moduli of cords, Gauss point by Gauss point. */
      std::vector<double> cords;
      /** The derivatives of @f$\eta_m@f$ by the modes, for all groups but the
       * first. */
      std::vector<std::array<double, Modes::n>> varying;
    };

    /** The sum of the thicknesses of all points of cords. */
    double
    thickness_of_cords() const;

    /** The sum of the thicknesses of the points of cords that are slack, at
     * each Gauss point. */
    std::array<double, Modes::n_gauss_points>
    slack_thickness(const Modes::Vector &E) const;

  private:
    /** The components along the axes where the tangents of the cell are others,
     * null where they are the axes. */
    const Modes::ComponentsOfGroups *
    of_tangents() const
    {
      return along.get();
    }

    std::array<Resultants::Vector, Modes::n_gauss_points>
    at_gauss_points(const Modes::Vector &E) const;

    /** Call a function with the constant modes whose sum, with the given
     * factors, is the mean of the @p s-th strain of a group. */
    template <typename Function>
    void
    for_mean(const unsigned int group,
             const unsigned int s,
             const Function    &function) const;

    /** The value of @f$\eta_m@f$ with its derivatives by the modes. */
    struct Variation
    {
      double                       value = 0;
      std::array<double, Modes::n> gradient{};
      /** The second derivatives, by the mode and the mean of a strain, and by
       * the latter twice. */
      std::array<double, Modes::twist + 1> mixed{}, by_mean{};
    };
    Variation
    variation(const Modes::Vector &E, const unsigned int group) const;

    /** Stresses, one for each group by which the thickness strain varies. */
    using OfGroups = dealii::Tensor<1, Modes::groups.size() - 1>;

    /** The relaxed stresses, Gauss point by Gauss point; empty if none
     * relaxes. */
    struct RelaxedStresses
    {
      std::vector<Relaxed<PointStrains::Vector>> points;
      std::vector<Relaxed<double>>               cords;
      /** The stresses of varying thickness strains, by RelaxingPly. */
      std::vector<Relaxed<OfGroups>> varying;
    };

    /** The linear law of @f$\eta_m@f$: its stiffness, and the stress that
     * relaxation adds. */
    struct VaryingLaw
    {
      double stiffness, added;
    };
    VaryingLaw
    varying_law(const unsigned int group, const RelaxedStresses &relaxed) const;

    /** Add the resultants of the thickness strains that vary, and their
     * derivative unless it is null. */
    void
    add_varying(const Modes::Vector   &E,
                const RelaxedStresses &relaxed,
                Modes::Vector         &resultants,
                Stiffness             *stiffness) const;
    RelaxedStresses
    relaxed(const HistoryOfPlies &history) const;

    Steps
    steps(const HistoryOfPlies &history) const;

    /** Call a function with the step of each RelaxingStress at each Gauss point
     * and the position of its internal variables. */
    template <typename Function>
    void
    for_internal(const Steps &steps, const Function &function) const;

    std::vector<double>
    added_stresses(const Steps &steps, const double *internal) const;

    /** The modulus @f$D'_{33}@f$ of a group. */
    double
    varying_modulus(const unsigned int group) const;

    /** Set the resultants, and unless it is null the stiffness.
     * @return whether that is not zero. */
    bool
    evaluate(const Modes::Vector  &E,
             const HistoryOfPlies &history,
             Modes::Vector        &resultants,
             Stiffness            *stiffness) const;

    /** The response of cords at a Gauss point, with relaxation. */
    CordLaw::Response
    response(const RelaxedStresses    &relaxed,
             const unsigned int        g,
             const unsigned int        cord,
             const Resultants::Vector &strain) const;

    /** The tangents of the cell where they are not the axes, and, if any ply is
     * not linear, what they give. */
    std::optional<CellTangents>                      tangents;
    std::shared_ptr<const Modes::ComponentsOfGroups> along;

    std::shared_ptr<const PlyPoints> points;
    std::vector<CordPoint>           cords;
    std::vector<RelaxingStress>      relaxing;
    /** A ply that relaxes, with its part of the thickness. */
    struct RelaxingPly
    {
      std::shared_ptr<const Relaxation> relaxation;
      double                            part;
    };
    std::vector<RelaxingPly> relaxing_plies;
    bool                     with_twist;
    /** The stiffness @f$w_mD'_{33}@f$ by group, and @f$D'_{3s}/D'_{33}@f$ by
     * group and strain. */
    std::array<double, Modes::groups.size()> varying_stiffness{};
    std::array<dealii::Tensor<1, Modes::twist + 1>, Modes::groups.size()>
      varying_parts;
  };
} // namespace Biface

#endif
