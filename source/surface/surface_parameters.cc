// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/surface/plane.h>
#include <biface/surface/spline_curve.h>
#include <biface/surface/surface_of_revolution.h>
#include <biface/surface/surface_parameters.h>

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
               {"surface of revolution", "plane"},
               "The reference surface: a curve, the meridian, rotated about "
               "the y axis (the axle of a wheel), or the plane z = 0 with the "
               "coordinates alpha_1 = x and alpha_2 = y.");
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
            return std::make_shared<SplineCurve>(parameters.points_file.pairs,
                                                 parameters.points_file.name);
          case MeridianType::cord_equilibrium:
            return std::make_shared<CordEquilibrium>(
              parameters.cord_equilibrium);
        }
      Assert(false, ExcInternalError());
      return {};
    }
  } // namespace


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
      }
    Assert(false, ExcInternalError());
    return {};
  }
} // namespace Biface
