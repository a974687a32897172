// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/upper_body.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "workflows/repair/joint_groups_internal.h"
#include "workflows/repair/motion_distance_internal.h"

namespace gaitwright {
namespace {

constexpr char kRest[] = "torso_and_head";

/// The groups by which joints are compared.
std::vector<std::string> ComparedGroups(const RobotModel& model, const UpperBody& upper) {
  std::vector<std::string> groups = GroupsOfJoints(model, upper);
  for (std::string& group : groups) {
    if (group != kLegJoints && group != kArmJoints) group = kRest;
  }
  return groups;
}

/// A group whose distances come row by row.
class GroupTally {
 public:
  GroupTally(std::string group, std::string unit) : result_{std::move(group), std::move(unit), 0.0, 0.0, 0.0, {}, {}} {}

  bool IsOf(const std::string& group) const { return result_.group == group; }

  void Add(double distance, double time_s, const std::string& where) {
    row_ += distance * distance;
    ++members_;
    if (distance <= result_.largest) return;
    result_.largest = distance;
    result_.largest_s = time_s;
    result_.largest_where = where;
  }

  void EndRow() {
    if (members_ == 0) return;
    const double mean = row_ / members_;
    result_.over_time.push_back(static_cast<float>(std::sqrt(mean)));
    squares_ += mean;
    row_ = 0.0;
    members_ = 0;
  }

  GroupDistance Finished() && {
    if (!result_.over_time.empty()) result_.rms = std::sqrt(squares_ / static_cast<double>(result_.over_time.size()));
    return std::move(result_);
  }

 private:
  GroupDistance result_;
  double row_ = 0.0, squares_ = 0.0;
  int members_ = 0;
};

/// Points of the robot whose distances are measured in W.
struct ComparedPoint {
  std::string name;
  int body;
  Vector3 p_BQ;
};

std::vector<ComparedPoint> FeetPoints(const RobotModel& model) {
  std::vector<ComparedPoint> points;
  for (const Leg& leg : model.legs) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    points.push_back({foot.name, foot.body, foot.X_BF.translation()});
  }
  return points;
}

std::vector<ComparedPoint> HandPoints(const RobotModel& model, const UpperBody& upper) {
  std::vector<ComparedPoint> points;
  for (const bool left : {true, false}) {
    if (!upper.arm(left)) continue;
    const Limb& arm = *upper.arm(left);
    points.push_back({model.bodies[static_cast<std::size_t>(arm.end_body)].name, arm.end_body, arm.p_BE});
  }
  return points;
}

/// Distances of joints, base, hands and feet between two postures, row by row.
class GroupTallies {
 public:
  explicit GroupTallies(const RobotModel& model)
      : model_(model), of_file_(model), of_plan_(model), base_("base", "m"), hands_("hands", "m"), feet_("feet", "m") {
    const UpperBody upper = FindUpperBody(model);
    const std::vector<std::string> groups = ComparedGroups(model, upper);
    for (const char* name : {kLegJoints, kArmJoints, kRest}) {
      if (std::find(groups.begin(), groups.end(), name) != groups.end()) joints_.emplace_back(name, "rad");
    }
    for (const std::string& group : groups) {
      const auto found =
          std::find_if(joints_.begin(), joints_.end(), [&](const GroupTally& tally) { return tally.IsOf(group); });
      of_dof_.push_back(static_cast<std::size_t>(found - joints_.begin()));
    }
    hand_points_ = HandPoints(model, upper);
    foot_points_ = FeetPoints(model);
  }

  void Add(const VectorX& q_file, const VectorX& q_plan, double time_s) {
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const auto at = static_cast<std::size_t>(d);
      joints_[of_dof_[at]].Add(std::abs(q_plan[7 + d] - q_file[7 + d]), time_s, model_.dof_names[at]);
    }
    for (GroupTally& tally : joints_) tally.EndRow();
    base_.Add((q_plan - q_file).head<3>().norm(), time_s, "");
    base_.EndRow();
    ForwardKinematics(model_, q_file, of_file_);
    ForwardKinematics(model_, q_plan, of_plan_);
    AddPoints(hand_points_, time_s, hands_);
    AddPoints(foot_points_, time_s, feet_);
  }

  std::vector<GroupDistance> Finished() && {
    std::vector<GroupDistance> groups;
    for (GroupTally& tally : joints_) groups.push_back(std::move(tally).Finished());
    groups.push_back(std::move(base_).Finished());
    if (!hand_points_.empty()) groups.push_back(std::move(hands_).Finished());
    groups.push_back(std::move(feet_).Finished());
    return groups;
  }

 private:
  void AddPoints(const std::vector<ComparedPoint>& points, double time_s, GroupTally& tally) const {
    for (const ComparedPoint& point : points) {
      const auto b = static_cast<std::size_t>(point.body);
      const Vector3 of_file = of_file_.p_WB[b] + of_file_.R_WB[b] * point.p_BQ;
      const Vector3 of_plan = of_plan_.p_WB[b] + of_plan_.R_WB[b] * point.p_BQ;
      tally.Add((of_plan - of_file).norm(), time_s, point.name);
    }
    tally.EndRow();
  }

  const RobotModel& model_;
  DynamicsScratch of_file_, of_plan_;
  std::vector<GroupTally> joints_;
  std::vector<std::size_t> of_dof_;  ///< index of joints_
  GroupTally base_, hands_, feet_;
  std::vector<ComparedPoint> hand_points_, foot_points_;
};

}  // namespace

std::string WordsOfGroup(const std::string& group) { return group == kRest ? "torso and head" : group; }

const GroupDistance* MotionDistance::Group(const std::string& name) const {
  const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const GroupDistance& one) { return one.group == name; });
  return found == groups.end() ? nullptr : &*found;
}

MotionDistance DistanceOf(const RobotModel& model, const EvenMotion& original, const MotionPlan& plan) {
  MotionDistance distance;
  GroupTallies groups(model);
  WholeBodySample sample;
  double joints = 0.0, mean = 0.0, turns = 0.0;
  for (int k = 0; k < original.size(); ++k) {
    const VectorX& q = original.q[static_cast<std::size_t>(k)];
    const double time_s = original.TimeOf(k);
    SampleWholeBody(plan.whole_body, time_s, sample);
    groups.Add(q, sample.q, time_s);
    const VectorX apart = (sample.q - q).tail(model.num_dofs()).cwiseAbs();
    joints += apart.squaredNorm() / model.num_dofs();
    mean += apart.mean();
    Eigen::Index which = 0;
    if (const double largest = apart.maxCoeff(&which); largest > distance.joint_largest_rad) {
      distance.joint_largest_rad = largest;
      distance.joint_largest_s = time_s;
      distance.joint_largest = model.dof_names[static_cast<std::size_t>(which)];
    }
    turns += RotationLog(BaseRotation(sample.q) * BaseRotation(q).transpose()).squaredNorm();
  }
  const double rows = original.size();
  distance.joint_rms_rad = std::sqrt(joints / rows);
  distance.joint_mean_rad = mean / rows;
  distance.base_turn_rms_rad = std::sqrt(turns / rows);
  distance.groups = std::move(groups).Finished();
  if (const GroupDistance* base = distance.Group("base")) {
    distance.base_rms_m = base->rms;
    distance.base_largest_m = base->largest;
    distance.base_largest_s = base->largest_s;
  }
  return distance;
}

}  // namespace gaitwright
