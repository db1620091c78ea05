// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_cord_ply_h
#define biface_tests_cord_ply_h

#include <vector>

#include <biface/laminate/material.h>
#include <biface/laminate/material_parameters.h>

/** The rubber-cord ply of the bias tire (MPa), under the name "cord". */
inline std::vector<Biface::MaterialParameters>
cord_ply()
{
  Biface::MaterialParameters cord;
  cord.name  = "cord";
  cord.type  = Biface::MaterialParameters::Type::transversely_isotropic;
  cord.E_L   = 510.45;
  cord.E_T   = 6.91;
  cord.G_LT  = 2.33;
  cord.G_TT  = 1.77;
  cord.nu_LT = 0.46;
  cord.nu_TT = 0.95;
  return {cord};
}

#endif
