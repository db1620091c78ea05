// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_program_tube_h
#define biface_tests_program_tube_h

#include <string>

/** A parameter file of a tube with the radius 100, the length 60, the thickness
 * 2 and E = 1000, round whatever the cells, without supports and loads, that
 * writes only tables.
 * @param nu Poisson's ratio. */
inline std::string
tube(const std::string &nu)
{
  return "set Formulation = paper\nset Materials = wall\n"
         "subsection Surface\n"
         "set Type = surface of revolution\n"
         "set Meridian = straight line\n"
         "subsection Straight line\n"
         "set Start = 100, 0\nset End = 100, 60\nend\nend\n"
         "subsection Material wall\nset Type = isotropic\n"
         "set E = 1000\nset nu = " +
         nu +
         "\nend\n"
         "subsection Laminate\nset Plies = wall: 2 @ 0\n"
         "set Reference surface = middle\nend\n"
         "subsection Output\nset Write VTU = false\nend\n"
         "subsection Checkpoint\nset Write = false\nend\n";
}

#endif
