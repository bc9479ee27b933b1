// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLParser.h"

#include "lms3dVRMLContext.h"
#include "lms3dVRMLNodeTypes.h"
#include "lms3dVRMLScope.h"

#include <utility>

void lms3dVRMLParser::ParseBodyElement(lms3dVRMLNode& node)
{
  if (this->Get().Kind != lms3dVRMLToken::WORD)
  {
    this->PassOver();
  }
  else if (this->IsAtDeclaration())
  {
    std::vector<lms3dVRMLField> ownFields;
    this->ParseDeclaration(ownFields, true);
  }
  else if (this->IsAtNode())
  {
    this->TakeForChild(node);
  }
  else if (!this->ParseDeclaringStatement())
  {
    this->ParseField(node);
  }
}

void lms3dVRMLParser::TakeForChild(lms3dVRMLNode& node)
{
  const std::string text =
    Quote(this->Get().Text) + " stands in " + std::string(node.TypeName) + " where a field should";
  lms3dVRMLField children = { "children", this->Get().Line, {} };
  if (node.Type && node.Type->HasField(children.Name))
  {
    this->Warn(text + "; it is taken for a child");
    this->ParseNodes(children.Value);
    this->AddField(node, std::move(children));
  }
  else
  {
    this->Lose(text + "; it is passed over");
    this->ParseNodes(children.Value);
  }
}

void lms3dVRMLParser::ParseField(lms3dVRMLNode& node)
{
  lms3dVRMLField field = { this->Keep(this->Get().Text), this->Get().Line, {} };
  const std::size_t surfaces = this->Surfaces;
  const bool mayBeSeenOutside = this->MayBeSeen;
  this->MayBeSeen = mayBeSeenOutside && !(node.Type && lms3dIsVRMLColorField(field.Name));
  this->Advance();
  field.Value = this->ParseValue();
  this->MayBeSeen = mayBeSeenOutside;
  this->EndField(node, std::move(field), this->Surfaces > surfaces);
}

// What an unknown node or field holds is parsed, but nothing will ask for it.
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
    this->PassOverField(node, field, hasSurfaces);
  }
}

void lms3dVRMLParser::PassOverField(
  const lms3dVRMLNode& node, const lms3dVRMLField& field, bool hasSurfaces)
{
  const std::string text =
    std::string(node.TypeName) + " has no field " + Quote(field.Name) + "; it is passed over";
  if (hasSurfaces)
  {
    this->Context.Messages.AddError(this->Document.FileName, field.Line, text);
  }
  else if (!node.Type || node.Type->Role != lms3dVRMLNodeType::SCRIPT)
  {
    this->Context.Messages.AddWarning(this->Document.FileName, field.Line, text);
  }
}

// Nodes that are given in several pieces are all kept; of other values the last counts.
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
  node.Fields.push_back(std::move(field));
}
