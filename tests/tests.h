// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_h
#define biface_tests_h

#include <cmath>
#include <iostream>
#include <string>

/**
 * Print whether a deviation, as a fraction of a scale, is within a bound.
 *
 * The outputs of tests are compared with an absolute tolerance, which is
 * meaningless for small numbers. So the comparison is made here, and the number
 * is printed only if it fails.
 */
inline void
check_small(const std::string &what,
            const double       deviation,
            const double       bound,
            const double       scale = 1)
{
  const double fraction = std::abs(deviation) / scale;
  std::cout << what << ": ";
  if (fraction <= bound)
    std::cout << "within " << bound << std::endl;
  else
    std::cout << "FAILED, " << fraction << " exceeds " << bound << std::endl;
}


/** Print whether a number lies in a range. */
inline void
check_range(const std::string &what,
            const double       value,
            const double       low,
            const double       high)
{
  std::cout << what << ": ";
  if (value >= low && value <= high)
    std::cout << "between " << low << " and " << high << std::endl;
  else
    std::cout << "FAILED, " << value << " is not between " << low << " and "
              << high << std::endl;
}


/** Print whether a condition holds. */
inline void
check_true(const std::string &what, const bool so)
{
  std::cout << what << ": " << (so ? "yes" : "FAILED, no") << std::endl;
}

#endif
