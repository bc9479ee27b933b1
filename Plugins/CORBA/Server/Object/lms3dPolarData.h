// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the paper's fetch() returns.
 */
#ifndef lms3dPolarData_h
#define lms3dPolarData_h

#include "LMS3DScanner.hh"
#include "lms3dSnapshot.h"

/// r, alpha, beta of each beam, metres and degrees.
LMS3D::Data* lms3dMakePolarData(const lms3dSnapshot& snapshot);

#endif
