// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dCallRetries.h"
#include "Common/lms3dLog.h"
#include "Common/lms3dORBLog.h"
#include "Common/lms3dVersion.h"
#include "Options/lms3dORBSettings.h"
#include "Options/lms3dServerOptions.h"
#include "Scanning/lms3dLogWindow.h"
#include "lms3dExitLimit.h"
#include "lms3dServer.h"
#include "lms3dStopSignal.h"

#include <omniORB4/minorCode.h>

#include <malloc.h>
#include <sys/resource.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr int ExitFailure = 1;
constexpr int ExitUsage = 2;

// If file descriptors run out, omniORB accepts no more connections and spins.
void AllowManyConnections()
{
  // lms3dGetORBSettings() allows 2,000 connections with a thread of their own.
  constexpr rlim_t MinimumFiles = 2100;
  rlimit limit = {};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0)
  {
    return;
  }
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_max < MinimumFiles)
  {
    lms3dLog("warning: the system allows " + std::to_string(limit.rlim_max) +
      " open files, and each connection is one. If they run out, new clients wait until idle " +
      "connections are closed. To allow more: ulimit -n " + std::to_string(MinimumFiles));
  }
}

// malloc_trim() leaves out the highest free block of each arena. Its default limit grows with the
// blocks that are freed, up to 64 MB. Blocks that exceed the second limit have pages of their own.
void LimitFreeMemory()
{
  constexpr int Megabyte = 1 << 20;
  mallopt(M_TRIM_THRESHOLD, 8 * Megabyte);
  mallopt(M_MMAP_THRESHOLD, 4 * Megabyte);
}

// omniORB makes each nil reference at its first use, and another thread may read it before it is
// complete. Here no other thread runs yet.
void MakeNilReferences()
{
  CORBA::Object::_nil();
  LMS3D::ScanListener::_nil();
}

CORBA::ORB_ptr MakeORB(const lms3dServerOptions& options)
{
  std::vector<std::string> logSettings = options.ORBArguments;
  logSettings.push_back(options.Endpoint);
  lms3dSetORBLog(lms3dLog, logSettings);
  lms3dLimitRetries();

  const lms3dORBSettings settings = lms3dGetORBSettings(options);
  std::vector<const char*> table;
  for (const auto& setting : settings)
  {
    table.insert(table.end(), { setting.first.c_str(), setting.second.c_str() });
  }
  table.insert(table.end(), { nullptr, nullptr });

  std::vector<std::string> arguments = { "lms3d-server" };
  arguments.insert(arguments.end(), options.ORBArguments.begin(), options.ORBArguments.end());
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments)
  {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  int count = static_cast<int>(arguments.size());
  MakeNilReferences();
  using Table = const char*(*)[2];
  return CORBA::ORB_init(count, pointers.data(), "omniORB4", reinterpret_cast<Table>(table.data()));
}

// Destroys the ORB before the server, because clients may call the server's object until then, even
// if the start fails half-way. The ORB waits for each answer to a client, and a client may send
// requests without reading the answers.
class RunningServer
{
public:
  RunningServer(
    const lms3dServerOptions& options, const lms3dStopTest& isStopped, lms3dExitLimit& limit)
    : Limit(limit)
    , Server(options, isStopped)
    , ORB(MakeORB(options))
  {
  }
  ~RunningServer()
  {
    this->Limit.Begin(std::uncaught_exceptions() == 0 ? 0 : ExitFailure);
    this->Server.Stop();
    this->ORB->destroy();
  }
  RunningServer(const RunningServer&) = delete;
  void operator=(const RunningServer&) = delete;

  void Start() { this->Server.Start(this->ORB); }

private:
  lms3dExitLimit& Limit;
  lms3dServer Server;
  const CORBA::ORB_var ORB;
};

void Serve(const lms3dServerOptions& options)
{
  lms3dExitLimit limit;
  const lms3dStopSignal signal([&limit] { limit.Begin(0); });
  lms3dLogVTKMessages();
  AllowManyConnections();
  LimitFreeMemory();
  try
  {
    RunningServer server(
      options, [&signal] { return signal.IsPending(); }, limit);
    server.Start();
    lms3dLog(signal.Wait() + ": ending");
  }
  catch (const lms3dReadingStopped&)
  {
    lms3dLog(signal.Wait() + ": ending before the scene was read");
  }
  lms3dLog("ended");
}

std::string Describe(const CORBA::SystemException& problem)
{
  // Null for codes that omniORB does not define.
  const char* const detail = problem.NP_minorString();
  return problem._name() + (detail ? std::string(", ") + detail : "");
}

// Explains what the ORB's own lines of the log do not.
std::string GetHint(const CORBA::SystemException& problem, const lms3dServerOptions& options)
{
  const bool isEndpoint = problem.minor() == omni::INITIALIZE_TransportError;
  return isEndpoint && options.TLSKey.empty() ? "; is the endpoint in use?" : "";
}

int Print(const std::string& text)
{
  std::cout << text << std::flush;
  if (!std::cout)
  {
    std::cerr << "lms3d-server: the standard output cannot be written\n";
    return ExitFailure;
  }
  return 0;
}

int Run(const lms3dServerOptions& options)
{
  if (options.Help || options.Version)
  {
    return Print(options.Help ? lms3dGetServerHelp() : std::string(lms3dVersion) + '\n');
  }
  lms3dCheckEndpointSources(options);
  try
  {
    Serve(options);
    return 0;
  }
  catch (const CORBA::SystemException& problem)
  {
    lms3dLog("the ORB failed: " + Describe(problem) + GetHint(problem, options));
  }
  catch (const CORBA::Exception& problem)
  {
    lms3dLog(std::string("the ORB failed: ") + problem._name());
  }
  catch (const omniORB::fatalException& problem)
  {
    lms3dLog(std::string("the ORB failed: ") + problem.errmsg());
  }
  catch (const std::exception& problem)
  {
    lms3dLog(problem.what());
  }
  return ExitFailure;
}
} // namespace

int main(int argc, char* argv[])
{
  int code = ExitUsage;
  try
  {
    code = Run(lms3dReadServerOptions({ argv + 1, argv + argc }));
  }
  catch (const std::invalid_argument& problem)
  {
    std::cerr << "lms3d-server: " << problem.what() << '\n';
  }
  lms3dFinishORBLog();
  lms3dFinishLog();
  return code;
}
