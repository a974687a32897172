// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/roll_moments.h"

namespace gaitwright {

std::vector<Vector3> RollMoments(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                 const std::vector<RigidBodySample>& samples) {
  std::vector<Vector3> moments(samples.size(), Vector3::Zero());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const RigidBodyInterval& in = motion.intervals[samples[k].interval];
    const double time_s = samples[k].time_s, u = (time_s - in.start_s) / (in.end_s - in.start_s);
    for (std::size_t i = 0; i < in.forces.size(); ++i) {
      const RigidStance& stance = problem.stances[in.forces[i].stance];
      const Vector3 evenly = (1.0 - u) * stance.MovedAt(in.start_s) + u * stance.MovedAt(in.end_s);
      moments[k] += (stance.MovedAt(time_s) - evenly).cross(samples[k].force_W[i]);
    }
  }
  return moments;
}

}  // namespace gaitwright
