// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Path and reason of the first mismatch of a value with a shape; "" if it fits.
inline std::string Misfit(const nlohmann::ordered_json& value, const DataShape& shape, const std::string& path = "$") {
  using Kind = DataShape::Kind;
  if (value.is_null() && shape.or_null) return "";
  std::string why;
  if (shape.kind == Kind::kObject) {
    if (!value.is_object()) why = path + " is no object";
    for (const std::string& key : shape.NeededKeys()) {
      if (why.empty() && !value.contains(key)) why = path + " lacks " + key;
    }
    for (const auto& member : shape.members) {
      if (why.empty() && value.contains(member.key))
        why = Misfit(value.at(member.key), member.shape, path + "." + member.key);
    }
    const std::vector<std::string> keys = shape.Keys();
    for (auto item = value.begin(); why.empty() && item != value.end(); ++item) {
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
        why = path + " has an unknown key " + item.key();
    }
  } else if (shape.kind == Kind::kList || shape.kind == Kind::kMap) {
    const bool list = shape.kind == Kind::kList;
    if (list ? !value.is_array() : !value.is_object()) why = path + (list ? " is no list" : " is no map");
    if (why.empty() && (value.size() < shape.least || value.size() > shape.most)) why = path + " has another length";
    for (std::size_t k = 0; why.empty() && list && k < value.size(); ++k)
      why = Misfit(value.at(k), shape.of.front(), path + "[" + std::to_string(k) + "]");
    for (auto item = value.begin(); why.empty() && !list && item != value.end(); ++item)
      why = Misfit(item.value(), shape.of.front(), path + "." + item.key());
  } else if (shape.kind == Kind::kNumber || shape.kind == Kind::kWhole) {
    const bool number = shape.kind == Kind::kWhole ? value.is_number_integer() : value.is_number();
    if (!number) why = path + " is no number of its kind";
    if (number && (value.get<double>() < shape.lowest || value.get<double>() > shape.highest))
      why = path + " is out of range";
  } else if (shape.kind == Kind::kText) {
    if (!value.is_string()) {
      why = path + " is no text";
    } else if (!shape.choices.empty() &&
               std::find(shape.choices.begin(), shape.choices.end(), value.get<std::string>()) == shape.choices.end()) {
      why = path + " is '" + value.get<std::string>() + "'";
    }
  } else if (shape.kind == Kind::kTruth && !value.is_boolean()) {
    why = path + " is no truth value";
  }
  for (const DataShape& other : shape.or_else) {
    if (!why.empty() && Misfit(value, other, path).empty()) why.clear();
  }
  return why;
}

/// The object without one key.
inline nlohmann::ordered_json Without(nlohmann::ordered_json json, const std::string& key) {
  json.erase(key);
  return json;
}

}  // namespace gaitwright
