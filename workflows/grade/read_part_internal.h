// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/grade/motion_measures.h"
#include "workflows/grade/rubric.h"

namespace gaitwright {

/// The rule of a measure that parts of that kind have. Refuses another, naming the nearest.
MeasureRule MeasureAt(const YAML::Node& node, const std::string& measure, PartKind kind);

/// Each reads what parts of its kind have. They refuse, naming the line, what there is not or is out of range.
void ReadQuestionSetup(const YamlMap& map, const YAML::Node& node, RubricPart& part);
void ReadMotionSetup(const YamlMap& map, const YAML::Node& node, RubricPart& part);
void ReadCodeSetup(const YamlMap& map, RubricPart& part);

/// A number, or a list of two that it is drawn between.
NumberRange RangeAt(const YAML::Node& node, const std::string& what);

}  // namespace gaitwright
