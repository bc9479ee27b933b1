// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FolderTest.h"
#include "Options/lms3dORBSettings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{
using ORBSettings = FolderTest;

std::string Find(const lms3dORBSettings& settings, const std::string& name)
{
  const auto setting = std::find_if(settings.begin(), settings.end(),
    [&name](const auto& candidate) { return candidate.first == name; });
  return setting == settings.end() ? "not set" : setting->second;
}
} // namespace

TEST_F(ORBSettings, DefaultsAreSafe)
{
  const lms3dORBSettings settings = lms3dGetORBSettings(lms3dServerOptions());
  EXPECT_EQ(Find(settings, "endPoint"), "giop:tcp:127.0.0.1:");
  EXPECT_EQ(Find(settings, "serverCallTimeOutPeriod"), "5000");
  EXPECT_EQ(Find(settings, "inConScanPeriod"), "30");
  EXPECT_EQ(Find(settings, "giopMaxMsgSize"), "not set");
  EXPECT_EQ(
    settings.back(), std::make_pair(std::string("clientTransportRule"), std::string("* none")));
}

// A time for connecting would renew a call's deadline with each connection.
TEST_F(ORBSettings, TheServerConnectsToTheNetworkOnlyAndInTheTimeOfTheCall)
{
  lms3dServerOptions options;
  options.Callbacks = true;
  options.ConnectTo = { "10.0.0.1/255.255.255.255" };
  const lms3dORBSettings settings = lms3dGetORBSettings(options);
  EXPECT_EQ(Find(settings, "clientConnectTimeOutPeriod"), "0");
  for (const auto& setting : settings)
  {
    if (setting.first == "clientTransportRule")
    {
      EXPECT_EQ(setting.second.find("unix"), std::string::npos) << setting.second;
    }
  }
}

TEST_F(ORBSettings, TheAdministratorsORBSettingsAreKept)
{
  lms3dServerOptions options;
  options.ORBArguments = { "-ORBendPoint", "giop:tcp:10.0.0.1:2810", "-ORBconfigFile",
    this->Write("omniORB.cfg", "# inConScanPeriod = 1\nmaxServerThreadPerConnection = 7\n") };
  setenv("ORBserverCallTimeOutPeriod", "1000", 1);
  const lms3dORBSettings settings = lms3dGetORBSettings(options);
  unsetenv("ORBserverCallTimeOutPeriod");
  EXPECT_EQ(Find(settings, "endPoint"), "not set");
  EXPECT_EQ(Find(settings, "maxServerThreadPerConnection"), "not set");
  EXPECT_EQ(Find(settings, "serverCallTimeOutPeriod"), "not set");
  EXPECT_EQ(Find(settings, "inConScanPeriod"), "30");
}

TEST_F(ORBSettings, AnORBSettingMayHaveTheNameOfAnotherAsItsValue)
{
  lms3dServerOptions options;
  options.ORBArguments = { "-ORBtraceFile", "-ORBconfigFile" };
  EXPECT_EQ(Find(lms3dGetORBSettings(options), "inConScanPeriod"), "30");
  const std::string file = this->Write("omniORB.cfg", "inConScanPeriod = 1\n");
  options.ORBArguments.insert(options.ORBArguments.end(), { "-ORBconfigFile", file });
  EXPECT_EQ(Find(lms3dGetORBSettings(options), "inConScanPeriod"), "not set");
}

TEST_F(ORBSettings, OwnOptionsWinOverTheAdministratorsORBSettings)
{
  lms3dServerOptions options;
  options.TLSKey = "key.pem";
  options.ConnectTo = { "10.0.0.1/255.255.255.255" };
  setenv("ORBsslKeyFile", "other.pem", 1);
  setenv("ORBclientTransportRule", "* tcp", 1);
  const lms3dORBSettings settings = lms3dGetORBSettings(options);
  unsetenv("ORBsslKeyFile");
  unsetenv("ORBclientTransportRule");
  EXPECT_EQ(Find(settings, "sslKeyFile"), "key.pem");
  EXPECT_NE(Find(settings, "clientTransportRule"), "not set");
}

TEST_F(ORBSettings, OnlyTheOptionNamesEndpoints)
{
  lms3dServerOptions options;
  EXPECT_NO_THROW(lms3dCheckEndpointSources(options));
  setenv("ORBendPoint", "giop:tcp:0.0.0.0:", 1);
  EXPECT_THROW(lms3dCheckEndpointSources(options), std::invalid_argument);
  options.AllowRemote = true;
  EXPECT_NO_THROW(lms3dCheckEndpointSources(options));
  unsetenv("ORBendPoint");
  options.AllowRemote = false;
  options.ORBArguments = { "-ORBendPointPublish", "127.0.0.1" };
  EXPECT_THROW(lms3dCheckEndpointSources(options), std::invalid_argument);
}
