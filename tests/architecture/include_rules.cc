// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/include_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "tests/architecture/rules_table.h"

namespace gaitwright::architecture {
namespace {

bool EndsWith(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether `path` is in `folder`; every path is in "".
bool Inside(const std::string& path, std::string_view folder) {
  if (folder.empty()) return true;
  return path.size() > folder.size() && path.compare(0, folder.size(), folder) == 0 && path[folder.size()] == '/';
}

bool InsideAny(const std::string& path, const std::vector<std::string_view>& folders) {
  return std::any_of(folders.begin(), folders.end(), [&](std::string_view folder) { return Inside(path, folder); });
}

std::string Listed(const std::vector<std::string_view>& folders) { return fmt::format("{}", fmt::join(folders, ", ")); }

const Layer* UmbrellaOf(const std::string& path) {
  const auto found =
      std::find_if(kUmbrellas.begin(), kUmbrellas.end(), [&](const Layer& l) { return path == l.folder; });
  return found == kUmbrellas.end() ? nullptr : &*found;
}

const Layer* LayerOf(const std::string& path) {
  if (const Layer* umbrella = UmbrellaOf(path)) return umbrella;
  const auto found =
      std::find_if(kLayers.begin(), kLayers.end(), [&](const Layer& l) { return Inside(path, l.folder); });
  return found == kLayers.end() ? nullptr : &*found;
}

std::string TopFolder(const std::string& path) { return path.substr(0, path.find('/')); }

bool IsOurs(const std::string& path) {
  static const std::vector<std::string> tops = {"kinematics", "planning", "optimisation", "playback", "workflows",
                                                "cli",        "examples", "python",       "tests"};
  return path.find('/') != std::string::npos && std::find(tops.begin(), tops.end(), TopFolder(path)) != tops.end();
}

bool IsHeader(const std::string& file) { return EndsWith(file, ".h"); }
bool IsPublicHeader(const std::string& file) { return IsHeader(file) && !EndsWith(file, "_internal.h"); }

/// Headers of the C++ standard library have neither a folder nor an ending.
bool IsStandard(const Include& include) {
  return include.angled && include.path.find_first_of("/.") == std::string::npos;
}

std::string OwnBreach(const std::string& file, const Layer& layer, const Include& include) {
  if (include.angled) return "our own headers stand in quotes";
  const Layer* other = LayerOf(include.path);
  if (other == nullptr) {
    return fmt::format("'{}' is in no folder of the order of rooms", include.path);
  }
  if (UmbrellaOf(include.path) != nullptr && !Inside(file, "examples"))
    return fmt::format("'{}' is for users: name the headers that are needed", include.path);
  if (UmbrellaOf(file) != nullptr && TopFolder(include.path) != TopFolder(file))
    return fmt::format("the header of a room has the room's own headers, not '{}'", include.path);
  for (const Blinkers& blinkers : kBlinkers) {
    if (Inside(file, blinkers.folder) && !InsideAny(include.path, blinkers.sees)) {
      return fmt::format("{} sees only {}, not '{}'", blinkers.folder, Listed(blinkers.sees), include.path);
    }
  }
  if (other->folder == layer.folder || other->rank < layer.rank) return "";
  return fmt::format("{} may not include '{}': {} is not below it", layer.folder, include.path, other->folder);
}

std::string ThirdPartyBreach(const std::string& file, const Include& include) {
  const auto owner = std::find_if(kOwners.begin(), kOwners.end(), [&](const Owner& o) {
    return include.path.compare(0, o.prefix.size(), o.prefix) == 0;
  });
  if (owner == kOwners.end()) {
    return fmt::format("'{}' is nobody's: name it from the root of the tree, or give it an owner in rules_table.h",
                       include.path);
  }
  if (!InsideAny(file, owner->folders)) {
    return fmt::format("'{}' belongs to {}", include.path, Listed(owner->folders));
  }
  if (IsPublicHeader(file) && !owner->in_headers) {
    return fmt::format("a public header may not include '{}': only std, Eigen and our own", include.path);
  }
  return "";
}

/// Whether a line prints to the terminal, which is not allowed in a library.
bool Prints(const std::string& line) {
  static const std::vector<std::string_view> printers = {"std::cout", "std::cerr", "fmt::print(", "std::printf(",
                                                         "std::puts("};
  return std::any_of(printers.begin(), printers.end(),
                     [&](std::string_view printer) { return line.find(printer) != std::string::npos; });
}

bool IsLibrary(const std::string& file) {
  return InsideAny(file, {"kinematics", "planning", "optimisation", "playback", "workflows"});
}

bool MayBeLong(const std::string& file) {
  return std::any_of(kLongFiles.begin(), kLongFiles.end(),
                     [&](const LongFile& allowed) { return allowed.file == file; });
}

}  // namespace

std::vector<Include> IncludesOf(const std::string& text) {
  std::vector<Include> includes;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("<\"", word);
    if (open == std::string::npos) continue;
    const std::size_t close = line.find(line[open] == '<' ? '>' : '"', open + 1);
    if (close == std::string::npos) continue;
    includes.push_back({line.substr(open + 1, close - open - 1), line[open] == '<', number});
  }
  return includes;
}

std::vector<std::string> IncludeBreaches(const std::string& file, const std::string& text) {
  const Layer* layer = LayerOf(file);
  if (layer == nullptr) {
    return {fmt::format("{}: its folder is not in the order of rooms; give it its place in rules_table.h", file)};
  }
  std::vector<std::string> breaches;
  for (const Include& include : IncludesOf(text)) {
    if (IsStandard(include)) continue;
    const std::string breach =
        IsOurs(include.path) ? OwnBreach(file, *layer, include) : ThirdPartyBreach(file, include);
    if (!breach.empty()) breaches.push_back(fmt::format("{}:{}: {}", file, include.line, breach));
  }
  return breaches;
}

std::vector<std::string> FileBreaches(const std::string& file, const std::string& text) {
  std::vector<std::string> breaches;
  const std::string head = text.substr(0, 200);
  if (head.find("SPDX-License-Identifier: BSD-3-Clause") == std::string::npos) {
    breaches.push_back(fmt::format("{}: no line 'SPDX-License-Identifier: BSD-3-Clause' at its head", file));
  }
  if (IsHeader(file) && text.find("#pragma once") == std::string::npos) {
    breaches.push_back(fmt::format("{}: a header without '#pragma once'", file));
  }
  std::istringstream lines(text);
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    ++count;
    if (IsLibrary(file) && Prints(line)) breaches.push_back(fmt::format("{}:{}: a library never prints", file, count));
  }
  if (count > kLongestFile && !MayBeLong(file)) {
    breaches.push_back(fmt::format("{}: {} lines; at most {}", file, count, kLongestFile));
  }
  return breaches;
}

std::vector<std::string> FilesAllowedToBeLong() {
  std::vector<std::string> files;
  for (const LongFile& allowed : kLongFiles) files.emplace_back(allowed.file);
  return files;
}

}  // namespace gaitwright::architecture
