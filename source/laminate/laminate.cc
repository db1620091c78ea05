// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <map>

#include <biface/base/input_error.h>
#include <biface/base/parameter_tools.h>
#include <biface/laminate/laminate.h>

namespace Biface
{
  using namespace dealii;

  void
  Laminate::Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Plies",
                      plies,
                      "The plies, inner ply first, separated by commas, each "
                      "as 'material: thickness @ angle'. The angle is that of "
                      "the material's first axis, from the first coordinate "
                      "line (the meridian) toward the second. Units: length, "
                      "degrees.",
                      Patterns::Anything());
    prm.add_parameter("Initial ply stresses",
                      initial_stresses,
                      "Stresses present in the undeformed shell, one triple "
                      "'sigma_L sigma_T tau_LT' a ply, inner ply first, "
                      "separated by commas; empty for none. They act in the "
                      "nonlinear part of the strains only, in equilibrium "
                      "with loads that are not listed. Unit: force/area.",
                      Patterns::Anything());
    add_choice(prm,
               "Thickness law",
               law,
               {"symmetric", "asymmetric", "full"},
               "How the thickness strain enters the stiffness: 'symmetric' "
               "(constant thickness stress, eliminated; free of locking), "
               "'asymmetric' (the paper's, with a nonsymmetric tangent) or "
               "'full' (three-dimensional law; locks in bending).");
    prm.add_parameter("Reference surface",
                      reference,
                      "Which surface of the shell the geometry describes: "
                      "'inner', 'middle', 'outer', 'ply N' (the outer side of "
                      "ply N, counted from the inner face), or its distance "
                      "from the inner face. Unit: length.",
                      Patterns::Anything());
  }


  namespace
  {
    std::vector<Ply>
    parse_plies(const Laminate::Parameters            &parameters,
                const std::vector<MaterialParameters> &materials)
    {
      const std::string entry = "Laminate/Plies";
      const std::string form  = "each ply is written 'material: thickness @ "
                                "angle'";

      std::map<std::string, SymmetricTensor<4, 3>> stiffness;
      std::string                                  names;
      for (const MaterialParameters &material : materials)
        {
          stiffness[material.name] = material.stiffness();
          names += (names.empty() ? "'" : ", '") + material.name + "'";
        }

      std::vector<Ply> plies;
      for (const std::string &text :
           Utilities::split_string_list(parameters.plies, ','))
        {
          const auto colon = text.find(':');
          const auto at    = text.find('@');
          if (colon == std::string::npos || at == std::string::npos ||
              at < colon)
            throw InputError(entry, text, form);
          const auto material =
            stiffness.find(Utilities::trim(text.substr(0, colon)));
          if (material == stiffness.end())
            throw InputError(
              entry, text, "its material must be one of " + names);
          const double thickness =
            parse_number(entry, text.substr(colon + 1, at - colon - 1), form);
          if (!(thickness > 0))
            throw InputError(entry, text, "a thickness must lie above 0");
          const double angle =
            parse_number(entry, text.substr(at + 1), form) * numbers::PI / 180;
          plies.push_back({material->second, thickness, angle, {}});
        }
      if (plies.empty())
        throw InputError(
          entry, parameters.plies, "there must be at least one ply");
      return plies;
    }


    void
    parse_initial_stresses(const std::string &text, std::vector<Ply> &plies)
    {
      const std::string entry = "Laminate/Initial ply stresses";
      const std::string form =
        "it must hold one triple 'sigma_L sigma_T tau_LT' a ply (" +
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


    double
    parse_reference(const std::string &text, const std::vector<Ply> &plies)
    {
      const std::string entry = "Laminate/Reference surface";
      const std::string form =
        "it must be 'inner', 'middle', 'outer', 'ply N' with N from 1 to " +
        std::to_string(plies.size()) + ", or a number";

      double h = 0;
      for (const Ply &ply : plies)
        h += ply.thickness;
      if (text == "inner")
        return 0;
      if (text == "middle")
        return h / 2;
      if (text == "outer")
        return h;
      if (text.rfind("ply ", 0) != 0)
        return parse_number(entry, text, form);

      const double n = parse_number(entry, text.substr(4), form);
      if (!(n >= 1 && n <= plies.size() && n == std::floor(n)))
        throw InputError(entry, text, form);
      double height = 0;
      for (unsigned int p = 0; p < n; ++p)
        height += plies[p].thickness;
      return height;
    }
  } // namespace


  Laminate::Laminate(const Parameters                      &parameters,
                     const std::vector<MaterialParameters> &materials)
    : plies(parse_plies(parameters, materials))
    , law(parameters.law)
    , reference_height(parse_reference(parameters.reference, plies))
  {
    parse_initial_stresses(parameters.initial_stresses, plies);
  }


  Laminate::Laminate(std::vector<Ply>   plies,
                     const ThicknessLaw law,
                     const double       reference_height)
    : plies(std::move(plies)), law(law), reference_height(reference_height)
  {}


  double
  Laminate::thickness() const
  {
    double h = 0;
    for (const Ply &ply : plies)
      h += ply.thickness;
    return h;
  }


  std::array<double, 2>
  Laminate::faces() const
  {
    return {{-reference_height, thickness() - reference_height}};
  }


  bool
  Laminate::is_symmetric() const
  {
    return law != ThicknessLaw::asymmetric;
  }


  namespace
  {
    /** @f$\int_{z_0}^{z_1} N^p N^q\,dz@f$ and @f$\int N^p\,dz@f$ over a ply of
     * a shell whose thickness runs from 0 to h. */
    struct FaceMoments
    {
      std::array<double, 2>                first{};
      std::array<std::array<double, 2>, 2> second{};

      FaceMoments(const double z_0, const double z_1, const double h)
      {
        const QGauss<1> quadrature(2);
        for (unsigned int i = 0; i < quadrature.size(); ++i)
          {
            const double z = z_0 + (z_1 - z_0) * quadrature.point(i)[0];
            const std::array<double, 2> N{{1 - z / h, z / h}};
            for (unsigned int p = 0; p < 2; ++p)
              {
                first[p] += quadrature.weight(i) * (z_1 - z_0) * N[p];
                for (unsigned int q = 0; q < 2; ++q)
                  second[p][q] +=
                    quadrature.weight(i) * (z_1 - z_0) * N[p] * N[q];
              }
          }
      }
    };

    // indices of the tensor components 11, 22, 12
    constexpr unsigned int tangential_pairs[3][2] = {{0, 0}, {1, 1}, {0, 1}};
  } // namespace


  Resultants::Matrix
  Laminate::stiffness() const
  {
    using namespace Resultants;

    const double h = thickness();
    Matrix       D;
    // of the symmetric law: f_ab^p and A
    std::array<std::array<double, 2>, 3> f{};
    double                               A = 0;

    double z = 0;
    for (const Ply &ply : plies)
      {
        const SymmetricTensor<4, 3> b =
          rotate_about_normal(ply.stiffness, ply.angle);
        const FaceMoments N(z, z + ply.thickness, h);
        z += ply.thickness;

        const double b_3333 = b[2][2][2][2];
        A += ply.thickness / b_3333;

        for (unsigned int ab = 0; ab < 3; ++ab)
          {
            const auto  &i      = tangential_pairs[ab];
            const double b_ab33 = b[i[0]][i[1]][2][2];
            for (unsigned int p = 0; p < 2; ++p)
              {
                f[ab][p] += b_ab33 / b_3333 * N.first[p];
                if (law != ThicknessLaw::symmetric)
                  D[Resultants::thickness][tangential(ab, p)] +=
                    b_ab33 * N.first[p];
                if (law == ThicknessLaw::full)
                  D[tangential(ab, p)][Resultants::thickness] +=
                    b_ab33 * N.first[p];
              }
            for (unsigned int cd = 0; cd < 3; ++cd)
              {
                const auto  &j      = tangential_pairs[cd];
                const double b_abcd = b[i[0]][i[1]][j[0]][j[1]];
                const double q_abcd =
                  b_abcd - b_ab33 * b[2][2][j[0]][j[1]] / b_3333;
                for (unsigned int p = 0; p < 2; ++p)
                  for (unsigned int q = 0; q < 2; ++q)
                    D[tangential(ab, p)][tangential(cd, q)] +=
                      (law == ThicknessLaw::full ? b_abcd : q_abcd) *
                      N.second[p][q];
              }
          }

        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int p = 0; p < 2; ++p)
              for (unsigned int q = 0; q < 2; ++q)
                D[transverse(a, p)][transverse(c, q)] +=
                  b[a][2][c][2] * N.second[p][q];

        if (law != ThicknessLaw::symmetric)
          D[Resultants::thickness][Resultants::thickness] +=
            b_3333 * ply.thickness;
      }

    if (law == ThicknessLaw::symmetric)
      {
        for (unsigned int ab = 0; ab < 3; ++ab)
          for (unsigned int p = 0; p < 2; ++p)
            {
              for (unsigned int cd = 0; cd < 3; ++cd)
                for (unsigned int q = 0; q < 2; ++q)
                  D[tangential(ab, p)][tangential(cd, q)] +=
                    f[ab][p] * f[cd][q] / A;
              D[tangential(ab, p)][Resultants::thickness] =
                D[Resultants::thickness][tangential(ab, p)] = h * f[ab][p] / A;
            }
        D[Resultants::thickness][Resultants::thickness] = h * h / A;
      }
    return D;
  }


  Resultants::Vector
  Laminate::initial_resultants() const
  {
    using namespace Resultants;

    const double h = thickness();
    Vector       H;
    double       z = 0;
    for (const Ply &ply : plies)
      {
        const SymmetricTensor<2, 3> stress =
          rotate_about_normal(ply.initial_stress, ply.angle);
        const FaceMoments N(z, z + ply.thickness, h);
        z += ply.thickness;

        for (unsigned int p = 0; p < 2; ++p)
          {
            for (unsigned int ab = 0; ab < 3; ++ab)
              H[tangential(ab, p)] +=
                stress[tangential_pairs[ab][0]][tangential_pairs[ab][1]] *
                N.first[p];
            for (unsigned int a = 0; a < 2; ++a)
              H[transverse(a, p)] += stress[a][2] * N.first[p];
          }
        H[Resultants::thickness] += stress[2][2] * ply.thickness;
      }
    return H;
  }
} // namespace Biface
