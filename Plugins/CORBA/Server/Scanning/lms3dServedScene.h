// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene in memory.
 */
#ifndef lms3dServedScene_h
#define lms3dServedScene_h

#include "LMS3DScanner.hh"
#include "lms3dAbort.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <string>

struct lms3dServedScene
{
  LMS3D::Scene Description;
  vtkSmartPointer<vtkPolyData> Surface;
};

using lms3dServedScenePointer = std::shared_ptr<const lms3dServedScene>;

/// The server ended before the scene was read.
class lms3dReadingStopped : public std::exception
{
};

/// Reads a VRML file; `isYUp` turns it so that z is up. Throws std::runtime_error where the file has
/// no surface, in words that tell a client nothing of the server's folders, and lms3dReadingStopped.
lms3dServedScenePointer lms3dReadScene(const std::string& name, const std::filesystem::path& file,
  bool isYUp, const lms3dStopTest& isStopped);

#endif
