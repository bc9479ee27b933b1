// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A table of results, printed as Markdown and saved as CSV.
 */
#ifndef Table_h
#define Table_h

#include <string>
#include <vector>

class Table
{
public:
  using Row = std::vector<std::string>;

  explicit Table(Row columns);

  /// As many cells as there are columns.
  void AddRow(Row cells);

  /// Prints the rows that were added since the last call, under the heads of the columns.
  void Print();

  /// Writes all rows. Throws std::runtime_error where the file cannot be written.
  void Save(const std::string& fileName) const;

  /// A number with a fixed count of digits after the point, or "-" for NaN.
  static std::string Format(double x, int decimals);

  /// A number in the style of 1.2e-16.
  static std::string FormatPower(double x);

private:
  Row Columns;
  std::vector<Row> Rows;
  std::size_t Printed = 0;
};

#endif
