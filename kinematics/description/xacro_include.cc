// SPDX-License-Identifier: BSD-3-Clause
// Files of a description.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

using tinyxml2::XMLElement;

constexpr std::size_t kLargestXacroFile = std::size_t{16} << 20, kMostXacroRead = std::size_t{64} << 20;  // [byte]

/// The reason why a text cannot be read as XML, to be appended to the name of its file; "" if it can be read. A byte
/// 0x00 is refused because tinyxml2 would stop there.
std::string ReasonNotXacroXml(const std::string& text, tinyxml2::XMLDocument& document) {
  if (text.size() > kLargestXacroFile)
    return fmt::format(": it has {} bytes; at most {} are read", text.size(), kLargestXacroFile);
  if (text.find('\0') != std::string::npos) return ": it has a byte 0x00";
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS)
    return fmt::format(":{}: it is not XML: {}", document.ErrorLineNum(), document.ErrorName());
  return document.RootElement() == nullptr ? ": it contains no element" : "";
}

}  // namespace

const XacroFile& XacroExpander::FileOf(const Element& element) {
  return *static_cast<const XacroFile*>(element.GetDocument()->GetUserData());
}

std::string XacroExpander::PlaceOf(const Element& element) {
  return fmt::format("{}:{}", FileOf(element).path, element.GetLineNum());
}

std::string XacroExpander::FolderOf(const Element& element) {
  return fs::path(FileOf(element).path).parent_path().string();
}

std::string XacroExpander::PathBeside(const Element& element, const std::string& path) {
  return (fs::path(FileOf(element).path).parent_path() / path).lexically_normal().string();
}

/// The path of an absolute path, a path relative to the file of the element, `package://NAME/PATH` or `file://PATH`.
std::string XacroExpander::PathOfUrl(const Element& element, const std::string& url) const {
  constexpr std::string_view kPackage = "package://", kFile = "file://";
  if (url.starts_with(kFile)) return PathBeside(element, url.substr(kFile.size()));
  if (!url.starts_with(kPackage)) return PathBeside(element, url);
  const std::size_t slash = std::min(url.find('/', kPackage.size()), url.size());
  const std::string name = url.substr(kPackage.size(), slash - kPackage.size());
  return (fs::path(FoundPackage(element, name)) / url.substr(std::min(slash + 1, url.size()))).string();
}

const XacroFile& XacroExpander::Parse(const std::string& text, const std::string& path) {
  bytes_read_ += text.size();
  if (bytes_read_ > kMostXacroRead)
    throw XacroProblem{FailureCode::kXacroLimit,
                       fmt::format("the included files have more than {} MiB", kMostXacroRead >> 20)};
  auto file = std::make_unique<XacroFile>();
  file->path = path;
  file->xml.SetUserData(file.get());
  if (const std::string reason = ReasonNotXacroXml(text, file->xml); !reason.empty())
    throw XacroProblem{FailureCode::kNotXml, path + reason};
  file->bare_tags = file->xml.RootElement()->Attribute("xmlns:xacro") != nullptr;
  return *(files_[path] = std::move(file));
}

void XacroExpander::Include(const Element& element, Node& out, XacroScope& scope) {
  CheckXacroAttributes(element, {"filename", "ns", "optional"});
  const std::string name = PrintedAttribute(element, "filename", scope);
  if (Trimmed(name).empty()) throw XacroProblem{FailureCode::kXacroInclude, "the attribute 'filename' is empty"};
  if (name.find_first_of("*?[") != std::string::npos) {
    throw XacroProblem{FailureCode::kXacroInclude,
                       fmt::format("'{}' is a pattern; only single files are included", Shortened(name))};
  }
  const std::string path = PathOfUrl(element, Trimmed(name));
  const bool optional = element.Attribute("optional") != nullptr &&
                        XacroTruthOfText(Evaluated(element.Attribute("optional"), scope), "'optional'");
  const auto known = files_.find(path);
  const XacroFile* file = known == files_.end() ? nullptr : known->second.get();
  if (std::find(including_.begin(), including_.end(), file) != including_.end() && file != nullptr)
    throw XacroProblem{FailureCode::kXacroRecursion, fmt::format("'{}' includes itself", path)};
  if (file == nullptr) {
    const Result<std::string> text = sources_.read(path);
    if (!text && optional && text.failure().code == FailureCode::kNoSuchFile) return;
    if (!text) throw XacroProblem{FailureCode::kXacroInclude, text.failure().message};
    file = &Parse(*text, path);
  }
  XacroScope* inner = &scope;
  if (element.Attribute("ns") != nullptr) {
    auto space = std::make_unique<XacroScope>();
    space->parent = space->caller = &scope;
    inner = space.get();
    scope.namespaces[PrintedAttribute(element, "ns", scope)] = std::move(space);
  }
  including_.push_back(file);
  ExpandNodes(file->xml.RootElement()->FirstChild(), out, *inner);
  including_.pop_back();
  Element* result_root = result_.RootElement();
  for (const tinyxml2::XMLAttribute* a = file->xml.RootElement()->FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string attribute = a->Name();
    if (attribute.starts_with("xmlns:") && attribute != "xmlns:xacro" && result_root->Attribute(a->Name()) == nullptr)
      SetAttribute(*result_root, attribute, a->Value());
  }
}

/// Each call creates a new value, because expressions may change lists.
XacroValue XacroExpander::LoadYamlFile(const std::string& path) {
  if (!yaml_.contains(path)) {
    const Result<std::string> text = sources_.read(path);
    if (!text) throw XacroProblem{FailureCode::kXacroYaml, text.failure().message};
    bytes_read_ += text->size();
    if (bytes_read_ > kMostXacroRead)
      throw XacroProblem{FailureCode::kXacroLimit,
                         fmt::format("the files have more than {} MiB", kMostXacroRead >> 20)};
    yaml_[path] = *text;
  }
  XacroScope none;
  XacroScopeContext context(*this, none, *at_);
  try {
    return XacroFromYaml(yaml_[path], context);
  } catch (XacroProblem& problem) {
    problem.message = fmt::format("{}: {}", path, problem.message);
    throw;
  }
}

}  // namespace gaitwright
