// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/lexicon.h"

#include <algorithm>

#include "workflows/words/pieces.h"

namespace gaitwright::words {

void Lexicon::Add(std::string_view phrases, Meaning meaning, const std::string& name, double value,
                  const std::map<std::string, TaskValue>& parameters) {
  for (std::size_t at = 0; at <= phrases.size();) {
    const std::size_t end = std::min(phrases.find('|', at), phrases.size());
    const std::string phrase(phrases.substr(at, end - at));
    Item item;
    item.meaning = meaning;
    item.name = name;
    item.value = value;
    item.parameters = parameters;
    items_.try_emplace(phrase, item);
    longest_ = std::max(longest_, PiecesOf(phrase).size());
    at = end + 1;
  }
}

const Item* Lexicon::Find(const std::string& phrase) const {
  const auto found = items_.find(phrase);
  return found == items_.end() ? nullptr : &found->second;
}

}  // namespace gaitwright::words
