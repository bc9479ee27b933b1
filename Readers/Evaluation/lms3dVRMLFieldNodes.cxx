// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/lms3dVRMLEvaluator.h"

#include "Grammar/lms3dVRMLContext.h"

lms3dVRMLEvaluator::FoundNodes lms3dVRMLEvaluator::FindNodes(
  const lms3dVRMLNodeInContext& node, std::string_view name)
{
  const FoundValue found = this->Find(node, name);
  const auto* nodes = found.Value ? std::get_if<lms3dVRMLNodes>(found.Value) : nullptr;
  if (found.Value && !nodes)
  {
    this->RejectKind(node, name, found, "a node");
  }
  return { nodes, found.Instance };
}

std::vector<lms3dVRMLNodeInContext> lms3dVRMLEvaluator::GetNodes(
  const lms3dVRMLNodeInContext& node, std::string_view name)
{
  const FoundNodes found = this->FindNodes(node, name);
  std::vector<lms3dVRMLNodeInContext> nodes;
  // Counts null nodes too, which no visit counts.
  if (found.Nodes && this->CountMemory(node, found.Nodes->size() * sizeof(nodes[0])))
  {
    nodes.reserve(found.Nodes->size());
    for (const lms3dVRMLNode* child : *found.Nodes)
    {
      nodes.push_back({ child, found.Instance });
    }
  }
  return nodes;
}

lms3dVRMLNodeInContext lms3dVRMLEvaluator::GetNodeAt(
  const lms3dVRMLNodeInContext& node, std::string_view name, double index)
{
  const FoundNodes found = this->FindNodes(node, name);
  const bool isThere =
    found.Nodes && index >= 0.0 && index < static_cast<double>(found.Nodes->size());
  return isThere
    ? lms3dVRMLNodeInContext{ (*found.Nodes)[static_cast<std::size_t>(index)], found.Instance }
    : lms3dVRMLNodeInContext();
}

// Usually the field has one node. If the file gives several, the first that was parsed counts.
lms3dVRMLNodeInContext lms3dVRMLEvaluator::GetNode(
  const lms3dVRMLNodeInContext& node, std::string_view name)
{
  const FoundNodes found = this->FindNodes(node, name);
  for (std::size_t i = 0; found.Nodes && i < found.Nodes->size(); ++i)
  {
    if ((*found.Nodes)[i])
    {
      return this->Expand({ (*found.Nodes)[i], found.Instance });
    }
    if (!this->Context.CountNode(node.Node->Document->FileName, node.Node->Line))
    {
      break;
    }
  }
  return {};
}

lms3dVRMLNodeInContext lms3dVRMLEvaluator::GetNode(
  const lms3dVRMLNodeInContext& node, std::string_view name, std::string_view typeName)
{
  const lms3dVRMLNodeInContext found = this->GetNode(node, name);
  if (found.Node && found.Node->TypeName != typeName)
  {
    const char* const article = typeName.front() == 'A' ? "an " : "a ";
    this->Reject(name, node.Node->Document->FileName, node.Node->Line,
      std::string(name) + " of " + std::string(node.Node->TypeName) + " should be " + article +
        std::string(typeName) + "; it is skipped");
    return {};
  }
  return found;
}
