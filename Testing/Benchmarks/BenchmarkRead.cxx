// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"

#include "Memory.h"
#include "Scenes.h"
#include "Table.h"
#include "Timer.h"

#include "Shapes/lms3dVRMLReader.h"
#include "vtkVRMLImporterSource.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <system_error>

namespace
{
namespace fs = std::filesystem;

constexpr double Megabyte = 1024.0 * 1024.0;

/// A file of one IndexedFaceSet, removed with the object.
class SceneFile
{
public:
  explicit SceneFile(vtkPolyData* surface)
    : Name((fs::temp_directory_path() / "lms3dBenchmarkRead.wrl").string())
  {
    std::FILE* file = std::fopen(this->Name.c_str(), "w");
    if (!file)
    {
      throw std::runtime_error("cannot write " + this->Name);
    }
    std::fputs(
      "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet { coord Coordinate { point [\n", file);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double p[3];
      surface->GetPoint(i, p);
      std::fprintf(file, "%.6f %.6f %.6f,\n", p[0], p[1], p[2]);
    }
    std::fputs("] } coordIndex [\n", file);
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      vtkIdType count;
      const vtkIdType* corners;
      surface->GetPolys()->GetCellAtId(cell, count, corners);
      std::fprintf(file, "%lld, %lld, %lld, -1,\n", static_cast<long long>(corners[0]),
        static_cast<long long>(corners[1]), static_cast<long long>(corners[2]));
    }
    std::fputs("] } }\n", file);
    std::fclose(file);
  }

  ~SceneFile()
  {
    std::error_code error;
    fs::remove(this->Name, error);
  }

  SceneFile(const SceneFile&) = delete;
  void operator=(const SceneFile&) = delete;

  const std::string Name;
};

/// What any reader has to do at least: get the bytes, and make numbers of them.
double SumNumbers(const std::string& fileName)
{
  std::string text(fs::file_size(fileName), '\0');
  std::ifstream(fileName, std::ios::binary)
    .read(&text[0], static_cast<std::streamsize>(text.size()));
  const auto isBlank = [](char c) { return c == ' ' || c == ',' || c == '\n'; };
  const char* const end = text.data() + text.size();
  double sum = 0.0;
  for (const char* p = text.data(); p < end;)
  {
    p = std::find_if_not(p, end, isBlank);
    double number = 0.0;
    const std::from_chars_result read = std::from_chars(p, end, number);
    sum += number;
    p = read.ec == std::errc() ? read.ptr : std::find_if(p, end, isBlank);
  }
  return sum;
}

struct Contender
{
  const char* Name;
  std::function<void()> Read;
  double Best = std::numeric_limits<double>::infinity();
};

/// The most memory that an execution holds beside its output.
double GetPeakAboveOutput(vtkVRMLImporterSource* reader)
{
  reader->GetOutput()->Initialize();
  const MemoryMeter meter;
  reader->Modified();
  reader->Update();
  return meter.GetPeak() - 1024.0 * static_cast<double>(reader->GetOutput()->GetActualMemorySize());
}

void TimeScene(const std::string& name, const BenchmarkOptions& options, Table& table)
{
  const vtkIdType count = MakeScene(name).Surface->GetNumberOfPolys();
  const SceneFile file(MakeScene(name).Surface);
  const double size = static_cast<double>(fs::file_size(file.Name));
  vtkNew<vtkVRMLImporterSource> reader;
  reader->SetFileName(file.Name.c_str());
  volatile double sum = 0.0;
  std::array<Contender, 3> contenders = { {
    { "its numbers alone", [&] { sum = SumNumbers(file.Name); } },
    { "its shapes", [&] { lms3dReadVRML(file.Name, {}, [](double) { return true; }); } },
    { "vtkVRMLImporterSource",
      [&]
      {
        reader->Modified();
        reader->Update();
      } },
  } };
  const int runs = count > 1000000 ? 3 : options.IsQuick ? 5 : 15;
  for (int run = 0; run < runs; ++run)
  {
    for (Contender& contender : contenders)
    {
      contender.Best = std::min(contender.Best, GetMilliseconds(contender.Read));
    }
  }
  const double peak = GetPeakAboveOutput(reader) / Megabyte;
  for (const Contender& contender : contenders)
  {
    const bool isLast = &contender == &contenders.back();
    table.AddRow({ name, std::to_string(count), Table::Format(size / Megabyte, 1), contender.Name,
      Table::Format(contender.Best, 2), Table::Format(contender.Best / contenders[0].Best, 2),
      isLast ? Table::Format(peak, 0) : "-" });
  }
  table.Print();
}
} // namespace

void RunReadBenchmark(const BenchmarkOptions& options)
{
  Table table(
    { "scene", "triangles", "file MB", "what is read", "ms", "x numbers", "MB beside the output" });
  for (const std::string& name : options.Scenes)
  {
    TimeScene(name, options, table);
  }
  if (!options.CSVFile.empty())
  {
    table.Save(options.CSVFile);
  }
}
