// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which beams without a return show free space.
 */
#ifndef lms3dPassingBeams_h
#define lms3dPassingBeams_h

#include <cstdint>
#include <vector>

class vtkPolyData;

/// Returns for each of the `beams` of a scan, by BeamId, whether there is nothing along it if it
/// has no return. The field data Status of the scan decides. Without Status, this holds for all
/// beams, unless the local map was made with a MaximumGapSize above 0: then some of them may have
/// been lost.
std::vector<bool> lms3dFindPassingBeams(vtkPolyData* map, vtkPolyData* scan, std::int64_t beams);

#endif
