// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dOptionsCheck.h"

#include "Options/lms3dServerOptions.h"

#include <cstddef>
#include <regex>
#include <stdexcept>

namespace
{
void CheckTLS(const lms3dServerOptions& options)
{
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

void lms3dCheckServerOptions(const lms3dServerOptions& options)
{
  if (options.Scenes.empty() && !options.Help && !options.Version)
  {
    throw std::invalid_argument("--scenes: name the folder of the scenes");
  }
  if (!options.AllowRemote && !lms3dIsLocalEndpoint(options.Endpoint))
  {
    throw std::invalid_argument("--endpoint: other machines could reach \"" + options.Endpoint +
      "\" and move the sensor. To permit that, add --allow-remote");
  }
  CheckTLS(options);
  if (options.FusedMapError > 0.0 && options.MapError > options.FusedMapError)
  {
    throw std::invalid_argument(
      "--fused-map: its error bound is below that of the local maps; add --map-error " +
      std::to_string(options.FusedMapError));
  }
}

bool lms3dIsLocalEndpoint(const std::string& endpoint)
{
  // The library's regular expressions recurse for each letter.
  constexpr std::size_t MaximumLength = 1000;
  static const std::regex local(
    R"(giop:unix:.*|giop:(tcp|ssl):(127(\.\d{1,3}){3}|localhost|\[::1\]):\d*)");
  return endpoint.size() <= MaximumLength && std::regex_match(endpoint, local);
}
