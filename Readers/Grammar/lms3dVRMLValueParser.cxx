// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLParser.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <limits>

namespace
{
// The number of values between two checks for abort.
constexpr std::size_t BatchSize = 1 << 16;
} // namespace

lms3dVRMLValue lms3dVRMLParser::ParseValue()
{
  lms3dVRMLValue value;
  switch (this->Get().Kind)
  {
    case lms3dVRMLToken::NUMBER:
      this->ParseNumbers(value);
      break;
    case lms3dVRMLToken::STRING:
      this->ParseStrings(value);
      break;
    case lms3dVRMLToken::WORD:
      return this->ParseWordValue();
    default:
      if (this->Get().Is('['))
      {
        this->ParseList(value);
      }
      else if (!this->IsAtEnd("a field"))
      {
        this->ReportLossHere("a value is missing");
      }
  }
  return value;
}

lms3dVRMLValue lms3dVRMLParser::ParseWordValue()
{
  lms3dVRMLValue value;
  if (this->Get().Is("TRUE") || this->Get().Is("FALSE"))
  {
    value = this->Get().Is("TRUE");
    this->Advance();
  }
  else if (this->Get().Is("IS"))
  {
    this->Lexer.AdvanceToName();
    value = lms3dVRMLReference{ this->Intern(this->Get().Text) };
    this->Advance();
  }
  else if (this->IsAtNode())
  {
    this->ParseNodes(value);
  }
  else if (lms3dIsVRMLField(this->Get().Text))
  {
    this->ReportLossHere("a value is missing before \"" + std::string(this->Get().Text) + "\"");
  }
  else if (this->Get().Is("NULL"))
  {
    value = lms3dVRMLNodes();
    this->Advance();
  }
  else
  {
    this->Skip();
  }
  return value;
}

void lms3dVRMLParser::ParseList(lms3dVRMLValue& value)
{
  const std::string_view what = "a list";
  this->Advance();
  while (!this->Get().Is(']'))
  {
    if (this->IsAtEnd(what))
    {
      return;
    }
    const bool isNextField = this->Get().Kind == lms3dVRMLToken::WORD &&
      lms3dIsVRMLField(this->Get().Text) && !this->IsAtNode();
    if (isNextField || this->Get().Is('}'))
    {
      this->ReportLoss("] is missing at the end of a list");
      return;
    }
    this->ParseListElement(value);
  }
  if (std::holds_alternative<std::monostate>(value))
  {
    value = lms3dVRMLNodes();
  }
  this->Advance();
}

// The first element determines the kind of the list.
void lms3dVRMLParser::ParseListElement(lms3dVRMLValue& value)
{
  const bool isEmpty = std::holds_alternative<std::monostate>(value);
  const bool isOfNumbers = std::holds_alternative<lms3dVRMLIntegers>(value) ||
    std::holds_alternative<lms3dVRMLReals>(value);
  const lms3dVRMLToken& token = this->Get();
  if (token.Kind == lms3dVRMLToken::NUMBER && (isEmpty || isOfNumbers))
  {
    this->ParseNumbers(value);
  }
  else if (token.Kind == lms3dVRMLToken::STRING &&
    (isEmpty || std::holds_alternative<lms3dVRMLStrings>(value)))
  {
    this->ParseStrings(value);
  }
  else if ((this->IsAtNode() || token.Is("NULL")) &&
    (isEmpty || std::holds_alternative<lms3dVRMLNodes>(value)))
  {
    this->ParseNodes(value);
  }
  else if (token.Kind == lms3dVRMLToken::WORD && isOfNumbers)
  {
    this->ParseWordAmongNumbers(value);
  }
  else if (token.Is("NULL") || token.Is("TRUE") || token.Is("FALSE"))
  {
    this->Advance();
  }
  else if (!this->ParseDeclaringStatement())
  {
    this->Skip();
  }
}

void lms3dVRMLParser::ParseNumbers(lms3dVRMLValue& value)
{
  if (std::holds_alternative<std::monostate>(value))
  {
    value = lms3dVRMLIntegers();
  }
  if (auto* integers = std::get_if<lms3dVRMLIntegers>(&value))
  {
    this->ParseRun(*integers);
    if (this->Get().Kind != lms3dVRMLToken::NUMBER ||
      !this->CountMemory(integers->size() * sizeof(double)))
    {
      return;
    }
    value = lms3dVRMLReals(integers->begin(), integers->end());
  }
  lms3dVRMLReals& reals = std::get<lms3dVRMLReals>(value);
  this->ParseRun(reals);
  while (this->Get().Kind == lms3dVRMLToken::NUMBER)
  {
    this->Warn(Quote(this->Get().Text) + " is not a finite number");
    reals.push_back(this->Get().Number);
    this->Advance();
    this->ParseRun(reals);
  }
}

// Reserves memory for a long list from the density so far and the distance to its end. Otherwise
// the list would be copied, and exist twice, whenever it grows. If the estimate was bad, because
// the closing mark is missing, the memory is returned.
template <typename List>
void lms3dVRMLParser::ParseRun(List& numbers)
{
  const std::size_t begin = this->Lexer.GetOffset();
  const std::size_t before = numbers.size();
  for (bool isMore = true; isMore;)
  {
    const std::size_t size = numbers.size();
    if (size == before + BatchSize)
    {
      const double density =
        static_cast<double>(size - before) / static_cast<double>(this->Lexer.GetOffset() - begin);
      const double more = 1.2 * density * static_cast<double>(this->Lexer.GetBytesToListEnd());
      numbers.reserve(size +
        std::min(static_cast<std::size_t>(more),
          static_cast<std::size_t>(this->Context.GetMemoryLeft() / sizeof(numbers[0]))));
    }
    this->Lexer.AppendNumbers(numbers, BatchSize);
    this->ReportProgress();
    isMore = this->CountMemory((numbers.size() - size) * sizeof(numbers[0])) &&
      numbers.size() == size + BatchSize;
  }
  if (numbers.size() > BatchSize && numbers.capacity() > 2 * numbers.size())
  {
    numbers.shrink_to_fit();
  }
}

// Appends NaN, so that the following numbers keep their indices.
void lms3dVRMLParser::ParseWordAmongNumbers(lms3dVRMLValue& value)
{
  if (const auto* integers = std::get_if<lms3dVRMLIntegers>(&value))
  {
    value = lms3dVRMLReals(integers->begin(), integers->end());
  }
  std::get<lms3dVRMLReals>(value).push_back(std::numeric_limits<double>::quiet_NaN());
  this->Skip();
}

void lms3dVRMLParser::ParseStrings(lms3dVRMLValue& value)
{
  if (!std::holds_alternative<lms3dVRMLStrings>(value))
  {
    value = lms3dVRMLStrings();
  }
  for (; this->Get().Kind == lms3dVRMLToken::STRING; this->Advance())
  {
    if (this->Get().IsOpen)
    {
      this->ReportLoss("the quote that ends a string is missing");
    }
    this->CountMemory(sizeof(std::string) + this->Get().Text.size());
    std::get<lms3dVRMLStrings>(value).push_back(lms3dUnescape(this->Get().Text));
  }
}

// A node that cannot be parsed remains in the list as null, because a Switch counts its choices.
void lms3dVRMLParser::ParseNodes(lms3dVRMLValue& value)
{
  if (!std::holds_alternative<lms3dVRMLNodes>(value))
  {
    value = lms3dVRMLNodes();
  }
  this->CountMemory(sizeof(lms3dVRMLNode*));
  std::get<lms3dVRMLNodes>(value).push_back(this->ParseNodeStatement());
}
