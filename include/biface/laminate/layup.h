// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_layup_h
#define biface_laminate_layup_h

#include <deal.II/base/parameter_handler.h>

#include <mpi.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <biface/laminate/failure_criteria.h>
#include <biface/laminate/laminate.h>
#include <biface/laminate/material_parameters.h>

namespace Biface
{
  /** A ply of a layup, whose thickness and angle depend on @f$\alpha_1@f$. */
  struct PlyDescription
  {
    /** The text of the user. */
    std::string text;
    /** Name of the material. */
    std::string material;
    /** Stiffness in the axes of the ply. Unit: force/area. */
    dealii::SymmetricTensor<4, 3> stiffness;
    /** If given for the material. */
    std::optional<Strengths> strengths;
    /** Thickness (length) and angle (radians) as functions of @f$\alpha_1@f$ in
     * the user's unit. */
    std::function<double(const double)> thickness, angle;
    /** The part of the meridian it covers, in the user's unit. */
    double begin = -std::numeric_limits<double>::infinity();
    double end   = std::numeric_limits<double>::infinity();
    /** Initial stress in the axes of the ply. Unit: force/area. */
    dealii::SymmetricTensor<2, 3> initial_stress;
  };


  /**
   * The plies of a shell, inner ply first. The thickness and angle of a ply may
   * vary along the meridian, and it may cover only a part of the meridian. At
   * each position, the layup gives a Laminate.
   */
  class Layup
  {
  public:
    struct Parameters
    {
      std::string  plies = "cord: 1.2 @ 52, cord: 1.2 @ -52, "
                           "cord: 1.2 @ 52, cord: 1.2 @ -52";
      std::string  tables;
      std::string  initial_stresses;
      ThicknessLaw law       = ThicknessLaw::symmetric;
      std::string  reference = "inner";

      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /** Throws InputError if the plies are invalid, a material is not in
     * @p materials, or a table cannot be read. */
    Layup(const Parameters                      &parameters,
          const std::vector<MaterialParameters> &materials,
          const MPI_Comm                         communicator = MPI_COMM_SELF);

    /**
     * The plies that cover @p within, with their thickness and angle at
     * @p alpha_1, both in the user's unit of the coordinate. At the end of a
     * ply, @p within selects the side.
     *
     * Throws InputError if a thickness is not positive or no ply covers the
     * position.
     */
    Laminate
    laminate(const double alpha_1, const double within) const;

    /** The same for positions at which no ply ends. */
    Laminate
    laminate(const double alpha_1) const
    {
      return laminate(alpha_1, alpha_1);
    }

    /** See Laminate::is_symmetric(). */
    bool
    is_symmetric() const
    {
      return law != ThicknessLaw::asymmetric;
    }

    const std::vector<PlyDescription> &
    get_plies() const
    {
      return plies;
    }

  private:
    std::vector<PlyDescription> plies;
    ThicknessLaw                law;
    /** The height of the reference surface above the inner face, for given
     * plies. */
    std::function<double(const std::vector<Ply> &)> reference_height;
  };
} // namespace Biface

#endif
