// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace
{
// The first two columns hold words, the others numbers.
constexpr std::size_t ColumnsOfWords = 2;

void PrintRow(const Table::Row& row, const std::vector<int>& widths)
{
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    std::printf(i < ColumnsOfWords ? "| %-*s " : "| %*s ", widths[i], row[i].c_str());
  }
  std::printf("|\n");
}

void WriteRow(const Table::Row& row, std::ostream& out)
{
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    out << (i > 0 ? "," : "") << row[i];
  }
  out << '\n';
}

std::string FormatAs(const char* format, int decimals, double x)
{
  char text[64];
  std::snprintf(text, sizeof text, format, decimals, x);
  return std::isfinite(x) ? text : "-";
}
} // namespace

Table::Table(Row columns)
  : Columns(std::move(columns))
{
}

void Table::AddRow(Row cells)
{
  this->Rows.push_back(std::move(cells));
}

void Table::Print()
{
  std::vector<int> widths(this->Columns.size());
  Row rule;
  for (std::size_t i = 0; i < widths.size(); ++i)
  {
    widths[i] = std::max(4, static_cast<int>(this->Columns[i].size()));
    for (std::size_t row = this->Printed; row < this->Rows.size(); ++row)
    {
      widths[i] = std::max(widths[i], static_cast<int>(this->Rows[row][i].size()));
    }
    rule.push_back(i < ColumnsOfWords ? "---" : "--:");
  }
  PrintRow(this->Columns, widths);
  PrintRow(rule, widths);
  for (; this->Printed < this->Rows.size(); ++this->Printed)
  {
    PrintRow(this->Rows[this->Printed], widths);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void Table::Save(const std::string& fileName) const
{
  std::ofstream file(fileName);
  WriteRow(this->Columns, file);
  for (const Row& row : this->Rows)
  {
    WriteRow(row, file);
  }
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

std::string Table::Format(double x, int decimals)
{
  return FormatAs("%.*f", decimals, x);
}

std::string Table::FormatPower(double x)
{
  return FormatAs("%.*e", 1, x);
}
