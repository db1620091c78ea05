// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/input/read_file.h>
#include <biface/surface/plane.h>
#include <biface/surface/quadrilateral_mesh.h>
#include <biface/surface/spline_curve.h>
#include <biface/surface/surface_of_revolution.h>
#include <biface/surface/surface_parameters.h>
#include <biface/surface/surface_without_chart.h>

namespace Biface
{
  using namespace dealii;

  void
  ReferenceSurface::Parameters::add_parameters(EntryDeclarations &prm)
  {
    // the sections of all meridians, so that a file may keep them while another
    // one is chosen
    add_choice(prm,
               "Type",
               type,
               {"surface of revolution", "plane", "mesh"},
               "The reference surface: a curve, the meridian, rotated about "
               "the y axis (the axle of a wheel), the plane z = 0 with the "
               "coordinates alpha_1 = x and alpha_2 = y, or any surface, given "
               "by a mesh from a file ('Surface/Mesh'), which has no "
               "coordinates.");
    add_choice(prm,
               "Meridian",
               meridian,
               {"circular arc", "straight line", "spline", "cord equilibrium"},
               "The meridian of a surface of revolution: a circular arc "
               "(torus, sphere; alpha_1 is its angle), a straight line "
               "(cylinder, cone, annulus; alpha_1 is the length from its "
               "start), a smooth curve through points of a file (alpha_1 "
               "is the length along the polygon of the points), or the shape "
               "of an inflated tire whose cords carry the pressure (alpha_1 "
               "is the length from the crown).");
    prm.enter_subsection("Circular arc");
    circular_arc.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Straight line");
    straight_line.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Cord equilibrium");
    cord_equilibrium.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Spline");
    add_parsed(prm,
               "File",
               "",
               points_file.name,
               parse_file_name,
               "A CSV file with the points of the meridian in order: "
               "radius, axial coordinate. Relative to the parameter "
               "file; see 'Tables' for names in double quotes.",
               // the contents of the file are compared, here and below
               Unit("length") | RestartChange::always);
    prm.add_parameter("Corner radius",
                      corner_radius,
                      "0: the spline passes smoothly through all points, and "
                      "beside a kink it swings. Else kinks, points at which "
                      "the polygon turns by more than 15 degrees and much more "
                      "than at their neighbors, are corners between splines of "
                      "their own, rounded with this least radius of curvature. "
                      "'--check' names them and their intervals of alpha_1, "
                      "which the mesh must resolve. Not negative.",
                      Patterns::Double(),
                      Unit("length"));
    prm.leave_subsection();
    prm.enter_subsection("Mesh");
    mesh.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Imperfection");
    imperfection.add_parameters(prm);
    prm.leave_subsection();
  }


  namespace
  {
    std::shared_ptr<const Meridian>
    make_meridian(const ReferenceSurface::Parameters &parameters)
    {
      using MeridianType = ReferenceSurface::Parameters::MeridianType;
      switch (parameters.meridian)
        {
          case MeridianType::circular_arc:
            return std::make_shared<CircularArc>(parameters.circular_arc);
          case MeridianType::straight_line:
            return std::make_shared<StraightLine>(parameters.straight_line);
          case MeridianType::spline:
            if (parameters.points_file.name.empty())
              throw InputError("Surface/Spline/File",
                               "",
                               "the meridian 'spline' needs a file");
            check_not_negative("Surface/Spline/Corner radius",
                               parameters.corner_radius);
            return std::make_shared<SplineCurve>(parameters.points_file.pairs,
                                                 parameters.points_file.name,
                                                 parameters.corner_radius);
          case MeridianType::cord_equilibrium:
            return std::make_shared<CordEquilibrium>(
              parameters.cord_equilibrium);
        }
      Assert(false, ExcInternalError());
      return {};
    }
  } // namespace


  std::vector<std::string>
  remarks_on_surface(const ReferenceSurface::Parameters &parameters)
  {
    using Parameters = ReferenceSurface::Parameters;
    if (parameters.type == Parameters::Type::mesh)
      return parameters.mesh.mesh->remarks;
    if (parameters.type != Parameters::Type::revolution ||
        (parameters.meridian != Parameters::MeridianType::spline &&
         parameters.meridian != Parameters::MeridianType::straight_line))
      return {};
    const auto               meridian = make_meridian(parameters);
    std::vector<std::string> remarks;
    if (const auto *spline = dynamic_cast<const SplineCurve *>(meridian.get()))
      remarks = spline->get_remarks();

    // the part of the length where the normal, to the right, points to the axis
    constexpr unsigned int n_samples = 1000;
    double                 length = 0, inward = 0;
    const auto [begin, end] = meridian->range();
    for (unsigned int i = 0; i < n_samples; ++i)
      {
        const Tensor<1, 2> along =
          meridian->evaluate(begin + (end - begin) * (i + 0.5) / n_samples)
            .first_derivative;
        length += along.norm();
        if (along[1] < -1e-6 * along.norm())
          inward += along.norm();
      }
    if (inward > length / 2)
      remarks.push_back(
        "Outward, to the right of the meridian, is toward the axis over " +
        number_to_string(std::round(100 * inward / length)) +
        " % of its length, so that pressure on the inner face pushes toward "
        "the axis; with its points in the reverse order outward is away from "
        "it.");
    return remarks;
  }


  std::unique_ptr<ReferenceSurface>
  make_surface(const ReferenceSurface::Parameters &parameters)
  {
    switch (parameters.type)
      {
        case ReferenceSurface::Parameters::Type::revolution:
          return std::make_unique<SurfaceOfRevolution>(
            make_meridian(parameters));
        case ReferenceSurface::Parameters::Type::plane:
          return std::make_unique<Plane>();
        case ReferenceSurface::Parameters::Type::mesh:
          return std::make_unique<SurfaceWithoutChart>();
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
