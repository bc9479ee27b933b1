// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Runs what may crash or never end, and gets its result.
 */
#ifndef SeparateProcess_h
#define SeparateProcess_h

#include <functional>
#include <string>
#include <vector>

struct SeparateResult
{
  std::vector<double> Numbers;
  /// Why there are none, as in "Segmentation fault"; empty where all went well.
  std::string Failure;
};

/**
 * Runs work in a process of its own, which is killed after the given number of seconds. Its output
 * is lost. Must be called before this process starts threads, because the new process inherits
 * locks. Throws std::runtime_error where there can be no other process.
 */
SeparateResult RunSeparately(
  const std::function<std::vector<double>()>& work, unsigned int maximumSeconds);

#endif
