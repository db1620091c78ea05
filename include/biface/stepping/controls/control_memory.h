// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_stepping_controls_control_memory_h
#define biface_stepping_controls_control_memory_h

#include <map>
#include <string>
#include <vector>

#include <biface/base/linear_algebra.h>
#include <biface/stepping/controls/step_size.h>
#include <biface/stepping/load_level.h>

namespace Biface
{
  /** All data that a control keeps between steps. */
  struct ControlMemory
  {
    /** The loads at the start of the stage. */
    LoadLevel start;
    StepSize  size;
    /** The completed fraction of the stage, see Control::done(). */
    double done = 0;
    /** Data of the derived class by name. */
    std::map<std::string, double> numbers;
    /** Displacements that the derived class keeps, by name (locally owned
     * entries). */
    std::map<std::string, LA::Vector> vectors;

    /** Archive the numbers and the names of vectors, which are distributed
     * and stored separately. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::vector<std::string> names;
      for (const auto &vector : vectors)
        names.push_back(vector.first);
      archive &start &size &done &numbers &names;
      for (const std::string &name : names)
        vectors[name];
    }
  };
} // namespace Biface

#endif
