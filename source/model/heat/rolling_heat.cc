// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <biface/base/errors.h>
#include <biface/contact/rolling.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/layup.h>
#include <biface/model/heat/heat_of_plies.h>
#include <biface/model/heat/rolling_heat.h>
#include <biface/model/mesh/shell_mesh.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/quantities/hysteresis.h>
#include <biface/model/state/loads.h>
#include <biface/model/state/state.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The thickness of a ply where it does not exist, relative to that of the
     * wall. */
    constexpr double thin = 1e-6;
  } // namespace


  void
  RollingHeat::Parameters::add_parameters(EntryDeclarations &prm)
  {
    add_choice(prm,
               "Temperatures",
               temperatures,
               {"given", "computed", "coupled"},
               "Which temperatures the plies of a rolling wheel have. 'given': "
               "that of the stage. 'computed': from the conduction of the heat "
               "of their losses through the wall, without an effect on "
               "them. 'coupled': the materials with a 'Temperature shift' also "
               "relax at these temperatures, in an iteration between rolling "
               "and conduction.");
    const auto add_film =
      [&](const std::string &name, HeatFilm &film, const std::string &what) {
        prm.add_parameter(name + " film",
                          film.coefficient,
                          "Film coefficient of " + what +
                            ": a number not less than 0.",
                          Patterns::Double(),
                          Unit("power/(area * temperature)"));
        prm.add_parameter(name + " temperature",
                          film.temperature,
                          "Temperature of " + what + ".",
                          Patterns::Double(),
                          Unit("temperature, that of the materials"));
      };
    add_film("Inside", inside, "the gas that touches the inner face");
    add_film("Air",
             air,
             "the air that touches the outer face where the ground does not");
    add_film("Ground", ground, "the ground, while it touches the outer face");
  }


  void
  RollingHeat::Parameters::check() const
  {
    for (const auto &[name, film] : {std::make_pair("Inside", inside),
                                     std::make_pair("Air", air),
                                     std::make_pair("Ground", ground)})
      check_not_negative("Heat/" + std::string(name) + " film",
                         film.coefficient);
  }


  RollingHeat::RollingHeat(const Parameters &parameters, const ShellMesh &mesh)
    : parameters(parameters), mesh(mesh)
  {
    const std::vector<double> &lines    = mesh.grid.lines[0];
    const unsigned int         n_strips = mesh.n_strips();
    const auto                &plies    = mesh.get_layup().get_plies();

    std::vector<double> areas(n_strips);
    for (const unsigned int c : mesh.walls)
      areas[mesh.cells[c].strip] += mesh.cells[c].geometry.weight;
    Utilities::MPI::sum(areas, mesh.communicator, areas);

    section.conductivity.reinit(n_strips, plies.size());
    section.source.reinit(n_strips, plies.size());
    volumes.reinit(n_strips, plies.size());
    for (unsigned int i = 0; i < n_strips; ++i)
      {
        const Laminate &laminate = mesh.strips[i].laminate;
        double          bottom = 0, sum = 0;
        for (const Ply &ply : laminate.get_plies())
          {
            const double middle = bottom + ply.thickness / 2;
            bottom += ply.thickness;
            volumes(i, ply.number) +=
              areas[i] * ply.thickness * laminate.area_ratio(middle);
            sum += ply.thickness * plies[ply.number].material.conductivity;
          }
        // a ply that does not exist here is a thin layer that conducts like the
        // others, so that the grid of the section stays regular
        for (unsigned int p = 0; p < plies.size(); ++p)
          section.conductivity(i, p) = volumes(i, p) > 0
                                         ? plies[p].material.conductivity
                                         : sum / laminate.thickness();
      }

    section.vertices.reinit(lines.size(), plies.size() + 1);
    for (unsigned int i = 0; i < lines.size(); ++i)
      {
        // the mean of the plies on both sides of the line
        std::vector<const Laminate *> sides;
        if (i > 0)
          sides.push_back(mesh.strips[i - 1].at_vertices[1].get());
        if (i < n_strips)
          sides.push_back(mesh.strips[i].at_vertices[0].get());
        double              height = 0;
        std::vector<double> thickness(plies.size());
        for (const Laminate *side : sides)
          {
            height += side->face_heights()[0] / sides.size();
            for (const Ply &ply : side->get_plies())
              thickness[ply.number] += ply.thickness / sides.size();
          }
        const SurfacePoint at = mesh.get_surface().evaluate(
          Point<2>(lines[i], mesh.grid.lines[1][0]));
        for (unsigned int p = 0; p <= plies.size(); ++p)
          {
            const Point<3> x       = at.position + height * at.frame[2];
            section.vertices(i, p) = Point<2>(x[1], std::hypot(x[0], x[2]));
            if (p < plies.size())
              height += std::max(thickness[p], thin * sides[0]->thickness());
          }
      }
  }


  std::vector<double>
  RollingHeat::parts_in_contact(const State &state) const
  {
    const std::vector<double> &around = mesh.grid.lines[1];
    const unsigned int         n      = mesh.grid.n_nodes(1);
    std::vector<double>        parts(mesh.n_strips());
    for (unsigned int k = 0; k < mesh.nodes.size(); ++k)
      {
        const Node &node = mesh.nodes[k];
        if (!node.locally_owned || !state.ground().active[k])
          continue;
        // a node covers its line halfway to both neighbors, and half of the
        // strips beside it
        const unsigned int j = node.grid_index[1];
        const double       angle =
          (around[j + 1] - around[j] + around[(j + n - 1) % n + 1] -
           around[(j + n - 1) % n]) /
          2;
        for (const int side : {-1, 0})
          {
            const int strip = static_cast<int>(node.grid_index[0]) + side;
            if (strip >= 0 && strip < static_cast<int>(parts.size()))
              parts[strip] += angle / 2 / (2 * numbers::PI);
          }
      }
    Utilities::MPI::sum(parts, mesh.communicator, parts);
    return parts;
  }


  HeatOfPlies
  RollingHeat::field(const Hysteresis          &hysteresis,
                     const std::vector<double> &parts,
                     const Loads               &loads) const
  {
    WallSection wall = section;
    for (unsigned int i = 0; i < volumes.size(0); ++i)
      for (unsigned int p = 0; p < volumes.size(1); ++p)
        if (volumes(i, p) > 0)
          wall.source(i, p) =
            Hysteresis::power(hysteresis.by_strip(i, p),
                              loads.rolling->angular_velocity) /
            volumes(i, p);
    HeatOfPlies result{wall.source, {}};
    if (!is_computed())
      return result;

    for (const double part : parts)
      {
        wall.films[0].push_back(parameters.inside);
        // particles meet air and ground in turn, in a time that is short for
        // heat
        wall.films[1].push_back(
          HeatFilm::mean(parameters.air, parameters.ground, part));
      }
    result.temperature = steady_temperatures(wall).plies;
    for (unsigned int i = 0; i < volumes.size(0); ++i)
      for (unsigned int p = 0; p < volumes.size(1); ++p)
        if (!(volumes(i, p) > 0))
          result.temperature(i, p) = std::numeric_limits<double>::quiet_NaN();
    return result;
  }


  Table<2, double>
  RollingHeat::followed(const State &state) const
  {
    const std::vector<double> &numbers = state.terms.at("heat").numbers;
    Table<2, double>           result(volumes.size(0), volumes.size(1));
    for (unsigned int i = 0; i < volumes.size(0); ++i)
      for (unsigned int p = 0; p < volumes.size(1); ++p)
        result(i, p) = volumes(i, p) > 0
                         ? numbers[i * volumes.size(1) + p]
                         : std::numeric_limits<double>::quiet_NaN();
    return result;
  }


  bool
  RollingHeat::Iteration::advance(const HeatOfPlies &field,
                                  const double       tolerance,
                                  State             &state)
  {
    const auto          &computed = field.temperature;
    const Parameters    &given    = heat.parameters;
    std::vector<double> &followed = state.terms["heat"].numbers;
    std::vector<double>  change;
    double               largest = 0, size = 0;
    const bool           first = followed.empty();
    for (unsigned int i = 0; i < computed.size(0); ++i)
      for (unsigned int p = 0; p < computed.size(1); ++p)
        {
          // one that no ply has where there is none
          const bool   exists = heat.volumes(i, p) > 0;
          const double T      = exists ? computed(i, p) : 0.;
          if (first)
            followed.push_back(T);
          change.push_back(T - followed[change.size()]);
          size = std::max(size, std::abs(change.back()));
          if (exists)
            for (const HeatFilm &film : {given.inside, given.air, given.ground})
              if (film.coefficient > 0)
                largest = std::max(largest, std::abs(T - film.temperature));
        }
    if (first)
      return false;
    if (size <= tolerance * largest)
      return true;

    if (!last_change.empty())
      {
        // Aitken's factor from the last two changes, section 10 of
        // doc/theory.md, "Heat"
        double product = 0, square = 0;
        for (unsigned int k = 0; k < change.size(); ++k)
          {
            const double difference = change[k] - last_change[k];
            product += last_change[k] * difference;
            square += difference * difference;
          }
        // bounds against a first guess far away
        if (square > 0)
          factor = std::min(1.5, std::max(0.1, -factor * product / square));
      }
    for (unsigned int k = 0; k < change.size(); ++k)
      followed[k] += factor * change[k];
    last_change = change;
    return false;
  }
} // namespace Biface
