// SPDX-License-Identifier: LGPL-2.1-or-later

// A surface from a file of STEP, a cylinder with its lids: points move to the
// closest face, not beyond its edges; the middle of a rim is on it; normals are
// those of the face on this side of a fold; and lengths are those of the unit.

#include <deal.II/opencascade/utilities.h>

#include <fstream>
#include <sstream>

#include <biface/base/errors.h>
#include <biface/surface/known_surface.h>

#include "../tests.h"
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

using namespace dealii;
using namespace Biface;


int
main()
{
  // what OpenCASCADE prints as it writes
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  OpenCASCADE::write_STEP(BRepPrimAPI_MakeCylinder(50, 200).Shape(),
                          "cylinder.step");
  std::ostringstream text;
  text << std::ifstream("cylinder.step").rdbuf();

  for (const double unit : {1., 1000.})
    {
      // in the unit of the mesh
      const double r = 50 / unit, h = 200 / unit, size = h;
      const auto   surface = surface_of_step(text.str(), "cylinder.step", unit);
      const auto   on_wall =
        surface->closest_point(Point<3>(0.6 * r, 0.7 * r, 0.3 * h), size);
      const double far = std::sqrt(0.85);
      check_small(
        "wall",
        on_wall->distance(Point<3>(0.6 * r / far, 0.7 * r / far, 0.3 * h)),
        1e-9,
        r);
      // through the wall, on the side where the others are
      check_small(
        "between points of the lid",
        surface
          ->point_between(Point<3>(0.9 * r, 0, 0.8 * h),
                          {Point<3>(0.8 * r, 0, h), Point<3>(0, 0, h)},
                          size)
          ->distance(Point<3>(0.9 * r, 0, h)),
        1e-9,
        r);
      // above the lid, and beside it
      check_small(
        "lid",
        surface->closest_point(Point<3>(0.2 * r, 0, h + 0.1 * r), size)
          ->distance(Point<3>(0.2 * r, 0, h)),
        1e-9,
        r);
      check_small("rim",
                  surface->closest_point(Point<3>(2 * r, 0, h + r), size)
                    ->distance(Point<3>(r, 0, h)),
                  1e-9,
                  r);
      const Point<3> one(r, 0, h), two(0, r, h);
      check_small(
        "middle of the rim",
        surface->middle_of_edge(one, two, size)
          ->distance(Point<3>(r * std::sqrt(.5), r * std::sqrt(.5), h)),
        1e-9,
        r);
      const Tensor<1, 3> outward({1, 0, 0}), upward({0, 0, 1});
      check_small(
        "normal of the wall",
        (surface->normal(one, outward + 0.2 * upward, size) - outward).norm(),
        1e-9);
      check_small(
        "normal of the lid, downward",
        (surface->normal(one, 0.2 * outward - upward, size) + upward).norm(),
        1e-9);
      check_small("no normal apart from the surface",
                  surface->normal(Point<3>(), outward, size).norm(),
                  1e-9);
    }

  // wrong references, in turn
  unsigned int n_answered = 0;
  for (unsigned int i = 0; i < 8; ++i)
    {
      std::string damaged  = text.str();
      std::size_t position = damaged.find("DATA;");
      for (unsigned int k = 0; k < 25 * i + 3; ++k)
        position = damaged.find(",#", position + 1);
      damaged[position + 1] = '9';
      try
        {
          surface_of_step(damaged, "damaged.step", 1);
          ++n_answered;
        }
      catch (const InputError &)
        {
          ++n_answered;
        }
    }
  check_true("damaged files are answered", n_answered == 8);

  for (const std::string &wrong : {std::string("ISO-10303-21;\nHEADER;\n"),
                                   std::string("solid of another program")})
    try
      {
        surface_of_step(wrong, "wrong.step", 1);
        std::cout << "ACCEPTED" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
}
