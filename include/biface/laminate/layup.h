// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_layup_h
#define biface_laminate_layup_h

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/input/coordinate.h>
#include <biface/input/formula.h>
#include <biface/laminate/failure_criteria.h>
#include <biface/laminate/laminate.h>
#include <biface/laminate/material_parameters.h>
#include <biface/laminate/meridional_tables.h>

namespace Biface
{
  class EntryDeclarations;


  /** A ply of a layup, whose thickness and angle depend on @f$\alpha_1@f$. */
  struct PlyDescription
  {
    /** The text of the user from which the ply comes. */
    std::string text;
    /** The name of the material. */
    std::string material;
    /** Whether axis L of the ply is that of fibers, rather than any direction
     * of an isotropic material. */
    bool has_fibers = false;
    /** The strengths, if given for the material. */
    std::optional<Strengths> strengths;
    /** The density. Unit: mass/volume. */
    double density = 0;
    /** The tangent of the angle by which strains lag behind stresses, see
     * Ply. */
    double loss_factor = 0;
    /** The conductivity of heat; 0 if it is not given. Unit: power/(length *
     * temperature). */
    double conductivity = 0;
    /** The thickness (length) and the angle (radians) as functions of
     * @f$\alpha_1@f$ in the user's unit. */
    std::function<double(const double)> thickness, angle;
    /** The distance of the cords as a function of @f$\alpha_1@f$; empty if they
     * are not described. Unit: length. */
    std::function<double(const double)> cord_pitch;
    /** The laws as a function of @f$\alpha_1@f$ and of the initial stress in
     * the axes of the ply. */
    std::function<PlyLaws(const double, const dealii::SymmetricTensor<2, 3> &)>
      laws;
    /** Whether the ply has cords that can go slack. */
    bool has_slack_cords = false;
    /** Whether the stresses relax, see MaterialParameters::relaxes(). */
    bool relaxes = false;
    /** Whether a law is one for large strains, see
     * MaterialParameters::is_hyperelastic(). */
    bool is_hyperelastic = false;
    /** The part of the meridian that the ply covers, in the user's unit. */
    double begin = -std::numeric_limits<double>::infinity();
    double end   = std::numeric_limits<double>::infinity();
    /** The initial stress in the axes of the ply as a function of
     * @f$\alpha_1@f$; empty for none. Unit: force/area. */
    std::function<dealii::SymmetricTensor<2, 3>(const double)> initial_stress;
  };


  /** A ply as the user describes it; see parse_ply_formula(). */
  struct PlyParameters
  {
    /** The whole text of the ply, as written. */
    std::string text;
    std::string material;
    /** The formula of the thickness. Unit: length. */
    Formula thickness;
    /** The formula of the angle. Unit: degrees. */
    Formula angle;
    /** The begin and the end of the part of the meridian that the ply covers,
     * if not all. */
    std::optional<std::pair<Coordinate, Coordinate>> range;
  };

  /** Read plies, 'material: thickness @@ angle from A to B' separated by
   * commas. An angle '+-A' is a ply at A and one at -A, '-+A' the other way
   * round; 'N x (...)' repeats the plies in parentheses. Throws InputError if
   * they are malformed. */
  std::vector<PlyParameters>
  parse_plies(const std::string &entry, const std::string &text);


  /** The list, as parse_plies() reads it, of the plies in the text of a CSV
   * file: 'material, thickness, angle, from, to', the last two where there are
   * any. Throws InputError if a line is malformed.
   * @param name that of the file. */
  std::string
  plies_of_csv(const std::string &text, const std::string &name);


  /** A position in the thickness of the wall. */
  struct ThicknessPosition
  {
    enum class Kind
    {
      /** A fraction of the thickness, from the inner face. */
      fraction,
      /** The outer side of a ply, counted from 1 at the inner face. */
      ply,
      /** The distance from the inner face. Unit: length. */
      distance
    };
    Kind   kind  = Kind::fraction;
    double value = 0;
  };

  /** Read 'inner', 'middle', 'outer', 'ply N' or a distance. Throws InputError
   * if it is none of these. */
  ThicknessPosition
  parse_thickness_position(const std::string &entry, const std::string &text);


  /** The initial stresses of plies, inner ply first: sigma_L, sigma_T, tau_LT;
   * see parse_ply_formula(). */
  using PlyStresses = std::vector<std::array<Formula, 3>>;

  /** Read triples of formulas without blanks, separated by commas. Throws
   * InputError if they are malformed. */
  PlyStresses
  parse_ply_stresses(const std::string &entry, const std::string &text);


  /** One of the initial resultants, as a function of the position. */
  struct InitialResultant
  {
    /** The component, in the order of Resultants. */
    unsigned int index;
    /** The formula of the value, see parse_position_formula(). Unit:
     * force/length. */
    Formula value;
  };

  /** Parse a list 'H_ij FACE = FORMULA', separated by semicolons. Throws
   * InputError if it is malformed. */
  std::vector<InitialResultant>
  parse_initial_resultants(const std::string &entry, const std::string &text);


  /** The layers of the wall, between L + 1 faces: the parts of the stack of
   * plies in which displacements are linear in the height. */
  struct LayerDivision
  {
    /** The number of layers of each ply, if each is divided into as many. */
    std::optional<unsigned int> per_ply;

    /** The number of plies in each layer, inner layer first, unless @p per_ply
     * is set; fractions of plies are fractions of their thickness. Empty for a
     * single layer of all plies. */
    std::vector<double> n_plies;

    /** The sides of the layers, as numbers of plies below them: from 0 to
     * @p n_plies_of_wall. */
    std::vector<double>
    sides(const unsigned int n_plies_of_wall) const;
  };

  /** Read 'one', 'one per ply', 'N per ply', or a list of numbers of plies.
   * Throws InputError where it is none of these. */
  LayerDivision
  parse_layers(const std::string &entry, const std::string &text);


  /** The lengths and areas in integrals over the thickness, see
   * ThicknessFunctions. */
  enum class ThicknessIntegrals
  {
    /** The integrals of a plate. */
    plate,
    /** The integrals of a shell, whose lengths and areas depend on the
     * height. */
    shell
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
      std::vector<PlyParameters> plies =
        parse_plies("Laminate/Plies",
                    "cord: 1.2 @ 52, cord: 1.2 @ -52, "
                    "cord: 1.2 @ 52, cord: 1.2 @ -52");
      /** The file of the plies; empty once the plies are those of the file, see
       * plies_of_csv(). */
      std::string            plies_file;
      std::vector<TableFile> tables;
      AngleReference         angle_reference = AngleReference::meridian;
      /** The initial stresses of each of the plies, or empty. */
      PlyStresses initial_stresses;
      /** The resultants that are added to those of the initial stresses. */
      std::vector<InitialResultant> initial_resultants;
      ThicknessLaw                  law = ThicknessLaw::symmetric;
      TransverseShearLaw            shear_law;
      /** The entry TransverseShearLaw::gradient_factor; if not set, it follows
       * from the number of layers. */
      std::optional<double> gradient_factor;
      ThicknessIntegrals    integrals = ThicknessIntegrals::plate;
      ThicknessPosition     reference;
      LayerDivision         layers;

      unsigned int
      n_layers() const
      {
        return layers.sides(plies.size()).size() - 1;
      }

      /** The shear law with the gradient factor. */
      TransverseShearLaw
      shear_law_of_layers() const
      {
        TransverseShearLaw result = shear_law;
        result.gradient_factor =
          gradient_factor.value_or(n_layers() > 1 ? 8 : 1);
        return result;
      }

      void
      add_parameters(EntryDeclarations &prm);

      /** Check the entries. Throws InputError if plies name a material that is
       * not in @p materials, or a formula a variable that there is not. */
      void
      check(const std::vector<MaterialParameters> &materials,
            const PlyVariables                    &variables) const;

    private:
      void
      check_layers() const;
    };

    /** Create the plies. Throws InputError like Parameters::check(), if a table
     * cannot be interpolated, or if a ply covers nothing. */
    Layup(const Parameters                      &parameters,
          const std::vector<MaterialParameters> &materials,
          const SurfaceOfPlies                  &surface = SurfaceOfPlies());

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

    /** The laminate at a position at which no ply ends, see laminate(alpha_1,
     * within). */
    Laminate
    laminate(const double alpha_1) const
    {
      return laminate(alpha_1, alpha_1);
    }

    /** The parts of the laminate at a position in the layers of the wall, inner
     * layer first; empty where no ply of a layer covers the position. */
    std::vector<std::optional<Laminate>>
    layers(const double alpha_1, const double within) const;

    /** The number of layers of the wall. */
    unsigned int
    n_layers() const
    {
      return sides_of_layers.size() - 1;
    }

    const std::vector<PlyDescription> &
    get_plies() const
    {
      return plies;
    }

    /** Whether any ply has fibers. */
    bool
    has_fibers() const;
    /** Whether the cords of any ply are described. */
    bool
    has_cords() const;
    /** Whether there are cords that can go slack. */
    bool
    has_slack_cords() const;
    /** Whether any ply has a loss factor. */
    bool
    has_loss() const;
    /** Whether the stresses of any ply relax. */
    bool
    relaxes() const;
    /** Whether the law of any ply is one for large strains. */
    bool
    is_hyperelastic() const;

    /** Let the thickness strain of the laminates be that along the normal, see
     * ThicknessStrain::normal. */
    void
    set_thickness_strain_along_normal(const bool value)
    {
      along_normal = value;
    }

    /** The initial resultants beside those of
     * Laminate::initial_resultants(). */
    const std::vector<InitialResultant> &
    get_initial_resultants() const
    {
      return initial_resultants;
    }

  private:
    /** The plies that cover @p within. */
    std::vector<Ply>
    plies_at(const double alpha_1, const double within) const;

    std::vector<PlyDescription> plies;
    /** The sides of the layers as numbers of plies below them, see
     * LayerDivision::sides(). */
    std::vector<double> sides_of_layers;
    ThicknessLaw        law;
    TransverseShearLaw  shear_law;
    /** The curvatures of the surface, see SurfaceOfPlies; empty for the
     * integrals of a plate. */
    std::function<std::array<double, 2>(const double)> curvature;
    ThicknessPosition                                  reference;
    std::vector<InitialResultant>                      initial_resultants;
    bool                                               along_normal = false;
  };
} // namespace Biface

#endif
