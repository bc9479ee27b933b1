// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLParser.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLScope.h"
#include "Model/lms3dUTF8.h"

namespace
{
// The fraction of the file between two reports of progress.
constexpr double ReportStep = 0.01;
} // namespace

lms3dVRMLParser::lms3dVRMLParser(
  std::string_view text, lms3dVRMLDocument& document, lms3dVRMLContext& context)
  : Lexer(text)
  , Document(document)
  , Context(context)
{
}

void lms3dVRMLParser::Parse()
{
  lms3dVRMLScope scope(nullptr, nullptr);
  this->Scope = &scope;
  this->Advance();
  while (this->Get().Kind != lms3dVRMLToken::END)
  {
    this->ParseStatements(this->Document.Roots);
    if (this->Get().Is('}'))
    {
      this->Skip();
    }
  }
}

void lms3dVRMLParser::ParseStatements(lms3dVRMLNodes& nodes)
{
  while (this->Get().Kind != lms3dVRMLToken::END && !this->Get().Is('}'))
  {
    if (this->Get().Kind != lms3dVRMLToken::WORD)
    {
      this->Skip();
    }
    else if (!this->ParseDeclaringStatement())
    {
      const bool isNode = this->IsAtNode();
      const lms3dVRMLNode* const node = this->ParseNodeStatement();
      if (isNode)
      {
        nodes.push_back(node);
      }
    }
  }
}

bool lms3dVRMLParser::ParseDeclaringStatement()
{
  const bool isExternal = this->Get().Is("EXTERNPROTO");
  if (isExternal || this->Get().Is("PROTO"))
  {
    this->ParsePrototype(isExternal);
    return true;
  }
  const bool isRoute = this->Get().Is("ROUTE");
  if (isRoute)
  {
    this->ParseRoute();
  }
  return isRoute;
}

// ROUTE node.event TO node.event has no effect, because the reader shows the initial state.
void lms3dVRMLParser::ParseRoute()
{
  this->Lexer.AdvanceToName();
  this->Advance();
  if (this->Get().Is("TO"))
  {
    this->Lexer.AdvanceToName();
    this->Advance();
  }
  else
  {
    this->Warn("a ROUTE has no TO");
  }
}

bool lms3dVRMLParser::IsAtEnd(std::string_view inside)
{
  const bool isAtEnd = this->Get().Kind == lms3dVRMLToken::END;
  if (isAtEnd && !this->HasReportedEnd)
  {
    this->HasReportedEnd = true;
    this->ReportLoss("the file ends inside " + std::string(inside));
  }
  return isAtEnd;
}

bool lms3dVRMLParser::Expect(char mark, std::string_view what)
{
  const bool isThere = this->Get().Is(mark);
  if (isThere)
  {
    this->Advance();
  }
  else if (!this->IsAtEnd(what))
  {
    this->ReportLoss(std::string(1, mark) + " is missing in " + std::string(what));
  }
  return isThere;
}

void lms3dVRMLParser::Skip()
{
  this->ReportLossHere(Quote(this->Get().Text) + " is not expected here; it is skipped");
  this->Advance();
}

void lms3dVRMLParser::SkipBlock(char opening, char closing)
{
  std::size_t open = 0;
  while (this->Get().Is(opening) || (open > 0 && this->Get().Kind != lms3dVRMLToken::END))
  {
    open += this->Get().Is(opening) ? 1 : 0;
    open -= this->Get().Is(closing) ? 1 : 0;
    this->Advance();
    if (open == 0)
    {
      return;
    }
  }
}

void lms3dVRMLParser::ReportProgress()
{
  const double fraction = this->Lexer.GetFractionDone();
  if (fraction >= this->ReportedFraction + ReportStep)
  {
    this->ReportedFraction = fraction;
    if (!this->Context.Report(fraction))
    {
      this->Stop();
    }
  }
}

// The end that follows is not a fault of the file, so it gives no message.
void lms3dVRMLParser::Stop()
{
  this->Lexer.Stop();
  this->HasReportedEnd = true;
}

bool lms3dVRMLParser::CountMemory(std::size_t bytes)
{
  const bool isWithin = this->Context.CountMemory(bytes, this->Document.FileName, this->Get().Line);
  if (!isWithin)
  {
    this->Stop();
  }
  return isWithin;
}

std::string_view lms3dVRMLParser::Intern(std::string_view name)
{
  const auto [interned, isNew] = this->Document.Names.emplace(name);
  if (isNew)
  {
    this->CountMemory(sizeof(std::string) + interned->capacity());
  }
  return *interned;
}

void lms3dVRMLParser::Warn(const std::string& text)
{
  this->Context.Messages.AddWarning(this->Document.FileName, this->Get().Line, text);
}

void lms3dVRMLParser::ReportLoss(const std::string& text)
{
  this->Context.Messages.AddError(this->Document.FileName, this->Get().Line, text);
}

void lms3dVRMLParser::ReportLossHere(const std::string& text)
{
  if (this->AffectsSurfaces)
  {
    this->ReportLoss(text);
  }
  else
  {
    this->Warn(text);
  }
}

std::string lms3dVRMLParser::Quote(std::string_view text)
{
  constexpr std::size_t maximumLength = 40;
  return "\"" + std::string(lms3dCutUTF8(text, maximumLength)) +
    (text.size() > maximumLength ? "..." : "") + "\"";
}
