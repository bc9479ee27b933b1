// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dORBSettings.h"

#include "Common/lms3dORBSources.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace
{
using Names = std::set<std::string>;

// The server's own options overrule the ORB's environment and configuration file.
Names GetNamesOfOwnOptions(const lms3dServerOptions& options)
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
      // Without a password omniORB loads no key, not even an unencrypted one, and reports no error.
      { "sslKeyPassword", "none" } });
}

void AddConnectRules(lms3dORBSettings& settings, const lms3dServerOptions& options)
{
  const std::string transports = std::string(" ") + lms3dNetworkTransports;
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
    // Milliseconds: for a client that does not read its answer, and for a listener or a naming
    // service that does not answer. Without a time for connecting, which would begin anew with each
    // connection.
    { "serverCallTimeOutPeriod", "5000" },
    { "clientCallTimeOutPeriod", "5000" },
    { "clientConnectTimeOutPeriod", "0" },
    // A client that sends requests without reading answers occupies four threads at most.
    { "maxServerThreadPerConnection", "4" },
    // Above this number of connections all share a pool of threads, and clients that send half a
    // message can fill the pool. Below it each connection has its own thread, which costs little.
    { "threadPerConnectionUpperLimit", "2000" },
    { "threadPerConnectionLowerLimit", "1900" },
    // Seconds after which a connection that is idle or stuck in half a message is closed.
    { "inConScanPeriod", "30" },
    { "unixTransportPermission", "600" },
    // lms3dLog() writes the time already.
    { "traceTime", "0" },
  };
  AddConnectRules(settings, options);
  if (!options.TLSKey.empty())
  {
    AddTLS(settings, options);
  }

  const lms3dORBSources administrator(options.ORBArguments);
  const Names own = GetNamesOfOwnOptions(options);
  const auto isOverruled = [&administrator, &own](const lms3dORBSettings::value_type& setting)
  { return own.count(setting.first) == 0 && administrator.IsSet(setting.first); };
  settings.erase(std::remove_if(settings.begin(), settings.end(), isOverruled), settings.end());
  return settings;
}

void lms3dCheckEndpointSources(const lms3dServerOptions& options)
{
  const lms3dORBSources administrator(options.ORBArguments);
  for (const char* name :
    { "endPoint", "endPointNoListen", "endPointNoPublish", "endPointPublish" })
  {
    if (!options.AllowRemote && administrator.IsSet(name))
    {
      throw std::invalid_argument(std::string(name) +
        ": the ORB's arguments, environment or configuration file name an endpoint. Use "
        "--endpoint, " +
        "or add --allow-remote");
    }
  }
}
