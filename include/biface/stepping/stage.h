// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_stage_h
#define biface_stepping_stage_h

#include <deal.II/base/parameter_handler.h>

#include <string>

#include <biface/model/state.h>

namespace Biface
{
  /** A stage of loading: from the loads of the stage before to its own, in
   * equal steps. */
  struct Stage
  {
    std::string  name   = "stage";
    StrainTheory theory = StrainTheory::nonlinear;
    /** At the end of the stage. */
    double pressure = 0;
    /** Whether there is a foundation, and how far it has come at the end. */
    bool   contact = false;
    double travel  = 0;
    /** Of the dead loads and prescribed displacements, at the end. */
    double       factor  = 0;
    unsigned int n_steps = 1;

    /** What is given in every step. */
    enum class Control
    {
      /** All loads. */
      load,
      /** A displacement; the loads follow. */
      displacement,
      /** The length of the way of all displacements; the loads follow. */
      arc_length,
      /** The force on the foundation; its travel follows. */
      force
    };
    Control control = Control::load;
    /** The displacement that is given: a named point, its component (0 to 2 for
     * x to z), and its value at the end of the stage. */
    std::string  control_point;
    unsigned int control_component = 0;
    double       control_value     = 0;
    /** The force on the foundation at the end of the stage, where it is given.
     */
    double force = 0;
    /** Whether steps of loads and of the force grow after easy ones. */
    bool adaptive = false;

    /** Begin with the stresses reached so far, but undeformed and unloaded. */
    bool from_prestress = false;

    /** @param number of the stage, for its default name. */
    void
    add_parameters(dealii::ParameterHandler &prm, const unsigned int number);

    /** Throws InputError where a value is not usable. */
    void
    check(const std::string &section) const;
  };
} // namespace Biface

#endif
