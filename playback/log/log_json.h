// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// The log as JSON text. The same log gives the same bytes, and reading them gives the same log exactly.
///
/// Keys: `format` ("gaitwright-playback-log"), `schema`, what PlaybackLog says of itself, `stances`, `body_contacts`,
/// then one row per sample in each of `time_s`, `q`, `v`, `tau_nm`, `tau_peak_nm`, `effort_use`, `contact` (bit i: foot
/// i) and `contact_wrenches` (by foot: force [N], moment [N m]), and `estimate` where the controller estimated the
/// base: place, quaternion x y z w, velocity, angular velocity; `broke_off` where it could not go on.
std::string LogToJson(const PlaybackLog& log);

/// A log from its JSON text. Refused with the reason: text that is cut short, that is no log, of another schema, a key
/// that is missing or of the wrong kind, sizes that disagree, what CheckLog refuses. @param source names the text in
/// messages.
Result<PlaybackLog> LogFromJson(const std::string& text, const std::string& source);

/// Writes atomically. @return the path.
Result<std::string> SaveLog(const PlaybackLog& log, const std::string& path);
/// The log of a file; refused as LogFromJson does, or where there is no such file.
Result<PlaybackLog> LoadLog(const std::string& path);

}  // namespace gaitwright
