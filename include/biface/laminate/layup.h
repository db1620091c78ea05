// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_layup_h
#define biface_laminate_layup_h

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <biface/laminate/laminate.h>
#include <biface/laminate/meridional_tables.h>
#include <biface/laminate/ply_parameters.h>

namespace Biface
{
  class EntryDeclarations;
  struct MaterialParameters;

  /** A ply of a layup, whose thickness and angle depend on the place. */
  struct PlyDescription
  {
    /** The text of the user from which the ply comes. */
    std::string text;
    PlyMaterial material;
    /** The thickness (length) and the angle (radians) as functions of the
     * place. */
    std::function<double(const PlyPlace &)> thickness, angle;
    /** The distance of the cords as a function of the place; empty if they are
     * not described. Unit: length. */
    std::function<double(const PlyPlace &)> cord_pitch;
    /** The laws as a function of the place and of the initial stress in the
     * axes of the ply. */
    std::function<PlyLaws(const PlyPlace &,
                          const dealii::SymmetricTensor<2, 3> &)>
      laws;
    /** Whether thickness, angle or initial stress are formulas of the place. */
    bool varies = false;
    /** The part of the meridian that the ply covers, in the user's unit;
     * infinite without bounds. */
    double begin, end;
    /** The group of cells that the ply covers; empty if it covers all. */
    std::string group;
    /** The initial stress in the axes of the ply as a function of the place;
     * empty for none. Unit: force/area. */
    std::function<dealii::SymmetricTensor<2, 3>(const PlyPlace &)>
      initial_stress;
  };


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
      /** The entries of TransverseShearLaw; if not set, they follow from
       * the element, the layers and the materials, see
       * shear_law_of_layers(). */
      std::optional<TransverseShearLaw> shear_law;
      std::optional<double>             gradient_factor;
      /** Whether the element is Formulation::standard. */
      bool               of_standard_element = false;
      ThicknessIntegrals integrals           = ThicknessIntegrals::plate;
      ThicknessPosition  reference;
      LayerDivision      layers;

      unsigned int
      n_layers() const
      {
        return layers.sides(plies.size()).size() - 1;
      }

      /** The shear law with the gradient factor. By default it is that of the
       * paper, but the stresses of a wall of one layer and one isotropic
       * material are in equilibrium, with Reissner's factor of 5/6
       * @cite Reissner1945, except with the elements of the paper.
       * @param homogeneous whether the wall is of such a material. */
      TransverseShearLaw
      shear_law_of_layers(const bool homogeneous) const;

      void
      add_parameters(EntryDeclarations &prm);

      /** Check the entries. Throws InputError if plies name a material that is
       * not in @p materials, or a formula a variable that there is not. */
      void
      check(const std::vector<MaterialParameters> &materials,
            const PlyVariables                    &variables) const;

    private:
      void
      add_plies(EntryDeclarations &prm);
      void
      add_initial_stresses(EntryDeclarations &prm);
      void
      add_laws(EntryDeclarations &prm);

      void
      check_layers() const;
    };

    /** Create the plies. Throws InputError like Parameters::check(), if a table
     * cannot be interpolated, or if a ply covers nothing. */
    Layup(const Parameters                      &parameters,
          const std::vector<MaterialParameters> &materials,
          const SurfaceOfPlies                  &surface = SurfaceOfPlies());

    /**
     * The plies that cover @p within, in the user's unit of the coordinate,
     * with their thickness and angle at @p place. At the end of a ply,
     * @p within selects the side; it has no meaning on a mesh from a file.
     *
     * Throws InputError if a thickness is not positive or no ply covers the
     * position.
     */
    Laminate
    laminate(const PlyPlace &place, const double within) const;

    /** The laminate at a position at which no ply ends, see laminate(place,
     * within). */
    Laminate
    laminate(const PlyPlace &place) const
    {
      return laminate(place, place.alpha_1);
    }

    /** The parts of the laminate at a position in the layers of the wall, inner
     * layer first; empty where no ply of a layer covers the position. */
    std::vector<std::optional<Laminate>>
    layers(const PlyPlace &place, const double within) const;

    /** Whether any ply depends on the place. */
    bool
    varies() const;

    /** The groups of cells that plies cover; with an empty name if any covers
     * all. */
    std::set<std::string>
    groups() const;

    /** The layup of the cells that are in given groups of a mesh: the plies of
     * other groups cover nothing, and all keep their numbers. */
    Layup
    in_groups(const std::set<std::string> &groups) const;

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

    const TransverseShearLaw &
    get_shear_law() const
    {
      return shear_law;
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
     * NormalThickness. */
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
    /** Whether something is true of the material of any ply. */
    bool
    any_material(const std::function<bool(const PlyMaterial &)> &is) const;

    /** The plies that cover @p within. */
    std::vector<Ply>
    plies_at(const PlyPlace &place, const double within) const;

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
