// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cctype>

#include "playback/report/page_parts_internal.h"
#include "playback/report/page_style.h"
#include "playback/report/plot_style.h"
#include "playback/report/svg_tools.h"

namespace gaitwright {

std::string WholePage(const std::string& title, const std::string& html, const std::string& more_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"/><title>{}</title>\n<style>{}{}{}</style></head>\n<body><main>\n"
      "{}</main></body></html>\n",
      EscapedXml(title), PageStyle(), PlotStyle(), more_style, html);
}

std::string VerdictPart(const VerdictWords& words) {
  const char* css = words.pass ? "pass" : "fail";
  const std::string score = words.score.empty()
                                ? ""
                                : fmt::format("<div class=\"score\"><b>{}</b><br/><span class=\"soft\">{}</span></div>",
                                              EscapedXml(words.score), EscapedXml(words.score_of));
  return fmt::format(
      "<div class=\"head\"><span class=\"verdict {0}\">{1}</span><div><h1>{2}</h1><p class=\"soft\">{3}</p></div>{4}"
      "</div>\n<p class=\"reason {0}\">{5}</p>\n",
      css, EscapedXml(words.verdict), EscapedXml(words.title), EscapedXml(words.about), score,
      SentencePart(words.reason));
}

std::string VerdictMark(bool pass) {
  return pass ? "<span class=\"mark pass\">pass</span>" : "<span class=\"mark fail\">FAIL</span>";
}

std::string CardPart(const std::string& what_html, const std::string& figure_html, const std::string& beside_html) {
  return fmt::format(
      "<div class=\"card\"><div class=\"what\">{}</div><div class=\"figure\">{}</div><div "
      "class=\"limit\">{}</div></div>\n",
      what_html, figure_html, beside_html);
}

std::string FigurePart(const Plot& plot) {
  return fmt::format("<figure id=\"{}\"><div class=\"scroll\">{}</div><figcaption>{}</figcaption></figure>\n",
                     plot.name, plot.svg, EscapedXml(plot.caption));
}

std::string ListPart(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = fmt::format("<h2>{}</h2>\n<ul>\n", EscapedXml(title));
  for (const std::string& line : lines) html += "<li>" + EscapedXml(line) + "</li>\n";
  return html + "</ul>\n";
}

std::string OptionsPart(const std::string& title, const std::vector<std::pair<std::string, std::string>>& options) {
  if (options.empty()) return "";
  std::string html = fmt::format("<details><summary>{}</summary><table><tbody>\n", EscapedXml(title));
  for (const auto& [key, value] : options) {
    html +=
        fmt::format("<tr><td><span class=\"key\">{}</span></td><td>{}</td></tr>\n", EscapedXml(key), EscapedXml(value));
  }
  return html + "</tbody></table></details>\n";
}

std::string SentencePart(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return EscapedXml(text) + ".";
}

}  // namespace gaitwright
