// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// The log as JSON text. Deterministic to the byte; reading it back gives the same log.
///
/// Keys: `format` ("gaitwright-playback-log"), `schema`, the header of PlaybackLog, `stances`, `body_contacts`, then
/// one row per sample in each of `time_s`, `q`, `v`, `tau_nm`, `tau_peak_nm`, `effort_use`, `contact` (bit i: foot i)
/// and `contact_wrenches` (by foot: force [N], moment [N m]), and `estimate` where the controller estimated the base:
/// place, quaternion x y z w, velocity, angular velocity; `broke_off` if the playback ended early.
std::string LogToJson(const PlaybackLog& log);

/// Reads a log from its JSON text. Refuses, with the reason: truncated text, text that is not a log, another schema, a
/// missing key or one of the wrong kind, inconsistent sizes, and logs that CheckLog refuses. @param source names the
/// text in messages.
Result<PlaybackLog> LogFromJson(const std::string& text, const std::string& source);

/// Writes atomically. @return the path.
Result<std::string> SaveLog(const PlaybackLog& log, const std::string& path);
/// Reads the log of a file. Refuses as LogFromJson does, or if there is no such file.
Result<PlaybackLog> LoadLog(const std::string& path);

}  // namespace gaitwright
