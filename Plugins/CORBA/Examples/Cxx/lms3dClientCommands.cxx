// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientCommands.h"

#include "lms3dClientActions.h"
#include "lms3dClientDevice.h"
#include "lms3dClientFiles.h"
#include "lms3dClientFusedMap.h"
#include "lms3dClientListener.h"
#include "lms3dClientNumbers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace
{
using Words = std::vector<std::string>;

CORBA::ULongLong GetCount(const Words& words)
{
  return words.empty()
    ? ~CORBA::ULongLong(0)
    : lms3dReadClientNumber<CORBA::ULongLong>("COUNT", words[0], "a whole number, 0 or more");
}

LMS3D::Vector3 GetVector(
  const std::array<const char*, 3>& names, const Words& words, std::size_t first)
{
  const auto get = [&](std::size_t axis)
  { return lms3dReadClientNumber<double>(names[axis], words[first + axis], "a number"); };
  return { get(0), get(1), get(2) };
}

lms3dClientCommand ReadSave(const Words& files)
{
  lms3dCheckFiles(files);
  return [files](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { lms3dSaveScan(scanner, files); };
}

lms3dClientCommand ReadFused(const Words& files)
{
  lms3dCheckFiles(files);
  return [file = files[0]](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { lms3dSaveFusedMap(scanner, file); };
}

lms3dClientCommand ReadGrow(const Words& words)
{
  return [count = GetCount(words)](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { lms3dWatchFusedMap(scanner, count); };
}

lms3dClientCommand ReadWatch(const Words& words)
{
  return [count = GetCount(words)](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { lms3dWatchScans(scanner, count); };
}

lms3dClientCommand ReadListen(const Words& words)
{
  return [count = GetCount(words)](CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner)
  { lms3dListenToScanner(orb, scanner, count, lms3dPrintHeader); };
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
  { lms3dMoveSensor(scanner, position, orientation); };
}

lms3dClientCommand ReadScene(const Words& words)
{
  return [name = words[0]](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { lms3dSelectScene(scanner, name); };
}

lms3dClientCommand ReadDevice(const Words& words)
{
  if (words.empty())
  {
    return [](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner) { lms3dPrintDevice(scanner); };
  }
  return [name = words[0]](CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
  { lms3dSelectPreset(scanner, name); };
}

lms3dClientCommand ReadSet(const Words& words)
{
  return [change = lms3dReadDeviceChange(words[0], { words.begin() + 1, words.end() })](
           CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner) { lms3dChangeDevice(scanner, change); };
}

// A command without arguments.
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
    { "status", "", "print what the server does, and its newest scan", { 0 },
      ReadNothing<lms3dPrintStatus> },
    { "scenes", "", "print the names of all scenes", { 0 }, ReadNothing<lms3dPrintScenes> },
    { "scene", "NAME", "select a scene, and wait for its first scan", { 1 }, ReadScene },
    { "pose", "X Y Z [RX RY RZ]",
      "move the sensor (metres, degrees), and wait for a scan from there", { 3, 6 }, ReadPose },
    { "presets", "", "print the names of all presets of the device", { 0 },
      ReadNothing<lms3dPrintPresets> },
    { "device", "[PRESET]",
      "print the properties of the device, or select a preset and wait for its first scan",
      { 0, 1 }, ReadDevice },
    { "set", "PROPERTY VALUE...",
      "set one of these properties (rangeNoise 0.005, axisOffset 0 0 0.1), and wait for a scan",
      { 2, 4 }, ReadSet },
    { "fetch", "", "print range, alpha and beta of each beam", { 0 },
      ReadNothing<lms3dPrintBeams> },
    { "save", "SCAN.vtp [MAP.vtp]", "save the newest scan and its local map as VTK files", { 1, 2 },
      ReadSave },
    { "fused", "MAP.vtp", "save the map of many scans; the server needs --fused-map", { 1 },
      ReadFused },
    { "grow", "[COUNT]", "print a line whenever that map changes, and fetch what changed", { 0, 1 },
      ReadGrow },
    { "reset", "", "begin that map anew, and wait for its first scan", { 0 },
      ReadNothing<lms3dResetFusedMap> },
    { "watch", "[COUNT]", "print a line for each scan; waits for the next one (long poll)",
      { 0, 1 }, ReadWatch },
    { "listen", "[COUNT]", "the same as a listener; the server needs --callbacks", { 0, 1 },
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
