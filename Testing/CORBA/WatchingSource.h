// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A vtkLMS3DRemoteSource, used as by a window.
 */
#ifndef WatchingSource_h
#define WatchingSource_h

#include "Remote/vtkLMS3DRemoteSource.h"

#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <cstdint>
#include <functional>
#include <string>

class vtkPolyData;

class WatchingSource
{
public:
  explicit WatchingSource(const std::string& url);

  vtkLMS3DRemoteSource* operator->() const { return this->Source; }

  vtkPolyData* GetScan() const { return this->Source->GetOutput(); }
  vtkPolyData* GetMap() const { return this->Source->GetLocalMap(); }

  /// A number of the scan's field data. 0 if it does not exist.
  std::uint64_t GetNumber(const char* name) const;

  /// The x coordinate of the scan's sensor, metres.
  double GetSensorX() const;

  /// Updates whenever there is something new, until the condition holds. Returns false if it does
  /// not hold within `seconds`.
  bool UpdateUntil(const std::function<bool()>& condition, int seconds = 60);

  /// Updates, and fails the test unless scan and map are empty.
  void ExpectNothing();

  /// All warnings since the last call.
  std::string TakeWarnings();

  /// Destroys the source.
  void Destroy() { this->Source = nullptr; }

private:
  vtkSmartPointer<vtkLMS3DRemoteSource> Source;
  vtkSmartPointer<vtkTest::ErrorObserver> Observer;
};

#endif
