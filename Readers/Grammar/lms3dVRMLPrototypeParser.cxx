// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLParser.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLScope.h"

#include <utility>

namespace
{
// Each field of an instance is searched for in the interface, linearly.
constexpr std::size_t MaximumNumberOfFields = 1000;
} // namespace

// The name is defined after the body, so that no prototype can contain itself.
void lms3dVRMLParser::ParsePrototype(bool isExternal)
{
  lms3dVRMLPrototype& prototype = this->Document.Prototypes.emplace_back(
    lms3dVRMLPrototype{ &this->Document, this->Get().Line, {}, {}, nullptr, isExternal, {} });
  this->CountMemory(sizeof(lms3dVRMLPrototype));
  this->Lexer.AdvanceToName();
  prototype.Name = this->Intern(this->Get().Text);
  this->Advance();
  if (this->Depth == lms3dVRMLMaximumDepth)
  {
    this->SkipPrototype(prototype);
    return;
  }
  ++this->Depth;
  this->ParseInterface(prototype);
  if (isExternal)
  {
    this->ParseUrls(prototype);
  }
  else
  {
    this->ParsePrototypeBody(prototype);
  }
  --this->Depth;

  this->Scope->Define(prototype.Name, &prototype);
  if (this->Depth == 0)
  {
    this->Document.PrototypesByName[prototype.Name] = &prototype;
    if (!isExternal && !this->Document.FirstPrototype)
    {
      this->Document.FirstPrototype = &prototype;
    }
  }
}

// The prototype remains undefined, so that its instances give messages too.
void lms3dVRMLParser::SkipPrototype(const lms3dVRMLPrototype& prototype)
{
  this->ReportLoss("PROTO " + std::string(prototype.Name) + " is nested too deeply");
  this->SkipBlock('[', ']');
  if (!prototype.IsExternal)
  {
    this->SkipBlock('{', '}');
  }
  else if (this->Get().Kind == lms3dVRMLToken::STRING)
  {
    this->Advance();
  }
  else
  {
    this->SkipBlock('[', ']');
  }
}

void lms3dVRMLParser::ParseUrls(lms3dVRMLPrototype& prototype)
{
  lms3dVRMLValue urls = this->ParseValue();
  if (auto* strings = std::get_if<lms3dVRMLStrings>(&urls))
  {
    prototype.Urls = std::move(*strings);
  }
}

bool lms3dVRMLParser::IsAtDeclaration() const
{
  const lms3dVRMLToken& token = this->Get();
  return token.Is("field") || token.Is("exposedField") || token.Is("eventIn") ||
    token.Is("eventOut");
}

void lms3dVRMLParser::ParseInterface(lms3dVRMLPrototype& prototype)
{
  const std::string_view what = "the interface of a PROTO";
  if (!this->Expect('[', what))
  {
    return;
  }
  while (!this->Get().Is(']') && !this->IsAtEnd(what))
  {
    if (this->IsAtDeclaration())
    {
      this->ParseDeclaration(prototype.Interface, !prototype.IsExternal);
    }
    else if (this->Get().Is('{'))
    {
      this->ReportLoss("] is missing before the body of a PROTO");
      return;
    }
    else
    {
      this->Skip();
    }
  }
  this->Advance();
}

// Accepts "field SFFloat size 1" and "eventIn SFTime start", and "... IS name" in a Script.
void lms3dVRMLParser::ParseDeclaration(std::vector<lms3dVRMLField>& fields, bool hasValues)
{
  const bool isField = this->Get().Is("field") || this->Get().Is("exposedField");
  this->Advance();
  this->Lexer.AdvanceToName();
  lms3dVRMLField field = { this->Intern(this->Get().Text), this->Get().Line, {} };
  this->Advance();
  if (this->Get().Is("IS") || (isField && hasValues))
  {
    field.Value = this->ParseValue();
  }
  if (fields.size() < MaximumNumberOfFields)
  {
    this->CountMemory(sizeof(lms3dVRMLField));
    fields.push_back(std::move(field));
  }
  else
  {
    this->ReportLoss(
      "an interface has more than " + std::to_string(MaximumNumberOfFields) + " fields");
  }
}

void lms3dVRMLParser::ParsePrototypeBody(lms3dVRMLPrototype& prototype)
{
  if (this->IsAtEnd("a PROTO"))
  {
    return;
  }
  if (!this->Get().Is('{'))
  {
    this->ReportLoss("PROTO " + std::string(prototype.Name) + " has no body");
    return;
  }
  this->Advance();
  lms3dVRMLScope* const outer = this->Scope;
  lms3dVRMLScope inner(outer, &prototype);
  this->Scope = &inner;
  lms3dVRMLNodes nodes;
  this->ParseStatements(nodes);
  this->Scope = outer;
  if (!this->IsAtEnd("a PROTO"))
  {
    this->Advance();
  }
  prototype.Body = nodes.empty() ? nullptr : nodes.front();
}
