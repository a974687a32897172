// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "kinematics/base/version.h"

int main() {
  std::printf("gaitwright %s\n", gaitwright::Version().c_str());
  return 0;
}
