// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeparateProcess.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
// Ends this process without what is done at the end of one, which its parent will do.
[[noreturn]] void WorkAndEnd(
  const std::function<std::vector<double>()>& work, unsigned int maximumSeconds, int pipe)
{
  int status = EXIT_FAILURE;
  alarm(maximumSeconds);
  if (std::freopen("/dev/null", "w", stdout) && std::freopen("/dev/null", "w", stderr))
  {
    try
    {
      const std::vector<double> numbers = work();
      std::FILE* file = fdopen(pipe, "wb");
      const bool isWritten =
        std::fwrite(numbers.data(), sizeof(double), numbers.size(), file) == numbers.size();
      status = std::fclose(file) == 0 && isWritten ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    catch (const std::exception&)
    {
      status = EXIT_FAILURE;
    }
  }
  _exit(status);
}

std::vector<double> ReadNumbers(int pipe)
{
  std::vector<double> numbers;
  std::array<double, 1024> part;
  std::FILE* file = fdopen(pipe, "rb");
  while (const std::size_t count = std::fread(part.data(), sizeof(double), part.size(), file))
  {
    numbers.insert(numbers.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
  }
  std::fclose(file);
  return numbers;
}

std::string GetFailure(int status)
{
  if (WIFSIGNALED(status))
  {
    return WTERMSIG(status) == SIGALRM ? "does not end" : strsignal(WTERMSIG(status));
  }
  return WEXITSTATUS(status) == EXIT_SUCCESS ? "" : "fails";
}
} // namespace

SeparateResult RunSeparately(
  const std::function<std::vector<double>()>& work, unsigned int maximumSeconds)
{
  std::fflush(nullptr);
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("no pipe to another process");
  }
  const pid_t child = fork();
  if (child < 0)
  {
    throw std::runtime_error("no other process");
  }
  if (child == 0)
  {
    close(ends[0]);
    WorkAndEnd(work, maximumSeconds, ends[1]);
  }
  close(ends[1]);
  SeparateResult result = { ReadNumbers(ends[0]), "" };
  int status = 0;
  waitpid(child, &status, 0);
  result.Failure = GetFailure(status);
  return result;
}
