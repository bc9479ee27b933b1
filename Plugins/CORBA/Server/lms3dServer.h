// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A running server: the scanner, its CORBA object and all that makes it known.
 */
#ifndef lms3dServer_h
#define lms3dServer_h

#include "lms3dListeners.h"
#include "lms3dNameRegistration.h"
#include "lms3dReferenceFile.h"
#include "lms3dScanLoop.h"
#include "lms3dScannerServant.h"
#include "lms3dSceneCatalogue.h"
#include "lms3dServerOptions.h"
#include "lms3dSettingsBoard.h"
#include "lms3dSnapshotStore.h"

#include <memory>
#include <string>

class lms3dServer
{
public:
  /// Reads the scene. Throws std::runtime_error where that fails, and lms3dReadingStopped.
  lms3dServer(const lms3dServerOptions& options, const lms3dStopTest& isStopped);
  ~lms3dServer();
  lms3dServer(const lms3dServer&) = delete;
  void operator=(const lms3dServer&) = delete;

  /// Scans and answers from now on. Prints a corbaloc, where there is one, and an IOR.
  void Start(CORBA::ORB_ptr orb);

  /// Ends waiting clients, listeners, names and the loop; the ORB may be destroyed after it.
  void Stop();

private:
  void Announce(CORBA::ORB_ptr orb, CORBA::Object_ptr scanner);

  const lms3dServerOptions Options;
  const lms3dSceneCatalogue Catalogue;
  lms3dSettingsBoard Board;
  lms3dSnapshotStore Store;
  lms3dScanLoop Loop;
  lms3dListeners Listeners;
  std::unique_ptr<lms3dReferenceFile> ReferenceFile;
  std::unique_ptr<lms3dNameRegistration> NameRegistration;
};

#endif
