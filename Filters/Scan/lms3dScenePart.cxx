// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScenePart.h"

#include <algorithm>
#include <stdexcept>
#include <string>

std::string lms3dDescribeMissingCells(const lms3dScenePart& scene)
{
  // VTK numbers from 0, some file formats from 1.
  const std::int64_t firstId = std::min<std::int64_t>(scene.MinimumGlobalId, 1);
  if (!scene.HasGlobalIds || scene.MaximumGlobalId - firstId < scene.NumberOfCells)
  {
    return {};
  }
  return "The scene's global ids go up to " + std::to_string(scene.MaximumGlobalId) +
    ", but it has only " + std::to_string(scene.NumberOfCells) +
    " cells in all processes together. If you extracted a part of a scene on purpose, ignore this "
    "warning. Otherwise a part is lost, and the scan shows what lies behind it. On Debian 12 with "
    "the present libexpat, ParaView's RedistributeDataSet loses pieces; use its filter D3 instead.";
}

void lms3dCheckScene(
  bool hasTriangles, const lms3dScenePart& scene, const std::string& skippedCells)
{
  if (hasTriangles)
  {
    return;
  }
  if (!skippedCells.empty())
  {
    throw std::runtime_error("There is nothing left to scan. " + skippedCells);
  }
  if (scene.HiddenCells > 0)
  {
    throw std::runtime_error("There is nothing left to scan: vtkGhostType hides all polygons, " +
      std::to_string(scene.HiddenCells) + " cells.");
  }
  throw std::runtime_error("The scene has no polygons, so there is nothing to scan. Connect a data "
                           "set with polygons, triangle strips or volume cells.");
}
