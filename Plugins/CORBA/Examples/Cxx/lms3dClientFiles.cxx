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

// An absolute path without links.
fs::path GetTarget(const std::string& file)
{
  return fs::weakly_canonical(fs::absolute(file));
}

[[noreturn]] void Fail(const std::string& file, const std::string& reason)
{
  throw std::runtime_error("cannot write \"" + file + "\": " + reason);
}

void CheckFile(const std::string& file)
{
  const fs::path target = GetTarget(file);
  const fs::path folder = target.parent_path();
  if (target.extension() != ".vtp")
  {
    Fail(file, "its name must end in .vtp");
  }
  if (fs::is_directory(target))
  {
    Fail(file, "it is a folder");
  }
  if (!fs::is_directory(folder))
  {
    Fail(file, "there is no folder \"" + folder.string() + '"');
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    Fail(file, "its folder is not writable");
  }
}

/// A file in the same folder that replaces the final one or is removed.
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

  void Rename() const { fs::rename(this->Path, this->Final); }

  const fs::path Path;

private:
  const fs::path Final;
};

// Writes to memory, because VTK 9.2 crashes if the file system is full. Binary mode, because the
// default, appended data, is not valid XML.
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
  std::set<fs::path> targets;
  for (const std::string& file : files)
  {
    CheckFile(file);
    if (!targets.insert(GetTarget(file)).second)
    {
      Fail(file, "both files have this name");
    }
  }
}

void lms3dWriteFile(vtkPolyData* data, const std::string& file)
{
  const TemporaryFile temporary(GetTarget(file));
  std::ofstream stream(temporary.Path, std::ios::binary);
  stream << GetText(data);
  stream.close();
  if (!stream)
  {
    Fail(file, std::generic_category().message(errno));
  }
  temporary.Rename();
}
