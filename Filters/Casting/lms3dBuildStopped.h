// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Thrown if the user stops the building or a long query of an acceleration structure.
 */
#ifndef lms3dBuildStopped_h
#define lms3dBuildStopped_h

#include <exception>

/// Leaves a constructor or a query whose lms3dProgress returned false. An abort is not an error.
class lms3dBuildStopped : public std::exception
{
public:
  const char* what() const noexcept override { return "The work was stopped."; }
};

#endif
