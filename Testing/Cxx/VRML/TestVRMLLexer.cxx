// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLLexer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using Token = lms3dVRMLToken;
using Texts = std::vector<std::string>;

Token ReadOne(const char* text)
{
  lms3dVRMLLexer lexer(text);
  lexer.Advance();
  return lexer.Get();
}

std::vector<std::string> ReadTexts(const std::string& text)
{
  lms3dVRMLLexer lexer(text);
  std::vector<std::string> texts;
  for (lexer.Advance(); lexer.Get().Kind != Token::END; lexer.Advance())
  {
    texts.emplace_back(lexer.Get().Text);
  }
  return texts;
}

std::vector<std::size_t> ReadLines(const std::string& text)
{
  lms3dVRMLLexer lexer(text);
  std::vector<std::size_t> lines;
  for (lexer.Advance(); lexer.Get().Kind != Token::END; lexer.Advance())
  {
    lines.push_back(lexer.Get().Line);
  }
  return lines;
}
} // namespace

TEST(VRMLLexer, ReadsIntegers)
{
  const std::vector<std::pair<const char*, std::int32_t>> integers = { { "0", 0 }, { "007", 7 },
    { "-1", -1 }, { "+12", 12 }, { "2147483647", 2147483647 }, { "-2147483648", -2147483647 - 1 },
    { "0x1F", 31 }, { "0XfF", 255 }, { "0xffffffff", -1 } };
  for (const auto& [text, value] : integers)
  {
    const Token token = ReadOne(text);
    EXPECT_EQ(token.Kind, Token::NUMBER) << text;
    EXPECT_TRUE(token.IsInteger) << text;
    EXPECT_EQ(token.Integer, value) << text;
    EXPECT_EQ(token.Number, value) << text;
  }
}

TEST(VRMLLexer, ReadsReals)
{
  const std::vector<std::pair<const char*, double>> reals = { { "1.5", 1.5 }, { ".5", 0.5 },
    { "-.5", -0.5 }, { "+1.", 1.0 }, { "1e3", 1000.0 }, { "1.E-2", 0.01 }, { "-2.5e+1", -25.0 },
    { "2147483648", 2147483648.0 }, { "12345678901234567890", 12345678901234567890.0 },
    { "1e-400", 0.0 }, { "0.1", 0.1 } };
  for (const auto& [text, value] : reals)
  {
    const Token token = ReadOne(text);
    EXPECT_EQ(token.Kind, Token::NUMBER) << text;
    EXPECT_FALSE(token.IsInteger) << text;
    EXPECT_EQ(token.Number, value) << text;
    EXPECT_EQ(token.Text, text);
  }
}

TEST(VRMLLexer, MarksNumbersThatAreNotFinite)
{
  for (const char* text :
    { "nan", "-NaN", "inf", "-inf", "Infinity", "1e400", "-1E999", "1.#INF", "-1.#IND", "1.#QNAN" })
  {
    const Token token = ReadOne(text);
    EXPECT_EQ(token.Kind, Token::NUMBER) << text;
    EXPECT_FALSE(std::isfinite(token.Number)) << text;
    EXPECT_EQ(token.Text, text);
  }
}

TEST(VRMLLexer, RoundsNumbersOutOfRangeByAllTheirDigits)
{
  const std::string zeros(400, '0');
  const Texts huge = { "1" + zeros + "e-5", "1" + zeros, "-1" + zeros + ".5e+7", "0.0001e1000",
    "1e" + zeros + "1" + zeros, "1" + zeros + "e-1" };
  const Texts tiny = { "0." + zeros + "1e5", "." + zeros + "1", "-0." + zeros + "1e-3",
    "1000e-1000", "1e-1" + zeros, "0." + zeros + "1E+30" };
  for (const std::string& text : huge)
  {
    EXPECT_TRUE(std::isinf(ReadOne(text.c_str()).Number)) << text;
  }
  for (const std::string& text : tiny)
  {
    EXPECT_EQ(ReadOne(text.c_str()).Number, 0.0) << text;
  }
}

TEST(VRMLLexer, ReadsOtherWordsAsWords)
{
  for (const char* text : { "Inline", "normal", "info", "12abc", "1.2.3", "-", "+", "0xG", "n" })
  {
    EXPECT_EQ(ReadOne(text).Kind, Token::WORD) << text;
  }
}

TEST(VRMLLexer, SeparatesTokens)
{
  EXPECT_EQ(ReadTexts("Box{size 1,2 3}[-1]\"a\"TRUE"),
    (std::vector<std::string>{
      "Box", "{", "size", "1", "2", "3", "}", "[", "-1", "]", "a", "TRUE" }));
  EXPECT_EQ(ReadTexts("a # b { \" \n c#d\re"), (std::vector<std::string>{ "a", "c", "e" }));
  EXPECT_EQ(ReadTexts("\xEF\xBB\xBF#VRML\nB"), std::vector<std::string>{ "B" });
  EXPECT_EQ(ReadTexts(std::string("a\0b", 3)), (std::vector<std::string>{ "a", "b" }));
}

TEST(VRMLLexer, CountsLinesWithAnyEnd)
{
  EXPECT_EQ(ReadLines("a\nb\r\nc\rd\n\ne"), (std::vector<std::size_t>{ 1, 2, 3, 4, 6 }));
  EXPECT_EQ(ReadLines("\"x\ny\" a # b\nc"), (std::vector<std::size_t>{ 1, 2, 3 }));
}

TEST(VRMLLexer, ReadsNamesThatTheGrammarForbids)
{
  lms3dVRMLLexer lexer("DEF 3D.wall-a'b {");
  lexer.Advance();
  lexer.AdvanceToName();
  EXPECT_EQ(lexer.Get().Text, "3D.wall-a'b");
  EXPECT_TRUE(lexer.IsFollowedBy('{'));
  EXPECT_FALSE(lexer.IsFollowedBy('['));
  lexer.AdvanceToName();
  EXPECT_TRUE(lexer.Get().Is('{'));
}

TEST(VRMLLexer, EndsAStringWithItsQuoteOrElseItsLine)
{
  lms3dVRMLLexer lexer("\"a \\\" b\n\\\\\" \"open\nBox \"closed\" \"open again");
  lexer.Advance();
  EXPECT_EQ(lms3dUnescape(lexer.Get().Text), "a \" b\n\\");
  EXPECT_FALSE(lexer.Get().IsOpen);
  lexer.Advance();
  EXPECT_EQ(lexer.Get().Text, "open\nBox ");
  lexer.Advance();
  EXPECT_EQ(lexer.Get().Text, "closed");
  EXPECT_EQ(lexer.Get().Kind, Token::WORD);
  lexer.Advance();
  EXPECT_EQ(lexer.Get().Text, " ");
  lexer.Advance();
  lexer.Advance();
  EXPECT_EQ(lexer.Get().Text, "again");
  lexer.Advance();
  EXPECT_EQ(lexer.Get().Kind, Token::END);

  lms3dVRMLLexer open("\"open\nBox \\\"");
  open.Advance();
  EXPECT_EQ(open.Get().Text, "open");
  EXPECT_TRUE(open.Get().IsOpen);
  open.Advance();
  EXPECT_TRUE(open.Get().Is("Box"));
  EXPECT_EQ(open.Get().Line, 2u);
}

TEST(VRMLLexer, ReadsRunsOfNumbers)
{
  lms3dVRMLLexer lexer("1 2 3 4.5 6 nan 7");
  lexer.Advance();
  std::vector<std::int32_t> integers;
  lexer.AppendNumbers(integers, 2);
  EXPECT_EQ(integers, (std::vector<std::int32_t>{ 1, 2 }));
  lexer.AppendNumbers(integers, 100);
  EXPECT_EQ(integers, (std::vector<std::int32_t>{ 1, 2, 3 }));
  std::vector<double> reals;
  lexer.AppendNumbers(reals, 100);
  EXPECT_EQ(reals, (std::vector<double>{ 4.5, 6.0 }));
  EXPECT_EQ(lexer.Get().Text, "nan");
  lexer.Stop();
  EXPECT_EQ(lexer.Get().Kind, Token::END);
  EXPECT_EQ(lexer.GetFractionDone(), 1.0);
}
