// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "playback/report/plots.h"

namespace gaitwright {

// Parts of HTML pages. Arguments named `html` are markup; all other texts are escaped here.

/// A self-contained page with the styles of pages and plots. @param more_style  CSS after them.
std::string WholePage(const std::string& title, const std::string& html, const std::string& more_style = "");

/// The head of a page about a verdict.
struct VerdictWords {
  bool pass = false;
  std::string verdict;        ///< "PASS"
  std::string title;          ///< of the page
  std::string about;          ///< pale line below the title
  std::string score = {};     ///< "91.2"; empty without a score
  std::string score_of = {};  ///< below the score: "of 100"
  std::string reason;         ///< a sentence without its full stop, in a box below
};
std::string VerdictPart(const VerdictWords& words);

/// "pass" or "FAIL" in its colour.
std::string VerdictMark(bool pass);

/// A card with a headline figure, inside an element of class "cards".
std::string CardPart(const std::string& what_html, const std::string& figure_html, const std::string& beside_html);

/// A plot with its caption; its id is the plot's name.
std::string FigurePart(const Plot& plot);

/// A heading with a list; empty without lines.
std::string ListPart(const std::string& title, const std::vector<std::string>& lines);

/// A folded table of options; empty without options.
std::string OptionsPart(const std::string& title, const std::vector<std::pair<std::string, std::string>>& options);

/// A text with a capital at its beginning and a full stop.
std::string SentencePart(std::string text);

}  // namespace gaitwright
