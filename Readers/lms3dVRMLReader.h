// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads the surfaces of VRML97 scenes (ISO/IEC 14772-1:1997).
 */
#ifndef lms3dVRMLReader_h
#define lms3dVRMLReader_h

#include "lms3dScene.h"

#include <cstdint>
#include <functional>
#include <string>

struct lms3dVRMLOptions
{
  /// The folder that Inline and EXTERNPROTO stay below; where empty, that of the scene.
  std::string SceneRoot;
  /// How far the triangles of a Sphere, Cone or Cylinder may be from it, metres.
  double ChordError = 0.001;
  int MaximumInlineDepth = 16;
  /// Each node counts once where it is written and once each time that it is met.
  std::int64_t MaximumNumberOfNodes = 20'000'000;
  std::int64_t MaximumNumberOfTriangles = 400'000'000;
  /// Of all files together, unpacked.
  std::int64_t MaximumFileSize = std::int64_t(1) << 31;
};

/// Told the share done, 0 to 1; returns false to stop.
using lms3dProgressFunction = std::function<bool(double)>;

/**
 * Reads all that can be read. What is lost is in the messages; without one of severity ERROR
 * nothing is. After a stop the scene is of no use: it has some of the shapes, or none, and no message
 * tells that.
 */
lms3dScene lms3dReadVRML(const std::string& fileName, const lms3dVRMLOptions& options,
  const lms3dProgressFunction& progress);

/// Empty where a file that begins so is VRML97, else what it is instead: "is a VRML 1.0 file".
std::string lms3dExplainBeginning(const std::string& beginning);

#endif
