// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientFiles.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

// Where a link leads.
fs::path GetPlace(const std::string& file)
{
  return fs::weakly_canonical(fs::absolute(file));
}

[[noreturn]] void Fail(const std::string& file, const std::string& reason)
{
  throw std::runtime_error("cannot write \"" + file + "\": " + reason);
}

void CheckFile(const std::string& file)
{
  const fs::path place = GetPlace(file);
  const fs::path folder = place.parent_path();
  if (place.extension() != ".vtp")
  {
    Fail(file, "the ending must be .vtp");
  }
  if (fs::is_directory(place))
  {
    Fail(file, "that is a folder");
  }
  if (!fs::is_directory(folder))
  {
    Fail(file, "there is no folder \"" + folder.string() + '"');
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    Fail(file, "no right to write there");
  }
}

/// A name beside a file that becomes it, or vanishes.
class TemporaryFile
{
public:
  explicit TemporaryFile(const fs::path& file)
    : Path(file.parent_path() /
        ("." + file.stem().string() + "." + std::to_string(getpid()) + file.extension().string()))
    , Final(file)
  {
  }

  ~TemporaryFile()
  {
    std::error_code ignored;
    fs::remove(this->Path, ignored);
  }

  TemporaryFile(const TemporaryFile&) = delete;
  void operator=(const TemporaryFile&) = delete;

  void Become() const { fs::rename(this->Path, this->Final); }

  const fs::path Path;

private:
  const fs::path Final;
};

// In memory: VTK 9.2 crashes where a file system takes no more. By default it appends binary data,
// which is no XML.
std::string GetText(vtkPolyData* data)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}
} // namespace

void lms3dCheckFiles(const std::vector<std::string>& files)
{
  std::set<fs::path> places;
  for (const std::string& file : files)
  {
    CheckFile(file);
    if (!places.insert(GetPlace(file)).second)
    {
      Fail(file, "choose two names");
    }
  }
}

void lms3dWriteFile(vtkPolyData* data, const std::string& file)
{
  const TemporaryFile temporary(GetPlace(file));
  std::ofstream stream(temporary.Path, std::ios::binary);
  stream << GetText(data);
  stream.close();
  if (!stream)
  {
    Fail(file, std::generic_category().message(errno));
  }
  temporary.Become();
}
