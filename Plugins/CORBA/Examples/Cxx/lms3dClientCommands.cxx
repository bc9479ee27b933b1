// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientCommands.h"

#include "lms3dClientFiles.h"
#include "lms3dClientListener.h"
#include "Client/lms3dRemoteData.h"
#include "Client/lms3dRemoteScan.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace
{
using Words = std::vector<std::string>;

constexpr CORBA::ULong WaitMilliseconds = 5000;
constexpr std::chrono::milliseconds PauseTime(500);

void Print(const LMS3D::ScanHeader& header)
{
  const LMS3D::Vector3& position = header.sensorPose.position;
  std::cout << "scan " << header.number << " (generation " << header.generation << ") of "
            << header.scene << " from " << position.x << ' ' << position.y << ' ' << position.z
            << ": " << header.returns << " of " << header.beams << " beams returned, map of "
            << header.mapTriangles << " triangles, "
            << static_cast<double>(header.endTime - header.startTime) * 1e-6 << " ms" << std::endl;
}

void PrintStatus(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  const LMS3D::Status_var status = scanner->getStatus();
  const LMS3D::Scene_var scene = scanner->getScene();
  std::cout << "LMS3D " << status->version << ", " << status->newest << " scans, "
            << status->lateScans << " late, rate " << status->rate << " Hz"
            << (status->isReadOnly ? ", read-only" : "") << '\n'
            << "scene " << scene->name << ", " << scene->triangles << " triangles\n";
  if (*status->problem)
  {
    std::cout << "no scan: " << status->problem << '\n';
  }
  if (status->newest != 0)
  {
    const LMS3D::ScanHeader_var header = scanner->getHeader();
    Print(header);
  }
}

void PrintScenes(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::SceneNames_var names = scanner->listScenes();
  for (CORBA::ULong i = 0; i < names->length(); ++i)
  {
    std::cout << names[i] << '\n';
  }
}

// The way of 2008; Clients/Paper does it without knowing anything else.
void Fetch(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::Data_var triples = scanner->fetch();
  std::cout.precision(std::numeric_limits<CORBA::Float>::max_digits10);
  std::cout << "r, m\talpha, deg\tbeta, deg\n";
  for (CORBA::ULong i = 0; i + 2 < triples->length(); i += 3)
  {
    std::cout << triples[i] << '\t' << triples[i + 1] << '\t' << triples[i + 2] << '\n';
  }
}

// As long as the server lives and has not given up: the next scan may be a long time off.
LMS3D::ScanHeader_var WaitForScan(
  LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong after, CORBA::ULongLong generation)
{
  for (;;)
  {
    try
    {
      return lms3dWaitForScan(scanner, after, generation, WaitMilliseconds, PauseTime);
    }
    catch (const LMS3D::NoScanYet&)
    {
      const LMS3D::Status_var status = scanner->getStatus();
      if (*status->problem)
      {
        throw std::runtime_error(std::string("the server has no scan: ") + status->problem.in());
      }
      if (status->newest < after || status->generation < generation)
      {
        throw std::runtime_error("the server was started anew");
      }
    }
  }
}

// The server drops old scans, so that a slow client may come too late for a part.
lms3dRemoteScan FetchNewest(LMS3D::LaserScanner_ptr scanner)
{
  constexpr int Tries = 5;
  for (int i = 1;; ++i)
  {
    try
    {
      const LMS3D::ScanHeader_var header = WaitForScan(scanner, 0, 0);
      return lms3dFetchScan(scanner, header);
    }
    catch (const LMS3D::ScanGone&)
    {
      if (i == Tries)
      {
        throw;
      }
    }
  }
}

void Save(LMS3D::LaserScanner_ptr scanner, const Words& files)
{
  const lms3dRemoteScan remote = FetchNewest(scanner);
  vtkNew<vtkPolyData> scan;
  lms3dFillScan(remote, scan);
  lms3dWriteFile(scan, files[0]);
  if (files.size() > 1)
  {
    vtkNew<vtkPolyData> map;
    lms3dFillMap(remote, map);
    lms3dWriteFile(map, files[1]);
  }
  Print(remote.Header);
}

lms3dClientCommand ReadSave(const Words& files)
{
  lms3dCheckFiles(files);
  return [files](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner) { Save(scanner, files); };
}

// "1e999" and "12x" are no numbers, "-1" is no count; the rest is for the server to judge.
template <typename Number>
Number GetNumber(const char* name, const std::string& word, const char* kind)
{
  Number number{};
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end)
  {
    throw std::invalid_argument(std::string(name) + ": \"" + word + "\" is not " + kind);
  }
  return number;
}

CORBA::ULongLong GetCount(const Words& words)
{
  return words.empty()
    ? ~CORBA::ULongLong(0)
    : GetNumber<CORBA::ULongLong>("COUNT", words[0], "a whole number, 0 or more");
}

LMS3D::Vector3 GetVector(
  const std::array<const char*, 3>& names, const Words& words, std::size_t first)
{
  const auto get = [&](std::size_t axis)
  { return GetNumber<double>(names[axis], words[first + axis], "a number"); };
  return { get(0), get(1), get(2) };
}

void Watch(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong count)
{
  CORBA::ULongLong last = 0;
  for (; count > 0; --count)
  {
    const LMS3D::ScanHeader_var header = WaitForScan(scanner, last, 0);
    Print(header);
    last = header->number;
  }
}

lms3dClientCommand ReadWatch(const Words& words)
{
  return [count = GetCount(words)](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { Watch(scanner, count); };
}

lms3dClientCommand ReadListen(const Words& words)
{
  return [count = GetCount(words)](CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner)
  { lms3dListenToScanner(orb, scanner, count, Print); };
}

void PrintFirst(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong generation)
{
  const LMS3D::ScanHeader_var header = WaitForScan(scanner, 0, generation);
  Print(header);
}

// The orientation stays where none is given.
void SetPose(LMS3D::LaserScanner_ptr scanner, const LMS3D::Vector3& position,
  const std::optional<LMS3D::Vector3>& orientation)
{
  LMS3D::Pose pose = scanner->getPose();
  pose.position = position;
  pose.orientation = orientation.value_or(pose.orientation);
  PrintFirst(scanner, scanner->setPose(pose));
}

lms3dClientCommand ReadPose(const Words& words)
{
  const LMS3D::Vector3 position = GetVector({ "X", "Y", "Z" }, words, 0);
  std::optional<LMS3D::Vector3> orientation;
  if (words.size() == 6)
  {
    orientation = GetVector({ "RX", "RY", "RZ" }, words, 3);
  }
  return [position, orientation](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { SetPose(scanner, position, orientation); };
}

lms3dClientCommand ReadScene(const Words& words)
{
  return [name = words[0]](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { PrintFirst(scanner, scanner->selectScene(name.c_str())); };
}

// A command without words.
template <void (*Run)(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr)>
lms3dClientCommand ReadNothing(const Words&)
{
  return Run;
}

struct Command
{
  const char* Name;
  const char* Values;
  const char* Help;
  std::vector<std::size_t> Counts;
  lms3dClientCommand (*Read)(const Words&);
};

const std::vector<Command>& GetCommands()
{
  static const std::vector<Command> commands = {
    { "status", "", "what the server does, and its newest scan", { 0 }, ReadNothing<PrintStatus> },
    { "scenes", "", "the scenes to choose from", { 0 }, ReadNothing<PrintScenes> },
    { "scene", "NAME", "choose one, and wait for its first scan", { 1 }, ReadScene },
    { "pose", "X Y Z [RX RY RZ]",
      "move the sensor (metres, degrees), and wait for a scan from there", { 3, 6 }, ReadPose },
    { "fetch", "", "range, alpha and beta of each beam, a line each", { 0 }, ReadNothing<Fetch> },
    { "save", "SCAN.vtp [MAP.vtp]", "the newest scan and its local map as VTK files", { 1, 2 },
      ReadSave },
    { "watch", "[COUNT]", "a line for each scan, waiting for the next (long poll)", { 0, 1 },
      ReadWatch },
    { "listen", "[COUNT]", "the same as a listener; the server has to allow --callbacks", { 0, 1 },
      ReadListen },
  };
  return commands;
}
} // namespace

std::string lms3dGetClientHelp()
{
  std::string help = "Usage: lms3d-client SCANNER COMMAND [-ORBNAME VALUE ...]\n\n"
                     "SCANNER: the file of --ior, an IOR, a corbaloc or a corbaname\n\n";
  for (const Command& command : GetCommands())
  {
    help.append("  ").append(command.Name).append(" ").append(command.Values).append("\n      ");
    help.append(command.Help).append("\n");
  }
  return help;
}

lms3dClientCommand lms3dReadClientCommand(const std::string& name, const Words& words)
{
  const std::vector<Command>& commands = GetCommands();
  const auto command = std::find_if(commands.begin(), commands.end(),
    [&name](const Command& candidate) { return name == candidate.Name; });
  if (command == commands.end() ||
    std::find(command->Counts.begin(), command->Counts.end(), words.size()) ==
      command->Counts.end())
  {
    return nullptr;
  }
  return command->Read(words);
}
