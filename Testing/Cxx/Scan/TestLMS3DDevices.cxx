// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The devices that users choose, and the properties that they set.
#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>

namespace
{
// All properties, without the lines that differ between two objects.
template <class Filter>
std::string Print(Filter* filter)
{
  std::stringstream text;
  filter->PrintSelf(text, vtkIndent());
  std::string kept;
  for (std::string line; std::getline(text, line);)
  {
    const bool isOwn = line.find("Modified") != std::string::npos ||
      line.find("0x") != std::string::npos || line.find("Executive") != std::string::npos;
    kept += isOwn ? "" : line + '\n';
  }
  return kept;
}

// Values that no device has.
void SetOtherValues(vtkLMS3DScanFilter* filter)
{
  filter->SetMaximumRange(3.0);
  filter->SetBeamDiameter(0.1);
  filter->SetBeamDivergence(0.2);
  filter->SetBeamSamples(11);
  filter->SetPulseLength(4.0);
  filter->SetRangeAtTenPercent(5.0);
}

void SetOtherValues(vtkLMS3DRangeErrorFilter* filter)
{
  filter->SetRangeBias(0.1);
  filter->SetRangeNoise(0.2);
  filter->SetRangeResolution(0.3);
}

template <class Filter>
class TestLMS3DDevices : public testing::Test
{
};

using Filters = testing::Types<vtkLMS3DScanFilter, vtkLMS3DRangeErrorFilter>;
TYPED_TEST_SUITE(TestLMS3DDevices, Filters);

TYPED_TEST(TestLMS3DDevices, IdealHasTheDefaultsOfAllProperties)
{
  vtkNew<TypeParam> filter;
  const std::string defaults = Print(filter.Get());
  EXPECT_EQ(filter->GetDevice(), TypeParam::IDEAL);
  SetOtherValues(filter.Get());
  EXPECT_EQ(filter->GetDevice(), -1);
  EXPECT_NE(Print(filter.Get()), defaults);
  filter->SetDeviceToIdeal();
  EXPECT_EQ(Print(filter.Get()), defaults);
}

TYPED_TEST(TestLMS3DDevices, EachDeviceIsFoundByItsValues)
{
  std::set<std::string> names;
  std::set<std::string> properties;
  for (int device = 0; device < TypeParam::GetNumberOfDevices(); ++device)
  {
    vtkNew<TypeParam> filter;
    SetOtherValues(filter.Get());
    filter->SetDevice(device);
    EXPECT_EQ(filter->GetDevice(), device);
    names.insert(TypeParam::GetDeviceName(device));
    properties.insert(Print(filter.Get()));
  }
  EXPECT_EQ(names, (std::set<std::string>{ "Ideal", "LMS200-mm", "LMS200-cm", "LMS291" }));
  EXPECT_EQ(properties.size(), names.size());
  EXPECT_EQ(TypeParam::GetDeviceName(-1), nullptr);
  EXPECT_EQ(TypeParam::GetDeviceName(TypeParam::GetNumberOfDevices()), nullptr);
}

TYPED_TEST(TestLMS3DDevices, TheSettersChooseTheDevicesOfTheirNames)
{
  vtkNew<TypeParam> filter;
  filter->SetDeviceToLMS200();
  EXPECT_STREQ(TypeParam::GetDeviceName(filter->GetDevice()), "LMS200-mm");
  filter->SetDeviceToLMS200Centimetres();
  EXPECT_STREQ(TypeParam::GetDeviceName(filter->GetDevice()), "LMS200-cm");
  filter->SetDeviceToLMS291();
  EXPECT_STREQ(TypeParam::GetDeviceName(filter->GetDevice()), "LMS291");
  filter->SetDeviceToIdeal();
  EXPECT_STREQ(TypeParam::GetDeviceName(filter->GetDevice()), "Ideal");
}

TYPED_TEST(TestLMS3DDevices, AnUnknownDeviceIsAnErrorAndChangesNothing)
{
  for (const int device : { -1, TypeParam::GetNumberOfDevices() })
  {
    vtkNew<TypeParam> filter;
    filter->SetDeviceToLMS291();
    vtkNew<vtkTest::ErrorObserver> observer;
    filter->AddObserver(vtkCommand::ErrorEvent, observer);
    const std::string before = Print(filter.Get());
    filter->SetDevice(device);
    EXPECT_NE(
      observer->GetErrorMessage().find("Device " + std::to_string(device)), std::string::npos)
      << observer->GetErrorMessage();
    EXPECT_EQ(Print(filter.Get()), before);
  }
}

TEST(TestLMS3DDeviceValues, AreThoseThatTheFiltersGet)
{
  using Scan = vtkLMS3DScanFilter;
  using Errors = vtkLMS3DRangeErrorFilter;
  for (int device = 0; device < Scan::GetNumberOfDevices(); ++device)
  {
    vtkNew<Scan> scan;
    vtkNew<Errors> errors;
    scan->SetDevice(device);
    errors->SetDevice(device);
    EXPECT_EQ(Scan::GetDeviceValue(device, "MaximumRange"), scan->GetMaximumRange());
    EXPECT_EQ(Scan::GetDeviceValue(device, "BeamDiameter"), scan->GetBeamDiameter());
    EXPECT_EQ(Scan::GetDeviceValue(device, "BeamDivergence"), scan->GetBeamDivergence());
    EXPECT_EQ(Scan::GetDeviceValue(device, "BeamSamples"), scan->GetBeamSamples());
    EXPECT_EQ(Scan::GetDeviceValue(device, "PulseLength"), scan->GetPulseLength());
    EXPECT_EQ(Scan::GetDeviceValue(device, "RangeAtTenPercent"), scan->GetRangeAtTenPercent());
    EXPECT_EQ(Errors::GetDeviceValue(device, "RangeBias"), errors->GetRangeBias());
    EXPECT_EQ(Errors::GetDeviceValue(device, "RangeNoise"), errors->GetRangeNoise());
    EXPECT_EQ(Errors::GetDeviceValue(device, "RangeResolution"), errors->GetRangeResolution());
    EXPECT_EQ(errors->GetRangeBias(), 0.0);
  }
  EXPECT_TRUE(std::isnan(Scan::GetDeviceValue(0, "Position")));
  EXPECT_TRUE(std::isnan(Scan::GetDeviceValue(0, nullptr)));
  EXPECT_TRUE(std::isnan(Scan::GetDeviceValue(-1, "MaximumRange")));
}

TEST(TestLMS3DDeviceValues, LeaveTheRig)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetPosition(1.0, 2.0, 3.0);
  scan->SetAlphaResolution(181);
  scan->SetMinimumRange(0.5);
  scan->SetMountingToPitching();
  scan->SetAxisOffset(0.1, 0.0, 0.05);
  scan->SetTurnRate(37.5);
  scan->SetReflectanceArray("Color");
  scan->ComputeTimeOn();
  const std::string before = Print(scan.Get());
  scan->SetDeviceToLMS200();
  scan->SetDeviceToIdeal();
  EXPECT_EQ(Print(scan.Get()), before);
}
} // namespace
