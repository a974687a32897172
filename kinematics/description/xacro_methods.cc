// SPDX-License-Identifier: BSD-3-Clause
// The methods of texts, lists and dictionaries that expressions may call.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {
namespace {

const std::vector<std::string> kXacroTextMethods = {
    "lower", "upper",   "strip", "lstrip", "rstrip",   "capitalize", "title",      "split",
    "join",  "replace", "find",  "count",  "endswith", "isdigit",    "startswith", "format"};
const std::vector<std::string> kXacroDictMethods = {"get", "keys", "values", "items"};
const std::vector<std::string> kXacroListMethods = {"index", "count", "pop"};

/// The largest number of arguments of each method.
const std::map<std::string, std::size_t> kMostMethodArguments = {{"lower", 0},      {"upper", 0},
                                                                 {"strip", 1},      {"lstrip", 1},
                                                                 {"rstrip", 1},     {"capitalize", 0},
                                                                 {"title", 0},      {"split", 2},
                                                                 {"join", 1},       {"replace", 3},
                                                                 {"find", 1},       {"count", 1},
                                                                 {"endswith", 1},   {"isdigit", 0},
                                                                 {"get", 2},        {"keys", 0},
                                                                 {"values", 0},     {"items", 0},
                                                                 {"startswith", 1}, {"index", 1},
                                                                 {"pop", 1},        {"format", kMostXacroItems}};

/// The argument at index `place`, which must be a text.
const std::string& XacroTextArgument(const std::vector<XacroValue>& arguments, std::size_t place,
                                     const std::string& name) {
  if (place >= arguments.size() || arguments[place].text() == nullptr)
    RefuseXacroType(fmt::format("{}() needs a text as argument {}", name, place + 1));
  return *arguments[place].text();
}

/// The largest number of parts for a method to cut or replace, from the argument at index `place`; unlimited if it is
/// missing or negative.
std::size_t XacroCountArgument(const std::vector<XacroValue>& arguments, std::size_t place, const std::string& name) {
  if (place >= arguments.size()) return std::string::npos;
  if (arguments[place].whole() == nullptr)
    RefuseXacroType(fmt::format("{}() needs a whole number as argument {}", name, place + 1));
  const std::int64_t count = *arguments[place].whole();
  return count < 0 ? std::string::npos : static_cast<std::size_t>(count);
}

XacroValue SplitText(const std::string& text, const std::vector<XacroValue>& arguments, XacroBudget& budget) {
  std::vector<XacroValue> parts;
  if (arguments.empty()) {
    constexpr const char* kBlanks = " \t\r\n";
    for (std::size_t from = text.find_first_not_of(kBlanks); from != std::string::npos;) {
      const std::size_t end = std::min(text.find_first_of(kBlanks, from), text.size());
      parts.push_back({text.substr(from, end - from)});
      from = text.find_first_not_of(kBlanks, end);
    }
  } else {
    const std::string& separator = XacroTextArgument(arguments, 0, "split");
    if (separator.empty()) RefuseXacroType("the separator of split() must not be empty");
    const std::size_t most = XacroCountArgument(arguments, 1, "split");
    std::size_t from = 0;
    for (std::size_t end = text.find(separator); end != std::string::npos && parts.size() < most;
         end = text.find(separator, from)) {
      parts.push_back({text.substr(from, end - from)});
      from = end + separator.size();
    }
    parts.push_back({text.substr(from)});
  }
  budget.Spend(parts.size());
  return XacroListOf(std::move(parts), budget);
}

XacroValue JoinText(const std::string& separator, const XacroValue& list, XacroBudget& budget) {
  std::string joined;
  bool first = true;
  for (const XacroValue& item : XacroItems(list, budget)) {
    if (item.text() == nullptr) RefuseXacroType(fmt::format("join() needs texts, not a {}", XacroKind(item)));
    joined += (first ? "" : separator) + *item.text();
    first = false;
    budget.Spend(1 + (separator.size() + item.text()->size()) / 16);
    if (joined.size() > kLongestXacroText) break;
  }
  return XacroText(std::move(joined));
}

XacroValue ReplaceText(const std::string& text, const std::vector<XacroValue>& arguments, XacroBudget& budget) {
  const std::string &from = XacroTextArgument(arguments, 0, "replace"),
                    &to = XacroTextArgument(arguments, 1, "replace");
  std::size_t left = XacroCountArgument(arguments, 2, "replace");
  if (from.empty()) RefuseXacroType("replace() needs a text that is not empty");
  std::string replaced;
  std::size_t at = 0;
  for (std::size_t found = text.find(from); found != std::string::npos && left > 0; found = text.find(from, at)) {
    --left;
    replaced.append(text, at, found - at);
    replaced += to;
    at = found + from.size();
    budget.Spend(1 + to.size() / 16);
    if (replaced.size() > kLongestXacroText) break;
  }
  return XacroText(replaced + text.substr(at));
}

/// The text in small letters, with a capital letter at the beginning of the text or of each word.
std::string CapitalisedText(const std::string& text, bool each_word) {
  std::string result = LowerCase(text);
  bool begins = true;
  for (char& c : result) {
    const bool letter = c >= 'a' && c <= 'z';
    if (begins && letter) c = static_cast<char>(c - 'a' + 'A');
    begins = each_word && !letter;
  }
  return result;
}

std::string StrippedText(const std::string& text, const std::string& characters, const std::string& method) {
  const std::size_t first = method == "rstrip" ? 0 : text.find_first_not_of(characters);
  const std::size_t last = method == "lstrip" ? text.size() : text.find_last_not_of(characters) + 1;
  return first == std::string::npos || last <= first ? "" : text.substr(first, last - first);
}

XacroValue TextMethod(const std::string& text, const std::string& name, const std::vector<XacroValue>& arguments,
                      XacroBudget& budget) {
  budget.Spend(1 + text.size() / 8);
  if (name == "format") return FormatXacroText(text, {arguments, {}}, budget);
  if (name == "lower") return {LowerCase(text)};
  if (name == "upper") {
    std::string upper = text;
    for (char& c : upper) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return {upper};
  }
  if (name == "capitalize" || name == "title") return {CapitalisedText(text, name == "title")};
  if (name == "isdigit")
    return {!text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })};
  if (name == "split") return SplitText(text, arguments, budget);
  if (name.ends_with("strip"))
    return {StrippedText(text, arguments.empty() ? " \t\r\n" : XacroTextArgument(arguments, 0, name), name)};
  if (name == "join") {
    if (arguments.size() != 1) RefuseXacroType("join() needs one list");
    return JoinText(text, arguments[0], budget);
  }
  if (name == "replace") return ReplaceText(text, arguments, budget);
  const std::string& part = XacroTextArgument(arguments, 0, name);
  if (name == "startswith") return {text.starts_with(part)};
  if (name == "endswith") return {text.ends_with(part)};
  const std::size_t found = text.find(part);
  if (name == "find") return {found == std::string::npos ? std::int64_t{-1} : static_cast<std::int64_t>(found)};
  if (part.empty()) return {static_cast<std::int64_t>(text.size() + 1)};
  std::int64_t count = 0;
  for (std::size_t at = found; at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return {count};
}

XacroValue DictMethod(const XacroDict& dict, const std::string& name, const std::vector<XacroValue>& arguments,
                      XacroBudget& budget) {
  if (name == "get") {
    if (arguments.empty() || arguments.size() > 2) RefuseXacroType("get() needs a key and an optional default");
    const XacroValue* value = dict.Find(arguments[0], budget);
    if (value != nullptr) return *value;
    return arguments.size() == 2 ? arguments[1] : XacroValue{};
  }
  std::vector<XacroValue> items;
  for (const auto& [key, value] : dict.entries)
    items.push_back(name == "keys" ? key : name == "values" ? value : XacroListOf({key, value}, budget));
  return XacroListOf(std::move(items), budget);
}

/// Removes the last item of a list, or the item at an index, and returns it. Recursive macros use this to visit a list.
XacroValue PoppedItem(XacroList& list, const std::vector<XacroValue>& arguments, XacroBudget& budget) {
  const std::int64_t size = static_cast<std::int64_t>(list.items.size());
  if (arguments.size() > 1 || (arguments.size() == 1 && arguments[0].whole() == nullptr))
    RefuseXacroType("pop() needs the index of an item");
  const std::int64_t given = arguments.empty() ? -1 : *arguments[0].whole(), place = given < 0 ? given + size : given;
  if (place < 0 || place >= size)
    throw XacroProblem{FailureCode::kXacroIndex,
                       fmt::format("pop() of item {} is outside a list of size {}", given, size)};
  budget.Spend(1 + list.items.size() / 8);
  XacroValue item = list.items[static_cast<std::size_t>(place)];
  list.items.erase(list.items.begin() + place);
  return item;
}

XacroValue ListMethod(const XacroList& list, const std::string& name, const std::vector<XacroValue>& arguments,
                      XacroBudget& budget) {
  if (arguments.size() != 1) RefuseXacroType(fmt::format("{}() takes one argument", name));
  std::int64_t count = 0;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    if (!XacroEqual(list.items[i], arguments[0], budget)) continue;
    if (name == "index") return {static_cast<std::int64_t>(i)};
    ++count;
  }
  if (name == "index") RefuseXacroType("index(): the list does not have the item");
  return {count};
}

}  // namespace

XacroValue CallXacroMethod(const XacroValue& object, const std::string& name, const std::vector<XacroValue>& arguments,
                           XacroBudget& budget) {
  const std::vector<std::string>* methods = object.text() != nullptr   ? &kXacroTextMethods
                                            : object.dict() != nullptr ? &kXacroDictMethods
                                            : object.list() != nullptr ? &kXacroListMethods
                                                                       : nullptr;
  if (methods == nullptr) RefuseXacroType(fmt::format("a {} has no method '{}'", XacroKind(object), Shortened(name)));
  if (std::find(methods->begin(), methods->end(), name) == methods->end()) {
    throw XacroProblem{FailureCode::kUnknownFunction,
                       fmt::format("the method '{}' of a {} is not known{}", Shortened(name), XacroKind(object),
                                   NearestOrAll(name, *methods))};
  }
  if (const std::size_t most = kMostMethodArguments.at(name); arguments.size() > most) {
    RefuseXacroType(fmt::format("{}() takes {} arguments at most, not {}", name, most, arguments.size()));
  }
  if (object.text() != nullptr) return TextMethod(*object.text(), name, arguments, budget);
  if (object.dict() != nullptr) return DictMethod(*object.dict(), name, arguments, budget);
  if (name == "pop") return PoppedItem(*std::get<std::shared_ptr<XacroList>>(object.held), arguments, budget);
  return ListMethod(*object.list(), name, arguments, budget);
}

}  // namespace gaitwright
