// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "kinematics/model/actuator.h"
#include "playback/play/play.h"
#include "workflows/compare/compare_parts_internal.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

struct Figure {
  std::string key, unit;
  double value;
};
using Figures = std::vector<Figure>;

/// The texts of one side: its type, then the options that it was made with.
struct Words {
  OptionTexts facts, options;
};

void AddBase(const MotionRows& rows, Figures& figures) {
  if (!rows.q.front().head<7>().allFinite()) return;
  double lowest = INFINITY, highest = -INFINITY, tilt = 0.0;
  for (const VectorX& q : rows.q) {
    lowest = std::min(lowest, q[2]);
    highest = std::max(highest, q[2]);
    tilt = std::max(tilt, std::acos(std::clamp(BaseRotation(q)(2, 2), -1.0, 1.0)));
  }
  figures.push_back({"base_travel_m", "m", (rows.q.back().head<2>() - rows.q.front().head<2>()).norm()});
  figures.push_back({"base_height_min_m", "m", lowest});
  figures.push_back({"base_height_max_m", "m", highest});
  figures.push_back({"base_tilt_max_rad", "rad", tilt});
}

void AddJoints(const RobotModel& model, const MotionRows& rows, Figures& figures) {
  double speed_use = 0.0, torque_use = 0.0;
  const std::vector<Actuator> motors = ActuatorsOf(model);
  for (std::size_t k = 0; k < rows.v.size(); ++k) {
    for (const Actuator& motor : motors) {
      speed_use = std::max(speed_use, std::abs(motor.Speed(rows.v[k].tail(model.num_dofs()))) / motor.velocity_limit);
      if (!rows.tau.empty())
        torque_use = std::max(torque_use, std::abs(motor.Effort(rows.tau[k])) / motor.effort_limit);
    }
  }
  figures.push_back({"joint_speed_use_max", "1", speed_use});
  if (!rows.tau.empty()) figures.push_back({"torque_of_limit_max", "1", torque_use});
}

void AddLog(const PlaybackLog& log, Figures& figures) {
  double slip = 0.0, force = 0.0, speed = 0.0;
  for (const StanceRecord& stance : log.stances) {
    slip = std::max(slip, stance.slip_m);
    force = std::max(force, stance.peak_normal_n);
    speed = std::max(speed, stance.touchdown_speed_m_s);
  }
  figures.push_back({"slip_max_m", "m", slip});
  figures.push_back({"foot_force_max_n", "N", force});
  figures.push_back({"touchdown_speed_max_m_s", "m/s", speed});
  figures.push_back({"saturated_max_s", "s", log.saturated_s.size() > 0 ? log.saturated_s.maxCoeff() : 0.0});
  figures.push_back({"body_contacts", "1", static_cast<double>(log.body_contacts.size())});
}

void AddPlan(const MotionPlan& plan, Figures& figures) {
  double clearance = INFINITY;
  for (const SwingTrajectory& swing : plan.swings) clearance = std::min(clearance, swing.clearance_m);
  figures.push_back({"footholds", "1", static_cast<double>(plan.footsteps.footholds.size())});
  if (std::isfinite(clearance)) figures.push_back({"foot_clearance_min_m", "m", clearance});
}

Figures OneSide(const ComparedMotion& motion) {
  Figures figures = {{"duration_s", "s", motion.end_s() - motion.start_s()}};
  AddBase(motion.rows, figures);
  AddJoints(motion.model, motion.rows, figures);
  if (motion.log) AddLog(*motion.log, figures);
  if (motion.plan) AddPlan(*motion.plan, figures);
  return figures;
}

Words OneSideInWords(const ComparedMotion& motion) {
  Words words{{{"robot", motion.model.name}, {"robot_hash", motion.model.hash}}, {}};
  OptionTexts& facts = words.facts;
  if (motion.plan) {
    const MotionPlan& plan = *motion.plan;
    facts.emplace_back("motion_hash", MotionHash(plan));
    facts.emplace_back("program_version", plan.provenance.program_version);
    facts.emplace_back("made_by", plan.provenance.made_by);
    facts.emplace_back("seed", fmt::format("{}", plan.provenance.seed));
    facts.emplace_back("gaits", GaitNames(plan.parts));
    facts.emplace_back("ground", plan.terrain.name);
    words.options = plan.provenance.options;
  }
  if (motion.log) {
    const PlaybackLog& log = *motion.log;
    facts.emplace_back("motion_hash", log.plan_hash);
    facts.emplace_back("program_version", log.program_version);
    facts.emplace_back("controller", log.controller);
    facts.emplace_back("total_mass_kg", fmt::format("{}", log.total_mass_kg));
    facts.emplace_back("friction", fmt::format("{}", log.friction));
    facts.emplace_back("log_rate_hz", fmt::format("{}", log.log_rate_hz));
    words.options = log.options;
  }
  return words;
}

const std::string* Find(const OptionTexts& words, const std::string& key) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.first == key; });
  return found == words.end() ? nullptr : &found->second;
}

/// "swing." of "swing.height_m"; empty for a key without a dot.
std::string GroupOf(const std::string& key) { return key.substr(0, key.rfind('.') + 1); }

/// The groups in which one side has several options and the other side has none of them.
std::set<std::string> GroupsOfOne(const OptionTexts& side, const OptionTexts& other) {
  std::map<std::string, int> sizes;
  for (const auto& [key, value] : side) ++sizes[GroupOf(key)];
  for (const auto& [key, value] : side) {
    if (Find(other, key) != nullptr) sizes.erase(GroupOf(key));
  }
  std::set<std::string> groups;
  for (const auto& [group, size] : sizes) {
    if (size > 1) groups.insert(group);
  }
  return groups;
}

/// Appends the differences. @param alike true: a non-empty value that only one side has is a difference too.
void AddDifferences(const OptionTexts& a, const OptionTexts& b, bool alike, std::vector<WordDifference>& words) {
  const std::set<std::string> only_a = GroupsOfOne(a, b), only_b = GroupsOfOne(b, a);
  for (const auto& [key, value] : a) {
    const std::string* other = Find(b, key);
    if (other == nullptr ? !alike || value.empty() : *other == value) continue;
    words.push_back({key, value, other == nullptr ? "" : *other, only_a.contains(GroupOf(key)) ? 'a' : ' '});
  }
  for (const auto& [key, value] : b) {
    if (!alike || value.empty() || Find(a, key) != nullptr) continue;
    words.push_back({key, "", value, only_b.contains(GroupOf(key)) ? 'b' : ' '});
  }
}

/// Adds the playback options of a log that differ from their defaults. A plan has no such options.
void AddUnusual(const ComparedMotion& log, bool log_is_b, std::vector<WordDifference>& words) {
  PlayRequest play;
  for (const OptionChange& change : ChangesFrom(play.Fields(), log.log->options)) {
    words.push_back({change.key, log_is_b ? change.usual : change.value, log_is_b ? change.value : change.usual});
  }
}

}  // namespace

std::vector<FigurePair> FiguresOf(const ComparedMotion& a, const ComparedMotion& b) {
  std::vector<FigurePair> pairs;
  for (const Figure& figure : OneSide(a)) pairs.push_back({figure.key, figure.unit, figure.value, std::nullopt});
  for (const Figure& figure : OneSide(b)) {
    const auto known =
        std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.key == figure.key; });
    if (known != pairs.end()) {
      known->b = figure.value;
    } else {
      pairs.push_back({figure.key, figure.unit, std::nullopt, figure.value});
    }
  }
  return pairs;
}

std::vector<WordDifference> WordsOf(const ComparedMotion& a, const ComparedMotion& b) {
  const Words of_a = OneSideInWords(a), of_b = OneSideInWords(b);
  const bool alike = a.kind == b.kind;
  std::vector<WordDifference> words;
  AddDifferences(of_a.facts, of_b.facts, alike, words);
  AddDifferences(of_a.options, of_b.options, alike, words);
  if (a.plan && b.log) AddUnusual(b, true, words);
  if (b.plan && a.log) AddUnusual(a, false, words);
  return words;
}

}  // namespace gaitwright
