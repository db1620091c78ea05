// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_problem_parameters_h
#define biface_problem_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <biface/contact/body_parameters.h>
#include <biface/element/formulation.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/pairs_file.h>
#include <biface/laminate/layup.h>
#include <biface/laminate/material_parameters.h>
#include <biface/model/contact/contact_parameters.h>
#include <biface/model/forces/dead_loads.h>
#include <biface/model/forces/gas.h>
#include <biface/model/forces/pressure_load.h>
#include <biface/model/heat/rolling_heat.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/supports.h>
#include <biface/output/results_writer.h>
#include <biface/problem/override.h>
#include <biface/problem/rig_protocol.h>
#include <biface/problem/sensitivity_parameters.h>
#include <biface/restart/checkpoint_writer.h>
#include <biface/solver/linear/linear_solver.h>
#include <biface/solver/newton.h>
#include <biface/stepping/load_stepping_parameters.h>
#include <biface/stepping/stage.h>
#include <biface/surface/chart_grid.h>
#include <biface/surface/grid_parameters.h>
#include <biface/surface/reference_surface.h>
#include <biface/surface/surface_parameters.h>

namespace Biface
{
  /**
   * All parameters of a run. Each part is declared by the class that uses it;
   * here they are collected in reading order.
   */
  struct Parameters
  {
    Units                        units;
    ReferenceSurface::Parameters surface;
    /** The files of plies whose contents are those of the laminate. */
    std::vector<std::string>        plies_files;
    ChartGrid::Parameters           mesh;
    Layup::Parameters               laminate;
    Formulation                     formulation = Formulation::standard;
    NamedPoints                     points;
    std::vector<MaterialParameters> materials;
    Supports                        supports;
    DeadLoads                       loads;
    PressureLoad                    pressure;
    Gas::Parameters                 gas;
    ContactParameters               contact;
    RollingHeat::Parameters         heat;
    std::vector<BodyParameters>     bodies;
    std::vector<Stage>              stages;
    RigProtocol                     tire_test;
    /** The position of the stage of the first point of the tire test, which
     * all others follow; the number of stages if there is none. */
    unsigned int                 first_rig_point = 0;
    LinearSolver::Parameters     linear_solver;
    Newton::Parameters           newton;
    LoadSteppingParameters       load_stepping;
    ResultsWriter::Parameters    output;
    CheckpointWriter::Parameters checkpoint;
    SensitivityParameters        sensitivities;

    /** What the program has to know of each of the entries, for those that
     * add_parameters() has declared. */
    AttributesByEntry attributes;

    /** Declare all entries, with a section for each of the materials, bodies
     * and stages. The object must outlive @p handler. */
    void
    add_parameters(dealii::ParameterHandler       &handler,
                   const std::vector<std::string> &material_names,
                   const std::vector<std::string> &body_names,
                   const unsigned int              n_stages);

    /** Give the loads and supports that stages name in 'Load factors' factors
     * of their own, and set those of the stages. Throws InputError if there are
     * none of a name. */
    void
    assign_load_factors();

    /** Read the mesh of a surface of type 'mesh', whose groups of single points
     * become named points. Must be called on all ranks. Throws InputError, see
     * MeshFile::read(). */
    void
    read_mesh(const MPI_Comm communicator);

    /** Append the stages of a tire test. Throws InputError if the tire cannot
     * be tested. */
    void
    add_tire_test();

    /** Whether the shell has inertia in a stage. */
    bool
    has_inertia() const;

    /** Check everything that does not need a mesh: values, and whether the
     * points, edges, materials and tables named by entries exist. Throws
     * InputError. */
    void
    check() const;

    /** Warnings about input that is valid but probably unintended: loads that
     * no stage applies, symmetry supports with angle plies, and a ground
     * that would travel beyond an edge that is held. */
    std::vector<std::string>
    warnings() const;

    /** The pairs of the files named by entries, by entry. */
    PairsByEntry
    named_pairs() const;

    /** The names of the files of pairs that entries name. */
    std::vector<std::string>
    input_files() const;

    /** The last stage that is run. */
    unsigned int
    last_stage() const
    {
      return std::min<unsigned int>(load_stepping.last_stage,
                                    stages.size() - 1);
    }

    /** The coefficient of friction of the ground in a stage. */
    FrictionCoefficient
    friction_in(const Stage &stage) const;

  private:
    /** Declare the entries of the stages, and their number. */
    void
    add_stages(EntryDeclarations &prm, const unsigned int n_stages);

    /** Throws InputError if springs, dampers and masses of supports have other
     * names than the forces on them. */
    void
    check_suspensions_of_supports() const;

    /** The 'Forces on bodies' of a stage with their motions. Throws InputError
     * if there is no such motion.
     * @param of_supports the names of all factors of supports. */
    std::vector<MotionByForce>
    motions_by_force(const unsigned int              i,
                     const std::vector<std::string> &of_supports) const;

    /** Throws InputError if the gas of a stage cannot be sealed. */
    void
    check_gas() const;

    /** Throws InputError where the air can have no waves.
     * @param pressures at the ends of the stages. */
    void
    check_air(const std::vector<double> &pressures) const;

    /** Check that stages with damping do not ask for what needs an
     * equilibrium. */
    void
    check_damping() const;

    /** Check stages with inertia, of which much depends on the other sections.
     */
    void
    check_inertia() const;

    /** Check what shakes the shell in a frequency response. */
    void
    check_response() const;

    /** Check the coefficients of friction, and where nodes are glued. */
    void
    check_friction() const;

    /** Check the bodies and the stages in which they are. */
    void
    check_bodies() const;

    /** A warning if the ground would travel beyond an edge that is held;
     * empty otherwise. */
    std::string
    travel_beyond_supports() const;

    /** Check that the formulation can do what the laminate asks. */
    void
    check_formulation() const;

    /** Check that an imperfection is used with nothing that needs a perfect
     * shell. */
    void
    check_imperfection() const;

    /** Throws InputError if a stage asks for modes and a ply has no
     * density. */
    void
    check_densities() const;
    void
    check_laws() const;

    /** Throws InputError if the temperatures of plies cannot be computed. */
    void
    check_heat() const;
    void
    check_law(const MaterialParameters &material,
              const Stage              &stage,
              const std::string        &section) const;

    /** Throws InputError if a stage in which the wheel rolls is not possible
     * with a material that relaxes. */
    void
    check_rolling_relaxation(const MaterialParameters &material,
                             const Stage              &stage,
                             const std::string        &section) const;


    /** Whether the shell rolls in each of the stages. */
    std::vector<bool>
    rolling_stages() const;

    /** Check the inclination angle of a stage.
     * @param section that of the stage. */
    void
    check_inclination(const std::string &section, const double angle) const;

    /** Check a stage with 'Inertia' in which the wheel rolls. */
    void
    check_inertia_of_wheel(const std::string &section,
                           const Stage       &stage) const;

    /** Check a stage with 'Transient rolling'. */
    void
    check_transient_rolling(const std::string &section,
                            const Stage       &stage,
                            const bool         rolls) const;

    /** Check the stages in which the shell rolls. */
    void
    check_rolling() const;

    /** Throws InputError if edges that do not exist are supported or loaded,
     * on a surface with coordinates. */
    void
    check_edges() const;

    /** Throws InputError if anything needs coordinates, on a mesh from a
     * file. */
    void
    check_mesh_from_file() const;
  };


  /**
   * Parse a parameter file, which the first rank reads for all.
   *
   * Throws InputError on all ranks if it cannot be read, or contains an unknown
   * entry or a value that cannot be parsed; the sentence names file, line,
   * entry, value, and what is allowed.
   *
   * @param file_name the file; empty for defaults only.
   * @param overrides settings that take precedence over the file.
   * @param communicator the ranks.
   * @param parameters the result.
   * @param prm receives the declared entries and their values.
   *
   * @return sentences about sections that are ignored.
   */
  std::vector<std::string>
  parse_parameters(const std::string           &file_name,
                   const std::vector<Override> &overrides,
                   const MPI_Comm               communicator,
                   Parameters                  &parameters,
                   dealii::ParameterHandler    &prm);

  /** Parse a parameter file, which the first rank reads for all, check all
   * parameters, see Parameters::check(), and read the files named by entries:
   * everything an analysis needs. */
  std::vector<std::string>
  read_parameters(const std::string           &file_name,
                  const std::vector<Override> &overrides,
                  const MPI_Comm               communicator,
                  Parameters                  &parameters,
                  dealii::ParameterHandler    &prm);

  /** All entries and their values as the text of a parameter file. */
  std::string
  print_parameters(const dealii::ParameterHandler &prm);
} // namespace Biface

#endif
