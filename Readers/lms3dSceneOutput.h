// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes one vtkPolyData of the shapes that an engine has read.
 */
#ifndef lms3dSceneOutput_h
#define lms3dSceneOutput_h

#include "lms3dScene.h"

class vtkPolyData;

/// Whether any shape has a triangle.
bool lms3dHasSurface(const lms3dScene& scene);

/// Points in the scene's coordinates, turned from y up to z up if asked; triangles; their arrays.
void lms3dWriteScene(const lms3dScene& scene, bool turnYUp, vtkPolyData* surface);

#endif
