// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "WatchingSource.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt64Array.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

WatchingSource::WatchingSource(const std::string& url)
  : Source(vtkSmartPointer<vtkLMS3DRemoteSource>::New())
  , Observer(vtkSmartPointer<vtkTest::ErrorObserver>::New())
{
  this->Source->AddObserver(vtkCommand::WarningEvent, this->Observer);
  this->Source->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  this->Source->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  this->Source->SetURL(url.c_str());
}

std::uint64_t WatchingSource::GetNumber(const char* name) const
{
  auto* array =
    vtkTypeUInt64Array::SafeDownCast(this->GetScan()->GetFieldData()->GetAbstractArray(name));
  return array ? array->GetValue(0) : 0;
}

double WatchingSource::GetSensorX() const
{
  constexpr int ColumnOfPosition = 3;
  vtkDataArray* pose = this->GetScan()->GetFieldData()->GetArray("SensorToWorld");
  return pose ? pose->GetComponent(ColumnOfPosition, 0) : 0.0;
}

bool WatchingSource::UpdateUntil(const std::function<bool()>& condition, int seconds)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(seconds);
  while (!condition() && Clock::now() < end)
  {
    if (this->Source->GetNeedsUpdate())
    {
      this->Source->Update();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
}

void WatchingSource::ExpectNothing()
{
  this->Source->Update();
  EXPECT_EQ(this->GetScan()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->GetMap()->GetNumberOfPoints(), 0);
}

std::string WatchingSource::TakeWarnings()
{
  std::string warnings = this->Observer->GetWarningMessage();
  this->Observer->Clear();
  return warnings;
}
