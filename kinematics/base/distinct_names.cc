// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/distinct_names.h"

#include <map>
#include <set>

namespace gaitwright {

std::vector<std::string> DistinctNames(const std::vector<std::string>& names, const std::string& joint) {
  std::set<std::string> used(names.begin(), names.end());  // a new name must also differ from later names
  std::map<std::string, int> count;
  std::vector<std::string> distinct;
  for (const std::string& name : names) {
    int& number = count[name];
    std::string made = name;
    if (++number > 1) {
      while (!used.insert(made = name + joint + std::to_string(number)).second) ++number;
    }
    distinct.push_back(made);
  }
  return distinct;
}

}  // namespace gaitwright
