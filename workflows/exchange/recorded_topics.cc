// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/packed_bytes_internal.h"
#include "workflows/exchange/recorded_topics_internal.h"
#include "workflows/exchange/sqlite_bag_internal.h"

namespace gaitwright {
namespace {

/// The type with the folder "msg", which some programs leave out.
std::string FullTypeOf(const std::string& type) {
  const std::size_t slash = type.find('/');
  return slash == std::string::npos || type.find('/', slash + 1) != std::string::npos
             ? type
             : type.substr(0, slash) + "/msg" + type.substr(slash);
}

constexpr std::size_t kLargestMessage = std::size_t{1} << 26U;  // unpacked [bytes]

/// Parses a message, which a bag may pack with zstd on its own; the first byte of a message of CDR is 0.
template <class Message>
Message ParsePacked(std::string_view data, Message (*parse)(std::string_view)) {
  return IsZstd(data) ? parse(UnpackedZstd(data, kLargestMessage)) : parse(data);
}

/// Adds the messages of a file to the topics.
class Collector {
 public:
  explicit Collector(RecordedTopics& topics) : topics_(topics) {}

  void Take(const RecordedMessage& recorded) {
    const std::string type = FullTypeOf(recorded.topic.type);
    if (type == kJointStateType) {
      Add(recorded, ParseJointState, topics_.joint_states);
    } else if (type == kOdometryType) {
      Add(recorded, ParseOdometry, topics_.odometry);
    } else if (type == kJointTrajectoryType) {
      Add(recorded, ParseRosTrajectory, topics_.trajectories);
    } else {
      topics_.others.emplace(recorded.topic.name, recorded.topic.type);
    }
  }

 private:
  template <class Message>
  static void Add(const RecordedMessage& recorded, Message (*parse)(std::string_view),
                  std::map<std::string, RecordedSeries<Message>>& topics) {
    const std::string& name = recorded.topic.name;
    if (recorded.topic.encoding != "cdr") {
      throw InvalidArgument(fmt::format("topic '{}' is encoded as '{}'; accepted: 'cdr', as ROS 2 writes it", name,
                                        recorded.topic.encoding));
    }
    RecordedSeries<Message>& series = topics[name];
    if (series.messages.size() == static_cast<std::size_t>(kMostCsvRows))
      throw InvalidArgument(fmt::format("topic '{}' has more than {} messages", name, kMostCsvRows));
    try {
      series.messages.push_back(ParsePacked(recorded.data, parse));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(
          fmt::format("message {} of topic '{}': {}", series.messages.size() + 1, name, error.what()));
    }
    series.log_time_ns.push_back(recorded.log_time_ns);
  }

  RecordedTopics& topics_;
};

/// Number of the robot's joints that the messages of a topic name.
template <class Message>
std::size_t JointsIn(const RobotModel& model, const RecordedSeries<Message>& series) {
  std::set<std::string> named;
  for (const Message& message : series.messages) {
    for (const std::string& name : message.names) named.insert(name);
  }
  return static_cast<std::size_t>(std::count_if(model.dof_names.begin(), model.dof_names.end(),
                                                [&](const std::string& name) { return named.count(name) > 0; }));
}

template <class Message>
std::vector<std::string> WithJoints(const RobotModel& model,
                                    const std::map<std::string, RecordedSeries<Message>>& topics) {
  std::vector<std::string> names;
  for (const auto& [name, series] : topics) {
    if (JointsIn(model, series) > 0) names.push_back(name);
  }
  return names;
}

/// The asked names among the candidates, or all candidates.
std::vector<std::string> Narrowed(const std::vector<std::string>& candidates, const std::vector<std::string>& asked) {
  std::vector<std::string> both;
  for (const std::string& name : candidates) {
    if (std::find(asked.begin(), asked.end(), name) != asked.end()) both.push_back(name);
  }
  return both.empty() ? candidates : both;
}

/// The only candidate, or "".
std::string OnlyOne(const std::vector<std::string>& candidates, const std::string& what) {
  if (candidates.size() > 1) {
    throw InvalidArgument(
        fmt::format("topics {} have {}; give the one to read with --topic", QuotedList(candidates), what));
  }
  return candidates.empty() ? "" : candidates.front();
}

template <class Map>
void AddNames(const Map& topics, std::vector<std::string>& names) {
  for (const auto& [name, series] : topics) names.push_back(name);
}

std::vector<std::string> AskedTopics(const RecordedTopics& topics, const std::string& asked) {
  std::vector<std::string> known, names;
  AddNames(topics.joint_states, known), AddNames(topics.odometry, known), AddNames(topics.trajectories, known);
  std::istringstream list(asked == "detect" ? "" : asked);
  for (std::string name; std::getline(list, name, ',');) {
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      names.push_back(name);
      continue;
    }
    const auto other = topics.others.find(name);
    if (other != topics.others.end()) {
      throw InvalidArgument(fmt::format("topic '{}' has messages of type '{}'; accepted: {}, {}, {}", name,
                                        other->second, kJointStateType, kOdometryType, kJointTrajectoryType));
    }
    throw InvalidArgument(fmt::format("topic '{}' does not exist{}", name, NearestOrAll(name, known)));
  }
  return names;
}

std::string FoundInstead(const RecordedTopics& topics) {
  std::vector<std::string> found;
  for (const auto& [name, series] : topics.joint_states) found.push_back(fmt::format("{} ({})", name, kJointStateType));
  for (const auto& [name, series] : topics.trajectories)
    found.push_back(fmt::format("{} ({})", name, kJointTrajectoryType));
  for (const auto& [name, series] : topics.odometry) found.push_back(fmt::format("{} ({})", name, kOdometryType));
  for (const auto& [name, type] : topics.others) found.push_back(fmt::format("{} ({})", name, type));
  return found.empty() ? "it has no messages" : "its topics are " + QuotedList(found);
}

}  // namespace

void ReadRecording(const std::string& bytes, RecordedTopics& topics) {
  Collector collector(topics);
  const TakeMessage take = [&](const RecordedMessage& message) { collector.Take(message); };
  if (bytes.starts_with(kSqliteMagic)) {
    ReadSqliteBag(bytes, take);
  } else if (!ReadMcap(bytes, take)) {
    topics.whole = false;
  }
}

ChosenTopics ChooseTopics(const RobotModel& model, const RecordedTopics& topics, const std::string& asked) {
  const std::vector<std::string> names = AskedTopics(topics, asked);
  const auto is_asked = [&](const auto& of_type) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return of_type.count(name) > 0; });
  };
  std::vector<std::string> odometry;
  AddNames(topics.odometry, odometry);
  const std::vector<std::string> states = WithJoints(model, topics.joint_states),
                                 trajectories = WithJoints(model, topics.trajectories);
  ChosenTopics chosen;
  if (!states.empty() && (is_asked(topics.joint_states) || !is_asked(topics.trajectories))) {
    chosen.joint_states = OnlyOne(Narrowed(states, names), "joint states");
  } else {
    chosen.trajectory = OnlyOne(Narrowed(trajectories, names), "joint trajectories");
  }
  if (chosen.joint_states.empty() && chosen.trajectory.empty()) {
    throw InvalidArgument(fmt::format("no topic has joint states or a joint trajectory with joints of robot '{}'; {}",
                                      model.name, FoundInstead(topics)));
  }
  chosen.odometry = OnlyOne(Narrowed(odometry, names), "odometry");
  return chosen;
}

}  // namespace gaitwright
