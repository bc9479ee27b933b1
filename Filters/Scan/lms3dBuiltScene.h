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
#include <functional>
#include <memory>
#include <string>

class vtkDataObject;

class lms3dBuiltScene
{
public:
  /// Whether the last Build was of this scene as it is now, for the same method.
  bool IsFor(vtkDataObject* scene, int method) const;

  /// `progress` receives the fraction of the triangles that are collected, 0 to 1, from the calling
  /// thread. If it returns false, the scene stays unbuilt and Build() returns false. Throws
  /// std::runtime_error, with a text for the user, if the scene is bad.
  bool Build(
    vtkDataObject* scene, int method,
    const std::function<bool(double)>& progress = [](double) { return true; });

  /// Words on the cells that were left out, empty where all were taken.
  const std::string& GetLeftOut() const { return this->LeftOut; }

  /// Null where the scene has no triangles.
  const lms3dRayCaster* GetCaster() const { return this->Caster.get(); }

  std::int64_t GetNumberOfCells() const { return this->NumberOfCells; }
  bool HasGlobalIds() const { return this->HasIds; }
  bool HasVolume() const { return this->IsOfVolume; }
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  std::unique_ptr<lms3dRayCaster> Caster;
  vtkTimeStamp BuildTime;
  std::string LeftOut;
  vtkDataObject* Scene = nullptr;
  vtkMTimeType SceneTime = 0;
  int Method = 0;
  std::int64_t NumberOfCells = 0;
  bool HasIds = false;
  bool IsOfVolume = false;
};

#endif
