// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "kinematics/base/text.h"
#include "kinematics/description/mjcf_document_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kLargestMjcf = std::size_t{16} << 20;  // total size of all files [byte]
constexpr std::size_t kMostMjcfFiles = 100;
constexpr std::size_t kMostMjcfAttributes = 1000;  // in one element: the time to parse them is quadratic
constexpr int kDeepestMjcf = 200;

bool IsMjcfInclude(const tinyxml2::XMLElement& element) { return std::strcmp(element.Name(), "include") == 0; }

/// The place of a character reference to zero, such as "&#0;", or npos.
std::size_t FindMjcfZeroReference(const std::string& text) {
  for (std::size_t at = text.find("&#"); at != std::string::npos; at = text.find("&#", at + 1)) {
    const std::size_t end = text.find_first_not_of("xX0", at + 2);
    if (end != std::string::npos && end > at + 2 && text[end] == ';') return at;
  }
  return std::string::npos;
}

/// The end of a comment, a CDATA section or a declaration that begins at a '<'.
std::size_t EndOfMjcfComment(const std::string& text, std::size_t at) {
  if (text.compare(at, 4, "<!--") == 0) return text.find("-->", at);
  if (text.compare(at, 9, "<![CDATA[") == 0) return text.find("]]>", at);
  const bool is_comment = at + 1 < text.size() && (text[at + 1] == '!' || text[at + 1] == '?');
  return is_comment ? text.find('>', at) : at;
}

/// Whether an element has more than kMostMjcfAttributes attributes.
bool HasManyMjcfAttributes(const std::string& text) {
  std::size_t count = 0;
  char quote = '\0';
  bool in_tag = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '<' && !in_tag) {
      const std::size_t end = EndOfMjcfComment(text, at);
      in_tag = end == at;
      at = std::min(end, text.size());
      count = 0;
    } else if (in_tag && c == '>') {
      in_tag = false;
    } else if (in_tag && (c == '"' || c == '\'')) {
      quote = c;
    } else if (in_tag && c == '=' && ++count > kMostMjcfAttributes) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string ShownMjcf(const std::string& text) { return IsPlainText(text) ? Shortened(text) : "(no text)"; }

void RefuseMjcf(FailureCode code, const std::string& message) {
  throw Failure{FailureKind::kBadInput, code, "ConvertMjcf", message, {}};
}

MjcfDocument::MjcfDocument(const std::string& text, const std::string& name, const TextReader& read_text) {
  const tinyxml2::XMLElement& model = Parse(text, name);
  if (std::strcmp(model.Name(), "mujoco") != 0 && std::strcmp(model.Name(), "mujocoinclude") != 0) {
    RefuseMjcf(FailureCode::kNotMjcf,
               fmt::format("{}: the root element is <{}>; a MuJoCo model has <mujoco>", name, ShownMjcf(model.Name())));
  }
  Include(model, 1, read_text);
}

const tinyxml2::XMLElement& MjcfDocument::Parse(const std::string& text, const std::string& name) {
  bytes_ += text.size();
  if (bytes_ > kLargestMjcf) {
    RefuseMjcf(FailureCode::kLargeMjcf,
               fmt::format("{0}: the model and its included files have more than {1} bytes; at most {1} are read", name,
                           kLargestMjcf));
  }
  if (text.find('\0') != std::string::npos || FindMjcfZeroReference(text) != std::string::npos)
    RefuseMjcf(FailureCode::kNotXml, fmt::format("{}: it is not XML: it contains the character 0x00", name));
  if (HasManyMjcfAttributes(text))
    RefuseMjcf(FailureCode::kLargeMjcf,
               fmt::format("{0}: an element has over {1} attributes; at most {1} are read", name, kMostMjcfAttributes));
  if (!IsPlainText(text))
    RefuseMjcf(FailureCode::kNotText, fmt::format("{}: it is not valid UTF-8 or contains a control character", name));
  files_.push_back(std::make_unique<File>());
  File& file = *files_.back();
  file.name = name;
  name_of_[&file.xml] = name;
  if (file.xml.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS)
    RefuseMjcf(FailureCode::kNotXml,
               fmt::format("{}, line {}: it is not XML: {}", name, file.xml.ErrorLineNum(), file.xml.ErrorName()));
  if (file.xml.RootElement() == nullptr)
    RefuseMjcf(FailureCode::kNotXml, fmt::format("{}: it contains no element", name));
  return *file.xml.RootElement();
}

const tinyxml2::XMLElement& MjcfDocument::ReadIncluded(const tinyxml2::XMLElement& include,
                                                       const TextReader& read_text) {
  const char* named = include.Attribute("file");
  if (named == nullptr || *named == '\0' || !IsPlainText(named))
    RefuseMjcf(FailureCode::kMjcfMissing, fmt::format("{}: it has no 'file'", Owner(include)));
  if (files_.size() >= kMostMjcfFiles)
    RefuseMjcf(FailureCode::kLargeMjcf,
               fmt::format("{0}: over {1} files are included; at most {1} are read", Owner(include), kMostMjcfFiles));
  if (!read_text)
    RefuseMjcf(FailureCode::kNoFile,
               fmt::format("{}: the file '{}' was not given with the model's text", Owner(include), Shortened(named)));
  std::string name = std::filesystem::path(named).lexically_normal().string();
  Result<std::string> text = read_text(name);
  if (!text && include.GetDocument() != &files_.front()->xml) {
    // Paths are relative to the model's folder, or to the folder of the including file if the first does not exist.
    const std::filesystem::path folder = std::filesystem::path(name_of_.at(include.GetDocument())).parent_path();
    const std::string beside = (folder / named).lexically_normal().string();
    Result<std::string> second = read_text(beside);
    if (second) {
      text = std::move(second);
      name = beside;
    }
  }
  if (!text) RefuseMjcf(FailureCode::kNoFile, fmt::format("{}: {}", Owner(include), text.failure().message));
  const bool again =
      std::any_of(files_.begin(), files_.end(), [&](const std::unique_ptr<File>& file) { return file->name == name; });
  if (again)
    RefuseMjcf(FailureCode::kMjcfInclude, fmt::format("{}: the file '{}' is included twice, or includes itself",
                                                      Owner(include), Shortened(named)));
  return Parse(*text, name);
}

void MjcfDocument::Include(const tinyxml2::XMLElement& parent, int depth, const TextReader& read_text) {
  if (depth > kDeepestMjcf) {
    RefuseMjcf(FailureCode::kLargeMjcf,
               fmt::format("{0}: elements are nested over {1} levels deep; at most {1} levels are read", Owner(parent),
                           kDeepestMjcf));
  }
  for (const auto* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (!IsMjcfInclude(*child)) {
      Include(*child, depth + 1, read_text);
      continue;
    }
    const tinyxml2::XMLElement& root = ReadIncluded(*child, read_text);
    included_[child] = &root;
    Include(root, depth + 1, read_text);
  }
}

std::vector<const tinyxml2::XMLElement*> MjcfDocument::Children(const tinyxml2::XMLElement& parent) const {
  std::vector<const tinyxml2::XMLElement*> children;
  for (const auto* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const auto include = included_.find(child);
    if (include == included_.end()) {
      children.push_back(child);
      continue;
    }
    const std::vector<const tinyxml2::XMLElement*> inner = Children(*include->second);
    children.insert(children.end(), inner.begin(), inner.end());
  }
  return children;
}

std::vector<const tinyxml2::XMLElement*> MjcfDocument::Sections(const std::string& name) const {
  std::vector<const tinyxml2::XMLElement*> sections = Children(root());
  std::erase_if(sections, [&](const tinyxml2::XMLElement* section) { return section->Name() != name; });
  return sections;
}

std::vector<const tinyxml2::XMLElement*> MjcfDocument::InSections(const std::string& name) const {
  std::vector<const tinyxml2::XMLElement*> all;
  for (const tinyxml2::XMLElement* section : Sections(name)) {
    const std::vector<const tinyxml2::XMLElement*> children = Children(*section);
    all.insert(all.end(), children.begin(), children.end());
  }
  return all;
}

std::string MjcfDocument::Owner(const tinyxml2::XMLElement& element) const {
  const std::string place = fmt::format("{}, line {}", name_of_.at(element.GetDocument()), element.GetLineNum());
  const bool is_class = std::strcmp(element.Name(), "default") == 0;
  const char* name = element.Attribute(is_class ? "class" : "name");
  if (name == nullptr || *name == '\0' || !IsPlainText(name))
    return fmt::format("{}: <{}>", place, ShownMjcf(element.Name()));
  return fmt::format("{}: {} '{}'", place, ShownMjcf(element.Name()), ShownMjcf(name));
}

}  // namespace gaitwright
