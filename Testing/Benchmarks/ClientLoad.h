// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Many clients at once, each a process of its own, and how long their calls took.
 */
#ifndef ClientLoad_h
#define ClientLoad_h

#include <functional>
#include <string>
#include <vector>

/// Of numbers in any order; not a number where there are none.
struct Quantiles
{
  explicit Quantiles(std::vector<double> values);
  double Median;
  double Percentile99;
  double Worst;
};

/// Starts this program `count` times with `arguments`, each of which has to call RunClient(). The
/// milliseconds of all calls of all clients. Throws std::runtime_error where one of them fails.
std::vector<double> RunClients(
  int count, const std::vector<std::string>& arguments, double seconds);

/// In such a process: makes calls from the time on that all clients have been told, and prints how long
/// each took.
void RunClient(
  const std::string& start, const std::string& seconds, const std::function<void()>& call);

#endif
