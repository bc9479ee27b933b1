// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief lms3dCorbaBenchmark: the time of the paper's fetch(), and how its clients slow down the
 * scanner.
 */
#include "ClientLoad.h"
#include "Punctuality.h"
#include "RawServer.h"
#include "Table.h"
#include "Timer.h"

#include "Client/lms3dScannerReference.h"
#include "ServerProcess.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace
{
constexpr CORBA::ULong Floats = 3 * 361 * 360;
constexpr std::size_t Bytes = Floats * sizeof(float);
constexpr double Rate = 10.0;
constexpr double Megabyte = 1e6;

struct Options
{
  double Seconds = 10.0;
  std::string CSVFile;
};

CORBA::ORB_ptr GetORB()
{
  static const CORBA::ORB_var orb = []
  {
    int none = 0;
    return CORBA::ORB_init(none, nullptr, "omniORB4");
  }();
  return orb;
}

// The roles of the processes that RunClients() starts.
void FetchByCorba(const std::string& url, const std::string& start, const std::string& seconds)
{
  const LMS3D::LaserScanner_var scanner = lms3dFindScanner(GetORB(), url);
  RunClient(start, seconds,
    [&scanner]
    {
      const LMS3D::Data_var data = scanner->fetch();
      if (data->length() != Floats)
      {
        throw std::runtime_error("the scan has an unexpected size");
      }
    });
}

void FetchRaw(const std::string& port, const std::string& start, const std::string& seconds)
{
  RawClient client(std::stoi(port), Bytes);
  RunClient(start, seconds, [&client] { client.Fetch(); });
}

double MeasureCopy(double seconds)
{
  const std::vector<char> from(Bytes, 'x');
  std::vector<char> to(Bytes);
  volatile char seen = 0;
  return GetBestMilliseconds(1000.0 * seconds,
    [&]
    {
      std::memcpy(to.data(), from.data(), Bytes);
      seen = to[Bytes / 2];
    });
}

class Report
{
public:
  Report(double copy, double seconds)
    : Copy(copy)
    , Seconds(seconds)
  {
  }

  void AddCopy()
  {
    this->Results.AddRow({ "memcpy", "-", "-", "-", Table::Format(this->Copy, 3), "-", "-", "-",
      "1.0", "-", "-", "-", "-" });
  }

  /// Add the raw server's calls first for each number of clients.
  void AddCalls(
    const char* what, int clients, const std::vector<double>& times, const Punctuality& loop)
  {
    const Quantiles ms(times);
    const bool isRaw = std::strcmp(what, "raw socket") == 0;
    this->Raw = isRaw ? ms.Median : this->Raw;
    const double perSecond = static_cast<double>(times.size()) / this->Seconds;
    Table::Row row = { what, std::to_string(clients), Table::Format(perSecond, 0),
      Table::Format(perSecond * Bytes / Megabyte, 0), Table::Format(ms.Median, 2),
      Table::Format(ms.Percentile99, 2), Table::Format(ms.Worst, 1),
      Table::Format(ms.Median / this->Raw, 2), Table::Format(ms.Median / this->Copy, 1) };
    this->Finish(row, loop);
  }

  void AddIdle(const Punctuality& loop)
  {
    this->Finish({ "none", "0", "-", "-", "-", "-", "-", "-", "-" }, loop);
  }

  void Print(const std::string& file)
  {
    this->Results.Print();
    if (!file.empty())
    {
      this->Results.Save(file);
    }
  }

private:
  void Finish(Table::Row row, const Punctuality& loop)
  {
    const Quantiles late(loop.GetLateness(Rate));
    row.insert(row.end(),
      { Table::Format(loop.GetScansPerSecond(), 2), Table::Format(late.Median, 2),
        Table::Format(late.Percentile99, 2), Table::Format(late.Worst, 1) });
    this->Results.AddRow(row);
  }

  const double Copy;
  const double Seconds;
  double Raw = 0.0;
  Table Results{ { "calls", "clients", "calls/s", "MB/s", "ms median", "ms 99 %", "ms worst",
    "x raw", "x memcpy", "scans/s", "late ms median", "late ms 99 %", "late ms worst" } };
};

void Measure(const Options& options)
{
  std::printf(
    "corba: fetch() of 361 x 360 beams, %zu bytes, from a server at %g scans a second\n\n", Bytes,
    Rate);
  const ServerProcess server({ "--rate", std::to_string(Rate) });
  const RawServer raw(Bytes);
  const LMS3D::LaserScanner_var scanner = lms3dFindScanner(GetORB(), server.GetCorbaloc());

  Report report(MeasureCopy(1.0), options.Seconds);
  report.AddCopy();
  {
    Punctuality loop(scanner);
    std::this_thread::sleep_for(std::chrono::duration<double>(options.Seconds));
    loop.Stop();
    report.AddIdle(loop);
  }
  const auto load = [&](const char* what, int clients, const std::vector<std::string>& arguments)
  {
    Punctuality loop(scanner);
    const std::vector<double> times = RunClients(clients, arguments, options.Seconds);
    loop.Stop();
    report.AddCalls(what, clients, times, loop);
  };
  for (const int clients : { 1, 8, 64 })
  {
    load("raw socket", clients, { "--raw", std::to_string(raw.GetPort()) });
    load("fetch()", clients, { "--fetch", server.GetCorbaloc() });
  }
  report.Print(options.CSVFile);
}

Options ReadOptions(const std::vector<std::string>& words)
{
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (words[i] == "--quick")
    {
      options.Seconds = 2.0;
    }
    else if (words[i] == "--csv" && i + 1 < words.size())
    {
      options.CSVFile = words[++i];
    }
    else
    {
      throw std::invalid_argument("unknown argument \"" + words[i] + "\"");
    }
  }
  return options;
}

void Run(const std::vector<std::string>& words)
{
  const bool isClient = words.size() == 4;
  if (isClient && words[0] == "--fetch")
  {
    FetchByCorba(words[1], words[2], words[3]);
  }
  else if (isClient && words[0] == "--raw")
  {
    FetchRaw(words[1], words[2], words[3]);
  }
  else
  {
    Measure(ReadOptions(words));
  }
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    Run({ argv + 1, argv + argc });
    return 0;
  }
  catch (const std::invalid_argument& problem)
  {
    std::fprintf(stderr, "%s; usage: ./run bench corba [--quick] [--csv FILE]\n", problem.what());
    return 2;
  }
  catch (const std::exception& problem)
  {
    std::fprintf(stderr, "%s\n", problem.what());
  }
  catch (const CORBA::Exception& problem)
  {
    std::fprintf(stderr, "the ORB failed: %s\n", problem._name());
  }
  return 1;
}
