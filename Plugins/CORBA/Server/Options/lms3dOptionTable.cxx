// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dOptionTable.h"

#include "Options/lms3dDeviceOptions.h"
#include "Options/lms3dOptionValues.h"
#include "Options/lms3dServerOptions.h"

#include <CLI/CLI.hpp>

#include <stdexcept>

namespace
{
using Words = std::vector<std::string>;

// 0 has a meaning of its own, in any notation.
double ReadRate(const std::string& text)
{
  constexpr double MinimumRate = 0.001;
  constexpr double MaximumRate = 10000.0;
  const bool isZero = lms3dReadOption(text, 0.0, MaximumRate) == 0.0;
  return isZero ? 0.0 : lms3dReadOption(text, MinimumRate, MaximumRate);
}

std::int64_t ReadLimit(const std::string& text)
{
  // A million times this fits.
  constexpr std::int64_t Maximum = 1'000'000'000'000;
  return lms3dReadOption<std::int64_t>(text, 1, Maximum);
}

bool ReadIsYUp(const std::string& text)
{
  if (text != "file" && text != "y")
  {
    throw std::invalid_argument('"' + text + "\" is neither file nor y");
  }
  return text == "y";
}

// The order is that of the help text.
const lms3dOption Options[] = {
  { "--scenes", 1, "FOLDER", "folder of VRML files from which clients choose; required",
    [](lms3dServerOptions& o, const Words& w) { o.Scenes = w[0]; } },
  { "--scene", 1, "NAME", "first scene (default: the first of the folder)",
    [](lms3dServerOptions& o, const Words& w) { o.Scene = w[0]; } },
  { "--up-axis", 1, "file|y", "file: z is up in the files (default); y: turn them so that z is up",
    [](lms3dServerOptions& o, const Words& w) { o.IsYUp = ReadIsYUp(w[0]); } },
  { "--scene-nodes", 1, "N", "nodes of a scene, with each USE and instance (default 2000000)",
    [](lms3dServerOptions& o, const Words& w) { o.SceneNodes = ReadLimit(w[0]); } },
  { "--scene-triangles", 1, "N", "triangles of a scene (default 20000000)",
    [](lms3dServerOptions& o, const Words& w) { o.SceneTriangles = ReadLimit(w[0]); } },
  { "--scene-memory", 1, "MB", "memory for what is made of a scene's files (default 2000)",
    [](lms3dServerOptions& o, const Words& w) { o.SceneMemory = ReadLimit(w[0]); } },
  { "--scene-size", 1, "MB", "files of a scene together, unpacked (default 1000)",
    [](lms3dServerOptions& o, const Words& w) { o.SceneSize = ReadLimit(w[0]); } },
  { "--position", 3, "X Y Z", "position of the sensor, metres (default 0 0 0)",
    [](lms3dServerOptions& o, const Words& w) { o.Position = lms3dReadVector(w); } },
  { "--orientation", 3, "X Y Z", "its angles about the axes, degrees (default 0 0 0)",
    [](lms3dServerOptions& o, const Words& w) { o.Orientation = lms3dReadVector(w); } },
  { "--rate", 1, "HZ",
    "scans per second, 0.001 to 10000 (default 10); 0: no pauses, all cores;\n"
    "new settings begin a scan at once",
    [](lms3dServerOptions& o, const Words& w) { o.Rate = ReadRate(w[0]); } },
  { "--map-error", 1, "M", "error bound of the local map, metres (default 0.01)",
    [](lms3dServerOptions& o, const Words& w) { o.MapError = lms3dReadOption(w[0], 0.0, 1e6); } },
  { "--no-map", 0, "", "make no local maps until a client switches them on",
    [](lms3dServerOptions& o, const Words&) { o.MakeMap = false; } },
  { "--fused-map", 1, "M",
    "keep one map of all poses with this error bound, metres, 1e-4 to 1e6;\n"
    "it needs --map-error up to this (default: no such map)",
    [](lms3dServerOptions& o, const Words& w)
    { o.FusedMapError = lms3dReadOption(w[0], 1e-4, 1e6); } },
  { "--fused-memory", 1, "MB", "memory for this map, its ranges and its surface (default 1000)",
    [](lms3dServerOptions& o, const Words& w)
    { o.FusedMemory = lms3dReadOption<std::int64_t>(w[0], 1, 1'000'000); } },
  { "--threads", 1, "N", "threads of the filters (default 0: all cores)",
    [](lms3dServerOptions& o, const Words& w) { o.Threads = lms3dReadOption(w[0], 0, 1024); } },
  { "--keep", 1, "N", "scans to keep (default 4, within 1 GiB); more for slow networks",
    [](lms3dServerOptions& o, const Words& w) { o.Keep = lms3dReadOption(w[0], 1, 1000); } },
  { "--endpoint", 1, "URI",
    "where to listen, e.g. giop:tcp:127.0.0.1:2810\n(default: a free port of 127.0.0.1)",
    [](lms3dServerOptions& o, const Words& w) { o.Endpoint = w[0]; } },
  { "--allow-remote", 0, "", "accept an endpoint that other machines can reach",
    [](lms3dServerOptions& o, const Words&) { o.AllowRemote = true; } },
  { "--tls-key", 1, "FILE", "certificate and private key, PEM, for endpoints giop:ssl:HOST:PORT",
    [](lms3dServerOptions& o, const Words& w) { o.TLSKey = w[0]; } },
  { "--tls-authorities", 1, "FILE", "authorities that must have signed clients' certificates, PEM",
    [](lms3dServerOptions& o, const Words& w) { o.TLSAuthorities = w[0]; } },
  { "--ior", 1, "FILE", "write the object's reference to a file, and remove it at the end",
    [](lms3dServerOptions& o, const Words& w) { o.IORFile = w[0]; } },
  { "--naming", 0, "", "register with the ORB's own naming service (-ORBInitRef)",
    [](lms3dServerOptions& o, const Words&) { o.Naming = true; } },
  { "--naming-service", 1, "URI",
    "register with this one, e.g. corbaloc::127.0.0.1:2809/NameService",
    [](lms3dServerOptions& o, const Words& w)
    {
      o.Naming = true;
      o.NamingService = w[0];
    } },
  { "--name", 1, "NAME", "register under this name (default LMS3D.Scanner: id LMS3D, kind Scanner)",
    [](lms3dServerOptions& o, const Words& w) { o.Name = w[0]; } },
  { "--read-only", 0, "", "clients may read but change nothing",
    [](lms3dServerOptions& o, const Words&) { o.ReadOnly = true; } },
  { "--callbacks", 0, "", "clients may subscribe listeners, to which the server connects",
    [](lms3dServerOptions& o, const Words&) { o.Callbacks = true; } },
  { "--connect-to", 1, "ADDRESS/MASK",
    "hosts beside this one to which the server may connect,\n"
    "for listeners and the naming service; can be repeated",
    [](lms3dServerOptions& o, const Words& w) { o.ConnectTo.push_back(w[0]); } },
};

void AddFlag(CLI::App& app, const lms3dOption& option, lms3dServerOptions& options)
{
  app
    .add_flag_callback(
      option.Name, [&option, &options] { option.Set(options, {}); }, option.Help)
    ->disable_flag_override()
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

// Sets the option each time that it is given, so that the last value remains.
void AddValues(CLI::App& app, const lms3dOption& option, lms3dServerOptions& options)
{
  const auto set = [&option, &options](const Words& words)
  {
    try
    {
      option.Set(options, words);
      return true;
    }
    catch (const std::invalid_argument& problem)
    {
      throw CLI::ValidationError(option.Name, problem.what());
    }
  };
  app.add_option(option.Name, set, option.Help)
    ->option_text(option.Values)
    ->type_name(option.Values)
    ->type_size(option.Count)
    ->trigger_on_parse();
}

void AddOption(CLI::App& app, const lms3dOption& option, lms3dServerOptions& options)
{
  option.Count == 0 ? AddFlag(app, option, options) : AddValues(app, option, options);
}
} // namespace

void lms3dAddServerOptions(CLI::App& app, lms3dServerOptions& options)
{
  app.set_help_flag();
  for (const lms3dOption& option : Options)
  {
    AddOption(app, option, options);
  }
  for (const lms3dOption& option : lms3dGetDeviceOptions())
  {
    AddOption(app, option, options);
  }
}
