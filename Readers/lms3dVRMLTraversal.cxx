// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dVRMLTraversal.h"

#include "lms3dVRMLContext.h"
#include "lms3dVRMLLibrary.h"
#include "lms3dVRMLNodeTypes.h"

#include <algorithm>
#include <string>
#include <utility>

lms3dVRMLTraversal::lms3dVRMLTraversal(lms3dVRMLContext& context, lms3dVRMLLibrary& library)
  : Context(context)
  , Library(library)
  , Evaluator(context, library)
{
}

// The groups around a node are in a list of their own, not on the stack, so that scenes may be deep.
std::vector<lms3dShape> lms3dVRMLTraversal::CollectShapes(const lms3dVRMLDocument& scene)
{
  this->EnterFile(scene, {}, {});
  while (!this->Groups.empty())
  {
    Group& group = this->Groups.back();
    if (group.Next < group.Members.size())
    {
      const lms3dVRMLView member = group.Members[group.Next++];
      this->Show(member, group.Around);
    }
    else
    {
      this->Leave(group);
    }
  }
  return std::move(this->Shapes);
}

void lms3dVRMLTraversal::EnterFile(
  const lms3dVRMLDocument& file, const lms3dVRMLView& view, const Place& place)
{
  std::vector<lms3dVRMLView> roots;
  roots.reserve(file.Roots.size());
  for (const lms3dVRMLNode* root : file.Roots)
  {
    roots.push_back({ root, nullptr });
  }
  this->Enter(view, std::move(roots), place);
  this->OpenFiles.push_back(&file);
  this->Groups.back().IsFile = true;
}

void lms3dVRMLTraversal::Enter(
  const lms3dVRMLView& node, std::vector<lms3dVRMLView> members, const Place& place)
{
  this->Open.insert(node);
  this->Groups.push_back({ node, std::move(members), place });
}

void lms3dVRMLTraversal::Leave(const Group& group)
{
  if (group.IsFile)
  {
    this->OpenFiles.pop_back();
  }
  this->Open.erase(group.Node);
  this->Groups.pop_back();
}

// The names inside of a prototype are not for those who use it.
void lms3dVRMLTraversal::Show(const lms3dVRMLView& view, Place place)
{
  if (!view.Node || !this->Context.CountNode(view.Node->Document->FileName, view.Node->Line))
  {
    return;
  }
  if (!view.Node->Name.empty() && (!view.Instance || place.Name.empty()))
  {
    place.Name = view.Node->Name;
  }
  const lms3dVRMLView node = this->Evaluator.Enter(view);
  if (!node.Node)
  {
    return;
  }
  if (this->Groups.size() > lms3dVRMLMaximumDepth)
  {
    this->Evaluator.Lose(node, std::string(node.Node->TypeName) + " is inside of too many nodes");
  }
  else if (this->Open.count(node) > 0)
  {
    this->Evaluator.Lose(node, std::string(node.Node->TypeName) + " is inside of itself");
  }
  else
  {
    this->ShowNode(node, place);
  }
}

void lms3dVRMLTraversal::ShowNode(const lms3dVRMLView& node, const Place& place)
{
  const std::string name(node.Node->TypeName);
  if (!node.Node->Type)
  {
    this->Evaluator.Lose(node, lms3dExplainUnknownNode(name));
    return;
  }
  switch (node.Node->Type->Role)
  {
    case lms3dVRMLNodeType::GROUP:
      this->Enter(node, this->Evaluator.GetNodes(node, "children"), place);
      break;
    case lms3dVRMLNodeType::TRANSFORM:
      this->ShowTransform(node, place);
      break;
    case lms3dVRMLNodeType::SWITCH:
      this->ShowSwitch(node, place);
      break;
    case lms3dVRMLNodeType::LOD:
      this->ShowLevel(node, place);
      break;
    case lms3dVRMLNodeType::INLINE:
      this->ShowInline(node, place);
      break;
    case lms3dVRMLNodeType::SHAPE:
      this->ShowShape(node, place);
      break;
    default:
      if (node.Node->Type->MayShow())
      {
        this->Evaluator.Lose(node, name + " is not the geometry of a Shape, and so is not shown");
      }
  }
}

// ISO/IEC 14772-1, 6.52: P' = T C R SR S -SR -C P.
void lms3dVRMLTraversal::ShowTransform(const lms3dVRMLView& transform, Place place)
{
  using Vector = std::array<double, 3>;
  const Vector center = this->Evaluator.GetVector<3>(transform, "center", { 0, 0, 0 });
  const Vector translation = this->Evaluator.GetVector<3>(transform, "translation", { 0, 0, 0 });
  const Vector scale = this->Evaluator.GetVector<3>(transform, "scale", { 1, 1, 1 });
  const auto rotation = this->Evaluator.GetVector<4>(transform, "rotation", { 0, 0, 1, 0 });
  const auto axes = this->Evaluator.GetVector<4>(transform, "scaleOrientation", { 0, 0, 1, 0 });
  place.ToWorld = place.ToWorld * lms3dTransform::Translation(translation) *
    lms3dTransform::Translation(center) * lms3dTransform::Rotation(rotation) *
    lms3dTransform::Rotation(axes) * lms3dTransform::Scale(scale) *
    lms3dTransform::Rotation({ axes[0], axes[1], axes[2], -axes[3] }) *
    lms3dTransform::Translation({ -center[0], -center[1], -center[2] });
  this->Enter(transform, this->Evaluator.GetNodes(transform, "children"), place);
}

void lms3dVRMLTraversal::ShowSwitch(const lms3dVRMLView& view, const Place& place)
{
  const double choice = this->Evaluator.GetNumber(view, "whichChoice", -1.0);
  this->Enter(view, { this->Evaluator.GetNodeAt(view, "choice", choice) }, place);
}

// The finest.
void lms3dVRMLTraversal::ShowLevel(const lms3dVRMLView& lod, const Place& place)
{
  this->Enter(lod, { this->Evaluator.GetNodeAt(lod, "level", 0) }, place);
}

void lms3dVRMLTraversal::ShowInline(const lms3dVRMLView& view, Place place)
{
  const lms3dVRMLEvaluator::Urls urls = this->Evaluator.GetUrls(view);
  if (urls.Strings.empty())
  {
    return;
  }
  if (++place.InlineDepth > this->Context.Options.MaximumInlineDepth)
  {
    this->Evaluator.Lose(view, "an Inline is lost: it is deeper than MaximumInlineDepth allows");
    return;
  }
  const lms3dVRMLDocument* file =
    this->Library.FindInline(urls.Strings, *urls.Document, *view.Node);
  if (std::find(this->OpenFiles.begin(), this->OpenFiles.end(), file) != this->OpenFiles.end())
  {
    this->Evaluator.Lose(view, "an Inline is lost: its file is one that it is inside of");
  }
  else if (file)
  {
    this->EnterFile(*file, view, place);
  }
}
