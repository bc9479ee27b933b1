// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which settings of the ORB an administrator gives, outside of LMS3D's own options.
 */
#ifndef lms3dORBSources_h
#define lms3dORBSources_h

#include <set>
#include <string>
#include <vector>

/// TCP and TLS, as clientTransportRule writes them. Without Unix sockets, which belong to other
/// programs of this machine.
constexpr const char* lms3dNetworkTransports = "ssl,tcp";

/// A clientTransportRule for clients: to any address, by TCP and TLS only, also after a forward
/// (LOCATION_FORWARD).
constexpr const char* lms3dClientTransportRule = "* ssl,tcp";

/**
 * The names of the settings in the arguments, in omniORB's environment variables and in its
 * configuration file. omniORB prefers the settings of ORB_init() to the environment's and the
 * file's, so a program that respects an administrator leaves these out. Reads the environment, so
 * it is not thread-safe against setenv().
 */
class lms3dORBSources
{
public:
  /// Reads the configuration file. `arguments` are a program's; each "-ORBname" precedes its value.
  explicit lms3dORBSources(const std::vector<std::string>& arguments);

  /// `name` has no prefix.
  bool IsSet(const std::string& name) const;

private:
  std::set<std::string> Names;
};

#endif
