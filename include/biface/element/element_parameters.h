// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_element_parameters_h
#define biface_element_element_parameters_h

#include <biface/element/interpolation.h>
#include <biface/element/strain_sampling.h>
#include <biface/element/thickness_strain.h>

namespace Biface
{
  class EntryDeclarations;


  /** Entries of the section 'Element'. */
  struct ElementParameters
  {
    StrainSampling  sampling         = StrainSampling::means;
    Interpolation   interpolation    = Interpolation::components;
    ThicknessStrain thickness_strain = ThicknessStrain::by_layers;

    void
    add_parameters(EntryDeclarations &prm);
  };
} // namespace Biface

#endif
