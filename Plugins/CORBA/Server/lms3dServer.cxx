// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dServer.h"

#include "Announcement/lms3dObjectAddresses.h"
#include "Common/lms3dDeviceNames.h"
#include "Common/lms3dLog.h"
#include "Connections/lms3dRequestGate.h"
#include "Object/lms3dSettingsCheck.h"
#include "Options/lms3dOptionsCheck.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace
{
constexpr const char* ObjectKey = "LMS3D";

lms3dSceneReading GetReading(const lms3dServerOptions& options)
{
  constexpr std::int64_t Megabyte = 1'000'000;
  lms3dSceneReading reading;
  reading.IsYUp = options.IsYUp;
  reading.MaximumNumberOfNodes = options.SceneNodes;
  reading.MaximumNumberOfTriangles = options.SceneTriangles;
  reading.MaximumMemory = Megabyte * options.SceneMemory;
  reading.MaximumFileSize = Megabyte * options.SceneSize;
  return reading;
}

void SetDevice(const lms3dServerOptions& options, lms3dScanSettings& settings)
{
  if (const std::optional<LMS3D::Preset> preset = lms3dFindPreset(options.Device))
  {
    settings.Device = preset->properties;
    settings.Configuration.maximumRange = preset->maximumRange;
  }
  for (const auto& change : options.DeviceChanges)
  {
    change(settings.Device);
  }
}

lms3dScanSettings MakeFirstSettings(const lms3dServerOptions& options,
  const lms3dSceneCatalogue& catalogue, const lms3dStopTest& isStopped)
{
  lms3dScanSettings settings;
  settings.Configuration = lms3dDefaultConfiguration();
  settings.Configuration.makeMap = options.MakeMap;
  settings.Configuration.mapError = options.MapError;
  SetDevice(options, settings);
  settings.Pose.position = { options.Position[0], options.Position[1], options.Position[2] };
  settings.Pose.orientation = { options.Orientation[0], options.Orientation[1],
    options.Orientation[2] };

  const std::string name = options.Scene.empty() ? catalogue.GetNames().front() : options.Scene;
  const std::filesystem::path* file = catalogue.Find(name);
  if (!file)
  {
    throw std::runtime_error("the folder of scenes has no \"" + name + "\"");
  }
  lms3dLog("reading the scene " + name);
  settings.Scene = lms3dReadScene(name, *file, GetReading(options), isStopped);
  return settings;
}

lms3dPermissions GetPermissions(const lms3dServerOptions& options)
{
  lms3dPermissions permissions;
  permissions.ReadOnly = options.ReadOnly;
  permissions.Callbacks = options.Callbacks;
  permissions.FusedMap = options.FusedMapError > 0.0;
  permissions.Rate = options.Rate;
  permissions.Reading = GetReading(options);
  return permissions;
}

lms3dFusedMapOptions GetFusedMapOptions(const lms3dServerOptions& options)
{
  constexpr double Megabyte = 1e6;
  return { options.FusedMapError, options.Threads,
    Megabyte * static_cast<double>(options.FusedMemory) };
}

bool UsesTLS(const std::string& address)
{
  return address.rfind("giop:ssl:", 0) == 0;
}

void LogAddresses(const std::vector<std::string>& addresses)
{
  for (const std::string& address : addresses)
  {
    lms3dLog("listening on " + address);
    if (!lms3dIsLocalEndpoint(address) && !UsesTLS(address))
    {
      lms3dLog(
        "warning: other machines can reach this address without TLS. All their users can read "
        "scans and, unless --read-only is given, move the sensor");
    }
  }
}
} // namespace

lms3dServer::lms3dServer(const lms3dServerOptions& options, const lms3dStopTest& isStopped)
  : Options(options)
  , Catalogue(options.Scenes)
  , Board(MakeFirstSettings(options, this->Catalogue, isStopped))
  , Store(static_cast<std::size_t>(options.Keep))
  , FusedMap(std::max(lms3dFusedMapStore::MinimumKeep, static_cast<std::size_t>(options.Keep)))
  , Loop(this->Board, this->Store, options.Rate, options.Threads)
  , Listeners(this->Store)
{
  if (options.FusedMapError > 0.0)
  {
    this->Loop.MakeFusedMap(GetFusedMapOptions(options), this->FusedMap);
  }
}

lms3dServer::~lms3dServer()
{
  this->Stop();
}

void lms3dServer::Start(CORBA::ORB_ptr orb)
{
  if (this->Options.Callbacks)
  {
    this->Listeners.Start();
  }
  lms3dRequestGate::Install();
  // The object keys of this adapter are plain text, so clients can write them in a corbaloc.
  const CORBA::Object_var object = orb->resolve_initial_references("omniINSPOA");
  const PortableServer::POA_var adapter = PortableServer::POA::_narrow(object);
  const PortableServer::Servant_var<lms3dScannerServant> servant =
    new lms3dScannerServant(GetPermissions(this->Options), this->Catalogue, this->Board,
      this->Store, this->FusedMap, this->Loop, this->Listeners);
  const PortableServer::ObjectId_var key = PortableServer::string_to_ObjectId(ObjectKey);
  adapter->activate_object_with_id(key, servant);
  const LMS3D::LaserScanner_var scanner = servant->_this();
  const PortableServer::POAManager_var manager = adapter->the_POAManager();
  manager->activate();
  lms3dRequestGate::Open();
  // Before a naming service that hangs can delay it.
  this->Loop.Start();
  this->Announce(orb, scanner);
}

void lms3dServer::Announce(CORBA::ORB_ptr orb, CORBA::Object_ptr scanner)
{
  const std::vector<std::string> addresses = lms3dGetAddresses(scanner);
  LogAddresses(addresses);
  const CORBA::String_var reference = orb->object_to_string(scanner);
  if (!this->Options.IORFile.empty())
  {
    this->ReferenceFile =
      std::make_unique<lms3dReferenceFile>(this->Options.IORFile, reference.in());
  }
  if (this->Options.Naming)
  {
    this->NameRegistration = std::make_unique<lms3dNameRegistration>(
      orb, this->Options.NamingService, this->Options.Name, scanner);
  }
  const std::string corbaloc = lms3dGetCorbaloc(addresses, ObjectKey);
  lms3dPrint((corbaloc.empty() ? "" : corbaloc + '\n') + reference.in());
}

// Unbinding the name needs a working ORB. Waiting calls and listeners end before the ORB waits for
// them.
void lms3dServer::Stop()
{
  this->ReferenceFile.reset();
  this->NameRegistration.reset();
  lms3dRequestGate::Close();
  this->Store.Stop();
  this->Loop.Stop();
  this->Listeners.Stop();
}
