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
#include "Object/lms3dPolarData.h"
#include "Scanning/lms3dFusedMapStore.h"
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
  /// Whether the server keeps a map of many scans.
  bool FusedMap = false;
  /// Scans per second, for the status.
  double Rate = 0.0;
  lms3dSceneReading Reading;
};

/**
 * Implements the operations of LMS3DScanner.idl, which documents what clients see.
 *
 * The ORB calls the operations in any thread, several at a time. The objects that they use may be
 * called from any thread, so only operations that check several settings, and selectScene(), need a
 * lock here. An operation that returns data of
 * a scan makes its whole answer from one snapshot, so an answer never mixes two scans.
 *
 * The ORB owns the arguments, which are valid until the operation returns, and frees the results
 * that are returned by pointer.
 */
class lms3dScannerServant : public POA_LMS3D::LaserScanner
{
public:
  /// Calls of selectScene(): one that reads its scene, and others that wait for their turn.
  static constexpr unsigned int MaximumSelections = 5;

  /// All objects that are given by reference must outlive the servant.
  lms3dScannerServant(const lms3dPermissions& permissions, const lms3dSceneCatalogue& catalogue,
    lms3dSettingsBoard& board, const lms3dSnapshotStore& store, const lms3dFusedMapStore& fusedMap,
    const lms3dScanLoop& loop, lms3dListeners& listeners);

  /// The paper's operation: the newest scan. Waits for the first scan, and throws CORBA::TRANSIENT
  /// if it does not come in time, CORBA::IMP_LIMIT if the scan does not fit into a message.
  LMS3D::Data* fetch() override;

  ///@{
  /// The settings of the next scan. They do not wait for a scan.
  LMS3D::Pose getPose() override;
  LMS3D::Configuration getConfiguration() override;
  LMS3D::Scene* getScene() override;
  ///@}

  ///@{
  /// Change the settings for all clients and return the new generation. Throw LMS3D::NotPermitted
  /// if the server is read-only, and LMS3D::InvalidArgument or LMS3D::LimitExceeded for values that
  /// lms3dCheckPose() or lms3dCheckConfiguration() refuses. After an exception nothing is changed.
  CORBA::ULongLong setPose(const LMS3D::Pose& newPose) override;
  CORBA::ULongLong setConfiguration(const LMS3D::Configuration& newConfiguration) override;
  ///@}

  /// The names of the catalogue. Throws CORBA::IMP_LIMIT if they do not fit into a message.
  LMS3D::SceneNames* listScenes() override;

  /// Reads the scene in the calling thread, one scene at a time, and only then replaces the old
  /// one. Throws LMS3D::NotPermitted if the server is read-only, LMS3D::NoSuchScene for a name that
  /// is not in the catalogue, LMS3D::LimitExceeded above MaximumSelections, LMS3D::SceneFailed if
  /// the file has no surface, and CORBA::TRANSIENT if the server ends meanwhile.
  CORBA::ULongLong selectScene(const char* name) override;

  /// Does not wait for a scan. Before the first one, its number and times are 0.
  LMS3D::Status* getStatus() override;

  ///@{
  /// The newest scan. Throw LMS3D::NoScanYet before the first one. getScan() throws
  /// LMS3D::LimitExceeded if the ranges do not fit into a message.
  LMS3D::ScanHeader* getHeader() override;
  LMS3D::Scan* getScan() override;
  ///@}

  /// Occupies a thread of the ORB and a place of lms3dWaitingRoom while it waits, ten seconds at
  /// most. Throws LMS3D::NoScanYet after `timeout` (milliseconds), LMS3D::LimitExceeded if no place
  /// is free, and CORBA::TRANSIENT if the server ends.
  LMS3D::ScanHeader* waitForScan(
    CORBA::ULongLong after, CORBA::ULongLong generation, CORBA::ULong timeout) override;

  ///@{
  /// Copies of parts of the scan `number`. Throw LMS3D::ScanGone if the store does not have the
  /// scan, LMS3D::InvalidArgument if it has fewer than `first` + `count` items, and
  /// LMS3D::LimitExceeded if they do not fit into a message.
  LMS3D::Ranges* getRanges(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;
  LMS3D::Coordinates* getMapPoints(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;
  LMS3D::Indices* getMapTriangles(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;
  ///@}

  /// Keeps a reference to the listener and returns the number of the subscription. Throws
  /// LMS3D::NotPermitted if the server has no callbacks, LMS3D::InvalidArgument for nil, and what
  /// lms3dListeners::Add() throws.
  CORBA::ULong subscribe(LMS3D::ScanListener_ptr listener) override;
  /// Does not wait for a current call of the listener. Throws LMS3D::InvalidArgument if there is no
  /// such subscription.
  void unsubscribe(CORBA::ULong subscription) override;

  /// The local map of the newest scan. Throws LMS3D::NoScanYet before the first one, and
  /// LMS3D::LimitExceeded if the map does not fit into a message.
  LMS3D::LocalMap* getMap() override;

  ///@{
  /// The device of the next scan. setDevice() changes it as setPose() changes the pose.
  LMS3D::Device* getDevice() override;
  CORBA::ULongLong setDevice(const LMS3D::Device& newDevice) override;
  ///@}

  ///@{
  /// The presets. getPreset() throws LMS3D::NoSuchPreset for other names, and so does
  /// selectPreset(), which throws what setDevice() and setConfiguration() throw, too.
  LMS3D::PresetNames* listPresets() override;
  LMS3D::Preset* getPreset(const char* name) override;
  CORBA::ULongLong selectPreset(const char* name) override;
  ///@}

  /// Throws LMS3D::ScanGone if the store does not have the scan.
  LMS3D::Device* getScanDevice(CORBA::ULongLong number) override;

  /// Throws what getRanges() throws. A scan without statuses has no item.
  LMS3D::BeamStatuses* getBeamStatuses(
    CORBA::ULongLong number, CORBA::ULong first, CORBA::ULong count) override;

  ///@{
  /// The changes of the map of many scans since a state. Throw LMS3D::NoFusedMap before the first
  /// state and without such a map. getFusedMap() throws LMS3D::LimitExceeded if they do not fit
  /// into a message.
  LMS3D::FusedMapHeader* getFusedMapHeader(CORBA::ULongLong since) override;
  LMS3D::FusedMap* getFusedMap(CORBA::ULongLong since) override;
  ///@}

  ///@{
  /// Copies of parts of these changes. Throw LMS3D::FusedMapGone if the store does not have the
  /// state `number`, and otherwise what getRanges() throws.
  LMS3D::FusedRegions* getFusedRegions(CORBA::ULongLong number, CORBA::ULongLong since,
    CORBA::ULong first, CORBA::ULong count) override;
  LMS3D::Offsets* getFusedPoints(CORBA::ULongLong number, CORBA::ULongLong since,
    CORBA::ULong first, CORBA::ULong count) override;
  LMS3D::Indices* getFusedTriangles(CORBA::ULongLong number, CORBA::ULongLong since,
    CORBA::ULong first, CORBA::ULong count) override;
  ///@}

  /// Begins a new map of many scans with the next scan.
  CORBA::ULongLong resetFusedMap() override;

private:
  /// Throws LMS3D::NotPermitted if the server is read-only.
  void RequireWritable() const;
  /// Never null. Throws LMS3D::NoScanYet before the first scan.
  lms3dSnapshotPointer GetNewest() const;
  /// Never null. Throws LMS3D::ScanGone.
  lms3dSnapshotPointer Find(CORBA::ULongLong number) const;
  /// Throws LMS3D::NoFusedMap without a map of many scans.
  void RequireFusedMap() const;
  ///@{
  /// Never null. Throw LMS3D::NoFusedMap and LMS3D::FusedMapGone.
  lms3dFusedMapPointer GetNewestFusedMap() const;
  lms3dFusedMapPointer FindFusedMap(CORBA::ULongLong number) const;
  ///@}

  const lms3dPermissions Permissions;
  const lms3dSceneCatalogue& Catalogue;
  lms3dSettingsBoard& Board;
  const lms3dSnapshotStore& Store;
  const lms3dFusedMapStore& FusedMap;
  const lms3dScanLoop& Loop;
  lms3dListeners& Listeners;
  /// Locked while the configuration or the device is checked and set, because their limits depend
  /// on both.
  std::mutex SettingsMutex;
  /// Locked while a scene is read.
  std::mutex SceneMutex;
  /// Current calls of selectScene().
  std::atomic<unsigned int> Selections{ 0 };
  lms3dWaitingRoom Waiting;
  lms3dPolarData PolarData;
};

#endif
