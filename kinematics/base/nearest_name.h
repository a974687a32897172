// SPDX-License-Identifier: BSD-3-Clause
// Hints about the nearest name, for messages that refuse a name.
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// The member of `candidates` nearest to `word`: one that begins with it, else the one with the smallest edit distance.
/// Empty if more than half of the letters differ.
std::string NearestName(const std::string& word, const std::vector<std::string>& candidates);

/// "; the nearest is 'trot'", or nothing if no name is near. Two to four names that begin with the word and are longer
/// by more than a letter are all named: "; the nearest are 'jerk_rad_s3', 'jerk_m_s3'".
std::string NearestHint(const std::string& word, const std::vector<std::string>& candidates);

/// As NearestHint; if no name is near, "; accepted: 'a', 'b'", or `listed_by` for more than 16 names.
/// @param listed_by  end of a sentence, such as "--list-options prints all of them"; "" for no such text.
std::string NearestOrAll(const std::string& word, const std::vector<std::string>& candidates,
                         const std::string& listed_by = "");

}  // namespace gaitwright
