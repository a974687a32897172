// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "workflows/live/live_messages.h"
#include "workflows/live/live_server.h"

namespace gaitwright {

/// Callbacks of a session.
struct LiveListener {
  std::function<void(const std::string&)> note = [](const std::string&) {};   ///< an event
  std::function<void(const std::string&)> phase = [](const std::string&) {};  ///< a line at each contact change
};

/// A world that runs in real time, with the pages that show it.
///
/// If the machine is too slow, the world falls behind and reports it; a lag beyond kMostBehind is dropped, so it never
/// runs faster to catch up.
class LiveSession {
 public:
  static constexpr double kMostBehind = 0.5;  ///< [s]
  static constexpr double kPictures_hz = 60.0;

  /// World and server must outlive this object.
  /// @param spent_s  a clock that measures the time of work [s]; default: the machine's.
  LiveSession(LiveWorld& live, LiveServer& server, LiveListener listener, std::function<double()> spent_s = {});

  /// Does the work that is due `wall_s` after the last call: messages, steps, a frame. Work beyond the time of a frame
  /// continues at the next call.
  /// @param wall_s  elapsed real time [s].
  void Turn(double wall_s);
  /// Runs in real time until `stop` returns true.
  void Run(const std::function<bool()>& stop);

 private:
  void Hear(double until_s);
  void StepOnce();
  void ReportPhase();
  void Note(const std::string& text);

  LiveWorld& live_;
  LiveServer& server_;
  LiveListener listener_;
  std::function<double()> spent_s_;
  LiveStatus status_;
  double due_s_ = 0.0;         ///< simulated time that is still due
  double let_go_s_ = 0.0;      ///< dropped part of it since the last report
  double unsaid_for_s_ = 0.0;  ///< time since the last report
  int noted_ = 0;
  FootSet planned_stance_ = 0, touching_ = 0;
};

}  // namespace gaitwright
