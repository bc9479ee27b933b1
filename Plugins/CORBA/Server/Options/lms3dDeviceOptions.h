// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The options of lms3d-server about the scanner's device.
 */
#ifndef lms3dDeviceOptions_h
#define lms3dDeviceOptions_h

#include "Options/lms3dOptionValues.h"

#include <vector>

/// Returns the options in the order of the help text.
const std::vector<lms3dOption>& lms3dGetDeviceOptions();

#endif
