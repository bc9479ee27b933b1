// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientFiles.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
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

// The temporary file. Empty before the first.
char PathOfSignal[PATH_MAX] = "";

extern "C" void RemoveAndEnd(int number)
{
  unlink(PathOfSignal);
  std::signal(number, SIG_DFL);
  std::raise(number);
}

/// While it exists, signals that end the program remove a file.
class SignalGuard
{
public:
  explicit SignalGuard(const fs::path& file)
  {
    const std::size_t length = file.string().copy(PathOfSignal, sizeof(PathOfSignal) - 1);
    PathOfSignal[length] = '\0';
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      this->Before[i] = std::signal(Signals[i], RemoveAndEnd);
      if (this->Before[i] == SIG_IGN) // by nohup
      {
        std::signal(Signals[i], SIG_IGN);
      }
    }
  }

  ~SignalGuard()
  {
    for (std::size_t i = 0; i < Signals.size(); ++i)
    {
      std::signal(Signals[i], this->Before[i]);
    }
  }

  SignalGuard(const SignalGuard&) = delete;
  void operator=(const SignalGuard&) = delete;

private:
  static constexpr std::array<int, 3> Signals = { SIGHUP, SIGINT, SIGTERM };

  std::array<void (*)(int), Signals.size()> Before = {};
};

/// A new file in the same folder that replaces the final one or is removed.
class TemporaryFile
{
public:
  explicit TemporaryFile(const fs::path& file)
    : Path(file.parent_path() /
        ("." + file.stem().string() + "." + std::to_string(getpid()) + file.extension().string()))
    , Final(file)
    , Guard(Path)
    , Descriptor(open(Path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666))
  {
    if (this->Descriptor < 0)
    {
      Fail(this->Path.string(), std::generic_category().message(errno));
    }
  }

  ~TemporaryFile()
  {
    this->Close();
    std::error_code ignored;
    fs::remove(this->Path, ignored);
  }

  TemporaryFile(const TemporaryFile&) = delete;
  void operator=(const TemporaryFile&) = delete;

  /// Fails with an error of the system.
  bool Write(const std::string& text)
  {
    for (std::size_t done = 0; done < text.size();)
    {
      const ssize_t count = write(this->Descriptor, text.data() + done, text.size() - done);
      if (count < 0)
      {
        return false;
      }
      done += static_cast<std::size_t>(count);
    }
    return this->Close();
  }

  void Rename() const { fs::rename(this->Path, this->Final); }

private:
  bool Close() { return this->Descriptor < 0 || close(std::exchange(this->Descriptor, -1)) == 0; }

  const fs::path Path;
  const fs::path Final;
  const SignalGuard Guard;
  int Descriptor;
};

// Writes to memory, because VTK 9.2 crashes if the file system is full. Binary mode, because the
// default, appended data, is not valid XML.
std::string GetText(vtkPolyData* data, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1 || writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    Fail(file, "VTK's error " + std::to_string(writer->GetErrorCode()));
  }
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
  const std::string text = GetText(data, file);
  TemporaryFile temporary(GetTarget(file));
  if (!temporary.Write(text))
  {
    Fail(file, std::generic_category().message(errno));
  }
  temporary.Rename();
}
