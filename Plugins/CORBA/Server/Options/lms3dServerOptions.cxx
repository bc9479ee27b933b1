// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dServerOptions.h"

#include "lms3dOptionSources.h"
#include "lms3dOptionValues.h"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace
{
using Words = lms3dOptionSetting::Words;

// 0, however it is written, has a meaning of its own.
double GetRate(const std::string& text)
{
  constexpr double Fastest = 10000.0;
  return lms3dGetNumber(text, 0.0, Fastest) == 0.0 ? 0.0 : lms3dGetNumber(text, 0.001, Fastest);
}

struct Option
{
  const char* Name;
  /// Words that follow.
  std::size_t Count;
  const char* Values;
  const char* Help;
  void (*Set)(lms3dServerOptions&, const Words&);
};

// The order is that of the help text.
const Option Options[] = {
  { "scenes", 1, "FOLDER", "the folder whose VRML files clients may choose from; needed",
    [](lms3dServerOptions& o, const Words& w) { o.Scenes = w[0]; } },
  { "scene", 1, "NAME", "the scene to begin with (default: the first of the folder)",
    [](lms3dServerOptions& o, const Words& w) { o.Scene = w[0]; } },
  { "up-axis", 1, "file|y", "file: scenes are z-up as they are (default); y: turn them to z-up",
    [](lms3dServerOptions& o, const Words& w) { o.IsYUp = lms3dGetChoice(w[0], "file", "y"); } },
  { "position", 3, "X Y Z", "where the sensor is, metres (default 0 0 0)",
    [](lms3dServerOptions& o, const Words& w) { o.Position = lms3dGetVector(w); } },
  { "orientation", 3, "X Y Z", "its angles about the axes, degrees (default 0 0 0)",
    [](lms3dServerOptions& o, const Words& w) { o.Orientation = lms3dGetVector(w); } },
  { "rate", 1, "HZ",
    "scans a second, 0.001 to 10000 (default 10); 0: as fast as it goes, on all cores",
    [](lms3dServerOptions& o, const Words& w) { o.Rate = GetRate(w[0]); } },
  { "map-error", 1, "M", "the bound of the local map's error, metres (default 0.01)",
    [](lms3dServerOptions& o, const Words& w) { o.MapError = lms3dGetNumber(w[0], 0.0, 1e6); } },
  { "no-map", 0, "", "make no local maps until a client asks for them",
    [](lms3dServerOptions& o, const Words&) { o.MakeMap = false; } },
  { "threads", 1, "N", "threads that scan (default 0: all cores)",
    [](lms3dServerOptions& o, const Words& w) { o.Threads = lms3dGetCount(w[0], 0, 1024); } },
  { "keep", 1, "N", "how many scans clients find (default 4, within 1 GiB); more for slow networks",
    [](lms3dServerOptions& o, const Words& w) { o.Keep = lms3dGetCount(w[0], 1, 1000); } },
  { "endpoint", 1, "URI",
    "where to listen, e.g. giop:tcp:127.0.0.1:2810 (default: a free port of 127.0.0.1)",
    [](lms3dServerOptions& o, const Words& w) { o.Endpoint = w[0]; } },
  { "allow-remote", 0, "", "take an endpoint that other machines can reach",
    [](lms3dServerOptions& o, const Words&) { o.AllowRemote = true; } },
  { "tls-key", 1, "FILE", "certificate and private key, PEM: for endpoints giop:ssl:HOST:PORT",
    [](lms3dServerOptions& o, const Words& w) { o.TLSKey = w[0]; } },
  { "tls-authorities", 1, "FILE", "the certificates that clients must be signed by, PEM",
    [](lms3dServerOptions& o, const Words& w) { o.TLSAuthorities = w[0]; } },
  { "ior", 1, "FILE", "write the object's reference to a file, removed at the end",
    [](lms3dServerOptions& o, const Words& w) { o.IORFile = w[0]; } },
  { "naming", 0, "", "register with the naming service that the ORB knows (-ORBInitRef)",
    [](lms3dServerOptions& o, const Words&) { o.Naming = true; } },
  { "naming-service", 1, "URI", "register with this one, e.g. corbaloc::127.0.0.1:2809/NameService",
    [](lms3dServerOptions& o, const Words& w)
    {
      o.Naming = true;
      o.NamingService = w[0];
    } },
  { "name", 1, "NAME", "under this name (default LMS3D.Scanner: id LMS3D, kind Scanner)",
    [](lms3dServerOptions& o, const Words& w) { o.Name = w[0]; } },
  { "read-only", 0, "", "clients may look but change nothing",
    [](lms3dServerOptions& o, const Words&) { o.ReadOnly = true; } },
  { "callbacks", 0, "", "clients may subscribe listeners, to which the server connects",
    [](lms3dServerOptions& o, const Words&) { o.Callbacks = true; } },
  { "connect-to", 1, "ADDRESS/MASK",
    "where the server may connect to beside this machine, for listeners and the naming service",
    [](lms3dServerOptions& o, const Words& w) { o.ConnectTo.push_back(w[0]); } },
  { "config", 1, "FILE",
    "options from a file, one a line: \"rate = 5\", \"position = 0.3 -0.2 1\", \"read-only\"; "
    "lines that begin with # are comments; values of the command line win",
    [](lms3dServerOptions&, const Words&) {} },
  { "help", 0, "", "this text", [](lms3dServerOptions& o, const Words&) { o.Help = true; } },
  { "version", 0, "", "the version of LMS3D",
    [](lms3dServerOptions& o, const Words&) { o.Version = true; } },
};

constexpr const char* Usage = R"(Usage: lms3d-server --scenes FOLDER [OPTIONS] [-ORBNAME VALUE ...]

Scans in an endless loop and serves the scans by CORBA, as Plugins/CORBA/LMS3DScanner.idl describes.
When it is ready it prints a corbaloc and an IOR, a line each. SIGTERM, SIGINT and SIGHUP end it, with
code 0.

)";

constexpr const char* UsageOfRest = R"(
Options of omniORB (-ORBtraceLevel 10) go to the ORB; what they, its environment and its own
configuration file set is kept, but for what the options above say. Endpoints are named by --endpoint
alone, unless --allow-remote is given.

Exit code: 0 ended by a signal, 1 failed while starting, 2 wrong options
)";

const Option& FindOption(const std::string& name)
{
  const auto* option = std::find_if(std::begin(Options), std::end(Options),
    [&name](const Option& candidate) { return name == candidate.Name; });
  if (option == std::end(Options))
  {
    throw std::invalid_argument("there is no such option; --help lists them");
  }
  return *option;
}

std::size_t GetCount(const std::string& name)
{
  return FindOption(name).Count;
}

void Set(lms3dServerOptions& options, const lms3dOptionSetting& setting)
{
  try
  {
    FindOption(setting.Name).Set(options, setting.Values);
  }
  catch (const std::invalid_argument& problem)
  {
    throw std::invalid_argument(setting.Origin + ": " + problem.what());
  }
}

void Check(const lms3dServerOptions& options)
{
  if (options.Scenes.empty() && !options.Help && !options.Version)
  {
    throw std::invalid_argument("--scenes: name the folder that has the scenes");
  }
  if (!options.AllowRemote && !lms3dIsLocalEndpoint(options.Endpoint))
  {
    throw std::invalid_argument("--endpoint: other machines could reach \"" + options.Endpoint +
      "\", and whoever can may move the sensor. Add --allow-remote if they shall");
  }
  if (options.TLSKey.empty() != options.TLSAuthorities.empty())
  {
    throw std::invalid_argument("--tls-key and --tls-authorities: one needs the other");
  }
  constexpr const char* TLSPrefix = "giop:ssl:";
  if ((options.Endpoint.rfind(TLSPrefix, 0) == 0) == options.TLSKey.empty())
  {
    throw std::invalid_argument(options.TLSKey.empty()
        ? "--endpoint: giop:ssl:HOST:PORT needs --tls-key and --tls-authorities"
        : "--tls-key: \"" + options.Endpoint + "\" would be served without TLS; give --endpoint " +
          "giop:ssl:HOST:PORT");
  }
}
} // namespace

lms3dServerOptions lms3dReadServerOptions(const std::vector<std::string>& arguments)
{
  lms3dServerOptions options;
  const lms3dCommandLine line = lms3dReadCommandLine(arguments, GetCount);
  for (const lms3dOptionSetting& setting : line.Settings)
  {
    if (setting.Name == "config")
    {
      for (const lms3dOptionSetting& fileSetting : lms3dReadOptionFile(setting.Values[0], GetCount))
      {
        Set(options, fileSetting);
      }
    }
  }
  for (const lms3dOptionSetting& setting : line.Settings)
  {
    Set(options, setting);
  }
  options.ORBArguments = line.ORBArguments;
  Check(options);
  return options;
}

std::string lms3dGetServerHelp()
{
  std::ostringstream help;
  help << Usage;
  for (const Option& option : Options)
  {
    help << "  --" << option.Name << (option.Count ? " " : "") << option.Values << "\n      "
         << option.Help << "\n";
  }
  help << UsageOfRest;
  return help.str();
}

bool lms3dIsLocalEndpoint(const std::string& endpoint)
{
  // The library's regular expressions call themselves for each letter.
  constexpr std::size_t Longest = 1000;
  static const std::regex local(
    R"(giop:unix:.*|giop:(tcp|ssl):(127(\.\d{1,3}){3}|localhost|\[::1\]):\d*)");
  return endpoint.size() <= Longest && std::regex_match(endpoint, local);
}
