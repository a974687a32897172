// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "cli/finish_json_internal.h"

namespace gaitwright::cli {

nlohmann::ordered_json FinishJson(const std::optional<FinishReport>& finished) {
  if (!finished) return {};
  return {{"knots", finished->knots},
          {"variables", finished->variables},
          {"solves", finished->solves},
          {"iterations", finished->iterations},
          {"solve_cpu_s", finished->solve_cpu_s},
          {"residual_force_mg", finished->residual_force},
          {"residual_moment_mgl", finished->residual_moment},
          {"periodic_cycles", finished->cycles}};
}

}  // namespace gaitwright::cli
