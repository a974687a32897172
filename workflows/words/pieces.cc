// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/pieces.h"

#include <cctype>
#include <cstdint>

namespace gaitwright::words {
namespace {

/// The code point at a byte and its length; what is no UTF-8 is one byte.
struct Point {
  std::uint32_t code = 0;
  std::size_t length = 1;
};

Point PointAt(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(at);
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
  if (length == 1 || at + length > text.size()) return {lead, 1};
  std::uint32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6U | (byte(at + i) & 0x3FU);
  return {code, length};
}

/// Full-width forms of ASCII, and typographic quotes, as the usual ones.
std::uint32_t Usual(std::uint32_t code) {
  if (code >= 0xFF01 && code <= 0xFF5E) return code - 0xFF01 + 0x21;
  if (code == 0x2018 || code == 0x2019) return '\'';
  if (code == 0x3000) return ' ';
  return code;
}

bool IsLetter(std::uint32_t code) {
  return (code < 128 && std::isalpha(static_cast<int>(code)) != 0) || (code >= 0xC0 && code < 0x250);
}
bool IsDigit(std::uint32_t code) { return code >= '0' && code <= '9'; }
bool IsHan(std::uint32_t code) {
  return (code >= 0x3400 && code <= 0x9FFF) || (code >= 0xF900 && code <= 0xFAFF) ||
         (code >= 0x20000 && code <= 0x2FFFF);
}

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  std::vector<Piece> Read() {
    while (at_ < text_.size()) {
      const std::uint32_t code = Code(at_);
      if (code <= ' ' || code == 0xA0 || code == 0xFEFF) {
        at_ += PointAt(text_, at_).length;
      } else if (IsLetter(code)) {
        ReadWord();
      } else if (IsDigit(code)) {
        ReadNumber();
      } else {
        Begin(IsHan(code) ? Piece::Kind::kCharacter : Piece::Kind::kSign);
        Take();
      }
    }
    return std::move(pieces_);
  }

 private:
  std::uint32_t Code(std::size_t at) const { return at < text_.size() ? Usual(PointAt(text_, at).code) : 0; }
  std::uint32_t NextCode() const { return Code(at_ + PointAt(text_, at_).length); }

  void Begin(Piece::Kind kind) { pieces_.push_back({kind, "", at_, at_}); }

  void Take() {
    const Point point = PointAt(text_, at_);
    const std::uint32_t usual = Usual(point.code);
    Piece& piece = pieces_.back();
    if (usual < 128) {
      piece.text += static_cast<char>(std::tolower(static_cast<int>(usual)));
    } else {
      piece.text += text_.substr(at_, point.length);
    }
    at_ += point.length;
    piece.end = at_;
  }

  void ReadWord() {
    Begin(Piece::Kind::kWord);
    while (at_ < text_.size()) {
      const std::uint32_t code = Code(at_);
      const bool joins = (code == '\'' || code == '-' || code == '/') && IsLetter(NextCode());
      if (!IsLetter(code) && !joins) break;
      Take();
    }
  }

  void ReadNumber() {
    Begin(Piece::Kind::kNumber);
    bool point = false;
    while (at_ < text_.size()) {
      const std::uint32_t code = Code(at_);
      const bool joins = code == '.' && !point && IsDigit(NextCode());
      if (!IsDigit(code) && !joins) break;
      point = point || joins;
      Take();
    }
    // "2nd", "10th" are words.
    static const char* const kEnds[] = {"st", "nd", "rd", "th"};
    for (const char* end : kEnds) {
      if (Code(at_) != static_cast<std::uint32_t>(end[0]) || Code(at_ + 1) != static_cast<std::uint32_t>(end[1]) ||
          IsLetter(Code(at_ + 2)))
        continue;
      pieces_.back().kind = Piece::Kind::kWord;
      Take();
      Take();
      return;
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> PiecesOf(const std::string& text) { return Reader(text).Read(); }

std::string PhraseOf(const std::vector<Piece>& pieces, std::size_t first, std::size_t count) {
  std::string phrase;
  for (std::size_t k = first; k < first + count; ++k) {
    const bool parted = k > first && pieces[k].kind != Piece::Kind::kCharacter &&
                        pieces[k - 1].kind != Piece::Kind::kCharacter && pieces[k].begin > pieces[k - 1].end;
    if (parted) phrase += ' ';
    phrase += pieces[k].text;
  }
  return phrase;
}

}  // namespace gaitwright::words
