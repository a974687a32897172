// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <sstream>
#include <vector>

#include "kinematics/model/mend_urdf_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

/// An attribute that contains numbers.
struct NumberAttribute {
  const char* element;
  const char* name;
  std::size_t count;
};

constexpr std::array kNumberAttributes = {
    NumberAttribute{"origin", "xyz", 3},        NumberAttribute{"origin", "rpy", 3},
    NumberAttribute{"axis", "xyz", 3},          NumberAttribute{"box", "size", 3},
    NumberAttribute{"mesh", "scale", 3},        NumberAttribute{"mass", "value", 1},
    NumberAttribute{"inertia", "ixx", 1},       NumberAttribute{"inertia", "ixy", 1},
    NumberAttribute{"inertia", "ixz", 1},       NumberAttribute{"inertia", "iyy", 1},
    NumberAttribute{"inertia", "iyz", 1},       NumberAttribute{"inertia", "izz", 1},
    NumberAttribute{"sphere", "radius", 1},     NumberAttribute{"cylinder", "radius", 1},
    NumberAttribute{"cylinder", "length", 1},   NumberAttribute{"capsule", "radius", 1},
    NumberAttribute{"capsule", "length", 1},    NumberAttribute{"limit", "lower", 1},
    NumberAttribute{"limit", "upper", 1},       NumberAttribute{"limit", "effort", 1},
    NumberAttribute{"limit", "velocity", 1},    NumberAttribute{"dynamics", "damping", 1},
    NumberAttribute{"dynamics", "friction", 1}, NumberAttribute{"mimic", "multiplier", 1},
    NumberAttribute{"mimic", "offset", 1},
};

std::vector<std::string> WordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string Replaced(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

/// Whether a word has one comma between two digits and no point.
bool HasDecimalComma(const std::string& word) {
  const std::size_t at = word.find(',');
  const auto digit = [&](std::size_t i) { return i < word.size() && word[i] >= '0' && word[i] <= '9'; };
  return at != std::string::npos && at > 0 && digit(at - 1) && digit(at + 1) &&
         word.find(',', at + 1) == std::string::npos && word.find('.') == std::string::npos;
}

}  // namespace

std::optional<std::string> WithoutCommas(const std::string& text, std::size_t count) {
  if (text.find(',') == std::string::npos) return std::nullopt;
  const std::vector<std::string> words = WordsOf(text);
  const bool decimal = words.size() == count && std::all_of(words.begin(), words.end(), [](const std::string& word) {
                         return word.find(',') == std::string::npos || HasDecimalComma(word);
                       });
  if (decimal) return Replaced(text, ',', '.');
  std::string parted = Replaced(text, ',', ' ');
  if (WordsOf(parted).size() == count) return parted;
  return std::nullopt;
}

bool MendNumbers(XMLElement& element, const RobotPart& part, std::vector<Finding>& findings) {
  bool mended = false;
  const auto put = [&](const char* name, const std::string& value, const std::string& why) {
    findings.push_back({FindingLevel::kWarning, FailureCode::kNumberFormat, part, element.GetLineNum(),
                        fmt::format("{}=\"{}\" of <{}> {}: read as \"{}\"", name, element.Attribute(name),
                                    element.Name(), why, value)});
    element.SetAttribute(name, value.c_str());
    mended = true;
  };
  for (const NumberAttribute& numbers : kNumberAttributes) {
    if (std::strcmp(element.Name(), numbers.element) != 0) continue;
    const char* value = element.Attribute(numbers.name);
    if (value == nullptr) continue;
    if (const auto text = WithoutCommas(value, numbers.count)) put(numbers.name, *text, "has commas");
    const std::vector<std::string> words = WordsOf(element.Attribute(numbers.name));
    if (words.size() == 1 && std::strcmp(numbers.name, "scale") == 0)
      put("scale", fmt::format("{0} {0} {0}", words.front()), "has one number, three are needed");
  }
  for (XMLElement* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    mended = MendNumbers(*child, part, findings) || mended;
  return mended;
}

}  // namespace gaitwright
