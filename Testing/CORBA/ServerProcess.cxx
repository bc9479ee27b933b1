// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>

#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
// Until the server ends. ThreadSanitizer makes everything ten times as slow.
#ifdef __SANITIZE_THREAD__
constexpr double MaximumSeconds = 10.0;
#else
constexpr double MaximumSeconds = 1.5;
#endif

std::vector<std::string> Complete(const std::vector<std::string>& arguments)
{
  std::vector<std::string> all = { LMS3D_SERVER, "--scenes", LMS3D_DATA_DIR, "--scene", "room.wrl",
    "--position", "0.3", "-0.2", "1", "--threads", std::to_string(FilterThreads) };
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}
} // namespace

ServerProcess::ServerProcess(const std::vector<std::string>& arguments)
{
  std::vector<std::string> words = Complete(arguments);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);

  int output[2];
  if (pipe(output) != 0)
  {
    ADD_FAILURE() << "no pipe";
    return;
  }
  this->Process = fork();
  if (this->Process == 0)
  {
    // So that it does not outlive a test program that crashes.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(output[1], STDOUT_FILENO);
    close(output[0]);
    close(output[1]);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  close(output[1]);
  this->Corbaloc = this->ReadLine(output[0]);
  this->IOR = this->ReadLine(output[0]);
  close(output[0]);
  EXPECT_EQ(this->Corbaloc.rfind("corbaloc:", 0), 0u) << "the server is not ready";
  EXPECT_EQ(this->IOR.rfind("IOR:", 0), 0u);
}

ServerProcess::~ServerProcess()
{
  if (this->Process > 0)
  {
    this->Terminate(SIGKILL);
  }
}

std::string ServerProcess::ReadLine(int pipe) const
{
  std::string line;
  char character = 0;
  while (read(pipe, &character, 1) == 1 && character != '\n')
  {
    line.push_back(character);
  }
  return line;
}

int ServerProcess::Terminate(int signal)
{
  int status = 0;
  kill(this->Process, signal);
  waitpid(this->Process, &status, 0);
  this->Process = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void ServerProcess::ExpectPromptEnd()
{
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(this->Terminate(SIGTERM), 0);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), MaximumSeconds);
}

long ServerProcess::GetResidentMemory() const
{
  std::ifstream stream("/proc/" + std::to_string(this->Process) + "/statm");
  long size = 0;
  long resident = 0;
  stream >> size >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

int FindFreePort()
{
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  close(listener);
  return ntohs(address.sin_port);
}
