// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Runs many clients at once, each in its own process, and measures their calls.
 */
#ifndef ClientLoad_h
#define ClientLoad_h

#include <functional>
#include <string>
#include <vector>

/// Quantiles of numbers in any order. NaN if there are none.
struct Quantiles
{
  explicit Quantiles(std::vector<double> values);
  double Median;
  double Percentile99;
  double Worst;
};

/// Starts this program `count` times with `arguments`, which must make it call RunClient(). Returns
/// the milliseconds of all calls of all clients. Throws std::runtime_error if a client fails.
std::vector<double> RunClients(
  int count, const std::vector<std::string>& arguments, double seconds);

/// For these processes: repeats `call` for `seconds` from the common start time on, and prints the
/// time of each call.
void RunClient(
  const std::string& start, const std::string& seconds, const std::function<void()>& call);

#endif
