// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/grade/motion_measures.h"
#include "workflows/grade/rubric.h"

namespace gaitwright {

/// The rule of a measure for parts of this kind. Refuses an unknown measure and names the nearest.
MeasureRule MeasureAt(const YAML::Node& node, const std::string& measure, RubricPartKind kind);

/// Each function reads the keys of one kind of part. It refuses unknown names and values out of range, and names the
/// line.
void ReadQuestionSetup(const YamlMap& map, const YAML::Node& node, RubricPart& part);
void ReadMotionSetup(const YamlMap& map, const YAML::Node& node, RubricPart& part);
void ReadCodeSetup(const YamlMap& map, RubricPart& part);

/// A number, or a list of the lowest and the highest number to draw.
NumberRange RangeAt(const YAML::Node& node, const std::string& what);

}  // namespace gaitwright
