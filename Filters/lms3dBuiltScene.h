// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene made ready for casting, kept until it changes.
 */
#ifndef lms3dBuiltScene_h
#define lms3dBuiltScene_h

#include "lms3dRayCaster.h"

#include <vtkTimeStamp.h>
#include <vtkType.h>

#include <memory>
#include <string>

class vtkDataObject;

class lms3dBuiltScene
{
public:
  /// Whether the last Build was of this scene as it is now, for the same method.
  bool IsFor(vtkDataObject* scene, int method) const;

  /**
   * Returns words on the cells that were left out, empty where all were taken. Throws
   * std::runtime_error, with words for the user, where nothing is left.
   */
  std::string Build(vtkDataObject* scene, int method);

  const lms3dRayCaster& GetCaster() const { return *this->Caster; }
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  std::unique_ptr<lms3dRayCaster> Caster;
  vtkTimeStamp BuildTime;
  vtkDataObject* Scene = nullptr;
  vtkMTimeType SceneTime = 0;
  int Method = 0;
};

#endif
