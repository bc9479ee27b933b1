// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A vtkLMS3DRemoteSource as a window uses it.
 */
#ifndef WatchingSource_h
#define WatchingSource_h

#include "vtkLMS3DRemoteSource.h"

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

  /// Field data of the scan; 0 where there is none.
  std::uint64_t GetNumber(const char* name) const;

  /// Where the sensor was, metres.
  double GetSensorX() const;

  /// Updates as a window does, whenever there is something new, until the condition holds. False
  /// where it does not within so many seconds.
  bool UpdateUntil(const std::function<bool()>& condition, int seconds = 10);

  /// All warnings since the last call.
  std::string TakeWarnings();

  /// Lets go of the source.
  void Destroy() { this->Source = nullptr; }

private:
  vtkSmartPointer<vtkLMS3DRemoteSource> Source;
  vtkSmartPointer<vtkTest::ErrorObserver> Observer;
};

#endif
