// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/find_package.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "kinematics/base/file.h"
#include "kinematics/base/options.h"
#include "kinematics/base/text.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPackageFolders = 4000;  // largest number of folders searched below ROS_PACKAGE_PATH
constexpr std::size_t kLargestPackageXml = std::size_t{1} << 20;

/// The name in a folder's package.xml, or "".
std::string NameInPackageXml(const fs::path& folder) {
  std::error_code error;
  const fs::path file = folder / "package.xml";
  if (!fs::is_regular_file(file, error)) return "";
  const Result<std::string> text = ReadFile(file.string(), kLargestPackageXml);
  tinyxml2::XMLDocument document;
  if (!text || document.Parse(text->c_str(), text->size()) != tinyxml2::XML_SUCCESS) return "";
  const tinyxml2::XMLElement* root = document.RootElement();
  const tinyxml2::XMLElement* name = root == nullptr ? nullptr : root->FirstChildElement("name");
  return name == nullptr || name->GetText() == nullptr ? "" : Trimmed(name->GetText());
}

std::vector<fs::path> PathsOfVariable(const char* variable) {
  std::vector<fs::path> paths;
  const char* value = std::getenv(variable);
  const std::string text = value == nullptr ? "" : value;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(':', from), text.size());
    if (end > from) paths.emplace_back(text.substr(from, end - from));
    from = end + 1;
  }
  return paths;
}

/// Looks for one package until a folder is accepted.
class PackageSearch {
 public:
  PackageSearch(const std::string& name, const std::function<bool(const std::string&)>& accepts)
      : name_(name), accepts_(accepts) {}

  const std::optional<std::string>& found() const { return found_; }

  bool Take(const fs::path& folder) {
    std::error_code error;
    const std::string path = fs::absolute(folder, error).lexically_normal().string();
    if (!tried_.insert(path).second) return false;
    if (!accepts_ || accepts_(path)) found_ = path;
    return found_.has_value();
  }

  /// Checks a folder, and the folder in it that has the name of the package.
  bool At(const fs::path& folder) {
    std::error_code error;
    if ((folder.filename() == name_ || NameInPackageXml(folder) == name_) && Take(folder)) return true;
    return fs::is_directory(folder / name_, error) && Take(folder / name_);
  }

  bool Above(const fs::path& folder) {
    for (fs::path at = folder;; at = at.parent_path()) {
      if (At(at)) return true;
      if (at == at.parent_path()) return false;
    }
  }

  /// Checks a folder of ROS_PACKAGE_PATH and all folders up to `levels` below it.
  bool Below(const fs::path& folder, int levels) {
    if (At(folder)) return true;
    if (levels == 0) return false;
    std::vector<fs::path> children;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (--folders_left_ < 0) return false;
      if (entry.is_directory(error) && !entry.path().filename().string().starts_with('.'))
        children.push_back(entry.path());
    }
    std::sort(children.begin(), children.end());
    return std::any_of(children.begin(), children.end(),
                       [&](const fs::path& child) { return Below(child, levels - 1); });
  }

  bool InEnvironment() {
    for (const fs::path& path : PathsOfVariable("ROS_PACKAGE_PATH")) {
      if (Below(path, 2)) return true;
    }
    std::error_code error;
    for (const fs::path& path : PathsOfVariable("AMENT_PREFIX_PATH")) {
      if (fs::is_directory(path / "share" / name_, error) && Take(path / "share" / name_)) return true;
    }
    return false;
  }

 private:
  const std::string& name_;
  const std::function<bool(const std::string&)>& accepts_;
  std::optional<std::string> found_;
  std::set<std::string> tried_;
  int folders_left_ = kMostPackageFolders;
};

std::string VariableForMessage(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr || *value == '\0' ? fmt::format("{} (not set)", variable)
                                            : fmt::format("{} ('{}')", variable, Shortened(value));
}

}  // namespace

Result<std::string> FindPackage(const std::string& name, const std::string& folder, const PackageFolders& given,
                                const std::function<bool(const std::string&)>& accepts) {
  const bool is_name = !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
  PackageSearch search(name, accepts);
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& [package, path] : given) {
    names.push_back(package);
    if (is_name && package == name && search.Take(path)) return *search.found();
  }
  const fs::path from = fs::weakly_canonical(folder.empty() ? "." : folder, error);
  const fs::path here = fs::current_path(error);
  if (is_name && (search.Above(from) || search.InEnvironment() || search.At(here))) return *search.found();
  return Failure{
      FailureKind::kBadInput,
      FailureCode::kNoPackage,
      "FindPackage",
      fmt::format("the package '{}' is not found: no folder in or above '{}', in {}, in {} or in the current folder "
                  "has this name or a package.xml with this name",
                  Shortened(name), from.string(), VariableForMessage("ROS_PACKAGE_PATH"),
                  VariableForMessage("AMENT_PREFIX_PATH")),
      {names.empty() ? fmt::format("give the folder of the package as {}=DIR", Shortened(name))
                     : fmt::format("give the folder of the package as {}=DIR; folders are given for {}",
                                   Shortened(name), QuotedList(names))}};
}

}  // namespace gaitwright
