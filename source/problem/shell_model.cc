// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <biface/base/errors.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/equations/force_terms.h>
#include <biface/model/forces/gas.h>
#include <biface/model/forces/viscous_damping.h>
#include <biface/model/mesh/named_points.h>
#include <biface/model/mesh/plies_on_surface.h>
#include <biface/model/time/inertia.h>
#include <biface/problem/expected_cost.h>
#include <biface/problem/shell_model.h>
#include <biface/surface/imperfection.h>
#include <biface/surface/quadrilateral_mesh.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    Layup
    make_layup(const Parameters &parameters, const ChartGrid &finest)
    {
      SurfaceOfPlies surface =
        plies_on_surface(make_surface(parameters.surface), finest);
      if (const auto &mesh = parameters.surface.mesh.mesh)
        {
          surface.groups.emplace();
          for (const QuadrilateralMesh::Group &group : mesh->groups)
            if (!group.cells.empty())
              surface.groups->push_back(group.name);
        }
      return {parameters.laminate, parameters.materials, surface};
    }


    /** The cavity of the gas, if any. */
    std::unique_ptr<const Cavity>
    make_cavity(const Parameters &parameters, const ShellMesh &mesh)
    {
      if (!parameters.gas.ambient_pressure)
        return nullptr;
      Cavity::Parameters cavity = parameters.gas.cavity;
      // plates close it down to the axis
      if (!parameters.pressure.end_plates.empty())
        cavity.rim_radius = 0;
      return std::make_unique<const Cavity>(mesh,
                                            cavity,
                                            parameters.pressure.face,
                                            parameters.pressure.kind ==
                                              PressureKind::follower);
    }


    /** The air in the cavity, if it has inertia. */
    std::unique_ptr<const AirColumn>
    make_air(const Parameters &parameters,
             const ShellMesh  &mesh,
             const Cavity     *cavity)
    {
      const auto &sound_speed = parameters.gas.air.sound_speed;
      if (!sound_speed)
        return nullptr;
      if (!(cavity->get_rim_radius() > 0))
        throw InputError("Gas/Sound speed",
                         number_to_string(*sound_speed),
                         "it must be 'none' for a cavity that reaches to the "
                         "axis, in which waves do not go around; with a rim, "
                         "give the 'Rim radius'");
      return std::make_unique<const AirColumn>(mesh,
                                               parameters.gas.air,
                                               *parameters.gas.ambient_pressure,
                                               cavity->get_rim_radius(),
                                               parameters.pressure.face);
    }


    /** The terms of make_force_terms(), the gas in the cavity, if any, and the
     * damping, if there is a stage with it. */
    ForceTerms
    force_terms(const Parameters         &parameters,
                const ShellMesh          &mesh,
                const ContactInteraction &contact,
                const Cavity             *cavity)
    {
      ForceTerms terms =
        make_force_terms(mesh, contact, parameters.loads, parameters.pressure);
      if (cavity)
        terms.push_back(std::make_unique<Gas>(parameters.gas, *cavity));
      if (std::any_of(parameters.stages.begin(),
                      parameters.stages.end(),
                      [](const Stage &stage) { return stage.damping > 0; }))
        terms.push_back(std::make_unique<ViscousDamping>(mesh));
      if (parameters.has_inertia())
        terms.push_back(std::make_unique<Inertia>(mesh));
      return terms;
    }
  } // namespace


  namespace
  {
    /** How the shell goes on beyond the edges of a grid. */
    SectorOfShell
    sector_of(const ReferenceSurface &surface,
              const ChartGrid        &grid,
              const Supports         &supports)
    {
      SectorOfShell sector;
      if (!grid.has_lines())
        return sector;
      const auto [start, end] = surface.range();
      for (unsigned int edge = 0; edge < supports.edges.size(); ++edge)
        if (supports.is_symmetric(edge))
          {
            const std::vector<double> &lines = grid.lines[edge / 2];
            const double line = edge % 2 == 0 ? lines.front() : lines.back();
            if (edge < 2)
              sector.planes[0].push_back((line - start) / (end - start));
            else if (!grid.closed)
              sector.planes[1].push_back(line);
          }
      if (supports.is_cyclic() && !grid.closed)
        sector.period = grid.lines[1].back() - grid.lines[1].front();
      return sector;
    }
  } // namespace


  std::shared_ptr<const ShellMesh>
  make_shell_mesh(const Parameters &parameters,
                  const MPI_Comm    communicator,
                  const ChartGrid  *grid)
  {
    std::unique_ptr<const ReferenceSurface> surface =
      make_surface(parameters.surface);
    // plies on a coarser mesh are those of the finest one: the shell is the
    // same
    const ChartGrid finest(parameters.mesh, *surface);
    const ChartGrid given = (grid ? *grid : finest);
    // a run that exceeds the memory would be killed without a word
    check_memory(parameters, given, communicator);
    const Layup                   layup  = make_layup(parameters, finest);
    const std::vector<NamedPoint> points = parameters.points.on(*surface);
    const auto                    mesh   = surface->has_chart()
                                             ? std::make_shared<ShellMesh>(communicator,
                                                      std::move(surface),
                                                      given,
                                                      layup,
                                                      parameters.supports,
                                                      points,
                                                      parameters.formulation)
                                             : std::make_shared<ShellMesh>(communicator,
                                                      std::move(surface),
                                                      given,
                                                      parameters.surface.mesh,
                                                      layup,
                                                      parameters.supports,
                                                      points);
    if (!parameters.surface.imperfection.is_zero())
      mesh->add_imperfection(Imperfection(
        parameters.surface.imperfection,
        mesh->get_surface(),
        sector_of(mesh->get_surface(), given, parameters.supports)));
    return mesh;
  }


  std::shared_ptr<const ShellMesh>
  with_other_plies(const ShellMesh &mesh, const Parameters &parameters)
  {
    const auto same_faces = mesh.with_layup(make_layup(parameters, mesh.grid));
    return same_faces ? same_faces
                      : make_shell_mesh(parameters, mesh.communicator);
  }


  ShellModel::ShellModel(const Parameters                &parameters,
                         std::shared_ptr<const ShellMesh> shell_mesh)
    : mesh(std::move(shell_mesh))
    , contact(*mesh, parameters.contact, parameters.bodies)
    , cavity(make_cavity(parameters, *mesh))
    , air(make_air(parameters, *mesh, cavity.get()))
    , equations(*mesh, force_terms(parameters, *mesh, contact, cavity.get()))
    , heat(mesh->grid.closed && mesh->get_layup().has_loss()
             ? std::make_unique<const RollingHeat>(parameters.heat, *mesh)
             : nullptr)
  {}
} // namespace Biface
