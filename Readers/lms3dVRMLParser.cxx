// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLParser.h"

#include "lms3dUTF8.h"
#include "lms3dVRMLContext.h"
#include "lms3dVRMLScope.h"

namespace
{
// The share of the file between two reports of progress.
constexpr double StepOfReport = 0.01;
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
      this->PassOver();
    }
  }
}

void lms3dVRMLParser::ParseStatements(lms3dVRMLNodes& nodes)
{
  while (this->Get().Kind != lms3dVRMLToken::END && !this->Get().Is('}'))
  {
    if (this->Get().Kind != lms3dVRMLToken::WORD)
    {
      this->PassOver();
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

// ROUTE node.event TO node.event: a scene is read as it stands at first.
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
    this->Warn("a ROUTE goes nowhere");
  }
}

bool lms3dVRMLParser::IsAtEnd(std::string_view inside)
{
  const bool isAtEnd = this->Get().Kind == lms3dVRMLToken::END;
  if (isAtEnd && !this->HasToldEnd)
  {
    this->HasToldEnd = true;
    this->Lose("the file ends inside of " + std::string(inside));
  }
  return isAtEnd;
}

bool lms3dVRMLParser::Enter(char mark, std::string_view what)
{
  const bool isThere = this->Get().Is(mark);
  if (isThere)
  {
    this->Advance();
  }
  else if (!this->IsAtEnd(what))
  {
    this->Lose(std::string(1, mark) + " is missing in " + std::string(what));
  }
  return isThere;
}

void lms3dVRMLParser::PassOver()
{
  this->LoseHere("cannot understand " + Quote(this->Get().Text) + " here; it is passed over");
  this->Advance();
}

void lms3dVRMLParser::PassOverBlock(char opening, char closing)
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

void lms3dVRMLParser::Tick()
{
  const double share = this->Lexer.GetShareDone();
  if (share >= this->ShareReported + StepOfReport)
  {
    this->ShareReported = share;
    if (!this->Context.Report(share))
    {
      this->Stop();
    }
  }
}

// Nothing is to be said of an end that is no fault of the file.
void lms3dVRMLParser::Stop()
{
  this->Lexer.Stop();
  this->HasToldEnd = true;
}

std::string_view lms3dVRMLParser::Keep(std::string_view name)
{
  return *this->Document.Names.emplace(name).first;
}

void lms3dVRMLParser::Warn(const std::string& text)
{
  this->Context.Messages.AddWarning(this->Document.FileName, this->Get().Line, text);
}

void lms3dVRMLParser::Lose(const std::string& text)
{
  this->Context.Messages.AddError(this->Document.FileName, this->Get().Line, text);
}

void lms3dVRMLParser::LoseHere(const std::string& text)
{
  if (this->MayBeSeen)
  {
    this->Lose(text);
  }
  else
  {
    this->Warn(text);
  }
}

std::string lms3dVRMLParser::Quote(std::string_view text)
{
  constexpr std::size_t longest = 40;
  return "\"" + std::string(lms3dCutUTF8(text, longest)) + (text.size() > longest ? "..." : "") +
    "\"";
}
