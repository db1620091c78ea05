// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_element_formulation_h
#define biface_element_formulation_h

namespace Biface
{
  /** The element. */
  enum class Formulation
  {
    /** The positions of the faces and their displacement vectors are bilinear:
     * no rigid motion strains the element, on cells of any shape, which are
     * flat or warped quadrilaterals; see Quadrilateral. */
    standard,
    /** The element of `standard` with strains that are sampled at the vertices
     * alone, and fewer modes, for comparisons: where the shell is compressed,
     * it may buckle from node to node. */
    vertices,
    /** The element of @cite GrigolyukKulikovPlotnikova2004: the components of
     * the displacements in the frames of the vertices are bilinear, and strains
     * are sampled at the vertices, with the exact geometry of the surface.
     * Where the frames turn from vertex to vertex, rigid motions strain the
     * element by terms of second order in its size. Where the shell is
     * compressed, it may buckle from node to node. Only walls of one layer on
     * cells along coordinate lines. */
    paper
  };
} // namespace Biface

#endif
