// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_supports_h
#define biface_model_supports_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

namespace Biface
{
  /**
   * A prescribed displacement of a node, in one component of its frame:
   * @f$c^- v_i^- + c^+ v_i^+ = \bar v@f$, where @f$\bar v@f$ grows with the
   * load factor.
   */
  struct SupportCondition
  {
    /** i - 1 */
    unsigned int component;
    /** @f$(c^-, c^+)@f$ */
    std::array<double, 2> coefficients;
    /** @f$\bar v@f$ at the load factor 1. Unit: length. */
    double value;
  };


  /**
   * Read the conditions of a support.
   *
   * The text is one of the words `free`, `fixed`, `hinged` (on the middle
   * surface), `hinged inner`, `hinged outer`, `symmetry` (only where
   * @p across says which component is across the edge); or a list, separated by
   * semicolons, of `v_i FACE` or `v_i FACE = value` with i = 1, 2, 3 and FACE
   * one of `inner`, `outer`, `both`, `middle`, `difference` (outer less inner).
   *
   * @param entry its name, for error messages.
   * @param across the component across an edge, or a number above 2 for a
   * point.
   *
   * Throws InputError where it is none of these.
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

  /** Read supports of points, 'name: support' separated by commas. Throws
   * InputError where they are malformed. */
  std::vector<PointSupport>
  parse_point_supports(const std::string &entry, const std::string &text);


  /** What holds the shell: conditions on its edges, indexed by Edge, and on
   * named points. */
  struct Supports
  {
    std::array<std::vector<SupportCondition>, 4> edges;
    std::vector<PointSupport>                    points;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /** Whether a displacement other than 0 is prescribed. */
    bool
    prescribe() const;
  };
} // namespace Biface

#endif
