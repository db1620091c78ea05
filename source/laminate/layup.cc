// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>

namespace Biface
{
  using namespace dealii;

  void
  Layup::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_plies(prm);
    add_initial_stresses(prm);
    add_laws(prm);
  }


  void
  Layup::Parameters::add_plies(EntryDeclarations &prm)
  {
    // texts are parsed as they are read, so that a message names the entry; the
    // names in them are known only to check()
    add_parsed(prm,
               "Plies",
               "cord: 1.2 @ 52, cord: 1.2 @ -52, cord: 1.2 @ 52, "
               "cord: 1.2 @ -52",
               plies,
               parse_plies,
               "The plies, inner ply first, separated by commas, each "
               "as 'material: thickness @ angle', followed by 'from A "
               "to B' if the ply covers only this part of alpha_1 "
               "(between two mesh lines; the jump in thickness is "
               "spread over the cells on both sides; both may be formulas "
               "of 'end', the largest alpha_1 of the surface), or on a mesh "
               "from a file by 'in GROUP' if it covers only this group of "
               "cells. The angle "
               "of the material's first axis is measured from the first "
               "coordinate line (the meridian) toward the second, see "
               "'Angle reference'. An angle '+-A' means two plies, at A and "
               "-A, an angle '-+A' two at -A and A, and 'N x (...)' repeats "
               "the plies in parentheses. "
               "Thickness and angle are numbers, or formulas of "
               "alpha_1 and of the 'Tables', such as 1.2 + "
               "0.01*abs(alpha_1). On a surface of revolution they know "
               "'end', the radius r of the reference surface and the function "
               "lift(A), the angle of cords that have the angle A at the "
               "crown, the largest radius of the mesh, and pantograph: "
               "the cosine of their angle from the circumference is "
               "proportional to r. With the meridian 'cord equilibrium' "
               "they know its crown cord angle beta_c. On a mesh from a "
               "file they are formulas of the position x, y, z instead, such "
               "as 2 - 0.01*x: nodes have the thickness there, and a cell has "
               "the stiffness of its center.",
               Unit::several("length, degrees, alpha_1 as in 'Mesh'"));
    add_parsed(
      prm,
      "Plies file",
      "",
      plies_file,
      parse_file_name,
      "A CSV file with the plies instead of 'Plies': a line for each, "
      "inner ply first, 'material, thickness, angle', followed by 'from, to' "
      "or 'group' as in 'Plies', after a line of these names, which may "
      "be missing; lines that start with '#' are comments. The "
      "cells are as in 'Plies'; those with a comma outside of "
      "parentheses stand in double quotes. In parameters.prm the "
      "plies are those of 'Plies', and so they are in 'Study' and "
      "'Sensitivities'. Relative to the parameter file.");
    add_choice(prm,
               "Angle reference",
               angle_reference,
               {"meridian", "circumference"},
               "The direction from which the angles in 'Plies' are counted: "
               "'meridian', from alpha_1 toward alpha_2, or 'circumference', "
               "from alpha_2 toward alpha_1, as usual for tires.");
    add_parsed(
      prm,
      "Tables",
      "",
      tables,
      [](const std::string &entry, const std::string &text) {
        return parse_tables(entry, text, "alpha_1");
      },
      "Tables for the formulas of 'Plies': a list of 'name: "
      "file', separated by commas. Each CSV file has rows "
      "'alpha_1, value' with increasing alpha_1; values are "
      "interpolated linearly and constant beyond the ends. "
      "Paths are relative to the parameter file. A name with "
      "a comma must be put in double quotes, in which %XX "
      "stands for the byte with this hexadecimal number.",
      // the contents of the files are compared
      RestartChange::always);
  }


  void
  Layup::Parameters::add_initial_stresses(EntryDeclarations &prm)
  {
    add_parsed(prm,
               "Initial ply stresses",
               "",
               initial_stresses,
               parse_ply_stresses,
               "Initial stresses in the undeformed shell, one triple "
               "'sigma_L sigma_T tau_LT' per ply, inner ply first, separated "
               "by commas; empty for none. Each is a number or a formula, "
               "without blanks, as in 'Plies'. They act only through the "
               "nonlinear part of the strains: the loads that balance them "
               "in the undeformed shell are not part of the model.",
               Unit("force/area"));
    add_parsed(
      prm,
      "Initial resultants",
      "",
      initial_resultants,
      parse_initial_resultants,
      "Initial resultants, the eleven H_ij of the theory, as functions "
      "of the position, added to those of 'Initial ply stresses': a "
      "list of 'H_ij FACE = FORMULA', separated by semicolons, with ij "
      "one of 11, 22, 12, 13, 23 and FACE one of inner, outer, both, or "
      "'H_33 = FORMULA'. A membrane force N is N/2 on both faces. The "
      "formulas are those of 'Loads/Pressure distribution'. They act "
      "like initial stresses, but are not part of the stresses of "
      "plies.",
      Unit("force/length"));
  }


  void
  Layup::Parameters::add_laws(EntryDeclarations &prm)
  {
    add_choice(prm,
               "Thickness law",
               law,
               {"symmetric", "asymmetric"},
               "How the thickness strain enters the stiffness: 'symmetric' "
               "(constant thickness stress, eliminated; free of locking) or "
               "'asymmetric' (the law of Grigolyuk, Kulikov and Plotnikova "
               "(2004), with an unsymmetric tangent, for 'Formulation = "
               "paper').");
    add_parsed(prm,
               "Transverse shear",
               "automatic",
               shear_law,
               parse_transverse_shear,
               "How the transverse shear strains of the faces enter the "
               "stiffness: 'constant strain' (the paper's law; too stiff, by "
               "1/5 for a homogeneous shell and more for thick laminates), "
               "'equilibrium' (the stiffness of the shear stresses in "
               "equilibrium with the bending stresses of the plies; 5/6 of "
               "'constant strain' for a homogeneous shell), or a factor, a "
               "number or formula above 0 and at most 1 such as 5/6, by which "
               "'constant strain' is multiplied. 'automatic': 'equilibrium' "
               "in a wall of one isotropic material with 'Formulation = "
               "standard' and one of 'Layers', 'constant strain' otherwise.");
    add_parsed(prm,
               "Gradient factor",
               "by layers",
               gradient_factor,
               parse_gradient_factor,
               "Multiplies the stiffness of each layer against opposite "
               "transverse shear strains of its faces, those of a gradient of "
               "the thickness strain, which keeps a face that is compressed "
               "from wrinkling on cells shorter than the layer is thick: a "
               "number from 1 (the law itself) to 1000, or 'by layers', 8 if "
               "there are several 'Layers', 1 otherwise.");
    add_parsed(
      prm,
      "Layers",
      "one",
      layers,
      parse_layers,
      "The layers of the wall, in each of which displacements are "
      "linear in the height, so that L layers have L + 1 faces: 'one' "
      "of all plies; 'one per ply' or 'N per ply'; or the number of "
      "plies in each layer, inner layer first, separated by commas. "
      "Numbers may be fractions, such as 4, 1/2, 1/2: a ply is divided "
      "there. A soft ply next to a stiff one, such as a tread or the "
      "core of a sandwich, needs a layer of its own. With several "
      "layers, the transverse shear strain of each has its own "
      "stiffness, see 'Transverse shear'.");
    add_choice(
      prm,
      "Integrals",
      integrals,
      {"plate", "shell"},
      "The lengths and areas over which plies are integrated: "
      "'plate', the same over the thickness, as in Grigolyuk, Kulikov "
      "and Plotnikova (2004), or 'shell', which grow with the distance "
      "from the centers of curvature: it matters for plies of different "
      "stiffness on the two sides of a thick wall, by terms of the "
      "order of the thickness over the radius.");
    add_parsed(prm,
               "Reference surface",
               "inner",
               reference,
               parse_thickness_position,
               "The surface of the shell that 'Surface' describes: "
               "'inner', 'middle', 'outer', 'ply N' (the outer side of "
               "ply N, counted from the inner face), or its distance "
               "from the inner face.",
               Unit("length"));
  }


  TransverseShearLaw
  Layup::Parameters::shear_law_of_layers(const bool homogeneous) const
  {
    using Kind                 = TransverseShearLaw::Kind;
    const bool         layered = n_layers() > 1;
    TransverseShearLaw result;
    if (shear_law)
      result = *shear_law;
    else if (of_standard_element && !layered && homogeneous)
      result.kind = Kind::equilibrium;
    result.gradient_factor = gradient_factor.value_or(layered ? 8 : 1);
    return result;
  }


  void
  Layup::Parameters::check(const std::vector<MaterialParameters> &materials,
                           const PlyVariables &variables) const
  {
    std::string names;
    for (const MaterialParameters &material : materials)
      names += (names.empty() ? "'" : ", '") + material.name + "'";
    for (const PlyParameters &ply : plies)
      {
        const auto material =
          std::find_if(materials.begin(), materials.end(), [&](const auto &m) {
            return m.name == ply.material;
          });
        if (material == materials.end())
          throw InputError(
            "Laminate/Plies", ply.text, "its material must be one of " + names);
        // here, and not for all materials: those that no ply uses may be
        // incomplete
        material->check();
        if ((material->is_hyperelastic() || material->relaxes()) &&
            law != ThicknessLaw::symmetric)
          throw InputError("the entry 'Laminate/Thickness law' must be "
                           "'symmetric' with the law of the material '" +
                           material->name + "', which is not linear.");
        if (material->has_slack_cords() && !initial_resultants.empty())
          throw InputError("the entry 'Laminate/Initial resultants' must be "
                           "empty with cords that go slack ('Material " +
                           material->name +
                           "/E_L compression'), since these resultants are "
                           "not those of single plies; use 'Laminate/Initial "
                           "ply stresses' instead.");
        const PlyMaterial of_ply = material->of_ply();
        if (of_ply.loss_factor > 0 && of_ply.is_hyperelastic)
          throw InputError("the entry 'Material " + material->name +
                           "/Loss factor' may only be given with a linear "
                           "law.");
        for (Formula formula : {ply.thickness, ply.angle})
          variables.bind(formula, tables);
      }

    if (!initial_stresses.empty() && initial_stresses.size() != plies.size())
      {
        std::string text;
        for (const auto &triple : initial_stresses)
          text += (text.empty() ? "" : ", ") + triple[0].get_text() + " " +
                  triple[1].get_text() + " " + triple[2].get_text();
        throw InputError("Laminate/Initial ply stresses",
                         text,
                         "it must contain one triple 'sigma_L sigma_T tau_LT' "
                         "per ply (" +
                           std::to_string(plies.size()) +
                           " plies), separated by commas");
      }
    for (const auto &triple : initial_stresses)
      for (Formula formula : triple)
        variables.bind(formula, tables);

    if (reference.kind == ThicknessPosition::Kind::ply &&
        reference.value > plies.size())
      throw InputError("Laminate/Reference surface",
                       "ply " + number_to_string(reference.value),
                       "N must lie between 1 and " +
                         std::to_string(plies.size()));
    check_layers();
  }


  void
  Layup::Parameters::check_layers() const
  {
    constexpr unsigned int max_layers = 100;

    const std::vector<double> sides    = layers.sides(plies.size());
    const unsigned int        n_layers = sides.size() - 1;
    if (sides.back() != plies.size())
      throw InputError("the entry 'Laminate/Layers' must contain all plies of "
                       "'Laminate/Plies', " +
                       std::to_string(plies.size()) + ", but contains " +
                       number_to_string(sides.back()) + ".");
    if (n_layers > max_layers)
      throw InputError("the entry 'Laminate/Layers' divides the wall into " +
                       std::to_string(n_layers) + " layers, but at most " +
                       std::to_string(max_layers) + " are allowed.");
    if (n_layers == 1)
      return;
    if (shear_law && shear_law->kind == TransverseShearLaw::Kind::factor)
      throw InputError(
        "the entry 'Laminate/Transverse shear' must be 'automatic', 'constant "
        "strain' or 'equilibrium' with several layers ('Laminate/Layers'): the "
        "deflection would converge to a wrong limit with a factor.");
    if (!initial_resultants.empty())
      throw InputError(
        "the entry 'Laminate/Initial resultants' must be empty with several "
        "layers ('Laminate/Layers'), since these resultants are those of the "
        "whole wall; use 'Laminate/Initial ply stresses' instead.");
  }


  namespace
  {
    /** An angle in degrees as that from e_1 toward e_2 in radians, between
     * -90 and 90 degrees if @p reference is the circumference. */
    double
    angle_from_meridian(const double angle, const AngleReference reference)
    {
      return (reference == AngleReference::meridian
                ? angle
                : std::remainder(90 - angle, 180)) *
             numbers::PI / 180;
    }


    /** The distance of the cords by alpha_1, see CordAndRubber::cord_pitch. */
    std::function<double(const PlyPlace &)>
    make_cord_pitch(const CordAndRubber                           &material,
                    const std::function<double(const PlyPlace &)> &angle,
                    const SurfaceOfPlies                          &surface)
    {
      // On a surface of revolution the number of cords is the same everywhere,
      // on other surfaces, and along the circumference, the distance.
      const double at_crown = material.cord_pitch;
      const double sine     = std::abs(std::cos(angle(surface.crown)));
      if (!surface.radius || sine < 1e-6)
        return [at_crown](const PlyPlace &) { return at_crown; };
      // the distance t is proportional to r sin(beta), section 4 of
      // doc/theory.md; the cosine of the angle from the meridian is sin(beta)
      const double factor = at_crown / (surface.radius(surface.crown) * sine);
      return [factor, angle, radius = surface.radius](const PlyPlace &place) {
        return factor * radius(place.alpha_1) *
               std::abs(std::cos(angle(place)));
      };
    }


    /** Let a ply with the thickness and angle given consist of cords in
     * rubber. */
    void
    set_cords(const MaterialParameters &material,
              const SurfaceOfPlies     &surface,
              PlyDescription           &ply)
    {
      const CordAndRubber &cords = material.cord_and_rubber;
      ply.cord_pitch             = make_cord_pitch(cords, ply.angle, surface);
      // pitch times thickness is constant as the volume of the rubber
      if (cords.thickness == CordAndRubber::Thickness::constant_volume)
        ply.thickness = [given    = ply.thickness,
                         pitch    = ply.cord_pitch,
                         at_crown = cords.cord_pitch](const PlyPlace &place) {
          return given(place) * at_crown / pitch(place);
        };
      ply.laws = [material,
                  text      = ply.text,
                  pitch     = ply.cord_pitch,
                  thickness = ply.thickness](
                   const PlyPlace              &place,
                   const SymmetricTensor<2, 3> &initial_stress) {
        // the volume fraction of the section normal to the cords; cords that
        // touch leave no rubber between them
        const CordAndRubber &cords = material.cord_and_rubber;
        const double         t = thickness(place), P = pitch(place);
        if (!(P > cords.cord_diameter && t > cords.cord_diameter))
          throw InputError(
            "Laminate/Plies",
            text,
            "at " + place.in_words() + " its cords of the diameter " +
              number_to_string(cords.cord_diameter) + " have the distance " +
              number_to_string(P) + " in the thickness " + number_to_string(t) +
              ", but both must be greater than the diameter");
        return material.laws(cords.cord_area() / (P * t), initial_stress);
      };
    }


    /** The material of a name, which exists. */
    const MaterialParameters &
    find_material(const std::vector<MaterialParameters> &materials,
                  const std::string                     &name)
    {
      const auto material =
        std::find_if(materials.begin(), materials.end(), [&](const auto &m) {
          return m.name == name;
        });
      Assert(material != materials.end(), ExcInternalError());
      return *material;
    }


    /** Throw InputError if there is no group of cells that a ply covers. */
    void
    check_group(const PlyParameters &ply, const SurfaceOfPlies &surface)
    {
      if (ply.group.empty())
        return;
      if (!surface.groups)
        throw InputError("Laminate/Plies",
                         ply.text,
                         "only a mesh from a file has groups; use 'from A to "
                         "B'");
      std::string names;
      for (const std::string &name : *surface.groups)
        if (name == ply.group)
          return;
        else
          names += (names.empty() ? "'" : ", '") + name + "'";
      throw InputError("Laminate/Plies",
                       ply.text,
                       names.empty() ? "the mesh has no group of cells"
                                     : "the groups of cells are " + names);
    }


    /** A ply without its initial stress. Throws InputError if it covers
     * nothing. */
    PlyDescription
    describe(const PlyParameters      &given,
             const MaterialParameters &material,
             const SurfaceOfPlies     &surface,
             const MeridionalTables   &tables,
             const AngleReference      angle_reference)
    {
      PlyDescription ply;
      ply.text           = given.text;
      ply.material       = material.of_ply();
      ply.thickness      = tables.function(given.thickness);
      const auto degrees = tables.function(given.angle);
      ply.angle          = [degrees, angle_reference](const PlyPlace &place) {
        return angle_from_meridian(degrees(place), angle_reference);
      };
      ply.varies = !given.thickness.used_names().empty() ||
                   !given.angle.used_names().empty();
      if (material.type == MaterialParameters::Type::cord_and_rubber)
        set_cords(material, surface, ply);
      else
        ply.laws = [material](const PlyPlace &,
                              const SymmetricTensor<2, 3> &initial) {
          return material.laws(0, initial);
        };
      std::tie(ply.begin, ply.end) = given.covered_part(surface.end);
      ply.group                    = given.group;
      check_group(given, surface);
      return ply;
    }


    /** The initial stress of a ply by the place, see PlyStresses. */
    std::function<SymmetricTensor<2, 3>(const PlyPlace &)>
    make_initial_stress(const PlyStresses::value_type &triple,
                        const MeridionalTables        &tables)
    {
      return [L  = tables.function(triple[0]),
              T  = tables.function(triple[1]),
              LT = tables.function(triple[2])](const PlyPlace &place) {
        SymmetricTensor<2, 3> stress;
        stress[0][0] = L(place);
        stress[1][1] = T(place);
        stress[0][1] = LT(place);
        return stress;
      };
    }
  } // namespace


  Layup::Layup(const Parameters                      &parameters,
               const std::vector<MaterialParameters> &materials,
               const SurfaceOfPlies                  &surface)
    : sides_of_layers(parameters.layers.sides(parameters.plies.size()))
    , law(parameters.law)
    , curvature(parameters.integrals == ThicknessIntegrals::shell
                  ? surface.curvature
                  : nullptr)
    , reference(parameters.reference)
    , initial_resultants(parameters.initial_resultants)
  {
    parameters.check(materials, PlyVariables(surface));
    const AngleReference   angle_reference = parameters.angle_reference;
    const MeridionalTables tables(parameters.tables, surface, angle_reference);
    for (unsigned int p = 0; p < parameters.plies.size(); ++p)
      {
        const PlyParameters &given = parameters.plies[p];
        plies.push_back(describe(given,
                                 find_material(materials, given.material),
                                 surface,
                                 tables,
                                 angle_reference));
        if (parameters.initial_stresses.empty())
          continue;
        const auto &triple          = parameters.initial_stresses[p];
        plies.back().initial_stress = make_initial_stress(triple, tables);
        for (const Formula &stress : triple)
          plies.back().varies =
            plies.back().varies || !stress.used_names().empty();
      }
    const auto is_of_same = [&](const PlyParameters &ply) {
      return ply.material == parameters.plies[0].material &&
             find_material(materials, ply.material).type ==
               MaterialParameters::Type::isotropic;
    };
    shear_law = parameters.shear_law_of_layers(std::all_of(
      parameters.plies.begin(), parameters.plies.end(), is_of_same));
  }


  namespace
  {
    /** The height of a position above the inner face, in given plies. */
    double
    height(const ThicknessPosition &position, const std::vector<Ply> &plies)
    {
      // plies are counted by their numbers in the whole layup, of which some
      // may not be present here
      double thickness = 0, below = 0;
      for (const Ply &ply : plies)
        {
          thickness += ply.thickness;
          if (ply.number < position.value)
            below += ply.thickness;
        }
      switch (position.kind)
        {
          case ThicknessPosition::Kind::fraction:
            return position.value * thickness;
          case ThicknessPosition::Kind::ply:
            return below;
          case ThicknessPosition::Kind::distance:
            return position.value;
        }
      Assert(false, ExcInternalError());
      return 0;
    }
  } // namespace


  std::vector<Ply>
  Layup::plies_at(const PlyPlace &place, const double within) const
  {
    std::vector<Ply> present;
    for (unsigned int p = 0; p < plies.size(); ++p)
      {
        const PlyDescription &ply = plies[p];
        // at the end of a ply, this selects the side
        if (within < ply.begin || within > ply.end)
          continue;
        const double thickness = ply.thickness(place);
        if (!(thickness > 0))
          throw InputError("Laminate/Plies",
                           ply.text,
                           "a thickness must be positive, and at " +
                             place.in_words() + " it is " +
                             number_to_string(thickness));
        const SymmetricTensor<2, 3> initial_stress =
          ply.initial_stress ? ply.initial_stress(place)
                             : SymmetricTensor<2, 3>();
        present.push_back({ply.laws(place, initial_stress),
                           thickness,
                           ply.angle(place),
                           initial_stress,
                           p,
                           ply.cord_pitch ? ply.cord_pitch(place) : 0,
                           ply.material});
      }
    if (present.empty())
      throw InputError(
        "no ply of the entry 'Laminate/Plies' covers alpha_1 = " +
        number_to_string(within) + ".");
    return present;
  }


  Laminate
  Layup::laminate(const PlyPlace &place, const double within) const
  {
    std::vector<Ply> present          = plies_at(place, within);
    const double     reference_height = height(reference, present);
    return Laminate(std::move(present),
                    law,
                    reference_height,
                    shear_law,
                    curvature ? curvature(place.alpha_1)
                              : std::array<double, 2>{{0, 0}},
                    {},
                    along_normal);
  }


  std::vector<std::optional<Laminate>>
  Layup::layers(const PlyPlace &place, const double within) const
  {
    const std::vector<Ply> present          = plies_at(place, within);
    const double           reference_height = height(reference, present);

    const std::array<double, 2> at =
      (curvature ? curvature(place.alpha_1) : std::array<double, 2>{{0, 0}});

    std::vector<std::vector<Ply>> parts(n_layers());
    std::vector<Ply>              all;
    for (unsigned int k = 0; k < n_layers(); ++k)
      for (Ply ply : present)
        {
          // sides are counted in plies, also in fractions of them: this is the
          // part of the ply that lies in the layer
          ply.begin = std::max(0., sides_of_layers[k] - ply.number);
          ply.end   = std::min(1., sides_of_layers[k + 1] - ply.number);
          if (!(ply.begin < ply.end))
            continue;
          ply.thickness *= ply.end - ply.begin;
          parts[k].push_back(ply);
          all.push_back(ply);
        }

    // equilibrium with bending is that of the whole wall, of whose distribution
    // of shear each layer takes its part
    WallOfLayer wall;
    double      h = 0;
    if (n_layers() > 1)
      {
        // the reference surface and the distribution of shear are those of all
        // plies together
        const Laminate undivided(
          std::move(all), law, reference_height, shear_law, at);
        h          = undivided.thickness();
        wall.shear = std::make_shared<const TransverseShear>(
          undivided.get_transverse_shear());
      }
    std::vector<std::optional<Laminate>> result;
    for (std::vector<Ply> &part : parts)
      {
        if (part.empty())
          {
            result.emplace_back();
            continue;
          }
        const unsigned int n_plies = part.size();
        // heights of a layer are counted from its own inner face
        result.emplace_back(Laminate(std::move(part),
                                     law,
                                     reference_height - wall.height_below,
                                     shear_law,
                                     at,
                                     wall,
                                     along_normal));
        const double thickness = result.back()->thickness();
        if (thickness < 1e-6 * h)
          throw InputError("the entry 'Laminate/Layers' makes layer " +
                           std::to_string(result.size()) + " " +
                           number_to_string(thickness) + " thick at " +
                           place.in_words() +
                           ", but a layer must have at least a millionth of "
                           "the thickness of the wall, " +
                           number_to_string(h) + ".");
        wall.n_below += n_plies;
        wall.height_below += thickness;
      }
    return result;
  }


  std::set<std::string>
  Layup::groups() const
  {
    std::set<std::string> result;
    for (const PlyDescription &ply : plies)
      result.insert(ply.group);
    return result;
  }


  Layup
  Layup::in_groups(const std::set<std::string> &groups) const
  {
    Layup result = *this;
    for (PlyDescription &ply : result.plies)
      if (!ply.group.empty() && groups.count(ply.group) == 0)
        std::tie(ply.begin, ply.end) =
          std::make_pair(std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity());
    return result;
  }


  bool
  Layup::varies() const
  {
    return std::any_of(
      plies.begin(), plies.end(), [](const auto &ply) { return ply.varies; });
  }


  bool
  Layup::has_fibers() const
  {
    return any_material(
      [](const PlyMaterial &material) { return material.has_fibers; });
  }


  bool
  Layup::has_cords() const
  {
    return std::any_of(plies.begin(), plies.end(), [](const auto &ply) {
      return static_cast<bool>(ply.cord_pitch);
    });
  }


  bool
  Layup::has_slack_cords() const
  {
    return any_material(
      [](const PlyMaterial &material) { return material.has_slack_cords; });
  }


  bool
  Layup::relaxes() const
  {
    return any_material(
      [](const PlyMaterial &material) { return material.relaxes; });
  }


  bool
  Layup::is_hyperelastic() const
  {
    return any_material(
      [](const PlyMaterial &material) { return material.is_hyperelastic; });
  }


  bool
  Layup::has_loss() const
  {
    return any_material([](const PlyMaterial &material) {
      return material.loss_factor > 0 || material.relaxes;
    });
  }


  bool
  Layup::any_material(const std::function<bool(const PlyMaterial &)> &is) const
  {
    return std::any_of(plies.begin(), plies.end(), [&](const auto &ply) {
      return is(ply.material);
    });
  }
} // namespace Biface
