// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// lms3d-client: shows and saves the scans of a server, and moves its sensor.
#include "Client/lms3dScannerReference.h"
#include "Common/lms3dCallRetries.h"
#include "Common/lms3dORBLog.h"
#include "Common/lms3dORBSources.h"
#include "lms3dClientActions.h"
#include "lms3dClientCommands.h"
#include "lms3dExceptionText.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr int ExitFailure = 1;
constexpr int ExitUsage = 2;

// Milliseconds. Longer than the server's longest wait, so that only a server that hangs exceeds it.
constexpr const char* CallMilliseconds = "15000";

void PrintLine(const std::string& line)
{
  std::cerr << line << '\n';
}

CORBA::ORB_ptr MakeORB(int& argc, char** argv)
{
  constexpr const char* rule = "clientTransportRule";
  const bool isRuleGiven = lms3dORBSources({ argv + 1, argv + argc }).IsSet(rule);
  const char* options[][2] = { { "clientCallTimeOutPeriod", CallMilliseconds },
    { "endPoint", "giop:tcp:127.0.0.1:" },
    { isRuleGiven ? nullptr : rule, lms3dClientTransportRule }, { nullptr, nullptr } };
  return CORBA::ORB_init(argc, argv, "omniORB4", options);
}

// Returns an empty function for a wrong command. Throws for wrong arguments, before contacting a
// scanner.
lms3dClientCommand ReadCommand(const std::vector<std::string>& arguments)
{
  if (arguments.size() < 2)
  {
    return nullptr;
  }
  return lms3dReadClientCommand(arguments[1], { arguments.begin() + 2, arguments.end() });
}

int Run(CORBA::ORB_ptr orb, const std::vector<std::string>& arguments)
{
  if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end())
  {
    std::cout << lms3dGetClientHelp();
    return 0;
  }
  const lms3dClientCommand command = ReadCommand(arguments);
  if (!command)
  {
    std::cerr << lms3dGetClientHelp();
    return ExitUsage;
  }
  const LMS3D::LaserScanner_var scanner = lms3dFindScanner(orb, arguments[0]);
  command(orb, scanner);
  return 0;
}
} // namespace

int main(int argc, char* argv[])
{
  int code = ExitFailure;
  try
  {
    lms3dSetORBLog(PrintLine, { argv + 1, argv + argc });
    lms3dLimitRetries();
    const CORBA::ORB_var orb = MakeORB(argc, argv);
    code = Run(orb, { argv + 1, argv + argc });
    lms3dRequireOutput();
    orb->destroy();
  }
  catch (const CORBA::Exception& problem)
  {
    std::cerr << "lms3d-client: " << lms3dDescribe(problem) << '\n';
  }
  catch (const std::invalid_argument& problem)
  {
    std::cerr << "lms3d-client: " << problem.what() << '\n';
    code = ExitUsage;
  }
  catch (const std::exception& problem)
  {
    std::cerr << "lms3d-client: " << problem.what() << '\n';
    code = ExitFailure;
  }
  return code;
}
