// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What lms3d-server is started with: the command line and the configuration file.
 */
#ifndef lms3dServerOptions_h
#define lms3dServerOptions_h

#include <array>
#include <string>
#include <vector>

/// lms3dGetServerHelp() tells what each is for.
struct lms3dServerOptions
{
  std::string Scenes;
  std::string Scene;
  bool IsYUp = false;
  std::array<double, 3> Position = { 0.0, 0.0, 0.0 };
  std::array<double, 3> Orientation = { 0.0, 0.0, 0.0 };
  double Rate = 10.0;
  double MapError = 0.01;
  bool MakeMap = true;
  int Threads = 0;
  int Keep = 4;

  std::string Endpoint = "giop:tcp:127.0.0.1:";
  bool AllowRemote = false;
  std::string TLSKey;
  std::string TLSAuthorities;
  std::string IORFile;
  bool Naming = false;
  std::string NamingService;
  std::string Name = "LMS3D.Scanner";

  bool ReadOnly = false;
  bool Callbacks = false;
  std::vector<std::string> ConnectTo;

  bool Help = false;
  bool Version = false;
  /// Names that begin with -ORB and their values, for the ORB.
  std::vector<std::string> ORBArguments;
};

/// Reads the configuration file that --config names, then the other arguments, which win. Throws
/// std::invalid_argument with what is wrong and where.
lms3dServerOptions lms3dReadServerOptions(const std::vector<std::string>& arguments);

std::string lms3dGetServerHelp();

/// True where nobody from another machine can reach "giop:TRANSPORT:HOST:PORT".
bool lms3dIsLocalEndpoint(const std::string& endpoint);

#endif
