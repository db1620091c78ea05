// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_probes_file_h
#define biface_output_probes_file_h

#include <deal.II/base/tensor.h>

#include <vector>

#include <biface/model/mesh/named_points.h>
#include <biface/output/result_file.h>

namespace Biface
{
  /** The displacements of both faces at a point, Cartesian and in the frame of
   * the coordinate lines. */
  struct PointDisplacement
  {
    /** The displacements of the inner and the outer face, then of those between
     * layers, from the inside out: Cartesian components, and those in the frame
     * of the node. Unit: length. */
    std::vector<dealii::Tensor<1, 3>> global, local;
  };


  /** The displacements at a named point, the same on all ranks. Must be called
   * on all ranks. */
  PointDisplacement
  displacement_at(const NamedPoint &point,
                  const LA::Vector &displacement,
                  const ShellMesh  &mesh);


  /** probes.csv: displacements of both faces and of the middle surface at the
   * named points. */
  class ProbesFile : public StepTable
  {
  public:
    ProbesFile(ResultsDirectory &directory, const ShellEquations &equations);

    /** Whether a point is named. */
    bool
    is_wanted() const override;

  private:
    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
