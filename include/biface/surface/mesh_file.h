// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_mesh_file_h
#define biface_surface_mesh_file_h

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include <biface/input/formula.h>
#include <biface/surface/mesh_options.h>

namespace Biface
{
  class EntryDeclarations;
  struct QuadrilateralMesh;

  /** Read a comma-separated list of joints, 'lines: rigid', 'lines: hinge' or
   * 'lines: STIFFNESS'. Throws InputError if it is malformed or names a group
   * twice. */
  std::vector<JointOfGroup>
  parse_joints(const std::string &entry, const std::string &text);


  /** The entries of a mesh from a file, and what the file contains. */
  struct MeshFile
  {
    /** The name of the file; empty for none. */
    std::string name;
    MeshOptions options;
    /** The name of the file of the known surface; empty for none. */
    std::string geometry_file;
    /** The first direction of the material, which is projected into the
     * surface: three formulas of the position. */
    std::vector<Formula> direction;
    /** The mesh; null before it is read. */
    std::shared_ptr<const QuadrilateralMesh> mesh;

    void
    add_parameters(EntryDeclarations &prm);

    /** Read the mesh, and the surface on which it lies; must be called on all
     * ranks. Throws InputError on all of them, see parse_mesh() and
     * surface_of_step().
     * @param unit the name of the unit of length; may be empty. */
    void
    read(const std::string &unit, const MPI_Comm communicator);

    /** The direction at a point. Throws InputError if it is not finite. */
    dealii::Tensor<1, 3>
    direction_at(const dealii::Point<3> &x) const;
  };
} // namespace Biface

#endif
