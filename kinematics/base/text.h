// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace gaitwright {

/// The text without spaces, tabs and line ends at its start and end.
std::string Trimmed(const std::string& text);

/// The text with ASCII capital letters replaced by small letters.
std::string LowerCase(std::string text);

/// Whether a text is UTF-8 without control characters other than tabs and line ends. Such a text can be shown and
/// written to any file.
bool IsPlainText(const std::string& text);

/// A text in another encoding as UTF-8: UTF-16 if it has a byte-order mark, else Latin-1. Nothing if it is already
/// UTF-8.
std::optional<std::string> InUtf8(const std::string& text);

/// The beginning of a UTF-8 text: `most` bytes, or fewer to end between two characters.
std::string FirstBytes(const std::string& text, std::size_t most);

/// A text for messages: its first 60 bytes approximately, with dots if it is longer.
std::string Shortened(const std::string& text);

/// A text for XML and HTML: the five reserved characters escaped, control characters removed.
std::string EscapedXml(const std::string& text);

}  // namespace gaitwright
