// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_name_of_h
#define biface_tests_name_of_h

#include <string>

#include <biface/element/formulation.h>

inline std::string
name_of(const Biface::Formulation formulation)
{
  return formulation == Biface::Formulation::paper      ? "paper"
         : formulation == Biface::Formulation::vertices ? "vertices"
                                                        : "standard";
}

#endif
