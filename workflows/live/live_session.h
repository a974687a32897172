// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "workflows/live/live_messages.h"
#include "workflows/live/live_server.h"

namespace gaitwright {

/// Told on the way.
struct LiveListener {
  std::function<void(const std::string&)> note = [](const std::string&) {};   ///< what happened
  std::function<void(const std::string&)> phase = [](const std::string&) {};  ///< a line at each change of contact
};

/// A world that goes on in real time, and the pages that look at it.
///
/// Where the machine is too slow, the world falls behind and says so; what it is behind beyond kMostBehind is let go,
/// so that it never rushes after.
class LiveSession {
 public:
  static constexpr double kMostBehind = 0.5;  ///< [s]
  static constexpr double kPictures_hz = 60.0;

  /// World and server must outlive it.
  /// @param spent_s  a clock that tells how long work takes [s]; the machine's where there is none.
  LiveSession(LiveWorld& live, LiveServer& server, LiveListener listener, std::function<double()> spent_s = {});

  /// What was to be done `wall_s` after the last call: messages, steps, a picture. What takes longer than a picture may
  /// is gone on with at the next call.
  /// @param wall_s  of the machine's clock [s].
  void Turn(double wall_s);
  /// In real time until `stop` says so.
  void Run(const std::function<bool()>& stop);

 private:
  void Hear(double until_s);
  void StepOnce();
  void TellPhase();
  void Note(const std::string& text);

  LiveWorld& live_;
  LiveServer& server_;
  LiveListener listener_;
  std::function<double()> spent_s_;
  LiveStatus status_;
  double due_s_ = 0.0;         ///< what the world has still to go to be where the wall's clock is
  double let_go_s_ = 0.0;      ///< of that, since it was said last
  double unsaid_for_s_ = 0.0;  ///< for so long it was not said
  int noted_ = 0;
  FootSet planned_stance_ = 0, touching_ = 0;
};

}  // namespace gaitwright
