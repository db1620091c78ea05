// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_ply_parameters_h
#define biface_laminate_ply_parameters_h

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <biface/input/coordinate.h>
#include <biface/input/formula.h>

namespace Biface
{
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
    /** The group of cells that the ply covers; empty if it covers all. */
    std::string group;

    /** The range as numbers, without bounds if the ply covers all. Throws
     * InputError if it covers nothing.
     * @param end of the surface, see SurfaceOfPlies. */
    std::pair<double, double>
    covered_part(const double end) const;
  };

  /** Read plies, 'material: thickness @@ angle from A to B' or 'material:
   * thickness @@ angle in GROUP', separated by commas. An angle '+-A' is a ply
   * at A and one at -A, '-+A' the other way round; 'N x (...)' repeats the
   * plies in parentheses. Throws InputError where they are malformed. */
  std::vector<PlyParameters>
  parse_plies(const std::string &entry, const std::string &text);


  /** The list that parse_plies() takes of the plies in the text of a CSV file:
   * 'material, thickness, angle, from, to' or 'material, thickness, angle,
   * group', the last ones where there are any.
   * Throws InputError where a line is malformed.
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
   * where it is none of these. */
  ThicknessPosition
  parse_thickness_position(const std::string &entry, const std::string &text);


  /** The initial stresses of plies, inner ply first: sigma_L, sigma_T, tau_LT;
   * see parse_ply_formula(). */
  using PlyStresses = std::vector<std::array<Formula, 3>>;

  /** Read triples of formulas without blanks, separated by commas. Throws
   * InputError where they are malformed. */
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
} // namespace Biface

#endif
