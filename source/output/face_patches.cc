// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/numerics/data_component_interpretation.h>

#include <biface/output/face_patches.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    const std::vector<std::string> dataset_names{"displacement",
                                                 "displacement",
                                                 "displacement",
                                                 "contact_pressure",
                                                 "active",
                                                 "outer_face",
                                                 "H_11",
                                                 "H_22",
                                                 "H_12",
                                                 "H_13",
                                                 "H_23",
                                                 "H_33"};
  } // namespace


  FacePatches::FacePatches(const ShellEquations &equations,
                           const State          &state,
                           const Loads          &loads)
  {
    using namespace Resultants;

    const ShellMesh &mesh = equations.mesh;
    patches.resize(2 * mesh.cells.size());
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const Cell &cell = mesh.cells[c];
        const auto H = Modes::at_vertices(equations.total_resultants(state, c));

        for (unsigned int face = 0; face < 2; ++face)
          {
            auto &patch          = patches[2 * c + face];
            patch.patch_index    = 2 * c + face;
            patch.n_subdivisions = 1;
            patch.reference_cell = ReferenceCells::Quadrilateral;
            patch.data.reinit(dataset_names.size(), 4);
            for (unsigned int v = 0; v < 4; ++v)
              {
                const Node &node = mesh.nodes[cell.nodes[v]];
                patch.vertices[v] =
                  mesh.deformed_position(state.displacement, node, face);
                const Tensor<1, 3> u = node.surface.from_frame(
                  mesh.displacement(state.displacement, node, face));

                unsigned int d = 0;
                for (unsigned int i = 0; i < 3; ++i)
                  patch.data(d++, v) = u[i];
                patch.data(d++, v) =
                  (face == outer
                     ? equations.pressure(state, loads, cell.nodes[v])
                     : 0.);
                patch.data(d++, v) =
                  (face == outer ? state.active[cell.nodes[v]] : 0);
                patch.data(d++, v) = face;
                for (unsigned int ab = 0; ab < 3; ++ab)
                  patch.data(d++, v) = H[v][tangential(ab, face)];
                for (unsigned int a = 0; a < 2; ++a)
                  patch.data(d++, v) = H[v][transverse(a, face)];
                patch.data(d++, v) = H[v][thickness];
              }
          }
      }
  }


  const std::vector<DataOutBase::Patch<2, 3>> &
  FacePatches::get_patches() const
  {
    return patches;
  }


  std::vector<std::string>
  FacePatches::get_dataset_names() const
  {
    return dataset_names;
  }


  std::vector<
    std::tuple<unsigned int,
               unsigned int,
               std::string,
               DataComponentInterpretation::DataComponentInterpretation>>
  FacePatches::get_nonscalar_data_ranges() const
  {
    return {std::make_tuple(
      0,
      2,
      std::string("displacement"),
      DataComponentInterpretation::component_is_part_of_vector)};
  }
} // namespace Biface
