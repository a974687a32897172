// SPDX-License-Identifier: BSD-3-Clause
// How messages that refuse a name go on after it.
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// The member of `candidates` nearest to `word`: one that begins with it, else the one that fewest letters make of it.
/// Empty where none is near: where more than half of its letters are others.
std::string NearestName(const std::string& word, const std::vector<std::string>& candidates);

/// "; the nearest is 'trot'", or nothing where none is near. Of two to four that begin with the word and go on for more
/// than a letter each is named: "; the nearest are 'jerk_rad_s3', 'jerk_m_s3'".
std::string NearestHint(const std::string& word, const std::vector<std::string>& candidates);

/// The same; where none is near "; there are 'a', 'b'", or of more than 16 what tells them.
/// @param listed_by  a sentence's end such as "--list-options prints all of them"; "" for nothing that does.
std::string NearestOrAll(const std::string& word, const std::vector<std::string>& candidates,
                         const std::string& listed_by = "");

}  // namespace gaitwright
