// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_model_forces_relaxation_in_transport_h
#define biface_model_forces_relaxation_in_transport_h

#include <deal.II/base/table.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <biface/element/modes.h>
#include <biface/laminate/time_step.h>
#include <biface/model/forces/nonlocal_stiffness.h>
#include <biface/model/mesh/shell_mesh.h>

namespace Biface
{
  struct HistoryOfPlies;
  class NonlinearPlies;
  class RelaxationAroundLine;
  struct RelaxingStress;
  struct State;


  /**
   * The relaxation of stresses in a wheel that rolls steadily: the material
   * flows through the mesh around the axle, and a Gauss point remembers what
   * the one behind it has had a moment ago; see RelaxationAroundLine.
   *
   * So the stresses at a point depend on the strains of all cells around the
   * axle, but by the internal variables alone: with these a cell has the law of
   * a step in time, see HistoryOfPlies.
   *
   * All functions but history() must be called on all ranks.
   */
  class RelaxationInTransport
  {
  public:
    /** The relaxation in the plies of a mesh. The objects are kept by
     * reference.
     * @param plies by ShellMesh::strips. */
    RelaxationInTransport(const ShellMesh                   &mesh,
                          const std::vector<NonlinearPlies> &plies);

    /** The internal variables of a cell with the step in which the material
     * flows to each of its Gauss points from the one behind it, or with the
     * step of the state if it does not transport. */
    HistoryOfPlies
    history(const State                    &state,
            const dealii::Table<2, double> &internal,
            const unsigned int              cell) const;

    /** A function that returns the strains of a locally owned cell. */
    using Strains = std::function<Modes::Vector(unsigned int cell)>;

    /** Set the internal variables of the cells to those of the Gauss points
     * behind their own, which follow from the strains of all cells. The
     * thickness strains of plies of different materials depend on what is
     * relaxed, so that this is an iteration.
     * @param internal by locally owned cell.
     * @return why they cannot be set, the same on all ranks; empty if they
     * are. */
    std::string
    set_internal_variables(const Strains            &strains,
                           const State              &state,
                           dealii::Table<2, double> &internal) const;

    /** The energy per area of the middle surface that the plies lose in a turn:
     * the integral of the relaxed stresses over their strains. By locally owned
     * cell, and by the plies of its laminate. Unit: force/length.
     * @param internal the variables of the cells' own points in equilibrium. */
    std::vector<std::vector<double>>
    losses(const Strains                  &strains,
           const dealii::Table<2, double> &internal,
           const double                    angular_velocity) const;

    /** The derivative of the forces by the displacements of other cells, at a
     * state with set_internal_variables(), which is kept by reference. */
    std::unique_ptr<const NonlocalStiffness>
    stiffness(const Strains                  &strains,
              const State                    &state,
              const dealii::Table<2, double> &internal) const;

  private:
    class Stiffness;

    /** Values at the Gauss points of a strip, closed around the axle: the same
     * number at each, in the order of its RelaxingStress. */
    class Ring;

    /** A function that sets the values of a locally owned cell. */
    using Fill =
      std::function<void(unsigned int cell, std::vector<double> &values)>;
    Ring
    gather(const unsigned int strip,
           const unsigned int n_per_point,
           const Fill        &fill) const;

    /** The relaxation of the plies of a strip while the material flows around
     * it. */
    struct Lines
    {
      /** The points of a row in the order in which the material passes them. */
      std::vector<unsigned int> places;
      /** The recursions of the plies that relax, by their positions in the
       * laminate. */
      std::map<unsigned int, RelaxationAroundLine> of_plies;
    };
    Lines
    lines(const State &state, const unsigned int strip) const;

    /** The internal variables of all points of a strip, from the components of
     * their elastic stresses. */
    Ring
    internal_variables(const Lines       &lines,
                       const unsigned int strip,
                       const Ring        &elastic) const;

    std::array<TimeStep, Modes::n_gauss_points>
    steps(const State &state, const Cell &cell) const;

    /** The step from the Gauss point behind to each point of a row of cells. */
    TimeStep
    step_to(const State       &state,
            const unsigned int around,
            const unsigned int second) const;

    unsigned int
    around(const unsigned int cell) const
    {
      return mesh.grid.cell_index(mesh.cells[cell].column)[1];
    }

    const std::vector<RelaxingStress> &
    relaxing(const unsigned int strip) const;

    /** The temperatures of the plies of a strip, if they follow from the heat;
     * otherwise empty. */
    std::vector<double>
    temperatures(const State &state, const unsigned int strip) const;

    const ShellMesh                   &mesh;
    const std::vector<NonlinearPlies> &plies;
    /** The locally owned cells of each strip. */
    std::vector<std::vector<unsigned int>> own_cells;
    /** The strip of the wall to which each strip belongs. */
    std::vector<unsigned int> columns;
  };
} // namespace Biface

#endif
