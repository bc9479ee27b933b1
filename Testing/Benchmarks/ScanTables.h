// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The tables of the benchmark scan.
 */
#ifndef ScanTables_h
#define ScanTables_h

#include "ScanContender.h"
#include "Table.h"

#include <string>
#include <vector>

struct BenchmarkScene;

class ScanTables
{
public:
  ScanTables();

  /// Adds and prints a scene's rows. The first contender is the raw packets. `shareOfOthers` is
  /// that of LoadMeter while the scans were timed.
  void AddScene(
    const BenchmarkScene& scene, std::vector<ScanContender>& contenders, double shareOfOthers);

  /// Prints all scenes, with both numbers of threads in one row.
  void PrintSummary();

  /// Writes all rows. Throws std::runtime_error if the file cannot be written.
  void Save(const std::string& fileName) const;

private:
  Table Rows;
  Table Summary;
};

#endif
