// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts exceptions to error texts.
 */
#ifndef lms3dFailure_h
#define lms3dFailure_h

#include <exception>
#include <new>
#include <string>

/// Runs `work`. Returns an empty string if it succeeds, or the text of the std::exception that it
/// threw: `withoutMemory` if that was std::bad_alloc. Other exceptions pass through.
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
