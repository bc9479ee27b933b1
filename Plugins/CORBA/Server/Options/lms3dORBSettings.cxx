// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dORBSettings.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>

namespace
{
using Names = std::set<std::string>;

constexpr const char* Prefix = "-ORB";

Names GetNamesOfArguments(const std::vector<std::string>& arguments)
{
  Names names;
  for (std::size_t i = 0; i < arguments.size(); i += 2)
  {
    names.insert(arguments[i].substr(std::string(Prefix).size()));
  }
  return names;
}

std::string GetConfigurationFile(const std::vector<std::string>& arguments)
{
  // Names and values in turn, where a value may look like a name.
  for (std::size_t i = 0; i < arguments.size(); i += 2)
  {
    if (arguments[i] == "-ORBconfigFile")
    {
      return arguments[i + 1];
    }
  }
  const char* const file = std::getenv("OMNIORB_CONFIG");
  return file ? file : "/etc/omniORB.cfg";
}

// Lines of "name = value"; of a file that is not there none.
Names GetNamesOfFile(const std::string& file)
{
  Names names;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    const std::size_t first = line.find_first_not_of(" \t");
    const std::size_t end = line.find_first_of(" \t=", first);
    if (first != std::string::npos && line[first] != '#' && end != std::string::npos)
    {
      names.insert(line.substr(first, end - first));
    }
  }
  return names;
}

Names GetChosenNames(const lms3dServerOptions& options)
{
  Names chosen = GetNamesOfFile(GetConfigurationFile(options.ORBArguments));
  chosen.merge(GetNamesOfArguments(options.ORBArguments));
  return chosen;
}

bool IsChosen(const std::string& name, const Names& chosen)
{
  return chosen.count(name) != 0 || std::getenv(("ORB" + name).c_str());
}

// What our own options say wins over the ORB's environment and configuration file.
Names GetNamesOfOptions(const lms3dServerOptions& options)
{
  Names names;
  if (!options.TLSKey.empty())
  {
    names.merge(Names{ "sslCAFile", "sslKeyFile", "sslKeyPassword" });
  }
  if (!options.ConnectTo.empty())
  {
    names.insert("clientTransportRule");
  }
  return names;
}

void AddTLS(lms3dORBSettings& settings, const lms3dServerOptions& options)
{
  settings.insert(settings.end(),
    { { "sslCAFile", options.TLSAuthorities }, { "sslKeyFile", options.TLSKey },
      // Without a password omniORB silently loads no key, even one that needs none.
      { "sslKeyPassword", "none" } });
}

void AddConnectRules(lms3dORBSettings& settings, const lms3dServerOptions& options)
{
  const std::string transports = " unix,ssl,tcp";
  settings.emplace_back("clientTransportRule", "127.0.0.1/255.255.255.255" + transports);
  for (const std::string& address : options.ConnectTo)
  {
    settings.emplace_back("clientTransportRule", address + transports);
  }
  settings.emplace_back("clientTransportRule", "* none");
}
} // namespace

lms3dORBSettings lms3dGetORBSettings(const lms3dServerOptions& options)
{
  lms3dORBSettings settings = {
    { "endPoint", options.Endpoint },
    // A client that takes no answer, a listener or a naming service that gives none.
    { "serverCallTimeOutPeriod", "5000" },
    { "clientCallTimeOutPeriod", "5000" },
    // The server's end waits for a listener's call; a lost packet is repeated after a second.
    { "clientConnectTimeOutPeriod", options.Callbacks ? "500" : "2000" },
    // One that asks without reading.
    { "maxServerThreadPerConnection", "4" },
    // Beyond this many connections all share a pool of threads, which clients that send half a
    // message can fill; below it they only have a thread of their own, which costs little.
    { "threadPerConnectionUpperLimit", "2000" },
    { "threadPerConnectionLowerLimit", "1900" },
    // Seconds after which a connection that is idle, or stuck in half a message, is closed.
    { "inConScanPeriod", "30" },
    { "unixTransportPermission", "600" },
    // Our log has the time already.
    { "traceTime", "0" },
  };
  AddConnectRules(settings, options);
  if (!options.TLSKey.empty())
  {
    AddTLS(settings, options);
  }

  const Names chosen = GetChosenNames(options);
  const Names own = GetNamesOfOptions(options);
  const auto isChosen = [&chosen, &own](const lms3dORBSettings::value_type& setting)
  { return own.count(setting.first) == 0 && IsChosen(setting.first, chosen); };
  settings.erase(std::remove_if(settings.begin(), settings.end(), isChosen), settings.end());
  return settings;
}

void lms3dCheckEndpointSources(const lms3dServerOptions& options)
{
  const Names chosen = GetChosenNames(options);
  for (const char* name :
    { "endPoint", "endPointNoListen", "endPointNoPublish", "endPointPublish" })
  {
    if (!options.AllowRemote && IsChosen(name, chosen))
    {
      throw std::invalid_argument(std::string(name) +
        ": the ORB's arguments, environment or configuration file would have the server listen " +
        "where --endpoint does not say. Use --endpoint, or add --allow-remote");
    }
  }
}
