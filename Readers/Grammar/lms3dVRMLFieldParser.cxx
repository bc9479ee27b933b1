// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLParser.h"

#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNodeTypes.h"
#include "Grammar/lms3dVRMLScope.h"

#include <utility>

void lms3dVRMLParser::ParseBodyElement(lms3dVRMLNode& node)
{
  if (this->Get().Kind != lms3dVRMLToken::WORD)
  {
    this->Skip();
  }
  else if (this->IsAtDeclaration())
  {
    std::vector<lms3dVRMLField> ownFields;
    this->ParseDeclaration(ownFields, true);
  }
  else if (this->IsAtNode())
  {
    this->ParseMisplacedChild(node);
  }
  else if (!this->ParseDeclaringStatement())
  {
    this->ParseField(node);
  }
}

void lms3dVRMLParser::ParseMisplacedChild(lms3dVRMLNode& node)
{
  const std::string text =
    Quote(this->Get().Text) + " is in " + std::string(node.TypeName) + " where a field is expected";
  lms3dVRMLField children = { "children", this->Get().Line, {} };
  if (node.Type && node.Type->HasField(children.Name))
  {
    this->Warn(text + "; it is read as a child");
    this->ParseNodes(children.Value);
    this->AddField(node, std::move(children));
  }
  else
  {
    this->ReportLoss(text + "; it is skipped");
    this->ParseNodes(children.Value);
  }
}

void lms3dVRMLParser::ParseField(lms3dVRMLNode& node)
{
  lms3dVRMLField field = { this->Intern(this->Get().Text), this->Get().Line, {} };
  const std::size_t surfaces = this->Surfaces;
  const bool affectedSurfaces = this->AffectsSurfaces;
  this->AffectsSurfaces = affectedSurfaces && !(node.Type && lms3dIsVRMLColorField(field.Name));
  this->Advance();
  field.Value = this->ParseValue();
  this->AffectsSurfaces = affectedSurfaces;
  this->EndField(node, std::move(field), this->Surfaces > surfaces);
}

// The content of unknown nodes and fields is parsed, but not stored.
void lms3dVRMLParser::EndField(lms3dVRMLNode& node, lms3dVRMLField&& field, bool hasSurfaces)
{
  const auto* reference = std::get_if<lms3dVRMLReference>(&field.Value);
  if (node.Prototype ? lms3dFindField(node.Prototype->Interface, field.Name) != nullptr
                     : node.Type && node.Type->HasField(field.Name))
  {
    if (!reference || !this->Scope->IsEvent(reference->Name))
    {
      this->AddField(node, std::move(field));
    }
  }
  else if (node.Prototype || node.Type)
  {
    this->SkipField(node, field, hasSurfaces);
  }
}

void lms3dVRMLParser::SkipField(
  const lms3dVRMLNode& node, const lms3dVRMLField& field, bool hasSurfaces)
{
  const std::string text =
    std::string(node.TypeName) + " has no field " + Quote(field.Name) + "; it is skipped";
  if (hasSurfaces)
  {
    this->Context.Messages.AddError(this->Document.FileName, field.Line, text);
  }
  else if (!node.Type || node.Type->Role != lms3dVRMLNodeType::SCRIPT)
  {
    this->Context.Messages.AddWarning(this->Document.FileName, field.Line, text);
  }
}

// If a field is given several times, lists of nodes are joined; of other values the last counts.
void lms3dVRMLParser::AddField(lms3dVRMLNode& node, lms3dVRMLField&& field)
{
  for (lms3dVRMLField& before : node.Fields)
  {
    if (before.Name == field.Name)
    {
      auto* nodes = std::get_if<lms3dVRMLNodes>(&before.Value);
      const auto* more = std::get_if<lms3dVRMLNodes>(&field.Value);
      if (nodes && more)
      {
        nodes->insert(nodes->end(), more->begin(), more->end());
      }
      else
      {
        this->Warn(std::string(node.TypeName) + " has the field " + Quote(field.Name) +
          " twice; the last counts");
        before = std::move(field);
      }
      return;
    }
  }
  this->CountMemory(sizeof(lms3dVRMLField));
  node.Fields.push_back(std::move(field));
}
