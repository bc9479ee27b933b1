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

/// NumberOfThreads of the filters, in servers and in the tests. 0: all cores. TBB's library is not
/// made for ThreadSanitizer.
#ifdef __SANITIZE_THREAD__
constexpr int FilterThreads = 1;
#else
constexpr int FilterThreads = 0;
#endif

/// A server that runs until Terminate(). The destructor kills it.
class ServerProcess
{
public:
  /// Starts the server with Data/room.wrl, unless `arguments` name another scene, and waits until
  /// it is ready. Fails the test if it does not become ready.
  explicit ServerProcess(const std::vector<std::string>& arguments = {});
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  void operator=(const ServerProcess&) = delete;

  const std::string& GetCorbaloc() const { return this->Corbaloc; }
  const std::string& GetIOR() const { return this->IOR; }
  pid_t GetProcess() const { return this->Process; }

  /// Sends a signal. Returns the exit code, or -1 if the signal killed the process.
  int Terminate(int signal);

  /// Fails the test unless SIGTERM ends the server soon, with code 0.
  void ExpectPromptEnd();

  /// Bytes.
  long GetResidentMemory() const;

private:
  std::string ReadLine(int pipe) const;

  pid_t Process = -1;
  std::string Corbaloc;
  std::string IOR;
};

/// A port of 127.0.0.1 that is free at the moment.
int FindFreePort();

#endif
