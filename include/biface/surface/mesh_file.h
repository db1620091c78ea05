// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_surface_mesh_file_h
#define biface_surface_mesh_file_h

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include <biface/input/formula.h>
#include <biface/surface/joint_of_group.h>

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
    /** The largest angle at which neighboring cells form a smooth surface.
     * Unit: degrees. */
    double fold_angle = 20;
    /** How cells are joined at groups of lines. */
    std::vector<JointOfGroup> joints;
    /** The first direction of the material, which is projected into the
     * surface: three formulas of the position. */
    std::vector<Formula> direction;
    /** The mesh; null before it is read. */
    std::shared_ptr<const QuadrilateralMesh> mesh;

    void
    add_parameters(EntryDeclarations &prm);

    /** Read the mesh; must be called on all ranks. Throws InputError on all of
     * them, see parse_mesh(). */
    void
    read(const MPI_Comm communicator);

    /** The direction at a point. Throws InputError if it is not finite. */
    dealii::Tensor<1, 3>
    direction_at(const dealii::Point<3> &x) const;
  };
} // namespace Biface

#endif
