// SPDX-License-Identifier: LGPL-2.1-or-later

#include <biface/element/element_parameters.h>
#include <biface/input/parameter_tools.h>

namespace Biface
{
  void
  ElementParameters::add_parameters(EntryDeclarations &prm)
  {
    // the element of the paper remains a choice, with which its results can be
    // repeated
    add_choice(
      prm,
      "Strain sampling",
      sampling,
      {"vertices", "means"},
      "Where the element takes its strains from. 'means', from its four "
      "vertices, but with the quadratic terms of the constant strains "
      "as means over the element and with two modes of twist: it does "
      "not buckle from node to node where the shell "
      "is compressed. 'vertices', from the vertices alone, is the "
      "element of Grigolyuk, Kulikov and Plotnikova (2004).");
    add_choice(
      prm,
      "Interpolation",
      interpolation,
      {"components", "Cartesian"},
      "What is bilinear in the element. 'components', those of the "
      "displacements in the frames of the surface at the vertices, is the "
      "element of Grigolyuk, Kulikov and Plotnikova (2004): it knows the "
      "curvature inside a cell, but where the frames turn, a rigid motion "
      "strains it. 'Cartesian', the positions of the faces and their "
      "displacement vectors: no rigid motion strains it, and cells are flat "
      "or warped quadrilaterals.");
    add_choice(
      prm,
      "Thickness strain",
      thickness_strain,
      {"by layers", "vertices", "mean director", "normal"},
      "Where the element takes its thickness strain from. 'vertices', from the "
      "lines between its faces at the four vertices, is the element of "
      "Grigolyuk, Kulikov and Plotnikova (2004). 'mean director', from the "
      "line between the faces as it is interpolated between the vertices: "
      "contact pressure on a soft layer does not make it rock from node to "
      "node. 'normal', from the part of that line which is normal to the "
      "faces: nor does pressure make a layer soft in shear, and nearly "
      "incompressible layers do not lock. 'by layers': "
      "'normal' if there are several 'Laminate/Layers', 'vertices' "
      "otherwise.");
  }
} // namespace Biface
