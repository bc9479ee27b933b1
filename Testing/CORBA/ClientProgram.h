// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The example clients as programs of their own, and what they print and save.
 */
#ifndef ClientProgram_h
#define ClientProgram_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// An example client. Its arguments are the scanner's reference, a command and the command's values.
struct Client
{
  std::vector<std::string> Program;
  std::vector<std::string> Command;
  /// The reference is the file of an IOR.
  bool TakesFile = false;
};

struct Outcome
{
  int Code;
  /// Both outputs: a client that succeeds writes its result and nothing else.
  std::string Text;
};

Outcome RunClient(
  const Client& client, const std::string& reference, const std::vector<std::string>& values = {});

/// Three numbers a line. Empty, with a test failure, where there is anything else.
std::vector<float> ReadTable(const Outcome& outcome);

struct Map
{
  std::vector<double> Points;
  std::vector<std::uint32_t> Triangles;
};

/// From a Wavefront OBJ file, which counts points from 1.
Map ReadMap(const std::filesystem::path& path);

/// A name for a file of the test's own, which is removed at its end.
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
