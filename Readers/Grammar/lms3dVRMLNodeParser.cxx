// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLParser.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNodeTypes.h"
#include "Grammar/lms3dVRMLScope.h"

bool lms3dVRMLParser::IsAtNode()
{
  const lms3dVRMLToken& token = this->Get();
  return token.Is("DEF") || token.Is("USE") ||
    (token.Kind == lms3dVRMLToken::WORD && this->Lexer.IsFollowedBy('{'));
}

const lms3dVRMLNode* lms3dVRMLParser::ParseNodeStatement()
{
  if (this->Get().Is("DEF"))
  {
    std::string_view name;
    return this->ParseDefinition(name) ? this->ParseNode(name) : nullptr;
  }
  if (this->Get().Is("USE"))
  {
    return this->ParseUse();
  }
  if (this->Lexer.IsFollowedBy('{'))
  {
    return this->ParseNode({});
  }
  if (!this->Get().Is("NULL"))
  {
    this->Skip();
    return nullptr;
  }
  this->Advance();
  return nullptr;
}

bool lms3dVRMLParser::IsNodeType(std::string_view name) const
{
  return this->Scope->FindPrototype(name) || lms3dFindVRMLNodeType(name);
}

bool lms3dVRMLParser::ParseDefinition(std::string_view& name)
{
  this->Lexer.AdvanceToName();
  if (this->Get().Kind == lms3dVRMLToken::WORD && this->IsNodeType(this->Get().Text) &&
    this->Lexer.IsFollowedBy('{'))
  {
    this->Warn("DEF without a name");
    return true;
  }
  name = this->Intern(this->Get().Text);
  this->Advance();
  const bool isNode = this->Get().Kind == lms3dVRMLToken::WORD && this->Lexer.IsFollowedBy('{');
  if (!isNode)
  {
    this->ReportLossHere("DEF " + std::string(name) + " is not followed by a node");
  }
  return isNode;
}

const lms3dVRMLNode* lms3dVRMLParser::ParseUse()
{
  this->Lexer.AdvanceToName();
  const std::string name(this->Get().Text);
  const lms3dVRMLNode* node = this->Scope->FindNode(name);
  if (!node)
  {
    this->ReportLossHere("USE " + name + ": no earlier node has this name");
  }
  else
  {
    this->Surfaces += node->Prototype || (node->Type && node->Type->MayHaveSurface()) ? 1 : 0;
  }
  if (this->Get().Kind == lms3dVRMLToken::WORD)
  {
    this->Advance();
  }
  return node;
}

const lms3dVRMLNode* lms3dVRMLParser::ParseNode(std::string_view name)
{
  lms3dVRMLNode* const node = this->BeginNode(name);
  if (node)
  {
    const bool affectedSurfaces = this->AffectsSurfaces;
    this->AffectsSurfaces = affectedSurfaces && (!node->Type || node->Type->AffectsSurface());
    ++this->Depth;
    this->ParseNodeBody(*node);
    --this->Depth;
    this->AffectsSurfaces = affectedSurfaces;
  }
  return node;
}

// The name is defined before the body is parsed, because a Script can refer to itself.
lms3dVRMLNode* lms3dVRMLParser::BeginNode(std::string_view name)
{
  this->ReportProgress();
  if (!this->Context.CountParsedNode(this->Document.FileName, this->Get().Line))
  {
    this->Stop();
    return nullptr;
  }
  if (this->Depth == lms3dVRMLMaximumDepth)
  {
    this->ReportLoss(std::string(this->Get().Text) + " is nested too deeply");
    this->Advance();
    this->SkipBlock('{', '}');
    return nullptr;
  }
  lms3dVRMLNode& node = this->Document.Nodes.emplace_back(lms3dVRMLNode{ &this->Document,
    this->Get().Line, this->Intern(this->Get().Text), nullptr, nullptr, name, {} });
  node.Prototype = this->Scope->FindPrototype(node.TypeName);
  node.Type = node.Prototype ? nullptr : lms3dFindVRMLNodeType(node.TypeName);
  this->Surfaces += node.Prototype || (node.Type && node.Type->MayHaveSurface()) ? 1 : 0;
  if (!node.Prototype && !node.Type)
  {
    this->Warn(lms3dExplainUnknownNode(node.TypeName));
  }
  if (!name.empty())
  {
    this->Scope->Define(name, &node);
  }
  this->Advance();
  return &node;
}

void lms3dVRMLParser::ParseNodeBody(lms3dVRMLNode& node)
{
  this->Advance();
  while (!this->Get().Is('}'))
  {
    if (this->IsAtEnd(node.TypeName))
    {
      return;
    }
    this->ParseBodyElement(node);
  }
  this->Advance();
}
