// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene made ready for casting, kept until it changes.
 */
#ifndef lms3dBuiltScene_h
#define lms3dBuiltScene_h

#include "Casting/lms3dRayCaster.h"

#include <vtkTimeStamp.h>
#include <vtkType.h>

#include <cstdint>
#include <memory>
#include <string>

class vtkDataObject;

class lms3dBuiltScene
{
public:
  /// Whether the last Build was of this scene as it is now, for the same method.
  bool IsFor(vtkDataObject* scene, int method) const;

  /// Throws std::runtime_error, with words for the user, where the scene is bad.
  void Build(vtkDataObject* scene, int method);

  /// Words on the cells that were left out, empty where all were taken.
  const std::string& GetSkippedCells() const { return this->SkippedCells; }

  /// Null where the scene has no triangles.
  const lms3dRayCaster* GetCaster() const { return this->Caster.get(); }

  std::int64_t GetNumberOfCells() const { return this->NumberOfCells; }
  bool HasGlobalIds() const { return this->HasIds; }
  bool HasVolume() const { return this->IsOfVolume; }
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  std::unique_ptr<lms3dRayCaster> Caster;
  vtkTimeStamp BuildTime;
  std::string SkippedCells;
  vtkDataObject* Scene = nullptr;
  vtkMTimeType SceneTime = 0;
  int Method = 0;
  std::int64_t NumberOfCells = 0;
  bool HasIds = false;
  bool IsOfVolume = false;
};

#endif
