// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A running server: the scanner, its CORBA object, and the announcement of its address.
 */
#ifndef lms3dServer_h
#define lms3dServer_h

#include "Announcement/lms3dNameRegistration.h"
#include "Announcement/lms3dReferenceFile.h"
#include "Connections/lms3dListeners.h"
#include "Object/lms3dScannerServant.h"
#include "Options/lms3dServerOptions.h"
#include "Scanning/lms3dFusedMapStore.h"
#include "Scanning/lms3dScanLoop.h"
#include "Scanning/lms3dSceneCatalogue.h"
#include "Scanning/lms3dSettingsBoard.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <memory>
#include <string>

/// For one thread. Clients may call the object from Start() on until the ORB is destroyed, so this
/// object must outlive the ORB.
class lms3dServer
{
public:
  /// Reads the scene. Throws std::runtime_error if that fails, and lms3dReadingStopped if
  /// `isStopped` returns true meanwhile.
  lms3dServer(const lms3dServerOptions& options, const lms3dStopTest& isStopped);
  ~lms3dServer();
  lms3dServer(const lms3dServer&) = delete;
  void operator=(const lms3dServer&) = delete;

  /// Starts to scan and to answer. Prints a corbaloc, if the address has one, and an IOR.
  void Start(CORBA::ORB_ptr orb);

  /// Removes the names, and ends waiting calls, listeners and the loop. The ORB may be destroyed
  /// afterwards.
  void Stop();

private:
  void Announce(CORBA::ORB_ptr orb, CORBA::Object_ptr scanner);

  const lms3dServerOptions Options;
  const lms3dSceneCatalogue Catalogue;
  lms3dSettingsBoard Board;
  lms3dSnapshotStore Store;
  lms3dFusedMapStore FusedMap;
  lms3dScanLoop Loop;
  lms3dListeners Listeners;
  std::unique_ptr<lms3dReferenceFile> ReferenceFile;
  std::unique_ptr<lms3dNameRegistration> NameRegistration;
};

#endif
