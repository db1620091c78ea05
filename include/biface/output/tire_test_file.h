// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_output_tire_test_file_h
#define biface_output_tire_test_file_h

#include <map>
#include <string>
#include <vector>

#include <biface/output/result_file.h>
#include <biface/stepping/tire_test.h>

namespace Biface
{
  /** The table of a tire test, `tire_test.csv`: a row for each point, also for
   * those that have failed, written anew whenever points are added. */
  class TireTestFile
  {
  public:
    static constexpr const char *file_name = "tire_test.csv";

    /** Arguments are kept by reference. */
    TireTestFile(const TireTest           &test,
                 const std::vector<Stage> &stages,
                 ResultsDirectory         &directory);

    /** Write the table if it is not up to date. Must be called on all ranks.
     * Throws OutputError.
     * @param tested the points by the positions of their stages. */
    void
    write(const std::map<unsigned int, TireTestResult> &tested);

    /** "2 of 30 points of the tire test failed" with their first reason; empty
     * if none did. */
    std::string
    failures(const std::map<unsigned int, TireTestResult> &tested) const;

    /** Its name, if it is written; else empty. */
    std::string
    description() const;

  private:
    std::string
    row(const unsigned int position, const TireTestResult &result) const;

    const TireTest           &test;
    const std::vector<Stage> &stages;
    ResultsDirectory         &directory;
    std::size_t               n_written = 0;
  };
} // namespace Biface

#endif
