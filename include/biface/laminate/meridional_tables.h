// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_laminate_meridional_tables_h
#define biface_laminate_meridional_tables_h

#include <functional>
#include <string>
#include <vector>

#include <biface/input/formula.h>
#include <biface/input/table_file.h>
#include <biface/laminate/surface_of_plies.h>

namespace Biface
{
  /** Read a formula of a ply, whose variables are not known yet: `alpha_1`, on
   * a surface of revolution its `end` and the radius `r`, the `beta_c` of a
   * surface that has a SurfaceOfPlies::crown_cord_angle, tables, and the
   * function lift(); on a mesh from a file the position `x`, `y`, `z`. Throws
   * InputError like Formula. */
  Formula
  parse_ply_formula(const std::string &entry, const std::string &text);


  /** The variables that formulas of plies know before the surface is made. */
  struct PlyVariables
  {
    /** Whether the surface has a radius and an end. */
    bool radius = false;
    /** Whether the surface has a crown cord angle. */
    bool crown_cord_angle = false;
    /** Whether the surface has positions in place of coordinates. */
    bool position = false;

    PlyVariables() = default;
    explicit PlyVariables(const SurfaceOfPlies &surface);

    /** Let a formula know these variables and the tables. Throws InputError,
     * see Formula::bind(). */
    void
    bind(Formula &formula, const std::vector<TableFile> &tables) const;
  };


  /**
   * The variables that formulas of plies know. Tables are linear between their
   * rows and constant beyond their ends.
   */
  class MeridionalTables
  {
  public:
    /** The tables on a surface. Throws InputError if one cannot be
     * interpolated. */
    MeridionalTables(const std::vector<TableFile> &tables,
                     const SurfaceOfPlies         &surface,
                     const AngleReference          angle_reference);

    /**
     * The formula of a ply, see parse_ply_formula(), as a function of the
     * place. It does not need the tables any longer.
     */
    std::function<double(const PlyPlace &)>
    function(Formula formula) const;

  private:
    std::vector<std::string>       names;
    SurfaceOfPlies                 surface;
    AngleReference                 angle_reference;
    std::vector<InterpolatedTable> tables;
  };
} // namespace Biface

#endif
