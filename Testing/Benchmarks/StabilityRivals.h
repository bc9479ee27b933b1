// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What else casts beams, as it comes, for the stability suite.
 */
#ifndef StabilityRivals_h
#define StabilityRivals_h

#include "StabilityMethod.h"

#include <vector>

/// Embree's triangles in single precision, coordinates narrowed as they are: single rays, in a
/// plain and in a robust scene, and coherent packets of 16 in a robust one.
std::vector<StabilityMethod> GetEmbreeMethods();

/// VTK's locators.
std::vector<StabilityMethod> GetLocatorMethods();

#endif
