// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include <biface/laminate/layup.h>
#include <biface/model/mesh/cell_maximum.h>
#include <biface/model/mesh/strip.h>
#include <biface/model/quantities/worst_strains.h>
#include <biface/surface/reference_surface.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** The maximum of a function of the strains at the vertices of a cell. */
    struct Candidate
    {
      double       value  = -std::numeric_limits<double>::infinity();
      unsigned int vertex = 0;
      /** 2 for the thickness strain. */
      unsigned int face = 0;
      /** Of a wave. Unit: degrees. */
      double direction = 0;
    };


    using Strains = std::array<Resultants::Vector, 4>;

    Candidate
    maximum_compression(const Strains &strains)
    {
      using namespace Resultants;
      Candidate maximum;
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Resultants::Vector &E = strains[v];
          for (unsigned int face = 0; face < 2; ++face)
            {
              // minus the lower principal strain in the face
              const double E_11 = E[tangential(0, face)];
              const double E_22 = E[tangential(1, face)];
              const double compression =
                std::hypot(E_11 - E_22, E[tangential(2, face)]) / 2 -
                (E_11 + E_22) / 2;
              if (compression > maximum.value)
                maximum = {compression, v, face};
            }
          if (-E[thickness] > maximum.value)
            maximum = {-E[thickness], v, 2};
        }
      return maximum;
    }


    Candidate
    maximum_shear(const Strains &strains)
    {
      using namespace Resultants;
      Candidate maximum;
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int face = 0; face < 2; ++face)
          {
            const double shear = std::hypot(strains[v][transverse(0, face)],
                                            strains[v][transverse(1, face)]);
            if (shear > maximum.value)
              maximum = {shear, v, face};
          }
      return maximum;
    }


    /** The length of the shortest side of a cell. */
    double
    shortest_side(const ShellMesh &mesh, const Cell &cell)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (unsigned int v = 0; v < 4; ++v)
        for (const unsigned int w : {v ^ 1U, v ^ 2U})
          shortest =
            std::min(shortest,
                     mesh.nodes[cell.nodes[v]].surface.position.distance(
                       mesh.nodes[cell.nodes[w]].surface.position));
      return shortest;
    }


    /** Minus the stiffness against short waves, see WorstStrains::ShortWave. */
    Candidate
    minimum_stiffness(const ShellMesh &mesh, const Cell &cell, const Strains &H)
    {
      using namespace Resultants;
      constexpr unsigned int n_directions = 36;

      Candidate maximum;
      double    thickness = 0;
      for (const unsigned int n : cell.nodes)
        thickness =
          std::max(thickness, 2 * mesh.nodes[n].half_thickness[cell.layer]);
      // the thickness strain resists waves that are longer than the layer is
      // thick
      if (shortest_side(mesh, cell) >= thickness)
        return maximum;
      const Matrix &D = mesh.strips[cell.strip].laminate.stiffness();
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          const double                direction = 180. * i / n_directions;
          const std::array<double, 2> n{
            {std::cos(direction * numbers::PI / 180),
             std::sin(direction * numbers::PI / 180)}};
          const auto stiffness = [&](const unsigned int p,
                                     const unsigned int q) {
            double sum = 0;
            for (unsigned int a = 0; a < 2; ++a)
              for (unsigned int b = 0; b < 2; ++b)
                sum += n[a] * D[transverse(a, p)][transverse(b, q)] * n[b];
            return sum;
          };
          const double inner = stiffness(0, 0), outer = stiffness(1, 1),
                       both        = stiffness(0, 1),
                       determinant = inner * outer - both * both;
          for (unsigned int v = 0; v < 4; ++v)
            {
              // the force that each face carries along the wave, section 4 of
              // doc/theory.md, "Gradient factor"
              std::array<double, 2> N;
              for (unsigned int p = 0; p < 2; ++p)
                N[p] = n[0] * n[0] * H[v][tangential(0, p)] +
                       n[1] * n[1] * H[v][tangential(1, p)] +
                       2 * n[0] * n[1] * H[v][tangential(2, p)];
              // the lowest eigenvalue
              const double half = (outer * N[0] + inner * N[1]) / 2;
              const double root = std::sqrt(
                std::max(0., half * half - determinant * N[0] * N[1]));
              const double value = -(1 + (half - root) / determinant);
              if (value > maximum.value)
                maximum = {value, v, N[0] < N[1] ? 0U : 1U, direction};
            }
        }
      return maximum;
    }


    /** The maximum on all ranks; none if all are minus infinity.
     * @param of_cell of the cells of this rank, in their order. */
    std::optional<WorstStrains::ShortWave>
    maximum(const ShellMesh &mesh, const std::vector<Candidate> &of_cell)
    {
      std::vector<double> values;
      for (const Candidate &candidate : of_cell)
        values.push_back(candidate.value);
      const auto worst = find_cell_maximum(mesh, values);
      if (!worst)
        return {};

      // value, face, coordinates, position, direction: of the one rank that has
      // the cell
      std::vector<double> data(8, 0.);
      if (worst->position)
        {
          const Candidate &candidate = of_cell[*worst->position];
          const Node      &node =
            mesh.nodes[mesh.cells[*worst->position].nodes[candidate.vertex]];
          data[0] = candidate.value;
          data[1] = candidate.face;
          for (unsigned int a = 0; a < 2; ++a)
            data[2 + a] = node.alpha[a] / mesh.get_surface().coordinate_unit(a);
          for (unsigned int i = 0; i < 3; ++i)
            data[4 + i] = node.surface.position[i];
          data[7] = candidate.direction;
        }
      Utilities::MPI::sum(data, mesh.communicator, data);

      ValueAtPlace place;
      place.value = data[0];
      if (data[1] < 2)
        place.face = static_cast<unsigned int>(data[1]);
      place.alpha    = Point<2>(data[2], data[3]);
      place.position = Point<3>(data[4], data[5], data[6]);
      place.cell     = worst->number;
      if (mesh.n_layers() > 1)
        place.layer = worst->layer;
      return WorstStrains::ShortWave{place, data[7]};
    }
  } // namespace


  WorstStrains
  worst_strains(const ShellMesh      &mesh,
                const InternalForces &forces,
                const State          &state)
  {
    // the whole wall of a stack has no strains of its own
    std::vector<Candidate> compressions(mesh.cells.size()),
      shears(mesh.cells.size());
    for (const unsigned int c : mesh.layers)
      {
        const Strains strains = forces.total_strains_at_vertices(state, c);
        compressions[c]       = maximum_compression(strains);
        shears[c]             = maximum_shear(strains);
      }
    WorstStrains worst{maximum(mesh, compressions)->stiffness,
                       maximum(mesh, shears)->stiffness,
                       {}};
    worst.compression.value *= -1;
    const auto &plies = mesh.get_layup().get_plies();
    worst.linear_law =
      std::any_of(plies.begin(), plies.end(), [](const PlyDescription &ply) {
        return !ply.material.is_hyperelastic;
      });
    return worst;
  }


  std::optional<WorstStrains::ShortWave>
  softest_short_wave(const ShellMesh               &mesh,
                     const InternalForces          &forces,
                     const State                   &state,
                     const types::global_cell_index node)
  {
    std::vector<Candidate> waves(mesh.cells.size());
    const auto             is_around = [&](const Cell &cell) {
      return std::any_of(
        cell.nodes.begin(), cell.nodes.end(), [&](const unsigned int n) {
          return mesh.nodes[n].number == node;
        });
    };
    for (const unsigned int c : mesh.layers)
      if (is_around(mesh.cells[c]))
        waves[c] = minimum_stiffness(
          mesh, mesh.cells[c], forces.total_resultants_at_vertices(state, c));
    auto softest = maximum(mesh, waves);
    if (softest)
      softest->stiffness.value *= -1;
    return softest;
  }


  namespace
  {
    std::string
    digits(const double value)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.4g", value);
      return text;
    }


    std::string
    place(const ValueAtPlace &strain)
    {
      const double size = strain.position.norm();
      std::string  position;
      for (unsigned int i = 0; i < 3; ++i)
        position += (i == 0 ? "" : ", ") +
                    digits(std::abs(strain.position[i]) < 1e-9 * size
                             ? 0.
                             : strain.position[i]);
      return (std::isnan(strain.alpha[0])
                ? "at x, y, z = (" + position + ")"
                : "at alpha_1 = " + digits(strain.alpha[0]) +
                    ", alpha_2 = " + digits(strain.alpha[1]) + " (cell " +
                    std::to_string(strain.cell) + "; x, y, z = " + position +
                    ")") +
             (!strain.face
                ? ""
                : std::string(" on the ") +
                    (*strain.face == Resultants::inner ? "inner" : "outer") +
                    " face") +
             (!strain.layer ? ""
                            : " of layer " + std::to_string(*strain.layer + 1));
    }
  } // namespace


  std::string
  describe(const WorstStrains &worst)
  {
    // a fifth of the strain away the stiffness is a fifth of the initial one
    constexpr double small = 0.2;
    // that of walls with several layers
    constexpr double large_factor = 8;
    const bool       at_the_end =
      worst.linear_law && worst.compression.value < 0.8 * least_stable_strain;
    return "the shell is compressed most " + place(worst.compression) +
           ", by the " + (worst.compression.face ? "tangential" : "thickness") +
           " strain " + digits(worst.compression.value) +
           ", and sheared most " + place(worst.shear) +
           ", by the transverse shear strain " + digits(worst.shear.value) +
           "." +
           (at_the_end
              ? " A linear (St. Venant-Kirchhoff) material has no "
                "stiffness left at the strain -1/3; close to it, steps "
                "fail, however small. Where a wall folds over, as a "
                "sidewall over the flange of a rim, see doc/limits.md."
              : "") +
           (worst.short_wave && worst.short_wave->stiffness.value < small
              ? " Where cells are shorter than the wall is thick, a face that "
                "is compressed may wrinkle: " +
                  place(worst.short_wave->stiffness) +
                  ", where the last iteration moved the shell most, the "
                  "stiffness against waves at " +
                  digits(worst.short_wave->direction) +
                  " degrees from alpha_1 is " +
                  digits(worst.short_wave->stiffness.value) +
                  " of that without load. " +
                  (worst.gradient_factor < large_factor
                     ? "A 'Laminate/Gradient factor' of 8, or larger cells, "
                       "may help."
                     : "Larger cells may help.")
              : "");
  }
} // namespace Biface
