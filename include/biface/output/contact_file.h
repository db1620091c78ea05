// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_contact_file_h
#define biface_output_contact_file_h

#include <biface/output/result_file.h>

namespace Biface
{
  /** contact-NNNN.csv: clearance and contact pressure at the nodes in contact
   * and at their neighbors. */
  class ContactFile : public ResultFile
  {
  public:
    ContactFile(ResultsDirectory &directory, const ShellEquations &equations);

    /** A regular expression for the names of the files, also of those for other
     * bodies than the ground, which contain their names. */
    std::string
    names_of_files() const override
    {
      return "contact-(?:.+-)?([0-9]{4,})\\.csv";
    }

  private:
    void
    write(const StepReport &report, const State &state) override;
  };
} // namespace Biface

#endif
