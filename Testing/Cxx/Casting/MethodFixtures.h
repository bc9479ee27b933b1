// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the tests of all intersection methods share.
 */
#ifndef MethodFixtures_h
#define MethodFixtures_h

#include <gtest/gtest.h>

#include <string>

class vtkLMS3DScanFilter;
class vtkPolyData;

/// The name of the method that is the parameter of a test.
std::string GetMethodName(const testing::TestParamInfo<int>& method);

/// The share of beams that must hit from within a closed mesh: beams at vertices and edges may be
/// lost where the header of vtkLMS3DScanFilter says so.
double GetMinimumShare(int method);

/// Sets scene and method, and a grid of 31 x 36 beams.
void SetUpScan(vtkLMS3DScanFilter* scan, vtkPolyData* scene, int method);

#endif
