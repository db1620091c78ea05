// SPDX-License-Identifier: LGPL-2.1-or-later

// Plies vary along the meridian as given by their formulas and tables; plies
// that cover only a part exist only there, with their own number and initial
// stress; the reference surface follows the plies; repeats, pairs of signs and
// angles from the circumference are as if written out; and cords pantograph.

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <biface/laminate/layup.h>

#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  Layup
  layup(const std::string    &plies,
        const std::string    &reference        = "inner",
        const std::string    &initial_stresses = "",
        const AngleReference  angle_reference  = AngleReference::meridian,
        const SurfaceOfPlies &surface          = SurfaceOfPlies())
  {
    Layup::Parameters parameters;
    parameters.angle_reference = angle_reference;
    parameters.plies           = parse_plies("plies", plies);
    parameters.reference = parse_thickness_position("reference", reference);
    parameters.initial_stresses =
      parse_ply_stresses("stresses", initial_stresses);
    parameters.tables = parse_tables("tables",
                                     "t: " DATA_DIR "/ply_thickness.csv, "
                                     "a: " DATA_DIR "/ply_angle.csv, "
                                     "beta_c: " DATA_DIR "/ply_angle.csv",
                                     "alpha_1");
    for (TableFile &table : parameters.tables)
      table.file.read("alpha_1, value", MPI_COMM_SELF);
    return Layup(parameters, cord_ply(), surface);
  }


  /** Material, thickness, angle in degrees and covered part of all plies at
   * alpha_1. */
  std::string
  description(const Layup &layup, const double alpha_1)
  {
    std::string text;
    for (const PlyDescription &ply : layup.get_plies())
      text += ply.material.name + ' ' + std::to_string(ply.thickness(alpha_1)) +
              ' ' + std::to_string(ply.angle(alpha_1) * 180 / numbers::PI) +
              ' ' + std::to_string(ply.begin) + ' ' + std::to_string(ply.end) +
              ';';
    return text;
  }


  /** Thickness and angle (degrees) of the only ply at alpha_1. */
  void
  check_ply(const Layup &layup,
            const double alpha_1,
            const double thickness,
            const double angle)
  {
    const Laminate laminate = layup.laminate(alpha_1);
    const Ply     &ply      = laminate.get_plies()[0];
    check_small("  thickness at " + std::to_string(static_cast<int>(alpha_1)),
                ply.thickness - thickness,
                1e-14);
    check_small("  angle", ply.angle * 180 / numbers::PI - angle, 1e-14, 90);
  }


  void
  check_faces(const std::string &reference,
              const double       alpha_1,
              const double       inner,
              const double       outer)
  {
    const auto faces = layup("cord: 1 @ 0, cord: 0.5 @ 0 from -30 to 30, "
                             "cord: 2 + 0.01*alpha_1 @ 0",
                             reference)
                         .laminate(alpha_1)
                         .face_heights();
    check_small("  " + reference + " at " +
                  std::to_string(static_cast<int>(alpha_1)),
                std::hypot(faces[0] - inner, faces[1] - outer),
                1e-14);
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::cout << "formulas" << std::endl;
  const Layup formulas =
    layup("cord: max(1.2, 1.2 + 0.01*alpha_1) @ 52 - 0.1*alpha_1");
  check_ply(formulas, -20, 1.2, 54);
  check_ply(formulas, 30, 1.5, 49);

  std::cout << "tables, constant beyond their ends" << std::endl;
  const Layup tables = layup("cord: t @ a");
  check_ply(tables, -60, 1, 50);
  check_ply(tables, -30, 1.5, 47.5);
  check_ply(tables, 15, 1.7, 43.75);
  check_ply(tables, 80, 1.4, 40);
  check_ply(tables, -80, 1, 50);

  std::cout << "tables in formulas" << std::endl;
  check_ply(layup("cord: 2*t + 0.1 @ -a + alpha_1"), 15, 3.5, -28.75);

  std::cout << "a ply that covers a part" << std::endl;
  const Layup part = layup("cord: 1 @ 0, cord: 0.5 + 0.001*alpha_1 @ 10 "
                           "from -30 to 30, cord: 2 @ 20",
                           "inner",
                           "1 0 0, 2 0 0, 3 0 0");
  check_true("  within", part.laminate(-29).get_plies().size() == 3);
  check_true("  below", part.laminate(-31).get_plies().size() == 2);
  check_true("  above", part.laminate(31).get_plies().size() == 2);
  const Laminate inside  = part.laminate(30, 29),
                 outside = part.laminate(30, 31);
  check_true("  at its end, on its side", inside.get_plies().size() == 3);
  check_true("  on the other side", outside.get_plies().size() == 2);
  check_small("  its thickness at its end",
              inside.get_plies()[1].thickness - 0.53,
              1e-14);
  const Ply &last = outside.get_plies()[1];
  check_true("  the others keep their numbers", last.number == 2);
  check_small("  angles", last.angle * 180 / numbers::PI - 20, 1e-13);
  check_small("  and initial stresses", last.initial_stress[0][0] - 3, 0);

  std::cout << "faces from the reference surface" << std::endl;
  // 1 + 0.5 + 2.1 within, 1 + 2.4 outside
  for (const double alpha_1 : {10., 40.})
    {
      const double h = (alpha_1 == 10 ? 3.6 : 3.4);
      check_faces("inner", alpha_1, 0, h);
      check_faces("middle", alpha_1, -h / 2, h / 2);
      check_faces("outer", alpha_1, -h, 0);
      check_faces("ply 1", alpha_1, -1, h - 1);
      // where ply 2 is not, its outer side is that of ply 1
      const double two = (alpha_1 == 10 ? 1.5 : 1);
      check_faces("ply 2", alpha_1, -two, h - two);
      check_faces("ply 3", alpha_1, -h, 0);
      check_faces("0.3", alpha_1, -0.3, h - 0.3);
    }

  std::cout << "short forms" << std::endl;
  const auto same = [&](const std::string &what,
                        const std::string &short_form,
                        const std::string &long_form) {
    check_true("  " + what,
               description(layup(short_form), 10) ==
                 description(layup(long_form), 10));
  };
  same("signs", "cord: 1 @ +-52", "cord: 1 @ 52, cord: 1 @ -52");
  same("signs the other way",
       "cord: 1 @ -+50+2 from -1 to 40",
       "cord: 1 @ -52 from -1 to 40, cord: 1 @ 52 from -1 to 40");
  same("repeats",
       "cord: 2 @ 0, 2 x (cord: 1 @ 5, cord: t @ +-a), cord: 3 @ 0",
       "cord: 2 @ 0, cord: 1 @ 5, cord: t @ a, cord: t @ -a, cord: 1 @ 5, "
       "cord: t @ a, cord: t @ -a, cord: 3 @ 0");
  same("nested repeats",
       "2 x (cord: (1 + 1) @ (1), 2x(cord: 1 @ 2))",
       "cord: 2 @ 1, cord: 1 @ 2, cord: 1 @ 2, cord: 2 @ 1, cord: 1 @ 2, "
       "cord: 1 @ 2");

  std::cout << "on a surface of revolution, r = 100 - alpha_1^2/100"
            << std::endl;
  SurfaceOfPlies surface;
  surface.radius = [](const double alpha_1) {
    return 100 - alpha_1 * alpha_1 / 100;
  };
  surface.end              = 60;
  surface.crown_cord_angle = 30;
  const auto on_surface    = [&](const std::string   &plies,
                              const AngleReference reference =
                                AngleReference::meridian) {
    return layup(plies, "inner", "", reference, surface);
  };
  check_ply(on_surface("cord: 1 + r/100 @ r + end - 60"), 50, 1.75, 75);
  // the sine of the angle from the meridian grows with the radius
  const double lifted = std::asin(0.75 * 0.5) * 180 / numbers::PI;
  check_ply(on_surface("cord: 1 @ lift(30)"), 0, 1, 30);
  check_ply(on_surface("cord: 1 @ lift(30)"), 50, 1, lifted);
  check_ply(on_surface("cord: 1 @ -lift(30) + 1"), 50, 1, -lifted + 1);
  const AngleReference around = AngleReference::circumference;
  check_ply(on_surface("cord: 1 @ 38", around), 50, 1, 52);
  check_ply(on_surface("cord: 1 @ -38", around), 50, 1, -52);
  check_ply(on_surface("cord: 1 @ lift(60)", around), 50, 1, lifted);
  check_ply(on_surface("cord: 1 @ lift(-60)", around), 50, 1, -lifted);
  check_ply(on_surface("cord: 1 @ -lift(30)", around), 0, 1, -60);
  check_ply(
    on_surface("cord: 1 @ beta_c"), 80, 1, 40); // the angle of the table
  Layup::Parameters with_crown;
  with_crown.plies           = parse_plies("plies", "cord: 1 @ -lift(beta_c)");
  with_crown.angle_reference = around;
  check_ply(Layup(with_crown, cord_ply(), surface), 0, 1, -60);
  const Layup turn_up =
    on_surface("cord: 1 @ 0, cord: 1 @ 5 from 0.5*end to end");
  check_true("  a part up to the end",
             turn_up.get_plies()[1].begin == 30 &&
               turn_up.get_plies()[1].end == 60);
}
