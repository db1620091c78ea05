// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef biface_tests_element_reference_values_h
#define biface_tests_element_reference_values_h

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <boost/property_tree/json_parser.hpp>
#include <tests.h>

/** The numbers of a JSON file in the directory data. */
class ReferenceValues
{
public:
  explicit ReferenceValues(const std::string &file)
  {
    boost::property_tree::read_json(DATA_DIR "/" + file, tree);
  }

  /** All numbers of an entry, in the order of the file. */
  std::vector<double>
  operator()(const std::string &name) const
  {
    return of(tree.get_child(name));
  }

private:
  boost::property_tree::ptree tree;

  static std::vector<double>
  of(const boost::property_tree::ptree &node)
  {
    if (node.empty())
      return {node.get_value<double>()};
    std::vector<double> numbers;
    for (const auto &child : node)
      for (const double number : of(child.second))
        numbers.push_back(number);
    return numbers;
  }
};


/** Check the largest deviation, relative to the largest number. */
template <typename Vector>
void
compare(const std::string         &what,
        const Vector              &ours,
        const std::vector<double> &reference,
        const double               bound = 1e-11)
{
  double deviation = 0, scale = 0;
  for (unsigned int i = 0; i < reference.size(); ++i)
    {
      deviation = std::max(deviation, std::abs(ours[i] - reference[i]));
      scale     = std::max(scale, std::abs(reference[i]));
    }
  check_small(what, deviation, bound, scale);
}

#endif
