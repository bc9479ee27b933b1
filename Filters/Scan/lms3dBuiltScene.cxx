// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dBuiltScene.h"

#include "Scene/lms3dSceneTriangles.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace
{
// The share of an update that collects triangles, rather than builds the ray caster.
constexpr double CollectShare = 0.3;

// The MTime of a composite does not include the MTimes of its blocks.
vtkMTimeType ComputeSceneTime(vtkDataObject* scene)
{
  vtkMTimeType time = scene->GetMTime();
  if (vtkDataObjectTree* tree = vtkDataObjectTree::SafeDownCast(scene))
  {
    auto nodes = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    nodes->VisitOnlyLeavesOff();
    for (nodes->InitTraversal(); !nodes->IsDoneWithTraversal(); nodes->GoToNextItem())
    {
      time = std::max(time, nodes->GetCurrentDataObject()->GetMTime());
    }
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(scene))
  {
    auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      time = std::max(time, leaves->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

template <typename Vector>
bool HaveSameBytes(const Vector& a, const Vector& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

// Compares bytes, since results must not depend on what was scanned before: zeros differ in sign.
bool AreSame(const lms3dTriangleMesh& a, const lms3dTriangleMesh& b)
{
  return HaveSameBytes(a.Triangles, b.Triangles) && HaveSameBytes(a.Cells, b.Cells) &&
    HaveSameBytes(a.Points, b.Points);
}
} // namespace

bool lms3dBuiltScene::IsUpToDate(vtkDataObject* scene, int method) const
{
  return this->Scene == scene && this->Method == method &&
    this->SceneTime == ComputeSceneTime(scene);
}

bool lms3dBuiltScene::Update(vtkDataObject* scene, int method, const lms3dProgress& progress)
{
  if (this->IsUpToDate(scene, method))
  {
    return true;
  }
  const vtkMTimeType time = ComputeSceneTime(scene);
  this->Scene = nullptr;
  lms3dSceneTriangles triangles =
    lms3dCollectTriangles(scene, "The scene", lms3dGetStepProgress(progress, 0.0, CollectShare));
  if (!triangles.IsComplete)
  {
    return false;
  }
  this->Describe(triangles);
  const bool isBuilt =
    this->Method == method && this->Caster && AreSame(this->Caster->GetMesh(), triangles.Mesh);
  if (!isBuilt &&
    !this->Build(std::move(triangles), method, lms3dGetStepProgress(progress, CollectShare, 1.0)))
  {
    return false;
  }
  this->Scene = scene;
  this->SceneTime = time;
  return true;
}

void lms3dBuiltScene::Describe(const lms3dSceneTriangles& triangles)
{
  this->SkippedCells = lms3dDescribeSkippedCells(triangles, "The scene");
  this->Part = { triangles.NumberOfCells, triangles.HiddenCells, triangles.HasGlobalIds,
    triangles.MinimumGlobalId, triangles.MaximumGlobalId, triangles.HasVolume };
}

bool lms3dBuiltScene::Build(
  lms3dSceneTriangles triangles, int method, const lms3dProgress& progress)
{
  // Frees the memory of the last structure before the new one takes its own.
  this->Caster.reset();
  this->Method = method;
  if (!triangles.Mesh.Triangles.empty())
  {
    this->Caster = lms3dRayCaster::New(method, std::move(triangles.Mesh), progress);
    if (!this->Caster)
    {
      return false;
    }
  }
  this->BuildTime.Modified();
  return true;
}
