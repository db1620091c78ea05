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
  /** A ply of a layup: a Ply whose thickness and angle depend on
   * @f$\alpha_1@f$. */
  struct PlyDescription
  {
    /** As the user wrote it. */
    std::string text;
    /** Name of the material. */
    std::string material;
    /** Stiffness in the ply's own axes. Unit: force/area. */
    dealii::SymmetricTensor<4, 3> stiffness;
    /** Where the material has them. */
    std::optional<Strengths> strengths;
    /** Thickness (length) and angle (radians) by @f$\alpha_1@f$ in the user's
     * unit. */
    std::function<double(const double)> thickness, angle;
    /** The part of the meridian it covers, in the user's unit. */
    double begin = -std::numeric_limits<double>::infinity();
    double end   = std::numeric_limits<double>::infinity();
    /** Initial stress in the ply's own axes. Unit: force/area. */
    dealii::SymmetricTensor<2, 3> initial_stress;
  };


  /**
   * The plies of a shell, inner ply first. Thickness and angle of each may
   * change along the meridian, and it may cover a part of the meridian only.
   * In places, it is a Laminate.
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

    /** Throws InputError where the plies are not usable, name a material
     * that is not in @p materials, or a table cannot be read. */
    Layup(const Parameters                      &parameters,
          const std::vector<MaterialParameters> &materials,
          const MPI_Comm                         communicator = MPI_COMM_SELF);

    /**
     * The plies at @p alpha_1, those of them that cover @p within, with their
     * thickness and angle at @p alpha_1; both in the unit in which the user
     * writes the coordinate. At the end of a ply, @p within says on which side.
     *
     * Throws InputError where a thickness is not positive, or no ply is there.
     */
    Laminate
    laminate(const double alpha_1, const double within) const;

    /** The same where no ply ends. */
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
    /** Where the reference surface lies in given plies, from the inner face. */
    std::function<double(const std::vector<Ply> &)> reference_height;
  };
} // namespace Biface

#endif
