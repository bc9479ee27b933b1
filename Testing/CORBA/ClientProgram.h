// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Runs the example clients as programs, and reads their results.
 */
#ifndef ClientProgram_h
#define ClientProgram_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// An example client. Its arguments are the scanner's reference, a command and the command's
/// values.
struct Client
{
  std::vector<std::string> Program;
  std::vector<std::string> Command;
  /// The client expects the path of a file with an IOR.
  bool TakesFile = false;
};

struct Outcome
{
  int Code;
  /// Standard output and standard error. A successful client prints only its result.
  std::string Text;
};

Outcome RunClient(
  const Client& client, const std::string& reference, const std::vector<std::string>& values = {});

/// Reads three numbers per line. If there is other text, fails the test and returns nothing.
std::vector<float> ReadTable(const Outcome& outcome);

struct Map
{
  std::vector<double> Points;
  std::vector<std::uint32_t> Triangles;
};

/// Reads a Wavefront OBJ file, which counts points from 1.
Map ReadMap(const std::filesystem::path& path);

/// The name of a temporary file. The destructor removes the file.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& name);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  void operator=(const TemporaryFile&) = delete;

  const std::filesystem::path Path;
};

#endif
