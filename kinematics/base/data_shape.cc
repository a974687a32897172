// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/data_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json SchemaJson(const DataShape& shape);

const char* TypeOf(DataShape::Kind kind) {
  switch (kind) {
    case DataShape::Kind::kObject:
    case DataShape::Kind::kMap:
      return "object";
    case DataShape::Kind::kList:
      return "array";
    case DataShape::Kind::kNumber:
      return "number";
    case DataShape::Kind::kWhole:
      return "integer";
    case DataShape::Kind::kText:
      return "string";
    default:
      return "boolean";
  }
}

void AddRange(const DataShape& shape, Json& json) {
  const bool whole = shape.kind == DataShape::Kind::kWhole;
  const auto figure = [&](double value) { return whole ? Json(static_cast<std::int64_t>(value)) : Json(value); };
  if (std::isfinite(shape.lowest)) json[shape.over_lowest ? "exclusiveMinimum" : "minimum"] = figure(shape.lowest);
  if (std::isfinite(shape.highest)) json["maximum"] = figure(shape.highest);
}

void AddCounts(const DataShape& shape, const char* least, const char* most, Json& json) {
  if (shape.least > 0) json[least] = shape.least;
  if (shape.most != std::string::npos) json[most] = shape.most;
}

/// Schema that needs exactly one key of each list.
Json OneOfEach(const std::vector<std::vector<std::string>>& lists) {
  Json all = Json::array();
  for (const std::vector<std::string>& keys : lists) {
    Json one = Json::array();
    for (const std::string& key : keys) one.push_back({{"required", Json::array({key})}});
    all.push_back({{"oneOf", one}});
  }
  return all;
}

void AddMembers(const DataShape& shape, Json& json) {
  Json properties = Json::object();
  for (const ShapeMember& member : shape.members) {
    Json property = SchemaJson(member.shape);
    if (!member.meaning.empty()) property["description"] = member.meaning;
    properties[member.key] = property;
  }
  json["properties"] = properties;
  if (const auto needed = shape.NeededKeys(); !needed.empty()) json["required"] = needed;
  if (!shape.one_of.empty()) json["allOf"] = OneOfEach(shape.one_of);
  json["additionalProperties"] = false;
}

/// The schema of a shape without its alternatives.
Json PlainSchema(const DataShape& shape) {
  Json json = Json::object();
  if (shape.kind == DataShape::Kind::kAnything) return json;
  json["type"] = TypeOf(shape.kind);
  if (!shape.choices.empty()) json["enum"] = shape.choices;
  AddRange(shape, json);
  if (shape.kind == DataShape::Kind::kObject && shape.least > 0) json["minProperties"] = shape.least;
  if (shape.kind == DataShape::Kind::kList) {
    AddCounts(shape, "minItems", "maxItems", json);
    json["items"] = SchemaJson(shape.of.front());
  } else if (shape.kind == DataShape::Kind::kMap) {
    AddCounts(shape, "minProperties", "maxProperties", json);
    json["additionalProperties"] = SchemaJson(shape.of.front());
  } else if (shape.kind == DataShape::Kind::kObject) {
    AddMembers(shape, json);
  }
  return json;
}

Json SchemaJson(const DataShape& shape) {
  if (shape.or_else.empty() && !shape.or_null) return PlainSchema(shape);
  Json any = Json::array({PlainSchema(shape)});
  for (const DataShape& other : shape.or_else) any.push_back(SchemaJson(other));
  if (shape.or_null) any.push_back({{"type", "null"}});
  return {{"anyOf", any}};
}

}  // namespace

std::vector<std::string> DataShape::Keys() const {
  std::vector<std::string> keys;
  for (const ShapeMember& member : members) keys.push_back(member.key);
  return keys;
}

std::vector<std::string> DataShape::NeededKeys() const {
  std::vector<std::string> keys;
  for (const ShapeMember& member : members) {
    if (member.needed) keys.push_back(member.key);
  }
  return keys;
}

std::vector<std::string> DataShape::OtherKeys() const {
  std::vector<std::string> keys;
  for (const ShapeMember& member : members) {
    if (!member.needed) keys.push_back(member.key);
  }
  return keys;
}

const DataShape& DataShape::At(const std::string& key) const {
  const auto at = std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.key == key; });
  if (at == members.end())
    throw InvalidArgument(fmt::format("the shape has no key '{}'{}", key, NearestOrAll(key, Keys())));
  return at->shape;
}

namespace shapes {
namespace {

DataShape Plain(DataShape::Kind kind) {
  DataShape shape;
  shape.kind = kind;
  return shape;
}

}  // namespace

DataShape Anything() { return {}; }

DataShape Truth() { return Plain(DataShape::Kind::kTruth); }

DataShape Text(std::vector<std::string> choices) {
  DataShape shape = Plain(DataShape::Kind::kText);
  shape.choices = std::move(choices);
  return shape;
}

DataShape Number() { return Plain(DataShape::Kind::kNumber); }

DataShape Number(double lowest, double highest) {
  DataShape shape = Number();
  shape.lowest = lowest;
  shape.highest = highest;
  return shape;
}

DataShape Positive(double highest) {
  DataShape shape = Number(0.0, highest);
  shape.over_lowest = true;
  return shape;
}

DataShape Whole(double lowest, double highest) {
  DataShape shape = Number(lowest, highest);
  shape.kind = DataShape::Kind::kWhole;
  return shape;
}

DataShape List(DataShape of, std::size_t least, std::size_t most) {
  DataShape shape = Plain(DataShape::Kind::kList);
  shape.of = {std::move(of)};
  shape.least = least;
  shape.most = most;
  return shape;
}

DataShape Numbers(std::size_t count) { return List(Number(), count, count); }

DataShape Numbers() { return List(Number()); }

DataShape MapOf(DataShape of, std::size_t least) {
  DataShape shape = List(std::move(of), least);
  shape.kind = DataShape::Kind::kMap;
  return shape;
}

DataShape Object(std::vector<ShapeMember> members, std::vector<std::vector<std::string>> one_of) {
  DataShape shape = Plain(DataShape::Kind::kObject);
  shape.members = std::move(members);
  shape.one_of = std::move(one_of);
  return shape;
}

DataShape NumberOrNull() { return OrNull(Number()); }

DataShape OrNull(DataShape shape) {
  shape.or_null = true;
  return shape;
}

DataShape Either(DataShape shape, DataShape other) {
  shape.or_else.push_back(std::move(other));
  return shape;
}

ShapeMember Field(const OptionField& field) {
  const auto shape = [&]() -> DataShape {
    if (std::holds_alternative<bool*>(field.target)) return Truth();
    if (std::holds_alternative<std::string*>(field.target)) return Text(field.choices);
    return std::holds_alternative<int*>(field.target) ? Whole(field.lowest, field.highest)
                                                      : Number(field.lowest, field.highest);
  };
  const bool bare = field.unit.empty() || field.unit == "1";
  return {field.key, shape(), bare ? field.meaning : fmt::format("{} [{}]", field.meaning, field.unit), false};
}

ShapeMember Optional(std::string key, DataShape shape, std::string meaning) {
  return {std::move(key), std::move(shape), std::move(meaning), false};
}

}  // namespace shapes

std::string SchemaOf(const DataShape& shape, const std::string& title, const std::string& description) {
  Json json = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}, {"description", description}};
  json.update(SchemaJson(shape));
  return json.dump(2) + "\n";
}

}  // namespace gaitwright
