// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_mesh_supports_h
#define biface_model_mesh_supports_h

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <biface/contact/suspension_parameters.h>
#include <biface/input/formula.h>
#include <biface/model/mesh/component.h>

namespace Biface
{
  class EntryDeclarations;


  /**
   * A prescribed displacement of a node, in one component:
   * @f$c^- v_i^- + c^+ v_i^+ = \bar v@f$, where @f$\bar v@f$ is multiplied by
   * the load factor.
   */
  struct SupportCondition
  {
    Component component;
    /** The coefficients @f$(c^-, c^+)@f$ of the inner and the outer face. */
    std::array<double, 2> coefficients;
    /** The displacement @f$\bar v@f$ for the load factor 1. Unit: length. */
    double value;
    /** Whether the value was given. */
    bool is_prescribed = false;
    /** The position of the load factor in Loads::factors. */
    unsigned int factor = 0;
    /** Whether the faces between layers are held like the outer one. */
    bool holds_all_faces = false;
    /** The formula of the undeformed position of the face, or of the middle of
     * the wall, that replaces the value; see parse_position_formula(). */
    std::optional<Formula> formula = {};
  };


  /**
   * Read the conditions of a support.
   *
   * The text is one of the words `free`, `fixed`, `hinged` (on the middle
   * surface), `hinged inner`, `hinged outer`, `symmetry` (only for edges, see
   * @p across); or a list, separated by semicolons, of `COMPONENT FACE` or
   * `COMPONENT FACE = value` with COMPONENT one of component_names(), FACE one
   * of `inner`, `outer`, `both`, `middle`, `difference` (outer minus inner),
   * and a number or formula.
   *
   * @param entry its name, for error messages.
   * @param across the position in the frame of the component normal to an edge,
   * or a number above 2 for a point.
   *
   * Throws InputError if the text is anything else.
   */
  std::vector<SupportCondition>
  parse_support(const std::string &entry,
                const std::string &text,
                const unsigned int across);


  /** A support of a named point. */
  struct PointSupport
  {
    std::string                   point;
    std::vector<SupportCondition> conditions;
  };

  /** A support of an edge of a mesh from a file. */
  struct EdgeSupport
  {
    std::string edge;
    /** The item of the list, for messages. */
    std::string                   text;
    std::vector<SupportCondition> conditions;
    /** The Cartesian direction normal to the plane of symmetry in which the
     * edge lies; none if it is not one. */
    std::optional<unsigned int> symmetry;
  };

  /** Read a comma-separated list of supports of edges, 'name: support'; see
   * parse_support(), with 'symmetry x' and so on for edges in a plane of
   * symmetry. Throws InputError if it is malformed. */
  std::vector<EdgeSupport>
  parse_edge_supports(const std::string &entry, const std::string &text);


  /** Read a comma-separated list of supports of points, 'name: support'. Throws
   * InputError if it is malformed. */
  std::vector<PointSupport>
  parse_point_supports(const std::string &entry, const std::string &text);


  /** The supports of the shell: conditions on its edges, indexed by Edge, and
   * on named points. */
  struct Supports
  {
    std::array<std::vector<SupportCondition>, 4> edges;
    /** Whether an edge is cyclic: the edges of alpha_2 have the same
     * displacements in their frames. */
    std::array<bool, 4>       cyclic{{false, false, false, false}};
    std::vector<PointSupport> points;
    /** The supports of the edges of a mesh from a file. */
    std::vector<EdgeSupport> named_edges;
    /** What resists prescribed displacements, by the names of their factors in
     * 'Load factors' of the stages; their forces are those of the whole
     * structure, see SupportMotion::multiple. */
    SuspensionParameters suspensions;

    void
    add_parameters(EntryDeclarations &prm);

    /** Whether the support of an edge, by its position in @p edges, is
     * equivalent to 'symmetry'. */
    bool
    is_symmetric(const unsigned int edge) const;

    /** Whether the edges of alpha_2 are coupled: both are cyclic. */
    bool
    is_cyclic() const
    {
      return cyclic[2] && cyclic[3];
    }

    /** Throw InputError if only one edge of alpha_2 is cyclic. */
    void
    check() const;
  };
} // namespace Biface

#endif
