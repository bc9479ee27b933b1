// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The options of lms3d-server, from its command line and its configuration files.
 */
#ifndef lms3dServerOptions_h
#define lms3dServerOptions_h

#include "LMS3DScanner.hh"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// The values of all options. lms3dGetServerHelp() describes each of them.
struct lms3dServerOptions
{
  std::string Scenes;
  std::string Scene;
  /// Metres, world coordinates.
  std::array<double, 3> Position = { 0.0, 0.0, 0.0 };
  /// Degrees about x, y and z, as vtkProp3D applies them.
  std::array<double, 3> Orientation = { 0.0, 0.0, 0.0 };
  /// The name of a preset.
  std::string Device = "ideal";
  /// What the options of single properties change of the preset, in their order.
  std::vector<std::function<void(LMS3D::Device&)>> DeviceChanges;
  /// Scans per second. 0: without pauses.
  double Rate = 10.0;
  /// Metres.
  double MapError = 0.01;
  /// The error bound of the map of many scans, metres. 0: no such map.
  double FusedMapError = 0.0;
  /// The memory of this map, megabytes.
  std::int64_t FusedMemory = 1000;
  /// 0: all cores.
  int Threads = 0;
  int Keep = 4;
  ///@{
  /// Limits for reading a scene. 0: the reader's default.
  std::int64_t SceneNodes = 0;
  std::int64_t SceneTriangles = 0;
  /// Megabytes.
  std::int64_t SceneMemory = 0;
  std::int64_t SceneSize = 0;
  ///@}

  std::string Endpoint = "giop:tcp:127.0.0.1:";
  std::string TLSKey;
  std::string TLSAuthorities;
  std::string IORFile;
  std::string NamingService;
  std::string Name = "LMS3D.Scanner";
  /// Each "ADDRESS/MASK".
  std::vector<std::string> ConnectTo;
  /// Options of omniORB: a name that begins with -ORB, its value, the next name and so on.
  std::vector<std::string> ORBArguments;

  bool IsYUp = false;
  bool MakeMap = true;
  bool AllowRemote = false;
  bool Naming = false;
  bool ReadOnly = false;
  bool Callbacks = false;
  bool Help = false;
  bool Version = false;
};

/**
 * Reads the files that --config names, then the command line, whose values overrule the files'.
 * `arguments` are without the program's name. Throws std::invalid_argument with the option or the
 * line of a file, the wrong value and what is expected.
 */
lms3dServerOptions lms3dReadServerOptions(const std::vector<std::string>& arguments);

/// The text of --help.
std::string lms3dGetServerHelp();

#endif
