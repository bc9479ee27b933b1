// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the returns of a scan have hit: normals, incidence, intensity and cell data, as
 * vtkLMS3DScanFilter documents them.
 */
#ifndef lms3dSurfaceAttributes_h
#define lms3dSurfaceAttributes_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dProcesses.h"
#include "Scan/lms3dScanSettings.h"

#include <cstdint>
#include <vector>

class vtkDataObject;
class vtkFieldData;
class vtkPolyData;

/// The triangle that each beam of a scan hit, ordered by turn, then by beam;
/// lms3dBeamPacket::NoTriangle for beams without a return from this process's part.
using lms3dHitTriangles = std::vector<std::int32_t>;

/// The surface of a scene, or of one process's part of it. References must outlive it.
struct lms3dReflectingSurface
{
  double GetReflectance(std::int32_t triangle) const
  {
    return this->Reflectances.empty() ? 1.0 : this->Reflectances[triangle];
  }

  const lms3dTriangleMesh& Mesh;

  /// One for each triangle; empty if all are 1.
  const std::vector<double>& Reflectances;
};

/// The hits of a scan. References must outlive it.
struct lms3dSurfaceHits
{
  const lms3dReflectingSurface Surface;
  const lms3dMovingBeams& Beams;
  const lms3dHitTriangles& Triangles;
};

/// Which arrays describe the hits of a scan.
struct lms3dSurfaceArrays
{
  explicit lms3dSurfaceArrays(const lms3dScanSettings& settings)
    : Attributes(settings.SurfaceAttributes)
    , Incidence(settings.Device.Arrays.Incidence)
    , Intensity(settings.Device.Arrays.Intensity)
  {
  }

  bool AreAny() const { return this->Attributes || this->Incidence || this->Intensity; }

  /// Normals, Incidence and the cell arrays of the scene.
  const bool Attributes;

  const bool Incidence;
  const bool Intensity;
};

/// Adds the wanted ones of Normals, Incidence, Intensity and the cell arrays of the scene to
/// `data`, in this order, one tuple for each beam with a triangle. `hasGlobalIds` says whether the
/// cells of the mesh are global ids. Uses the threads of the calling TBB arena.
void lms3dAddSurfaceAttributes(const lms3dSurfaceHits& hits, const lms3dSurfaceArrays& wanted,
  vtkDataObject* scene, bool hasGlobalIds, vtkFieldData* data);

/// Adds the attributes of all processes to the first process's `scan`. In each process,
/// `attributes` has a tuple for each beam with a triangle in `triangles`. If a beam has a triangle
/// in several processes, the lowest rank wins. A cell array must exist in all processes with
/// returns, or, if none has any, in all with triangles. May change `attributes`. Collective.
void lms3dGatherSurfaceAttributes(const lms3dProcesses& processes,
  const lms3dHitTriangles& triangles, vtkFieldData* attributes, vtkPolyData* scan);

#endif
