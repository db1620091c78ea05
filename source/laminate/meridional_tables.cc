// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>

#include <biface/laminate/meridional_tables.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The names of the variables of lift(): the ratio of the radii, and the
     * number of an AngleReference. */
    const std::vector<std::string> lift_variables{"_r_ratio",
                                                  "_angle_reference"};


    /** In the order of MeridionalTables::function(). A table hides a variable
     * of the same name, which then starts with '_'. */
    std::vector<std::string>
    variables(const PlyVariables &known, const std::vector<TableFile> &tables)
    {
      if (known.position)
        return {"x", "y", "z"};
      std::vector<std::string> names{"alpha_1"};
      const auto               add = [&](const std::string &name) {
        const bool hidden =
          std::any_of(tables.begin(), tables.end(), [&](const auto &table) {
            return table.name == name;
          });
        names.push_back((hidden ? "_" : "") + name);
      };
      if (known.radius)
        {
          add("end");
          add("r");
          names.insert(
            names.end(), lift_variables.begin(), lift_variables.end());
        }
      if (known.crown_cord_angle)
        add("beta_c");
      for (const TableFile &table : tables)
        names.push_back(table.name);
      return names;
    }
  } // namespace


  Formula
  parse_ply_formula(const std::string &entry, const std::string &text)
  {
    const auto lifted = [](const double               angle,
                           const std::vector<double> &values) {
      return lift(angle, values[0], static_cast<AngleReference>(values[1]));
    };
    return Formula(
      entry, text, FormulaFunction("lift", lift_variables, lifted));
  }


  PlyVariables::PlyVariables(const SurfaceOfPlies &surface)
    : radius(surface.radius)
    , crown_cord_angle(surface.crown_cord_angle)
    , position(surface.groups)
  {}


  void
  PlyVariables::bind(Formula                      &formula,
                     const std::vector<TableFile> &tables) const
  {
    formula.bind(variables(*this, tables));
  }


  MeridionalTables::MeridionalTables(const std::vector<TableFile> &files,
                                     const SurfaceOfPlies         &surface,
                                     const AngleReference angle_reference)
    : names(variables(PlyVariables(surface), files))
    , surface(surface)
    , angle_reference(angle_reference)
  {
    for (const TableFile &file : files)
      tables.push_back(interpolate(file.file, "alpha_1"));
  }


  std::function<double(const PlyPlace &)>
  MeridionalTables::function(Formula formula) const
  {
    formula.bind(names);
    const double crown_radius =
      (surface.radius ? surface.radius(surface.crown) : 0);
    return [formula,
            crown_radius,
            surface   = surface,
            reference = static_cast<double>(angle_reference),
            tables    = tables](const PlyPlace &place) {
      // in the order of variables()
      if (place.position)
        return formula(
          {(*place.position)[0], (*place.position)[1], (*place.position)[2]});
      const double        alpha_1 = place.alpha_1;
      std::vector<double> values{alpha_1};
      if (surface.radius)
        {
          const double r = surface.radius(alpha_1);
          values.insert(values.end(),
                        {surface.end, r, r / crown_radius, reference});
        }
      if (surface.crown_cord_angle)
        values.push_back(*surface.crown_cord_angle);
      for (const auto &table : tables)
        values.push_back(table->value(Point<1>(alpha_1)));
      return formula(values);
    };
  }
} // namespace Biface
