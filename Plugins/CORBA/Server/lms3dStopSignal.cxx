// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dStopSignal.h"

#include <cerrno>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace
{
// A handler may hardly do more than write into a pipe.
int Pipe[2] = { -1, -1 };

void WriteSignal(int number)
{
  const int error = errno;
  const char byte = static_cast<char>(number);
  // A full pipe has told enough already.
  if (write(Pipe[1], &byte, 1) < 0)
  {
    errno = error;
  }
}
} // namespace

lms3dStopSignal::lms3dStopSignal()
{
  struct sigaction action = {};
  action.sa_handler = WriteSignal;
  action.sa_flags = SA_RESTART;
  if (pipe2(Pipe, O_CLOEXEC) != 0 || fcntl(Pipe[1], F_SETFL, O_NONBLOCK) != 0 ||
    sigaction(SIGTERM, &action, nullptr) != 0 || sigaction(SIGINT, &action, nullptr) != 0)
  {
    throw std::runtime_error("the signal handlers cannot be installed");
  }
}

std::string lms3dStopSignal::Wait() const
{
  char byte = 0;
  while (read(Pipe[0], &byte, 1) < 0 && errno == EINTR)
  {
  }
  return byte == SIGINT ? "SIGINT" : "SIGTERM";
}
