// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_requested_criteria_h
#define biface_output_requested_criteria_h

#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace Biface
{
  class EntryDeclarations;
  class Layup;
  struct Strengths;


  /** A failure criterion. */
  struct FailureCriterion
  {
    /** The name of the criterion, as in the parameter file. */
    std::string name;
    /** The name of the failure index in files. */
    std::string column;
    /** The function that computes the failure index for stresses in the axes of
     * the ply. */
    double (*index)(const dealii::SymmetricTensor<2, 3> &stress,
                    const Strengths                     &strengths);
  };


  /** The requested failure criteria. */
  struct FailureCriteria
  {
    bool maximum_stress = false;
    bool tsai_wu        = false;

    void
    add_parameters(EntryDeclarations &prm);

    /** The requested criteria, in the order of the files. */
    std::vector<FailureCriterion>
    requested() const;

    /** A sentence for each material without the strengths that the criteria
     * need. */
    std::vector<std::string>
    warnings(const Layup &layup) const;
  };
} // namespace Biface

#endif
