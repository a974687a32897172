// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// What a plan breaks of what the robot can do, worst first in proportion to its limit: position, speed and torque of
/// joints, reach of legs, collisions of the robot with itself. Empty for a plan that keeps them all.
std::vector<Violation> BrokenLimits(const AuditReport& audit);

/// All that a plan breaks for which it is not given: limits, worst first, and then other laws in the audit's order.
std::vector<Violation> Forbidding(const AuditReport& audit);

/// Past limits by this much in all the audit may let a plan pass.
inline constexpr double kSlightExcess = 1e-5;

/// True for failures that a slower walk may not have: not what the gait, the robot's build or the ground forbids.
bool IsTooMuch(const Failure& failure);

/// Whether a plan is sound enough to be given.
bool IsSound(const Result<PlannedWalk>& planned);

/// Why a plan that is not sound is not given: the worst limit of the robot, or else the first of the other laws.
Failure WhyForbidden(const PlannedWalk& planned);

/// The code for which a plan that is not sound is refused.
FailureCode ReasonRefused(const Result<PlannedWalk>& planned);

/// One sentence without a full stop that names the joint, link or foot of a violation, its value, its limit and by how
/// much that is passed; of other laws than limits what is lacking.
std::string LimitText(const Violation& violation);

/// Whether a command has a plan within the limits, at the gait's own time or a shorter one: what the search asks.
using CanWalk = std::function<bool(const WalkCommand& command)>;

/// The quantity of a command that says how fast it is, or with counted steps of a given length how far a step goes.
enum class Pace { kSpeed, kLateralSpeed, kYawRate, kStepLength };
Pace PaceOf(const WalkCommand& command);
/// Its value, not negative; the robot's own speed where the command gives none.
double PaceValue(const RobotModel& model, const WalkCommand& command);

/// The same walk with its pace at `value`, positive, and every other speed in proportion, to four digits. The robot's
/// own speed counts where the command gives none.
WalkCommand AtPace(const RobotModel& model, const WalkCommand& command, double value);

/// The start of the same walk: long enough to gain full speed, hold it for some cycles and stop again.
WalkCommand Shortened(const RobotModel& model, const WalkCommand& command, const Gait& gait);

/// Largest pace below that of the command, of two digits, at which `can_walk` says yes: by halving and then bisection,
/// at most 20 questions. 0 when there is none, as when it says no to the slowest.
double LargestPace(const RobotModel& model, const WalkCommand& command, const CanWalk& can_walk);

/// The same from a pace on that is known to be possible, short of the largest by less than `grain` numbers of two
/// digits; that one when none above it is, as one question tells. Strides up from it double, and where they lead too
/// far they are bisected.
double LargestPaceAbove(const RobotModel& model, const WalkCommand& command, double known, int grain,
                        const CanWalk& can_walk);

/// The next lower number of two digits.
double NextLower(double value);

/// To give a plan all the same that fails its audit.
Suggestion AllowLimits();

/// The flags that ask for a pace and what goes with it: "--speed 1.1 --yaw-rate 0.2".
std::string PaceFlags(const WalkCommand& command);

}  // namespace gaitwright
