// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLEvaluator.h"

#include "lms3dVRMLContext.h"
#include "lms3dVRMLLibrary.h"

#include <algorithm>

lms3dVRMLView lms3dVRMLEvaluator::Enter(lms3dVRMLView view)
{
  while (view.Node && view.Node->Prototype)
  {
    view = this->EnterInstance(view);
  }
  return view;
}

// A Joint may hold another Joint: only an instance that is met again inside of itself never ends.
bool lms3dVRMLEvaluator::IsInside(const lms3dVRMLView& view) const
{
  for (const lms3dVRMLInstance* outer = view.Instance; outer; outer = outer->Outer)
  {
    if (outer->Node == view.Node)
    {
      return true;
    }
  }
  return false;
}

lms3dVRMLView lms3dVRMLEvaluator::EnterInstance(const lms3dVRMLView& view)
{
  if (!this->Context.CountNode(view.Node->Document->FileName, view.Node->Line))
  {
    return {};
  }
  const auto known = this->Known.find(view);
  if (known != this->Known.end())
  {
    return { known->second->Prototype->Body, known->second };
  }
  const int depth = view.Instance ? view.Instance->Depth + 1 : 1;
  if (this->IsInside(view) || depth > lms3dVRMLMaximumDepth)
  {
    this->Lose(view, std::string(view.Node->TypeName) + " is an instance inside of itself");
    return {};
  }
  const lms3dVRMLPrototype* body = this->Library.FindBody(*view.Node->Prototype);
  if (!body)
  {
    return {};
  }
  const lms3dVRMLInstance& instance =
    this->Instances.emplace_back(lms3dVRMLInstance{ view.Node, body, view.Instance, depth });
  this->Known[view] = &instance;
  return { body->Body, &instance };
}

bool lms3dVRMLEvaluator::MayDependOnInstance(const lms3dVRMLView& view)
{
  const auto isReference = [](const lms3dVRMLField& field)
  { return std::holds_alternative<lms3dVRMLReference>(field.Value); };
  const auto mayDepend = [&isReference](const lms3dVRMLField& field)
  {
    const auto* nodes = std::get_if<lms3dVRMLNodes>(&field.Value);
    return isReference(field) || (nodes && !nodes->empty());
  };
  const auto holdsOneThatMay = [&mayDepend](const lms3dVRMLField& field)
  {
    const auto* nodes = std::get_if<lms3dVRMLNodes>(&field.Value);
    return nodes &&
      std::any_of(nodes->begin(), nodes->end(),
        [&mayDepend](const lms3dVRMLNode* node)
        { return node && std::any_of(node->Fields.begin(), node->Fields.end(), mayDepend); });
  };
  const std::vector<lms3dVRMLField>& fields = view.Node->Fields;
  return view.Instance &&
    (std::any_of(fields.begin(), fields.end(), isReference) ||
      std::any_of(fields.begin(), fields.end(), holdsOneThatMay));
}

// An instance's own value, or else the default, is seen from where the instance is.
lms3dVRMLEvaluator::FoundValue lms3dVRMLEvaluator::Find(
  const lms3dVRMLView& view, std::string_view name)
{
  const lms3dVRMLField* field = lms3dFindField(view.Node->Fields, name);
  FoundValue found = { nullptr, view.Instance, view.Node->Document, field ? field->Line : 0 };
  while (field && std::holds_alternative<lms3dVRMLReference>(field->Value))
  {
    const std::string_view outerName = std::get<lms3dVRMLReference>(field->Value).Name;
    const lms3dVRMLInstance* instance = found.Instance;
    if (!instance)
    {
      this->Lose(view, "IS " + std::string(outerName) + " is not inside of a PROTO");
      return {};
    }
    const lms3dVRMLField* given = lms3dFindField(instance->Node->Fields, outerName);
    field = given ? given : lms3dFindField(instance->Prototype->Interface, outerName);
    if (!field)
    {
      this->Lose(view,
        "IS " + std::string(outerName) + ": PROTO " + std::string(instance->Prototype->Name) +
          " has no such field");
    }
    found.Instance = instance->Outer;
    found.Line = field ? field->Line : 0;
    found.Document = given ? instance->Node->Document : instance->Prototype->Document;
  }
  found.Value =
    field && !std::holds_alternative<std::monostate>(field->Value) ? &field->Value : nullptr;
  return found;
}

bool lms3dVRMLEvaluator::CountWork(const lms3dVRMLView& geometry, std::size_t triangles)
{
  return this->Context.CountWork(triangles, geometry.Node->Document->FileName, geometry.Node->Line);
}

void lms3dVRMLEvaluator::Warn(const lms3dVRMLView& view, const std::string& text)
{
  this->Context.Messages.AddWarning(view.Node->Document->FileName, view.Node->Line, text);
}

void lms3dVRMLEvaluator::Lose(const lms3dVRMLView& view, const std::string& text)
{
  this->Context.Messages.AddError(view.Node->Document->FileName, view.Node->Line, text);
}
