// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The scanner's CORBA object: validates requests and answers them from the newest scans.
 */
#ifndef lms3dScannerServant_h
#define lms3dScannerServant_h

#include "Connections/lms3dListeners.h"
#include "Connections/lms3dWaitingRoom.h"
#include "LMS3DScanner.hh"
#include "Scanning/lms3dScanLoop.h"
#include "Scanning/lms3dSceneCatalogue.h"
#include "Scanning/lms3dSettingsBoard.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <atomic>
#include <mutex>

/// What clients may do.
struct lms3dPermissions
{
  bool ReadOnly = false;
  bool Callbacks = false;
  /// Scans per second, for the status.
  double Rate = 0.0;
  /// Rotates scenes whose y axis is up so that the z axis is up.
  bool IsYUp = false;
};

/// LMS3DScanner.idl documents every operation. The ORB calls them in any thread, several at a time.
class lms3dScannerServant : public POA_LMS3D::LaserScanner
{
public:
  /// Calls of selectScene(): one that reads its scene, and others that wait for their turn.
  static constexpr unsigned int MaximumSelections = 5;

  /// All objects that are given by reference must outlive the servant.
  lms3dScannerServant(const lms3dPermissions& permissions, const lms3dSceneCatalogue& catalogue,
    lms3dSettingsBoard& board, const lms3dSnapshotStore& store, const lms3dScanLoop& loop,
    lms3dListeners& listeners);

  LMS3D::Data* fetch() override;

  LMS3D::Pose getPose() override;
  CORBA::ULongLong setPose(const LMS3D::Pose& newPose) override;
  LMS3D::Configuration getConfiguration() override;
  CORBA::ULongLong setConfiguration(const LMS3D::Configuration& newConfiguration) override;
  LMS3D::SceneNames* listScenes() override;
  LMS3D::Scene* getScene() override;
  CORBA::ULongLong selectScene(const char* name) override;

  LMS3D::Status* getStatus() override;
  LMS3D::ScanHeader* getHeader() override;
  LMS3D::ScanHeader* waitForScan(
    CORBA::ULongLong after, CORBA::ULongLong generation, CORBA::ULong timeout) override;
  LMS3D::Scan* getScan() override;
  LMS3D::Ranges* getRanges(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;
  LMS3D::Coordinates* getMapPoints(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;
  LMS3D::Indices* getMapTriangles(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;

  CORBA::ULong subscribe(LMS3D::ScanListener_ptr listener) override;
  void unsubscribe(CORBA::ULong subscription) override;

private:
  void RequireWritable() const;
  lms3dSnapshotPointer GetNewest() const;
  lms3dSnapshotPointer Find(CORBA::ULongLong number) const;

  const lms3dPermissions Permissions;
  const lms3dSceneCatalogue& Catalogue;
  lms3dSettingsBoard& Board;
  const lms3dSnapshotStore& Store;
  const lms3dScanLoop& Loop;
  lms3dListeners& Listeners;
  std::mutex SceneMutex;
  std::atomic<unsigned int> Selections{ 0 };
  lms3dWaitingRoom Waiting;
};

#endif
