// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene in memory.
 */
#ifndef lms3dServedScene_h
#define lms3dServedScene_h

#include "LMS3DScanner.hh"
#include "Scanning/lms3dAlgorithmObservers.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

/// Does not change after it was read.
struct lms3dServedScene
{
  LMS3D::Scene Description;
  /// Metres, world coordinates.
  vtkSmartPointer<vtkPolyData> Surface;
};

/// How scenes are read.
struct lms3dSceneReading
{
  /// Rotates a scene whose y axis is up so that its z axis is up.
  bool IsYUp = false;
  ///@{
  /// The limits of vtkVRMLImporterSource. 0: the default of that class.
  std::int64_t MaximumNumberOfNodes = 0;
  std::int64_t MaximumNumberOfTriangles = 0;
  std::int64_t MaximumMemory = 0;
  std::int64_t MaximumFileSize = 0;
  ///@}
};

using lms3dServedScenePointer = std::shared_ptr<const lms3dServedScene>;

/// Thrown if the server ends before the scene is read.
class lms3dReadingStopped : public std::exception
{
};

/// Reads a VRML file. Throws std::runtime_error if the file has no surface, and lms3dReadingStopped
/// if `isStopped` returns true. Messages for clients do not contain the server's folders.
lms3dServedScenePointer lms3dReadScene(const std::string& name, const std::filesystem::path& file,
  const lms3dSceneReading& reading, const lms3dStopTest& isStopped);

#endif
