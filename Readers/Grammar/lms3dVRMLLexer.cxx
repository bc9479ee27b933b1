// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLLexer.h"

#include "Grammar/lms3dVRMLCharacters.h"
#include "Grammar/lms3dVRMLNumber.h"

#include <algorithm>
#include <cmath>

lms3dVRMLLexer::lms3dVRMLLexer(std::string_view text)
  : Begin(text.data())
  , Position(text.data())
  , End(text.data() + text.size())
  , ListEnd(text.data())
{
  const std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark)
  {
    this->Position += byteOrderMark.size();
  }
}

void lms3dVRMLLexer::EndLine()
{
  const bool isPair =
    *this->Position == '\r' && this->Position + 1 < this->End && this->Position[1] == '\n';
  this->Position += isPair ? 2 : 1;
  ++this->Line;
}

void lms3dVRMLLexer::SkipBlanks()
{
  while (this->Position < this->End)
  {
    const char c = *this->Position;
    if (lms3dIsLineEnd(c))
    {
      this->EndLine();
    }
    else if (lms3dIsBlank(c))
    {
      ++this->Position;
    }
    else if (c == '#')
    {
      this->Position = std::find_if(this->Position, this->End, lms3dIsLineEnd);
    }
    else
    {
      return;
    }
  }
}

bool lms3dVRMLLexer::BeginToken()
{
  this->SkipBlanks();
  this->Token.Kind = lms3dVRMLToken::END;
  this->Token.Line = this->Line;
  this->Token.Text = {};
  return this->Position < this->End;
}

void lms3dVRMLLexer::Advance()
{
  if (!this->BeginToken())
  {
    return;
  }
  const char c = *this->Position;
  if (c == '{' || c == '}' || c == '[' || c == ']')
  {
    this->Token.Kind = lms3dVRMLToken::MARK;
    this->Token.Text = { this->Position++, 1 };
  }
  else if (c == '"')
  {
    this->ReadString();
  }
  else if (!lms3dMayBeginNumber(c) || !this->ReadNumber())
  {
    this->ReadWord(lms3dEndsWord);
  }
}

void lms3dVRMLLexer::AppendNumbers(std::vector<std::int32_t>& integers, std::size_t maximum)
{
  for (; maximum > 0 && this->Token.Kind == lms3dVRMLToken::NUMBER && this->Token.IsInteger;
       --maximum)
  {
    integers.push_back(this->Token.Integer);
    this->Advance();
  }
}

void lms3dVRMLLexer::AppendNumbers(std::vector<double>& reals, std::size_t maximum)
{
  for (; maximum > 0 && this->Token.Kind == lms3dVRMLToken::NUMBER &&
       std::isfinite(this->Token.Number);
       --maximum)
  {
    reals.push_back(this->Token.Number);
    this->Advance();
  }
}

void lms3dVRMLLexer::AdvanceToName()
{
  if (this->BeginToken() && !lms3dEndsName(*this->Position))
  {
    this->ReadWord(lms3dEndsName);
  }
  else
  {
    this->Advance();
  }
}

// Reads at least one character, so that every call advances.
void lms3dVRMLLexer::ReadWord(bool (*ends)(char))
{
  const char* end = std::find_if(this->Position + 1, this->End, ends);
  this->Token.Kind = lms3dVRMLToken::WORD;
  this->Token.Text = { this->Position, static_cast<std::size_t>(end - this->Position) };
  this->Position = end;
}

void lms3dVRMLLexer::ReadString()
{
  const char* const first = ++this->Position;
  const char* last = this->FindQuote(first);
  this->Token.Kind = lms3dVRMLToken::STRING;
  this->Token.IsOpen = last == this->End || *last != '"';
  if (this->Token.IsOpen)
  {
    this->IsQuoteMissing = true;
    last = std::find_if(first, this->End, lms3dIsLineEnd);
  }
  this->Token.Text = { first, static_cast<std::size_t>(last - first) };
  while (this->Position < last)
  {
    if (lms3dIsLineEnd(*this->Position))
    {
      this->EndLine();
    }
    else
    {
      ++this->Position;
    }
  }
  this->Position = last + (this->Token.IsOpen ? 0 : 1);
}

// After one missing quote, no string extends past its line. Otherwise each further quote could make
// the lexer search the rest of the file.
const char* lms3dVRMLLexer::FindQuote(const char* p) const
{
  while (p < this->End && *p != '"' && !(this->IsQuoteMissing && lms3dIsLineEnd(*p)))
  {
    p += *p == '\\' && p + 1 < this->End && !lms3dIsLineEnd(p[1]) ? 2 : 1;
  }
  return p;
}

bool lms3dVRMLLexer::ReadNumber()
{
  const lms3dVRMLNumber number = lms3dReadNumber(this->Position, this->End);
  if (!number.End)
  {
    return false;
  }
  this->Token.Kind = lms3dVRMLToken::NUMBER;
  this->Token.Text = { this->Position, static_cast<std::size_t>(number.End - this->Position) };
  this->Token.Number = number.Real;
  this->Token.IsInteger = number.IsInteger;
  this->Token.Integer = number.Integer;
  this->Position = number.End;
  return true;
}

bool lms3dVRMLLexer::IsFollowedBy(char mark)
{
  this->SkipBlanks();
  return this->Position < this->End && *this->Position == mark;
}

void lms3dVRMLLexer::Stop()
{
  this->Position = this->End;
  this->Token.Kind = lms3dVRMLToken::END;
}

// Caches the next closing mark, because several lists before it can lack their own.
std::size_t lms3dVRMLLexer::GetBytesToListEnd()
{
  if (this->ListEnd <= this->Position)
  {
    this->ListEnd =
      std::find_if(this->Position, this->End, [](char c) { return c == ']' || c == '}'; });
  }
  return static_cast<std::size_t>(this->ListEnd - this->Position);
}

double lms3dVRMLLexer::GetFractionDone() const
{
  return this->End == this->Begin ? 1.0
                                  : static_cast<double>(this->Position - this->Begin) /
      static_cast<double>(this->End - this->Begin);
}

std::string lms3dUnescape(std::string_view text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isEscape =
      text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\');
    result += text[isEscape ? ++i : i];
  }
  return result;
}
