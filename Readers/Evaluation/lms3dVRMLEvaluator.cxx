// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/lms3dVRMLEvaluator.h"

#include "Evaluation/lms3dVRMLDocumentCache.h"
#include "Grammar/lms3dVRMLContext.h"

#include <algorithm>

namespace
{
// With its entry in the table of known instances.
constexpr std::size_t BytesPerInstance =
  sizeof(lms3dVRMLInstance) + sizeof(lms3dVRMLNodeInContext) + 3 * sizeof(void*);
} // namespace

lms3dVRMLNodeInContext lms3dVRMLEvaluator::Expand(lms3dVRMLNodeInContext node)
{
  while (node.Node && node.Node->Prototype)
  {
    node = this->ExpandInstance(node);
  }
  return node;
}

// Nested instances of one prototype are legal (a Joint in a Joint). Recursion is endless only if
// the same node is met again within its own instance.
bool lms3dVRMLEvaluator::IsInside(const lms3dVRMLNodeInContext& node) const
{
  for (const lms3dVRMLInstance* outer = node.Instance; outer; outer = outer->Outer)
  {
    if (outer->Node == node.Node)
    {
      return true;
    }
  }
  return false;
}

lms3dVRMLNodeInContext lms3dVRMLEvaluator::ExpandInstance(const lms3dVRMLNodeInContext& node)
{
  if (!this->Context.CountNode(node.Node->Document->FileName, node.Node->Line))
  {
    return {};
  }
  const auto known = this->KnownInstances.find(node);
  if (known != this->KnownInstances.end())
  {
    return { known->second->Prototype->Body, known->second };
  }
  const int depth = node.Instance ? node.Instance->Depth + 1 : 1;
  if (this->IsInside(node) || depth > lms3dVRMLMaximumDepth)
  {
    this->ReportLoss(node, std::string(node.Node->TypeName) + " contains an instance of itself");
    return {};
  }
  const lms3dVRMLPrototype* body = this->Documents.FindBody(*node.Node->Prototype);
  if (!body || !this->CountMemory(node, BytesPerInstance))
  {
    return {};
  }
  const lms3dVRMLInstance& instance =
    this->Instances.emplace_back(lms3dVRMLInstance{ node.Node, body, node.Instance, depth });
  this->KnownInstances[node] = &instance;
  return { body->Body, &instance };
}

bool lms3dVRMLEvaluator::MayDependOnInstance(const lms3dVRMLNodeInContext& node)
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
        [&mayDepend](const lms3dVRMLNode* child)
        { return child && std::any_of(child->Fields.begin(), child->Fields.end(), mayDepend); });
  };
  const std::vector<lms3dVRMLField>& fields = node.Node->Fields;
  return node.Instance &&
    (std::any_of(fields.begin(), fields.end(), isReference) ||
      std::any_of(fields.begin(), fields.end(), holdsOneThatMay));
}

// A value given by the instance, or else the default, belongs to the context around the instance.
lms3dVRMLEvaluator::FoundValue lms3dVRMLEvaluator::Find(
  const lms3dVRMLNodeInContext& node, std::string_view name)
{
  const lms3dVRMLField* field = lms3dFindField(node.Node->Fields, name);
  FoundValue found = { nullptr, node.Instance, node.Node->Document, field ? field->Line : 0 };
  while (field && std::holds_alternative<lms3dVRMLReference>(field->Value))
  {
    const std::string_view outerName = std::get<lms3dVRMLReference>(field->Value).Name;
    const lms3dVRMLInstance* instance = found.Instance;
    if (!instance)
    {
      this->ReportLoss(node, "IS " + std::string(outerName) + " is outside a PROTO");
      return {};
    }
    const lms3dVRMLField* given = lms3dFindField(instance->Node->Fields, outerName);
    field = given ? given : lms3dFindField(instance->Prototype->Interface, outerName);
    if (!field)
    {
      this->ReportLoss(node,
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

bool lms3dVRMLEvaluator::CountWork(const lms3dVRMLNodeInContext& geometry, std::size_t triangles)
{
  return this->Context.CountWork(triangles, geometry.Node->Document->FileName, geometry.Node->Line);
}

bool lms3dVRMLEvaluator::CountMemory(const lms3dVRMLNodeInContext& node, std::size_t bytes)
{
  return this->Context.CountMemory(bytes, node.Node->Document->FileName, node.Node->Line);
}

void lms3dVRMLEvaluator::Warn(const lms3dVRMLNodeInContext& node, const std::string& text)
{
  this->Context.Messages.AddWarning(node.Node->Document->FileName, node.Node->Line, text);
}

void lms3dVRMLEvaluator::ReportLoss(const lms3dVRMLNodeInContext& node, const std::string& text)
{
  this->Context.Messages.AddError(node.Node->Document->FileName, node.Node->Line, text);
}
