// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLEvaluator.h"

#include "lms3dVRMLContext.h"

lms3dVRMLEvaluator::FoundNodes lms3dVRMLEvaluator::FindNodes(
  const lms3dVRMLView& view, std::string_view name)
{
  const FoundValue found = this->Find(view, name);
  const auto* nodes = found.Value ? std::get_if<lms3dVRMLNodes>(found.Value) : nullptr;
  if (found.Value && !nodes)
  {
    this->RejectKind(view, name, found, "a node");
  }
  return { nodes, found.Instance };
}

std::vector<lms3dVRMLView> lms3dVRMLEvaluator::GetNodes(
  const lms3dVRMLView& view, std::string_view name)
{
  const FoundNodes found = this->FindNodes(view, name);
  std::vector<lms3dVRMLView> views;
  if (found.Nodes)
  {
    views.reserve(found.Nodes->size());
    for (const lms3dVRMLNode* node : *found.Nodes)
    {
      views.push_back({ node, found.Instance });
    }
  }
  return views;
}

lms3dVRMLView lms3dVRMLEvaluator::GetNodeAt(
  const lms3dVRMLView& view, std::string_view name, double place)
{
  const FoundNodes found = this->FindNodes(view, name);
  const bool isThere =
    found.Nodes && place >= 0.0 && place < static_cast<double>(found.Nodes->size());
  return isThere ? lms3dVRMLView{ (*found.Nodes)[static_cast<std::size_t>(place)], found.Instance }
                 : lms3dVRMLView();
}

// The first that could be read, if the file gives several.
lms3dVRMLView lms3dVRMLEvaluator::GetNode(const lms3dVRMLView& view, std::string_view name)
{
  const FoundNodes found = this->FindNodes(view, name);
  for (std::size_t i = 0; found.Nodes && i < found.Nodes->size(); ++i)
  {
    if ((*found.Nodes)[i])
    {
      return this->Enter({ (*found.Nodes)[i], found.Instance });
    }
    if (!this->Context.CountNode(view.Node->Document->FileName, view.Node->Line))
    {
      break;
    }
  }
  return {};
}

lms3dVRMLView lms3dVRMLEvaluator::GetNode(
  const lms3dVRMLView& view, std::string_view name, std::string_view typeName)
{
  const lms3dVRMLView node = this->GetNode(view, name);
  if (node.Node && node.Node->TypeName != typeName)
  {
    const char* const article = typeName.front() == 'A' ? "an " : "a ";
    this->Reject(name, view.Node->Document->FileName, view.Node->Line,
      std::string(name) + " of " + std::string(view.Node->TypeName) + " should be " + article +
        std::string(typeName) + "; it is passed over");
    return {};
  }
  return node;
}
