// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which beams of a scan met nothing, according to its array Status.
 */
#ifndef lms3dFreeBeams_h
#define lms3dFreeBeams_h

#include <cstdint>
#include <vector>

class vtkPolyData;

/// Returns for each of the `beams` of a scan, by BeamId, whether there is nothing along it: the
/// field data Status of the scan says that it met nothing, or a surface beyond the range. (Beams
/// whose return was too weak or too near do not show free space.) Returns an empty vector if the
/// scan has no Status of this size.
std::vector<bool> lms3dFindFreeBeams(vtkPolyData* scan, std::int64_t beams);

#endif
