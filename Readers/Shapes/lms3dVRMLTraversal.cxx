// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/lms3dVRMLTraversal.h"

#include "Evaluation/lms3dVRMLDocumentCache.h"
#include "Grammar/lms3dVRMLContext.h"
#include "Grammar/lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <string>
#include <utility>

lms3dVRMLTraversal::lms3dVRMLTraversal(lms3dVRMLContext& context, lms3dVRMLDocumentCache& documents)
  : Context(context)
  , Documents(documents)
  , Evaluator(context, documents)
{
}

std::vector<lms3dShape> lms3dVRMLTraversal::CollectShapes(const lms3dVRMLDocument& scene)
{
  this->EnterFile(scene, {}, {});
  while (!this->Groups.empty())
  {
    Group& group = this->Groups.back();
    if (group.Next < group.Members.size())
    {
      const lms3dVRMLNodeInContext member = group.Members[group.Next++];
      this->Visit(member, group.State);
    }
    else
    {
      this->Leave(group);
    }
  }
  return std::move(this->Shapes);
}

void lms3dVRMLTraversal::EnterFile(const lms3dVRMLDocument& file,
  const lms3dVRMLNodeInContext& fileNode, const InheritedState& state)
{
  std::vector<lms3dVRMLNodeInContext> roots;
  if (!this->Context.CountMemory(file.Roots.size() * sizeof(roots[0]), file.FileName, 0))
  {
    return;
  }
  roots.reserve(file.Roots.size());
  for (const lms3dVRMLNode* root : file.Roots)
  {
    roots.push_back({ root, nullptr });
  }
  this->Enter(fileNode, std::move(roots), state);
  this->OpenFiles.push_back(&file);
  this->Groups.back().IsFile = true;
}

void lms3dVRMLTraversal::Enter(const lms3dVRMLNodeInContext& node,
  std::vector<lms3dVRMLNodeInContext> members, const InheritedState& state)
{
  this->OpenNodes.insert(node);
  this->Groups.push_back({ node, std::move(members), state });
}

void lms3dVRMLTraversal::Leave(const Group& group)
{
  if (group.IsFile)
  {
    this->OpenFiles.pop_back();
  }
  this->OpenNodes.erase(group.Node);
  this->Groups.pop_back();
}

// Names within a prototype do not replace names outside it.
void lms3dVRMLTraversal::Visit(const lms3dVRMLNodeInContext& member, InheritedState state)
{
  if (!member.Node || !this->Context.CountNode(member.Node->Document->FileName, member.Node->Line))
  {
    return;
  }
  if (!member.Node->Name.empty() && (!member.Instance || state.Name.empty()))
  {
    state.Name = member.Node->Name;
  }
  const lms3dVRMLNodeInContext node = this->Evaluator.Expand(member);
  if (!node.Node)
  {
    return;
  }
  if (this->Groups.size() > lms3dVRMLMaximumDepth)
  {
    this->Evaluator.ReportLoss(node, std::string(node.Node->TypeName) + " is nested too deeply");
  }
  else if (this->OpenNodes.count(node) > 0)
  {
    this->Evaluator.ReportLoss(node, std::string(node.Node->TypeName) + " contains itself");
  }
  else
  {
    this->VisitNode(node, state);
  }
}

void lms3dVRMLTraversal::VisitNode(const lms3dVRMLNodeInContext& node, const InheritedState& state)
{
  const std::string name(node.Node->TypeName);
  if (!node.Node->Type)
  {
    this->Evaluator.ReportLoss(node, lms3dExplainUnknownNode(name));
    return;
  }
  switch (node.Node->Type->Role)
  {
    case lms3dVRMLNodeType::GROUP:
      this->Enter(node, this->Evaluator.GetNodes(node, "children"), state);
      break;
    case lms3dVRMLNodeType::TRANSFORM:
      this->VisitTransform(node, state);
      break;
    case lms3dVRMLNodeType::SWITCH:
      this->VisitSwitch(node, state);
      break;
    case lms3dVRMLNodeType::LOD:
      this->VisitLOD(node, state);
      break;
    case lms3dVRMLNodeType::INLINE:
      this->VisitInline(node, state);
      break;
    case lms3dVRMLNodeType::SHAPE:
      this->VisitShape(node, state);
      break;
    default:
      if (node.Node->Type->MayHaveSurface())
      {
        this->Evaluator.ReportLoss(node, name + " is outside a Shape, so it is not shown");
      }
  }
}

// ISO/IEC 14772-1, 6.52: P' = T C R SR S -SR -C P.
void lms3dVRMLTraversal::VisitTransform(
  const lms3dVRMLNodeInContext& transform, InheritedState state)
{
  using Vector = std::array<double, 3>;
  const Vector center = this->Evaluator.GetVector<3>(transform, "center", { 0, 0, 0 });
  const Vector translation = this->Evaluator.GetVector<3>(transform, "translation", { 0, 0, 0 });
  const Vector scale = this->Evaluator.GetVector<3>(transform, "scale", { 1, 1, 1 });
  const auto rotation = this->Evaluator.GetVector<4>(transform, "rotation", { 0, 0, 1, 0 });
  const auto axes = this->Evaluator.GetVector<4>(transform, "scaleOrientation", { 0, 0, 1, 0 });
  state.ToWorld = state.ToWorld * lms3dTransform::Translation(translation) *
    lms3dTransform::Translation(center) * lms3dTransform::Rotation(rotation) *
    lms3dTransform::Rotation(axes) * lms3dTransform::Scale(scale) *
    lms3dTransform::Rotation({ axes[0], axes[1], axes[2], -axes[3] }) *
    lms3dTransform::Translation({ -center[0], -center[1], -center[2] });
  this->Enter(transform, this->Evaluator.GetNodes(transform, "children"), state);
}

void lms3dVRMLTraversal::VisitSwitch(
  const lms3dVRMLNodeInContext& switchNode, const InheritedState& state)
{
  const double choice = this->Evaluator.GetNumber(switchNode, "whichChoice", -1.0);
  this->Enter(switchNode, { this->Evaluator.GetNodeAt(switchNode, "choice", choice) }, state);
}

// The first level is the finest.
void lms3dVRMLTraversal::VisitLOD(const lms3dVRMLNodeInContext& lod, const InheritedState& state)
{
  this->Enter(lod, { this->Evaluator.GetNodeAt(lod, "level", 0) }, state);
}

void lms3dVRMLTraversal::VisitInline(const lms3dVRMLNodeInContext& inlineNode, InheritedState state)
{
  const lms3dVRMLEvaluator::Urls urls = this->Evaluator.GetUrls(inlineNode);
  if (urls.Strings.empty())
  {
    return;
  }
  if (++state.InlineDepth > this->Context.Options.MaximumInlineDepth)
  {
    this->Evaluator.ReportLoss(
      inlineNode, "an Inline is lost: it is deeper than MaximumInlineDepth allows");
    return;
  }
  const lms3dVRMLDocument* file =
    this->Documents.FindInline(urls.Strings, *urls.Document, *inlineNode.Node);
  if (std::find(this->OpenFiles.begin(), this->OpenFiles.end(), file) != this->OpenFiles.end())
  {
    this->Evaluator.ReportLoss(inlineNode, "an Inline is lost: its file contains the Inline");
  }
  else if (file)
  {
    this->EnterFile(*file, inlineNode, state);
  }
}
