// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// The nesting error of the tags of an XML text; empty if there is none. Quotes of attributes are respected, and CDATA
/// sections are skipped.
inline std::string XmlFault(const std::string& text) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string::npos) {
    if (text.compare(at, 9, "<![CDATA[") == 0) {
      at = text.find("]]>", at);
      if (at == std::string::npos) return "a section of characters that does not end";
      continue;
    }
    const std::size_t start = at + 1;
    char quote = 0;
    while (++at < text.size() && (quote != 0 || text[at] != '>')) {
      if (quote == 0 && (text[at] == '"' || text[at] == '\'')) {
        quote = text[at];
      } else if (text[at] == quote) {
        quote = 0;
      } else if (text[at] == '<') {
        return "'<' inside of a tag: " + text.substr(start, 40);
      }
    }
    if (at >= text.size()) return "a tag that does not end: " + text.substr(start, 40);
    const std::string tag = text.substr(start, at - start);
    if (tag[0] == '!' || tag[0] == '?' || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t"));
    if (name[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || open.back() != name.substr(1)) {
      return "<" + name + "> closes <" + (open.empty() ? "nothing" : open.back()) + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

}  // namespace gaitwright
