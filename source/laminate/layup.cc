// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/meridional_tables.h>

namespace Biface
{
  using namespace dealii;

  void
  Layup::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Plies",
                      plies,
                      "The plies, inner ply first, separated by commas, each "
                      "as 'material: thickness @ angle', followed by 'from A "
                      "to B' if the ply covers only this part of alpha_1 "
                      "(between two mesh lines; the jump in thickness is "
                      "spread over the cells on both sides). The angle of the "
                      "material's first axis is measured from the first "
                      "coordinate line (the meridian) toward the second. "
                      "Thickness and angle are numbers, or formulas of "
                      "alpha_1 and of the 'Tables', such as 1.2 + "
                      "0.01*abs(alpha_1). Units: length, degrees, alpha_1 as "
                      "in 'Mesh'.",
                      Patterns::Anything());
    prm.add_parameter("Tables",
                      tables,
                      "Tables for the formulas of 'Plies': a list of 'name: "
                      "file', separated by commas. Each CSV file has rows "
                      "'alpha_1, value' with increasing alpha_1; values are "
                      "interpolated linearly and constant beyond the ends. "
                      "Paths are relative to the parameter file.",
                      Patterns::Anything());
    prm.add_parameter("Initial ply stresses",
                      initial_stresses,
                      "Initial stresses in the undeformed shell, one triple "
                      "'sigma_L sigma_T tau_LT' per ply, inner ply first, "
                      "separated by commas; empty for none. They act only "
                      "through the nonlinear part of the strains, being in "
                      "equilibrium with loads that are not given. Unit: "
                      "force/area.",
                      Patterns::Anything());
    add_choice(prm,
               "Thickness law",
               law,
               {"symmetric", "asymmetric", "full"},
               "How the thickness strain enters the stiffness: 'symmetric' "
               "(constant thickness stress, eliminated; free of locking), "
               "'asymmetric' (the paper's law, with an unsymmetric tangent) "
               "or 'full' (three-dimensional law; locks in bending).");
    prm.add_parameter("Reference surface",
                      reference,
                      "The surface of the shell that 'Surface' describes: "
                      "'inner', 'middle', 'outer', 'ply N' (the outer side of "
                      "ply N, counted from the inner face), or its distance "
                      "from the inner face. Unit: length.",
                      Patterns::Anything());
  }


  namespace
  {
    /** Split a text at commas, but not within parentheses. */
    std::vector<std::string>
    split_plies(const std::string &text)
    {
      std::vector<std::string> parts(1);
      int                      depth = 0;
      for (const char c : text)
        {
          depth += (c == '(') - (c == ')');
          if (c == ',' && depth <= 0)
            parts.emplace_back();
          else
            parts.back() += c;
        }
      for (std::string &part : parts)
        part = Utilities::trim(part);
      return parts;
    }


    /** Split "from A to B" off the end of the text of a ply, if present. */
    void
    take_range(const std::string &entry,
               std::string       &angle,
               PlyDescription    &ply)
    {
      const auto from = angle.find(" from ");
      if (from == std::string::npos)
        return;
      const std::string form =
        "the covered part must have the form 'from A to B' with numbers A < B";
      const std::vector<std::string> words =
        split_words(angle.substr(from + 6));
      if (words.size() != 3 || words[1] != "to")
        throw InputError(entry, ply.text, form);
      ply.begin = parse_number(entry, words[0], form);
      ply.end   = parse_number(entry, words[2], form);
      if (!(ply.begin < ply.end))
        throw InputError(entry, ply.text, form);
      angle.erase(from);
    }


    std::vector<PlyDescription>
    parse_plies(const Layup::Parameters               &parameters,
                const std::vector<MaterialParameters> &materials,
                const MeridionalTables                &tables)
    {
      const std::string entry = "Laminate/Plies";
      const std::string form  = "each ply must have the form 'material: "
                                "thickness @ angle'";
      std::string       names;
      for (const MaterialParameters &material : materials)
        names += (names.empty() ? "'" : ", '") + material.name + "'";

      // commas within formulas count, too, which is harmless
      check_list_length(entry, parameters.plies, 1000);
      std::vector<PlyDescription> plies;
      for (const std::string &text : split_plies(parameters.plies))
        {
          if (text.empty())
            throw InputError(entry,
                             parameters.plies,
                             "commas must separate plies of the form "
                             "'material: thickness @ angle'");
          PlyDescription ply;
          ply.text         = text;
          const auto colon = text.find(':');
          const auto at    = text.find('@');
          if (colon == std::string::npos || at == std::string::npos ||
              at < colon)
            throw InputError(entry, text, form);

          ply.material = Utilities::trim(text.substr(0, colon));
          const auto material =
            std::find_if(materials.begin(),
                         materials.end(),
                         [&](const auto &m) { return m.name == ply.material; });
          if (material == materials.end())
            throw InputError(
              entry, text, "its material must be one of " + names);
          ply.stiffness = material->stiffness();
          ply.strengths = material->get_strengths();

          std::string angle = text.substr(at + 1);
          take_range(entry, angle, ply);
          angle = Utilities::trim(angle);
          const std::string thickness =
            Utilities::trim(text.substr(colon + 1, at - colon - 1));
          if (thickness.empty() || angle.empty())
            throw InputError(entry, text, form);
          ply.thickness      = tables.parse(entry, thickness);
          const auto degrees = tables.parse(entry, angle);
          ply.angle          = [degrees](const double alpha_1) {
            return degrees(alpha_1) * numbers::PI / 180;
          };
          plies.push_back(ply);
        }
      return plies;
    }


    void
    parse_initial_stresses(const std::string           &text,
                           std::vector<PlyDescription> &plies)
    {
      const std::string entry = "Laminate/Initial ply stresses";
      const std::string form =
        "it must contain one triple 'sigma_L sigma_T tau_LT' per ply (" +
        std::to_string(plies.size()) + " plies), separated by commas";

      const std::vector<std::string> triples =
        Utilities::split_string_list(text, ',');
      if (triples.empty())
        return;
      if (triples.size() != plies.size())
        throw InputError(entry, text, form);
      for (unsigned int p = 0; p < plies.size(); ++p)
        {
          const std::vector<double> stress =
            parse_numbers(entry, triples[p], 3, form);
          plies[p].initial_stress[0][0] = stress[0];
          plies[p].initial_stress[1][1] = stress[1];
          plies[p].initial_stress[0][1] = stress[2];
        }
    }


    /** The height of the reference surface for given plies. */
    std::function<double(const std::vector<Ply> &)>
    parse_reference(const std::string &text, const unsigned int n_plies)
    {
      const std::string entry = "Laminate/Reference surface";
      const std::string form =
        "it must be 'inner', 'middle', 'outer', 'ply N' with N from 1 to " +
        std::to_string(n_plies) + ", or a number";

      // the thickness of the plies with numbers below n
      const auto height = [](const std::vector<Ply> &plies,
                             const unsigned int      n) {
        double sum = 0;
        for (const Ply &ply : plies)
          sum += (ply.number < n ? ply.thickness : 0.);
        return sum;
      };
      const auto fraction_of_thickness = [=](const double fraction) {
        return [=](const std::vector<Ply> &plies) {
          return fraction * height(plies, n_plies);
        };
      };

      if (text == "inner")
        return fraction_of_thickness(0);
      if (text == "middle")
        return fraction_of_thickness(0.5);
      if (text == "outer")
        return fraction_of_thickness(1);
      if (text.rfind("ply ", 0) == 0)
        {
          const double n = parse_number(entry, text.substr(4), form);
          if (!(n >= 1 && n <= n_plies && n == std::floor(n)))
            throw InputError(entry, text, form);
          return [=](const std::vector<Ply> &plies) {
            return height(plies, static_cast<unsigned int>(n));
          };
        }
      const double distance = parse_number(entry, text, form);
      return [=](const std::vector<Ply> &) { return distance; };
    }
  } // namespace


  Layup::Layup(const Parameters                      &parameters,
               const std::vector<MaterialParameters> &materials,
               const MPI_Comm                         communicator)
    : plies(parse_plies(parameters,
                        materials,
                        MeridionalTables(parameters.tables, communicator)))
    , law(parameters.law)
    , reference_height(parse_reference(parameters.reference, plies.size()))
  {
    parse_initial_stresses(parameters.initial_stresses, plies);
  }


  Laminate
  Layup::laminate(const double alpha_1, const double within) const
  {
    std::vector<Ply> present;
    for (unsigned int p = 0; p < plies.size(); ++p)
      {
        const PlyDescription &ply = plies[p];
        if (within < ply.begin || within > ply.end)
          continue;
        const double thickness = ply.thickness(alpha_1);
        if (!(thickness > 0))
          throw InputError("Laminate/Plies",
                           ply.text,
                           "a thickness must be positive, and at alpha_1 = " +
                             number_to_string(alpha_1) + " it is " +
                             number_to_string(thickness));
        present.push_back({ply.stiffness,
                           thickness,
                           ply.angle(alpha_1),
                           ply.initial_stress,
                           p});
      }
    if (present.empty())
      throw InputError(
        "no ply of the entry 'Laminate/Plies' covers alpha_1 = " +
        number_to_string(within) + ".");
    const double height = reference_height(present);
    return Laminate(std::move(present), law, height);
  }
} // namespace Biface
