// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dScannerServant.h"

#include "Common/lms3dLog.h"
#include "Common/lms3dVersion.h"
#include "Object/lms3dReplies.h"
#include "Object/lms3dSettingsCheck.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <string>

namespace
{
// Milliseconds.
constexpr CORBA::ULong MaximumWait = 10000;
} // namespace

lms3dScannerServant::lms3dScannerServant(const lms3dPermissions& permissions,
  const lms3dSceneCatalogue& catalogue, lms3dSettingsBoard& board, const lms3dSnapshotStore& store,
  const lms3dFusedMapStore& fusedMap, const lms3dScanLoop& loop, lms3dListeners& listeners)
  : Permissions(permissions)
  , Catalogue(catalogue)
  , Board(board)
  , Store(store)
  , FusedMap(fusedMap)
  , Loop(loop)
  , Listeners(listeners)
  , Waiting(store)
{
}

LMS3D::Data* lms3dScannerServant::fetch()
{
  return this->PolarData.Get(*this->Waiting.WaitForFirst());
}

LMS3D::Pose lms3dScannerServant::getPose()
{
  return this->Board.Get().Pose;
}

CORBA::ULongLong lms3dScannerServant::setPose(const LMS3D::Pose& newPose)
{
  this->RequireWritable();
  lms3dCheckPose(newPose);
  return this->Board.SetPose(newPose);
}

LMS3D::Configuration lms3dScannerServant::getConfiguration()
{
  return this->Board.Get().Configuration;
}

CORBA::ULongLong lms3dScannerServant::setConfiguration(const LMS3D::Configuration& newConfiguration)
{
  this->RequireWritable();
  lms3dCheckConfiguration(newConfiguration);
  const std::lock_guard<std::mutex> lock(this->SettingsMutex);
  lms3dCheckRays(newConfiguration, this->Board.Get().Device);
  return this->Board.SetConfiguration(newConfiguration);
}

LMS3D::SceneNames* lms3dScannerServant::listScenes()
{
  return lms3dMakeSceneNames(this->Catalogue);
}

LMS3D::Scene* lms3dScannerServant::getScene()
{
  return new LMS3D::Scene(this->Board.Get().Scene->Description);
}

// Reads one scene at a time, so that many large scenes at once cannot fill the memory.
CORBA::ULongLong lms3dScannerServant::selectScene(const char* name)
{
  this->RequireWritable();
  const std::filesystem::path* file = this->Catalogue.Find(name);
  if (!file)
  {
    throw LMS3D::NoSuchScene(name);
  }
  const lms3dLimitedCall call(
    this->Selections, MaximumSelections, "too many clients select a scene");
  const std::lock_guard<std::mutex> lock(this->SceneMutex);
  // The server may have ended while this call waited for its turn.
  if (this->Store.IsStopped())
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  try
  {
    const CORBA::ULongLong generation = this->Board.SetScene(lms3dReadScene(
      name, *file, this->Permissions.Reading, [this] { return this->Store.IsStopped(); }));
    lms3dLog(lms3dLogKind::Scenes, "a client selected the scene " + std::string(name));
    return generation;
  }
  catch (const lms3dReadingStopped&)
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  catch (const std::exception& problem)
  {
    throw LMS3D::SceneFailed(name, lms3dMakeText(problem.what()));
  }
}

LMS3D::Status* lms3dScannerServant::getStatus()
{
  LMS3D::Status_var status = new LMS3D::Status;
  const lms3dSnapshotPointer newest = this->Store.GetNewest();
  status->version = lms3dVersion;
  status->incarnation = this->Loop.GetIncarnation();
  status->generation = this->Board.Get().Generation;
  status->newest = newest ? newest->Header.number : 0;
  status->rate = this->Permissions.Rate;
  status->lateScans = this->Loop.GetNumberOfLateScans();
  status->scanSeconds = newest ? newest->ScanSeconds : 0.0;
  status->mapSeconds = newest ? newest->MapSeconds : 0.0;
  status->isReadOnly = this->Permissions.ReadOnly;
  status->hasCallbacks = this->Permissions.Callbacks;
  status->waiting = static_cast<CORBA::ULong>(this->Waiting.GetNumber());
  status->listening = static_cast<CORBA::ULong>(this->Listeners.GetNumber());
  status->problem = lms3dMakeText(this->Loop.GetProblem());
  return status._retn();
}

LMS3D::ScanHeader* lms3dScannerServant::getHeader()
{
  return new LMS3D::ScanHeader(this->GetNewest()->Header);
}

LMS3D::ScanHeader* lms3dScannerServant::waitForScan(
  CORBA::ULongLong after, CORBA::ULongLong generation, CORBA::ULong timeout)
{
  const std::chrono::milliseconds limited(std::min(timeout, MaximumWait));
  const lms3dSnapshotPointer snapshot = this->Waiting.Wait(after, generation, limited);
  if (!snapshot && this->Store.IsStopped())
  {
    throw CORBA::TRANSIENT(0, CORBA::COMPLETED_NO);
  }
  if (!snapshot)
  {
    throw LMS3D::NoScanYet(this->Store.GetNewestNumber());
  }
  return new LMS3D::ScanHeader(snapshot->Header);
}

LMS3D::Scan* lms3dScannerServant::getScan()
{
  const lms3dSnapshotPointer snapshot = this->GetNewest();
  LMS3D::Scan_var scan = new LMS3D::Scan;
  scan->header = snapshot->Header;
  LMS3D::Ranges_var ranges =
    lms3dMakePart<LMS3D::Ranges>(snapshot->Ranges, 1, 0, snapshot->Header.beams);
  const CORBA::ULong length = ranges->length();
  scan->beamRanges.replace(length, length, ranges->get_buffer(true), true);
  return scan._retn();
}

LMS3D::Ranges* lms3dScannerServant::getRanges(
  CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakePart<LMS3D::Ranges>(this->Find(number)->Ranges, 1, first, count);
}

LMS3D::Coordinates* lms3dScannerServant::getMapPoints(
  CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakePart<LMS3D::Coordinates>(this->Find(number)->MapPoints, 3, first, count);
}

LMS3D::Indices* lms3dScannerServant::getMapTriangles(
  CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count)
{
  return lms3dMakePart<LMS3D::Indices>(this->Find(number)->MapTriangles, 3, first, count);
}

CORBA::ULong lms3dScannerServant::subscribe(LMS3D::ScanListener_ptr listener)
{
  if (!this->Permissions.Callbacks)
  {
    throw LMS3D::NotPermitted("the server was started without callbacks; use waitForScan()");
  }
  if (CORBA::is_nil(listener))
  {
    throw LMS3D::InvalidArgument("the listener is nil");
  }
  return this->Listeners.Add(listener);
}

void lms3dScannerServant::unsubscribe(CORBA::ULong subscription)
{
  if (!this->Listeners.Remove(subscription))
  {
    throw LMS3D::InvalidArgument("there is no such subscription");
  }
}

LMS3D::LocalMap* lms3dScannerServant::getMap()
{
  return lms3dMakeLocalMap(*this->GetNewest());
}

void lms3dScannerServant::RequireWritable() const
{
  if (this->Permissions.ReadOnly)
  {
    throw LMS3D::NotPermitted("the server was started read-only");
  }
}

lms3dSnapshotPointer lms3dScannerServant::GetNewest() const
{
  lms3dSnapshotPointer snapshot = this->Store.GetNewest();
  if (!snapshot)
  {
    throw LMS3D::NoScanYet(0);
  }
  return snapshot;
}

lms3dSnapshotPointer lms3dScannerServant::Find(CORBA::ULongLong number) const
{
  lms3dSnapshotPointer snapshot = this->Store.Find(number);
  if (!snapshot)
  {
    // In this order, so that newest >= oldest even if a scan is published in between.
    const CORBA::ULongLong oldest = this->Store.GetOldestNumber();
    throw LMS3D::ScanGone(oldest, this->Store.GetNewestNumber());
  }
  return snapshot;
}
