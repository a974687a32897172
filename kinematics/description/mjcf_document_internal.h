// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Stops the conversion by throwing a Failure, which ConvertMjcfText catches.
[[noreturn]] void RefuseMjcf(FailureCode code, const std::string& message);

/// A text of the model for messages: shortened, or "(no text)" if it is not plain text.
std::string ShownMjcf(const std::string& text);

/// The text of a model and of the files that it includes.
class MjcfDocument {
 public:
  using TextReader = std::function<Result<std::string>(const std::string& file)>;

  /// Throws a Failure for a text that is not XML, another root element, and too many bytes, levels or files.
  MjcfDocument(const std::string& text, const std::string& name, const TextReader& read_text);

  const tinyxml2::XMLElement& root() const { return *files_.front()->xml.RootElement(); }

  /// Child elements in order; the elements of an included file replace its <include>.
  std::vector<const tinyxml2::XMLElement*> Children(const tinyxml2::XMLElement& parent) const;

  /// Elements of this name below the root; a section may occur several times.
  std::vector<const tinyxml2::XMLElement*> Sections(const std::string& name) const;

  /// Children of all sections of this name.
  std::vector<const tinyxml2::XMLElement*> InSections(const std::string& name) const;

  /// File, line and element for messages: "walker.xml, line 12: joint 'knee'".
  std::string Owner(const tinyxml2::XMLElement& element) const;

 private:
  struct File {
    std::string name;
    tinyxml2::XMLDocument xml;
  };

  const tinyxml2::XMLElement& Parse(const std::string& text, const std::string& name);
  void Include(const tinyxml2::XMLElement& parent, int depth, const TextReader& read_text);
  const tinyxml2::XMLElement& ReadIncluded(const tinyxml2::XMLElement& include, const TextReader& read_text);

  std::vector<std::unique_ptr<File>> files_;
  std::map<const tinyxml2::XMLDocument*, std::string> name_of_;
  std::map<const tinyxml2::XMLElement*, const tinyxml2::XMLElement*> included_;  // root element by <include>
  std::size_t bytes_ = 0;
};

}  // namespace gaitwright
