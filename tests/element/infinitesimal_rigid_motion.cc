// SPDX-License-Identifier: LGPL-2.1-or-later

// On a torus, the energy of an infinitesimal rigid motion is zero where vectors
// are interpolated; where components are, with the paper's formulation, it
// decreases with the fourth power of the cell size: its strains are of second
// order.

#include <biface/laminate/layup.h>

#include "one_cell.h"
#include <cord_ply.h>
#include <tests.h>

using namespace dealii;
using namespace Biface;

namespace
{
  /** The energy of a rigid motion in the linear theory, as a fraction of that
   * of a unit strain over the same area. */
  double
  relative_energy(const Formulation   formulation,
                  const std::string  &n_cells,
                  const Tensor<1, 3> &translation,
                  const Tensor<1, 3> &rotation)
  {
    const Laminate laminate =
      Layup(Layup::Parameters(), cord_ply()).laminate(0);
    const ModeStiffness stiffness(laminate.stiffness(), formulation);

    double energy = 0, scale = 0;
    for (const TestCell &cell :
         make_cells(torus(),
                    {{"20:80:" + n_cells, "-10:50:" + n_cells}},
                    laminate.face_heights(),
                    formulation))
      {
        MixedElement::NodalVector V;
        for (unsigned int v = 0; v < 4; ++v)
          for (unsigned int face = 0; face < 2; ++face)
            {
              const SurfacePoint &point = cell.points[v];
              const Tensor<1, 3>  x =
                point.position + laminate.face_heights()[face] * point.frame[2];
              const Tensor<1, 3> u =
                point.to_frame(translation + cross_product_3d(rotation, x));
              add_face_displacement(u, v, face, V);
            }
        const Modes::Vector E =
          MixedElement(cell.geometry, MixedElement::NodalVector())
            .strain_variation(V);
        energy += cell.geometry.weight *
                  Modes::mean_product(stiffness.resultants(E), E);
        scale += cell.geometry.weight * stiffness(0, 0, 0);
      }
    return energy / scale;
  }


  void
  test(const Formulation   formulation,
       const std::string  &name,
       const Tensor<1, 3> &translation,
       const Tensor<1, 3> &rotation)
  {
    const double coarse =
      relative_energy(formulation, "8", translation, rotation);
    if (formulation != Formulation::paper)
      {
        check_small(name, coarse, 1e-24);
        return;
      }
    const double medium =
      relative_energy(formulation, "16", translation, rotation);
    const double fine =
      relative_energy(formulation, "32", translation, rotation);
    check_range(name + ", 8 to 16 cells", coarse / medium, 14, 18);
    check_range(name + ", 16 to 32 cells", medium / fine, 15, 17);
  }
} // namespace


int
main()
{
  const Tensor<1, 3> none;
  for (const auto formulation : all_elements())
    {
      std::cout << "formulation: " << name_of(formulation) << std::endl;
      test(formulation, "translation along x", Tensor<1, 3>({1, 0, 0}), none);
      test(formulation,
           "translation along the axle",
           Tensor<1, 3>({0, 1, 0}),
           none);
      test(formulation, "rotation about x", none, Tensor<1, 3>({1, 0, 0}));
      test(
        formulation, "rotation about the axle", none, Tensor<1, 3>({0, 1, 0}));
      test(formulation, "rotation about z", none, Tensor<1, 3>({0, 0, 1}));
    }
}
