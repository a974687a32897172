// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace gaitwright {

/// The text without spaces, tabs and ends of lines before and after it.
std::string Trimmed(const std::string& text);

/// The text with small letters for capital ones, as far as they are ASCII.
std::string LowerCase(std::string text);

/// Whether a text is UTF-8 without control characters other than tabs and ends of lines, so that it can be shown and
/// written to any file.
bool IsPlainText(const std::string& text);

/// The UTF-8 of a text in another encoding: UTF-16 by its byte order mark, else Latin-1. Nothing if it is UTF-8
/// already.
std::optional<std::string> InUtf8(const std::string& text);

/// The beginning of a UTF-8 text: so many bytes or, where these end inside of a character, those before it.
std::string FirstBytes(const std::string& text, std::size_t most);

/// A text for messages: its first 60 bytes or so, with dots if it is longer.
std::string Shortened(const std::string& text);

/// A text for XML and HTML: the five reserved characters escaped, control characters removed.
std::string EscapedXml(const std::string& text);

}  // namespace gaitwright
