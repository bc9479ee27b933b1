// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dOptionTable.h"

#include "Common/lms3dDeviceLimits.h"
#include "Common/lms3dDeviceNames.h"
#include "Options/lms3dServerOptions.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <type_traits>

namespace
{
using Words = std::vector<std::string>;

template <typename Number>
Number ReadNumber(const std::string& text, Number minimum, Number maximum)
{
  Number number{};
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  // NaN fails both comparisons.
  if (result.ec != std::errc() || result.ptr != end || !(number >= minimum && number <= maximum))
  {
    std::ostringstream message;
    message << '"' << text << "\" is not a " << (std::is_integral<Number>() ? "whole " : "")
            << "number from " << minimum << " to " << maximum;
    throw std::invalid_argument(message.str());
  }
  return number;
}

// 0 has a meaning of its own, in any notation.
double ReadRate(const std::string& text)
{
  constexpr double MinimumRate = 0.001;
  constexpr double MaximumRate = 10000.0;
  const bool isZero = ReadNumber(text, 0.0, MaximumRate) == 0.0;
  return isZero ? 0.0 : ReadNumber(text, MinimumRate, MaximumRate);
}

std::int64_t ReadLimit(const std::string& text)
{
  // A million times this fits.
  constexpr std::int64_t Maximum = 1'000'000'000'000;
  return ReadNumber<std::int64_t>(text, 1, Maximum);
}

std::array<double, 3> ReadVector(const Words& words)
{
  constexpr double Maximum = 1e6;
  return { ReadNumber(words.at(0), -Maximum, Maximum), ReadNumber(words.at(1), -Maximum, Maximum),
    ReadNumber(words.at(2), -Maximum, Maximum) };
}

bool ReadIsYUp(const std::string& text)
{
  if (text != "file" && text != "y")
  {
    throw std::invalid_argument('"' + text + "\" is neither file nor y");
  }
  return text == "y";
}

std::string ReadDevice(const std::string& text)
{
  if (!lms3dFindPreset(text))
  {
    throw std::invalid_argument(
      '"' + text + "\" is none of " + lms3dJoinNames(lms3dGetPresetNames()));
  }
  return text;
}

LMS3D::ScannerMounting ReadMounting(const std::string& text)
{
  const std::optional<LMS3D::ScannerMounting> mounting = lms3dFindMounting(text);
  return mounting ? *mounting
                  : throw std::invalid_argument(
                      '"' + text + "\" is none of " + lms3dJoinNames(lms3dGetMountingNames()));
}

std::string ReadArrayName(const std::string& text)
{
  return text.size() <= lms3dMaximumArrayName
    ? text
    : throw std::invalid_argument("the name has more than 128 letters");
}

template <double LMS3D::Device::*Property>
void SetLength(lms3dServerOptions& options, const Words& words)
{
  const double length = ReadNumber(words[0], 0.0, lms3dMaximumLength);
  options.DeviceChanges.emplace_back([length](LMS3D::Device& d) { d.*Property = length; });
}

struct Option
{
  const char* Name;
  /// Number of values. A flag has none.
  int Count;
  const char* Values;
  const char* Help;
  void (*Set)(lms3dServerOptions&, const Words&);
};

// The order is that of the help text.
const Option Options[] = {
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
    [](lms3dServerOptions& o, const Words& w) { o.Position = ReadVector(w); } },
  { "--orientation", 3, "X Y Z", "its angles about the axes, degrees (default 0 0 0)",
    [](lms3dServerOptions& o, const Words& w) { o.Orientation = ReadVector(w); } },
  { "--device", 1, "NAME",
    "the device: ideal (default) or lms200-mm; the following options\n"
    "replace single properties of it, wherever they stand",
    [](lms3dServerOptions& o, const Words& w) { o.Device = ReadDevice(w[0]); } },
  { "--range-bias", 1, "M", "systematic error of ranges, metres",
    [](lms3dServerOptions& o, const Words& w)
    {
      const double bias = ReadNumber(w[0], -lms3dMaximumLength, lms3dMaximumLength);
      o.DeviceChanges.emplace_back([bias](LMS3D::Device& d) { d.rangeBias = bias; });
    } },
  { "--range-noise", 1, "M", "standard deviation of the error of ranges, metres",
    SetLength<&LMS3D::Device::rangeNoise> },
  { "--range-resolution", 1, "M", "step of ranges, metres; 0: no rounding",
    SetLength<&LMS3D::Device::rangeResolution> },
  { "--seed", 1, "N", "selects the random numbers of the errors (default 0)",
    [](lms3dServerOptions& o, const Words& w)
    {
      using Limits = std::numeric_limits<CORBA::Long>;
      const CORBA::Long seed = ReadNumber(w[0], Limits::min(), Limits::max());
      o.DeviceChanges.emplace_back([seed](LMS3D::Device& d) { d.noiseSeed = seed; });
    } },
  { "--beam-diameter", 1, "M", "diameter of a beam where it starts, metres",
    SetLength<&LMS3D::Device::beamDiameter> },
  { "--beam-divergence", 1, "RATIO", "metres by which it grows per metre of range, 0 to 1",
    [](lms3dServerOptions& o, const Words& w)
    {
      const double ratio = ReadNumber(w[0], 0.0, lms3dMaximumDivergence);
      o.DeviceChanges.emplace_back([ratio](LMS3D::Device& d) { d.beamDivergence = ratio; });
    } },
  { "--beam-samples", 1, "N", "rays of a beam, 1 to 1000; a beam of 1 has no width",
    [](lms3dServerOptions& o, const Words& w)
    {
      const CORBA::ULong samples = ReadNumber<CORBA::ULong>(w[0], 1, lms3dMaximumSamples);
      o.DeviceChanges.emplace_back([samples](LMS3D::Device& d) { d.beamSamples = samples; });
    } },
  { "--pulse-length", 1, "M", "difference of ranges that still mix, metres (default 1)",
    SetLength<&LMS3D::Device::pulseLength> },
  { "--range-at-ten-percent", 1, "M",
    "range at which a surface that reflects 10 % is seen, metres;\n0: every surface is seen",
    SetLength<&LMS3D::Device::rangeAtTenPercent> },
  { "--reflectance-array", 1, "NAME", "the scene's array with the reflectance of each cell",
    [](lms3dServerOptions& o, const Words& w)
    {
      const std::string name = ReadArrayName(w[0]);
      o.DeviceChanges.emplace_back(
        [name](LMS3D::Device& d) { d.reflectanceArray = name.c_str(); });
    } },
  { "--mounting", 1, "NAME", "yawing (default), yawing-top, pitching or rolling",
    [](lms3dServerOptions& o, const Words& w)
    {
      const LMS3D::ScannerMounting mounting = ReadMounting(w[0]);
      o.DeviceChanges.emplace_back([mounting](LMS3D::Device& d) { d.mounting = mounting; });
    } },
  { "--axis-offset", 3, "X Y Z", "centre of the mirror from the sensor's position, metres",
    [](lms3dServerOptions& o, const Words& w)
    {
      const std::array<double, 3> v = ReadVector(w);
      o.DeviceChanges.emplace_back([v](LMS3D::Device& d) { d.axisOffset = { v[0], v[1], v[2] }; });
    } },
  { "--turn-rate", 1, "DEG/S", "turn of the platform during a fan (default 0: stepped)",
    [](lms3dServerOptions& o, const Words& w)
    {
      const double rate = ReadNumber(w[0], -lms3dMaximumTurnRate, lms3dMaximumTurnRate);
      o.DeviceChanges.emplace_back([rate](LMS3D::Device& d) { d.turnRate = rate; });
    } },
  { "--status", 0, "", "keep the status of each beam: why it gave a return, or none",
    [](lms3dServerOptions& o, const Words&)
    { o.DeviceChanges.emplace_back([](LMS3D::Device& d) { d.computeStatus = true; }); } },
  { "--rate", 1, "HZ",
    "scans per second, 0.001 to 10000 (default 10); 0: no pauses, all cores;\n"
    "new settings begin a scan at once",
    [](lms3dServerOptions& o, const Words& w) { o.Rate = ReadRate(w[0]); } },
  { "--map-error", 1, "M", "error bound of the local map, metres (default 0.01)",
    [](lms3dServerOptions& o, const Words& w) { o.MapError = ReadNumber(w[0], 0.0, 1e6); } },
  { "--no-map", 0, "", "make no local maps until a client switches them on",
    [](lms3dServerOptions& o, const Words&) { o.MakeMap = false; } },
  { "--threads", 1, "N", "threads of the filters (default 0: all cores)",
    [](lms3dServerOptions& o, const Words& w) { o.Threads = ReadNumber(w[0], 0, 1024); } },
  { "--keep", 1, "N", "scans to keep (default 4, within 1 GiB); more for slow networks",
    [](lms3dServerOptions& o, const Words& w) { o.Keep = ReadNumber(w[0], 1, 1000); } },
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

void AddFlag(CLI::App& app, const Option& option, lms3dServerOptions& options)
{
  app
    .add_flag_callback(
      option.Name, [&option, &options] { option.Set(options, {}); }, option.Help)
    ->disable_flag_override()
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

// Sets the option each time that it is given, so that the last value remains.
void AddValues(CLI::App& app, const Option& option, lms3dServerOptions& options)
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
} // namespace

void lms3dAddServerOptions(CLI::App& app, lms3dServerOptions& options)
{
  app.set_help_flag();
  for (const Option& option : Options)
  {
    option.Count == 0 ? AddFlag(app, option, options) : AddValues(app, option, options);
  }
}
