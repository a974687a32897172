// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/pieces.h"

#include <gtest/gtest.h>

#include <tuple>

namespace gaitwright::words {
namespace {

using PieceKind = Piece::Kind;
using Texts = std::vector<std::string>;

Texts TextsOfPieces(const std::string& text) {
  Texts texts;
  for (const Piece& piece : PiecesOf(text)) texts.push_back(piece.text);
  return texts;
}

std::vector<PieceKind> KindsOfPieces(const std::string& text) {
  std::vector<PieceKind> kinds;
  for (const Piece& piece : PiecesOf(text)) kinds.push_back(piece.kind);
  return kinds;
}

TEST(Pieces, WordsNumbersCharactersAndSignsArePartedAndLabelled) {
  EXPECT_EQ(TextsOfPieces("Walk 3 steps, 走!"), (Texts{"walk", "3", "steps", ",", "走", "!"}));
  EXPECT_EQ(KindsOfPieces("Walk 3 steps, 走!"),
            (std::vector<PieceKind>{PieceKind::kWord, PieceKind::kNumber, PieceKind::kWord, PieceKind::kSign,
                                    PieceKind::kCharacter, PieceKind::kSign}));
  EXPECT_TRUE(PiecesOf("").empty());
  EXPECT_TRUE(PiecesOf(" \t\r\n").empty());
}

/// The bytes of a piece refer to the original text, also after respelling.
TEST(Pieces, PlacesCoverTheTextInOrderAndWithoutSpaces) {
  for (const std::string text :
       {"Don't  walk 1.5e3 m/s!", "請往前走３米，然後揮手。", "plz go\xC2\xA0on", "a\377b", "3rd two-metre"}) {
    std::size_t end = 0;
    for (const Piece& piece : PiecesOf(text)) {
      EXPECT_GE(piece.begin, end) << text;
      EXPECT_GT(piece.end, piece.begin) << text;
      for (std::size_t at = end; at < piece.begin; ++at)
        EXPECT_TRUE(text[at] == ' ' || text[at] == '\xC2' || text[at] == '\xA0') << text << " at byte " << at;
      end = piece.end;
    }
    EXPECT_EQ(end, text.size()) << text;
  }
}

TEST(Pieces, ANumberHasOnePointAndAnExponentOnlyWithDigits) {
  EXPECT_EQ(TextsOfPieces("1.5"), Texts{"1.5"});
  EXPECT_EQ(TextsOfPieces("1.5.2"), (Texts{"1.5", ".", "2"}));
  EXPECT_EQ(TextsOfPieces("2."), (Texts{"2", "."})) << "the full stop of a sentence";
  EXPECT_EQ(TextsOfPieces("1.5e3 2E-1 3e+2"), (Texts{"1.5e3", "2e-1", "3e+2"}));
  EXPECT_EQ(TextsOfPieces("3e"), (Texts{"3", "e"}));
  EXPECT_EQ(TextsOfPieces("3e-"), (Texts{"3", "e", "-"}));
  EXPECT_EQ(TextsOfPieces("3m"), (Texts{"3", "m"}));
}

TEST(Pieces, OrdinalsInDigitsAreWords) {
  EXPECT_EQ(TextsOfPieces("1st 2nd 3rd 10th"), (Texts{"1st", "2nd", "3rd", "10th"}));
  EXPECT_EQ(KindsOfPieces("1st 2nd 3rd 10th"), std::vector<PieceKind>(4, PieceKind::kWord));
  EXPECT_EQ(TextsOfPieces("2 steps"), (Texts{"2", "steps"}));
  EXPECT_EQ(TextsOfPieces("2steps"), (Texts{"2", "steps"})) << "st goes on";
  EXPECT_EQ(KindsOfPieces("3them").front(), PieceKind::kNumber);
}

TEST(Pieces, ApostrophesHyphensAndSlashesJoinLettersOnly) {
  EXPECT_EQ(TextsOfPieces("don't twenty-five m/s"), (Texts{"don't", "twenty-five", "m/s"}));
  EXPECT_EQ(TextsOfPieces("'walk'"), (Texts{"'", "walk", "'"}));
  EXPECT_EQ(TextsOfPieces("walk-"), (Texts{"walk", "-"}));
  EXPECT_EQ(TextsOfPieces("walk - turn"), (Texts{"walk", "-", "turn"}));
}

TEST(Pieces, AHyphenPartsANumberFromItsUnitButNotFromItsOnes) {
  EXPECT_EQ(TextsOfPieces("two-metre"), (Texts{"two", "-", "metre"}));
  EXPECT_EQ(TextsOfPieces("twenty-degree"), (Texts{"twenty", "-", "degree"}));
  EXPECT_EQ(TextsOfPieces("twenty-five"), Texts{"twenty-five"});
  EXPECT_EQ(TextsOfPieces("three-quarter"), Texts{"three-quarter"});
}

TEST(Pieces, WidthQuotesAndScriptDoNotChangeTheText) {
  for (const auto& [text, usual] : {std::pair("ＷＡＬＫ　３．５", "walk 3.5"), std::pair("don’t", "don't"),
                                    std::pair("請轉兩點", "请转两点"), std::pair("\xEF\xBB\xBFwalk", "walk")})
    EXPECT_EQ(TextsOfPieces(text), TextsOfPieces(usual)) << text;
}

TEST(Pieces, ShortFormsAreSpeltInFull) {
  EXPECT_EQ(TextsOfPieces("plz dont"), (Texts{"please", "don't"}));
  EXPECT_EQ(TextsOfPieces("U"), Texts{"you"});
  EXPECT_EQ(TextsOfPieces("us"), Texts{"us"}) << "only the whole word";
}

/// Bytes that are not UTF-8 become signs of one byte each, and reading continues.
TEST(Pieces, BytesThatAreNoUtf8ArePassedOneByOne) {
  const std::vector<Piece> pieces = PiecesOf("go\xE8\xB5");  // a truncated character
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().text.substr(0, 2), "go");
  EXPECT_EQ(pieces.back().end, 4U);
}

TEST(Pieces, APhraseHasSpacesWhereTheTextHasThemBetweenWords) {
  const std::vector<Piece> english = PiecesOf("Turn   left,then go");
  EXPECT_EQ(PhraseOf(english, 0, 2), "turn left");
  EXPECT_EQ(PhraseOf(english, 1, 3), "left,then");
  EXPECT_EQ(PhraseOf(english, 0, 0), "");
  const std::vector<Piece> chinese = PiecesOf("向 左 转");
  EXPECT_EQ(PhraseOf(chinese, 0, 3), "向左转");
}

}  // namespace
}  // namespace gaitwright::words
