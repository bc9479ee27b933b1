// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientLoad.h"

#include "Timer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include <unistd.h>

namespace
{
using Clock = std::chrono::steady_clock;

double GetSeconds()
{
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// Time that processes need before their first call.
double GetStartingSeconds(int count)
{
  return 1.0 + 0.05 * count;
}

std::vector<double> ReadNumbers(std::FILE* pipe)
{
  std::vector<double> numbers;
  for (double number; std::fread(&number, sizeof(number), 1, pipe) == 1;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

std::string Quote(const std::string& word)
{
  return " '" + word + "'";
}
} // namespace

Quantiles::Quantiles(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const auto at = [&values](double share)
  {
    return values.empty() ? std::nan("")
                          : values[static_cast<std::size_t>(share * (values.size() - 1))];
  };
  this->Median = at(0.5);
  this->Percentile99 = at(0.99);
  this->Worst = at(1.0);
}

std::vector<double> RunClients(int count, const std::vector<std::string>& arguments, double seconds)
{
  std::string command = "exec /proc/" + std::to_string(getpid()) + "/exe";
  for (const std::string& argument : arguments)
  {
    command.append(Quote(argument));
  }
  command +=
    ' ' + std::to_string(GetSeconds() + GetStartingSeconds(count)) + ' ' + std::to_string(seconds);
  std::vector<std::FILE*> clients(count);
  std::generate(clients.begin(), clients.end(), [&command] { return popen(command.c_str(), "r"); });
  std::vector<double> all;
  bool isWell = true;
  for (std::FILE* client : clients)
  {
    const std::vector<double> times = ReadNumbers(client);
    all.insert(all.end(), times.begin(), times.end());
    isWell = pclose(client) == 0 && isWell;
  }
  if (!isWell)
  {
    throw std::runtime_error("a client failed");
  }
  return all;
}

void RunClient(
  const std::string& start, const std::string& seconds, const std::function<void()>& call)
{
  call(); // connects
  const double begin = std::stod(start);
  const double end = begin + std::stod(seconds);
  std::this_thread::sleep_for(std::chrono::duration<double>(begin - GetSeconds()));
  std::vector<double> times;
  while (GetSeconds() < end)
  {
    times.push_back(GetMilliseconds(call));
  }
  std::fwrite(times.data(), sizeof(double), times.size(), stdout);
}
