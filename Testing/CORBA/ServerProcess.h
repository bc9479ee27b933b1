// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A real lms3d-server, for tests.
 */
#ifndef ServerProcess_h
#define ServerProcess_h

#include <chrono>
#include <string>
#include <vector>

#include <sys/types.h>

/// The threads of the filters, of servers and beside them; 0: all cores. TBB's library is not made
/// for ThreadSanitizer.
#ifdef __SANITIZE_THREAD__
constexpr int FilterThreads = 1;
#else
constexpr int FilterThreads = 0;
#endif

/// Runs until Terminate(), or is killed at the end of the test.
class ServerProcess
{
public:
  /// Starts it on Data/room.wrl, unless `arguments` say otherwise, and waits until it is ready. A
  /// test failure where it does not become so.
  explicit ServerProcess(const std::vector<std::string>& arguments = {});
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  void operator=(const ServerProcess&) = delete;

  const std::string& GetCorbaloc() const { return this->Corbaloc; }
  const std::string& GetIOR() const { return this->IOR; }
  pid_t GetProcess() const { return this->Process; }

  /// The exit code after a signal, -1 where the signal itself ended it.
  int Terminate(int signal);

  /// SIGTERM ends it soon, with code 0; else a test failure.
  void ExpectPromptEnd();

  /// Bytes.
  long GetResidentMemory() const;

private:
  std::string ReadLine(int pipe) const;

  pid_t Process = -1;
  std::string Corbaloc;
  std::string IOR;
};

/// A port of 127.0.0.1 that nobody has at the moment.
int FindFreePort();

#endif
