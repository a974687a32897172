// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/explain_blockage.h"

#include <fmt/format.h>

namespace gaitwright {

Failure ExplainBlockage(const RobotModel& model, const GroundIndex&, const FootstepQuery& query, FootstepGraph& graph,
                        int farthest, const FootstepSearchOptions&) {
  const PlanarPose at = RouteAt(query.route, farthest < 0 ? 0.0 : graph.Progress(farthest));
  return {FailureKind::kInfeasible,
          "no_footholds",
          "SearchFootsteps",
          fmt::format("robot '{}' finds no footholds beyond x = {:.2f} m, y = {:.2f} m", model.name, at.x_m, at.y_m),
          {}};
}

}  // namespace gaitwright
