// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What stopped some work, in words for the user.
 */
#ifndef lms3dFailure_h
#define lms3dFailure_h

#include <exception>
#include <new>
#include <string>

/// Does the work. Empty where it ends well, else the words of what it threw, `withoutMemory` where
/// that was std::bad_alloc.
template <typename Work>
std::string lms3dRunAndGetError(const Work& work, const char* withoutMemory)
{
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    return withoutMemory;
  }
  catch (const std::exception& failure)
  {
    return failure.what();
  }
  return std::string();
}

#endif
