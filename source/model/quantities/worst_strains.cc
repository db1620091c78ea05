// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include <biface/model/mesh/largest_cell.h>
#include <biface/model/quantities/worst_strains.h>

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


    /** The maximum on all ranks.
     * @param of_cell of the cells of this rank, in their order. */
    StrainAtPlace
    maximum(const ShellMesh &mesh, const std::vector<Candidate> &of_cell)
    {
      std::vector<double> values;
      for (const Candidate &candidate : of_cell)
        values.push_back(candidate.value);
      const auto worst = find_largest_cell(mesh, values);
      Assert(worst, ExcMessage("A mesh has cells."));

      // value, face, coordinates, position: of the one rank that has the cell
      std::vector<double> data(7, 0.);
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
        }
      Utilities::MPI::sum(data, mesh.communicator, data);

      StrainAtPlace place;
      place.value = data[0];
      if (data[1] < 2)
        place.face = static_cast<unsigned int>(data[1]);
      place.alpha    = Point<2>(data[2], data[3]);
      place.position = Point<3>(data[4], data[5], data[6]);
      place.cell     = worst->number;
      if (mesh.n_layers() > 1)
        place.layer = worst->layer;
      return place;
    }
  } // namespace


  WorstStrains
  worst_strains(const ShellMesh      &mesh,
                const InternalForces &forces,
                const State          &state)
  {
    std::vector<Candidate> compressions, shears;
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        if (!mesh.cells[c].is_layer)
          {
            compressions.emplace_back();
            shears.emplace_back();
            continue;
          }
        const Strains strains =
          Modes::at_vertices(forces.total_strains(state, c));
        compressions.push_back(maximum_compression(strains));
        shears.push_back(maximum_shear(strains));
      }
    WorstStrains worst{maximum(mesh, compressions), maximum(mesh, shears)};
    worst.compression.value *= -1;
    return worst;
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
    place(const StrainAtPlace &strain)
    {
      const double size = strain.position.norm();
      std::string  position;
      for (unsigned int i = 0; i < 3; ++i)
        position += (i == 0 ? "" : ", ") +
                    digits(std::abs(strain.position[i]) < 1e-9 * size
                             ? 0.
                             : strain.position[i]);
      return "at alpha_1 = " + digits(strain.alpha[0]) +
             ", alpha_2 = " + digits(strain.alpha[1]) + " (cell " +
             std::to_string(strain.cell) + "; x, y, z = " + position + ")" +
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
    const bool at_the_end = worst.compression.value < 0.8 * least_stable_strain;
    return "the shell is compressed most " + place(worst.compression) +
           ", by the " + (worst.compression.face ? "tangential" : "thickness") +
           " strain " + digits(worst.compression.value) +
           ", and sheared most " + place(worst.shear) +
           ", by the transverse shear strain " + digits(worst.shear.value) +
           "." +
           (at_the_end
              ? " A linear (St. Venant-Kirchhoff) material has no "
                "stiffness left at the strain -1/3; close to it, steps "
                "fail, however small."
              : "");
  }
} // namespace Biface
