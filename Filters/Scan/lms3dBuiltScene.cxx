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
#include <utility>

namespace
{
// A composite does not tell when one of its parts changes.
vtkMTimeType GetSceneTime(vtkDataObject* scene)
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
} // namespace

bool lms3dBuiltScene::IsFor(vtkDataObject* scene, int method) const
{
  return this->Scene == scene && this->SceneTime == GetSceneTime(scene) && this->Method == method;
}

void lms3dBuiltScene::Build(vtkDataObject* scene, int method)
{
  this->Caster.reset();
  this->Scene = nullptr;
  lms3dSceneTriangles triangles = lms3dCollectTriangles(scene);
  this->SkippedCells = lms3dDescribeSkippedCells(triangles, "The scene");
  this->NumberOfCells = triangles.NumberOfCells;
  this->HasIds = triangles.HasGlobalIds;
  this->IsOfVolume = triangles.HasVolume;
  if (!triangles.Mesh.Triangles.empty())
  {
    this->Caster = lms3dRayCaster::New(method, std::move(triangles.Mesh));
  }
  this->Scene = scene;
  this->SceneTime = GetSceneTime(scene);
  this->Method = method;
  this->BuildTime.Modified();
}
