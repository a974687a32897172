// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <map>
#include <sstream>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {
namespace {

/// Checks the events of a YAML text without storing them. Throws InvalidArgument if the text exceeds the bounds.
class BoundsWatch : public YAML::EventHandler {
 public:
  explicit BoundsWatch(std::size_t most_values) : most_values_(most_values) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) Refuse(mark, "a second YAML document begins; exactly one is accepted");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { Take(mark, anchor, 1); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = size_of_.find(anchor);
    if (known == size_of_.end()) Refuse(mark, "an alias refers to a node that contains it");
    Take(mark, 0, known->second);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                const std::string& value) override {
    if (value.size() > kLongestYamlText)
      Refuse(mark, fmt::format("a text has {} bytes; at most {} are read", value.size(), kLongestYamlText));
    if (value.find('\0') != std::string::npos) Refuse(mark, "a text contains a byte 0x00");
    Take(mark, anchor, 1);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    Open(mark, anchor);
  }
  void OnSequenceEnd() override { Close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    Open(mark, anchor);
  }
  void OnMapEnd() override { Close(); }

 private:
  /// A list or map that is still open.
  struct Container {
    YAML::anchor_t anchor;
    std::size_t before;  ///< values before it
  };

  [[noreturn]] static void Refuse(const YAML::Mark& mark, const std::string& message) {
    throw InvalidArgument(fmt::format("line {}: {}", mark.line + 1, message));
  }
  void Take(const YAML::Mark& mark, YAML::anchor_t anchor, std::size_t values) {
    values_ += values;
    if (values_ > most_values_)
      Refuse(mark, fmt::format("more than {} values, including those repeated by aliases", most_values_));
    if (anchor != 0) size_of_[anchor] = values;
  }
  void Open(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() >= kDeepestYaml)
      Refuse(mark, fmt::format("lists and maps are nested more than {} levels deep", kDeepestYaml));
    open_.push_back({anchor, values_});
    Take(mark, 0, 1);
  }
  void Close() {
    if (open_.empty()) return;
    if (open_.back().anchor != 0) size_of_[open_.back().anchor] = values_ - open_.back().before;
    open_.pop_back();
  }

  const std::size_t most_values_;
  int documents_ = 0;
  std::size_t values_ = 0;
  std::vector<Container> open_;
  std::map<YAML::anchor_t, std::size_t> size_of_;  // of completed nodes
};

/// Calls a function that reads YAML. For some texts, yaml-cpp throws exceptions of other types than its own.
template <class Read>
auto WithYamlErrors(Read read) {
  try {
    return read();
  } catch (const YAML::Exception&) {
    throw;
  } catch (const InvalidArgument&) {
    throw;
  } catch (const std::exception& error) {
    throw InvalidArgument(fmt::format("line 1: this is not YAML: {}", error.what()));
  }
}

}  // namespace

YAML::Node LoadYaml(const std::string& text, const YamlBounds& bounds) {
  if (text.size() > bounds.bytes)
    throw InvalidArgument(fmt::format("line 1: the text has {} bytes; at most {} are read", text.size(), bounds.bytes));
  return WithYamlErrors([&] {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    BoundsWatch watch(bounds.values);
    while (parser.HandleNextDocument(watch)) {
    }
    return YAML::Load(text);
  });
}

}  // namespace gaitwright
