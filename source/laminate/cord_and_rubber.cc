// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/laminate/cord_and_rubber.h>

namespace Biface
{
  using namespace dealii;

  void
  CordAndRubber::add_parameters(EntryDeclarations &prm)
  {
    // 0 stands for what is not given; check() asks for it where the material is
    // of this type
    prm.add_parameter("E_cord",
                      E_cord,
                      "Young's modulus of the cords.",
                      Patterns::Double(),
                      Unit("force/area"));
    add_parsed(prm,
               "Cord curve",
               "",
               curve.name,
               parse_file_name,
               "A CSV file with the measured curve of a cord, instead of "
               "'E_cord': stretch, force, from 1, 0 on, both increasing. Only "
               "with 'Matrix = neo-Hooke'; in compression the slope at the "
               "stretch 1 remains. Relative to the parameter file; see "
               "'Tables' for names in double quotes. Unit of the forces: "
               "force.",
               // the contents of the file are compared
               RestartChange::always);
    prm.add_parameter("nu_cord",
                      nu_cord,
                      "Poisson's ratio of the cords; it has little effect.",
                      Patterns::Double(),
                      Unit::none());
    prm.add_parameter("E_rubber",
                      E_rubber,
                      "Young's modulus of the rubber.",
                      Patterns::Double(),
                      Unit("force/area"));
    prm.add_parameter("nu_rubber",
                      nu_rubber,
                      "Poisson's ratio of the rubber, at least 0.4 and less "
                      "than 0.5.",
                      Patterns::Double(),
                      Unit::none());
    prm.add_parameter("Cord diameter",
                      cord_diameter,
                      "Diameter of a cord, taken as a full circle.",
                      Patterns::Double(),
                      Unit("length"));
    prm.add_parameter("Cord pitch",
                      cord_pitch,
                      "Distance between the centers of neighboring cords, "
                      "across them, at the crown, the largest radius of the "
                      "mesh. On a surface of revolution the number of cords "
                      "is the same everywhere, so that their distance is "
                      "proportional to r sin(beta) with the angle beta from "
                      "the circumference; on a plane, and for cords along the "
                      "circumference, it is constant.",
                      Patterns::Double(),
                      Unit("length"));
    add_choice(prm,
               "Homogenization",
               homogenization,
               {"Halpin-Tsai", "Akasaka-Hirano"},
               "The moduli across the cords: 'Halpin-Tsai', or "
               "'Akasaka-Hirano' for inextensible cords in incompressible "
               "rubber.");
    add_choice(prm,
               "Ply thickness",
               thickness,
               {"constant volume", "as given"},
               "How the thickness given in 'Laminate/Plies' is understood: "
               "'constant volume', at the crown, from which it grows as the "
               "cords come closer, since rubber keeps its volume, or 'as "
               "given', everywhere; then the volume fraction of cords, and "
               "the moduli, vary.");
  }


  void
  CordAndRubber::check(const std::string &name) const
  {
    const std::string section = "Material " + name + "/";
    if (curve.name.empty())
      check_positive(section + "E_cord", E_cord);
    else if (E_cord != 0)
      throw InputError(section + "E_cord",
                       number_to_string(E_cord),
                       "it may only be given without 'Cord curve'");
    check_positive(section + "E_rubber", E_rubber);
    check_positive(section + "Cord diameter", cord_diameter);
    check_positive(section + "Cord pitch", cord_pitch);
    if (!(cord_modulus() >= 10 * E_rubber))
      throw InputError(
        section + (curve.name.empty() ? "E_cord" : "Cord curve"),
        curve.name.empty() ? number_to_string(E_cord) : curve.name,
        (curve.name.empty() ? std::string()
                            : "its modulus at the stretch 1 is " +
                                number_to_string(cord_modulus()) + ", but ") +
          "it must be at least ten times 'E_rubber'");
    if (!(nu_cord >= 0 && nu_cord < 0.5))
      throw InputError(section + "nu_cord",
                       number_to_string(nu_cord),
                       "it must be at least 0 and less than 0.5");
    if (!(nu_rubber >= 0.4 && nu_rubber < 0.5))
      throw InputError(section + "nu_rubber",
                       number_to_string(nu_rubber),
                       "it must be at least 0.4 and less than 0.5");
    if (!(cord_diameter < cord_pitch))
      throw InputError(section + "Cord pitch",
                       number_to_string(cord_pitch),
                       "it must be greater than the diameter of the cords");
  }


  std::shared_ptr<const ForceCurve>
  CordAndRubber::force_curve() const
  {
    return curve.name.empty() ? nullptr
                              : std::make_shared<const ForceCurve>(curve);
  }


  double
  CordAndRubber::cord_modulus() const
  {
    // the cords carry the force of the curve by its slope at the stretch 1,
    // over their own area
    return curve.name.empty() ? E_cord
                              : ForceCurve(curve).initial_slope() / cord_area();
  }


  double
  CordAndRubber::cord_area() const
  {
    return numbers::PI / 4 * cord_diameter * cord_diameter;
  }


  Material
  CordAndRubber::ply_material(const double v) const
  {
    const double E_c = cord_modulus();
    const double G_c = E_c / (2 * (1 + nu_cord));
    const double G_r = E_rubber / (2 * (1 + nu_rubber));

    // cords and rubber have the same strain along the cords
    const double E_L   = v * E_c + (1 - v) * E_rubber;
    double       nu_LT = 0, E_T = 0, G_LT = 0;
    if (homogenization == Homogenization::halpin_tsai)
      {
        // for a property p with the factor xi
        const auto halpin_tsai =
          [v](const double p_c, const double p_r, const double xi) {
            const double eta = (p_c / p_r - 1) / (p_c / p_r + xi);
            return p_r * (1 + xi * eta * v) / (1 - eta * v);
          };
        nu_LT = v * nu_cord + (1 - v) * nu_rubber;
        E_T   = halpin_tsai(E_c, E_rubber, 2);
        G_LT  = halpin_tsai(G_c, G_r, 1);
      }
    else
      {
        // inextensible cords in incompressible rubber
        nu_LT = 0.5;
        E_T   = 4 * E_rubber / (3 * (1 - v));
        G_LT  = E_rubber / (3 * (1 - v));
      }

    // Neither homogenization gives the constants in the plane across the cords:
    // they follow from Hill's bulk modulus of a composite of cylinders and an
    // identity of transverse isotropy (section 4 of doc/theory.md, "Cords in
    // rubber").
    // bulk moduli in plane strain
    const double K_c = G_c / (1 - 2 * nu_cord);
    const double K_r = G_r / (1 - 2 * nu_rubber);
    const double K_T = (K_r * (K_c + G_r) * (1 - v) + K_c * (K_r + G_r) * v) /
                       ((K_c + G_r) * (1 - v) + (K_r + G_r) * v);
    const double G_TT = 1 / (4 / E_T - 1 / K_T - 4 * nu_LT * nu_LT / E_L);
    return Material::transversely_isotropic(
      E_L, E_T, G_LT, G_TT, nu_LT, E_T / (2 * G_TT) - 1);
  }
} // namespace Biface
