// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene with its acceleration structure, which is kept until the scene changes.
 */
#ifndef lms3dBuiltScene_h
#define lms3dBuiltScene_h

#include "Casting/lms3dRayCaster.h"
#include "Pipeline/lms3dProgress.h"
#include "Scan/lms3dScenePart.h"

#include <vtkTimeStamp.h>
#include <vtkType.h>

#include <memory>
#include <string>

class vtkDataObject;
struct lms3dSceneTriangles;

class lms3dBuiltScene
{
public:
  /**
   * Brings the ray caster up to date with the scene. Does nothing if neither the scene's MTime nor
   * the method changed. Otherwise collects the scene's triangles, and builds a ray caster only if
   * they differ from the present caster's: a new data array does not build, whereas any change
   * of coordinates, cells, hidden cells or global ids does.
   *
   * The scene is not kept alive. Uses the threads of the calling TBB arena. Returns false if
   * `progress` stopped the work; the next update then starts again. Throws std::runtime_error, with
   * a text for the user, if the scene is bad or memory is short.
   */
  bool Update(vtkDataObject* scene, int method, const lms3dProgress& progress);

  /// Returns whether Update has nothing to do. Visits all data sets of the scene.
  bool IsUpToDate(vtkDataObject* scene, int method) const;

  /// Returns a text for the user about cells that were skipped, empty if there are none.
  const std::string& GetSkippedCells() const { return this->SkippedCells; }

  /// Returns null if the scene has no triangles. The caster lives until the next Update.
  const lms3dRayCaster* GetCaster() const { return this->Caster.get(); }

  /// Returns the method of the last Update.
  int GetMethod() const { return this->Method; }

  /// Returns what the cells of the scene have in common, also those without a surface.
  const lms3dScenePart& GetPart() const { return this->Part; }

  /// Returns the time when a ray caster was last built, 0 before the first.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

  /// Returns the MTime of the scene, with all of its data sets, at the last complete Update.
  vtkMTimeType GetSceneTime() const { return this->SceneTime; }

private:
  void Describe(const lms3dSceneTriangles& triangles);
  bool Build(lms3dSceneTriangles triangles, int method, const lms3dProgress& progress);

  std::unique_ptr<lms3dRayCaster> Caster;
  vtkTimeStamp BuildTime;
  std::string SkippedCells;
  lms3dScenePart Part;

  /// The method of Caster.
  int Method = 0;

  /// What the last complete Update was for. The pointer is compared, never followed.
  vtkDataObject* Scene = nullptr;
  vtkMTimeType SceneTime = 0;
};

#endif
