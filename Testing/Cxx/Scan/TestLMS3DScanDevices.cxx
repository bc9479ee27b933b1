// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with devices of all kinds: threads, methods, abort, bad properties.
 */
#include "Fixtures/ProgressListener.h"
#include "Scan/DeviceFixtures.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
vtkSmartPointer<vtkLMS3DScanFilter> MakeDeviceScan(vtkDataObject* scene, const Device& device)
{
  auto scan = MakeScan(scene);
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 91, 45);
  device.Apply(scan);
  return scan;
}

class LMS3DScanDevices : public testing::TestWithParam<Device>
{
};
} // namespace

TEST_P(LMS3DScanDevices, GiveTheSameBitsWithAnyNumberOfThreads)
{
  auto scan = MakeDeviceScan(ReadRoom(), GetParam());
  scan->SetNumberOfThreads(1);
  scan->Update();
  const std::uint64_t alone = HashOutputs(scan);
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 1000);
  for (int threads : { 2, 3, 8 })
  {
    scan->SetNumberOfThreads(threads);
    scan->Update();
    EXPECT_EQ(HashOutputs(scan), alone) << threads;
  }
}

TEST_P(LMS3DScanDevices, DifferFromTheDefaultDevice)
{
  auto scan = MakeDeviceScan(ReadRoom(), GetParam());
  scan->Update();
  auto ideal = MakeScan(ReadRoom());
  ideal->SetPosition(0.3, -0.2, 1.0);
  SetGrid(ideal, 91, 45);
  ideal->Update();
  EXPECT_NE(Hash(scan->GetRangeImage()), Hash(ideal->GetRangeImage()));
}

TEST_P(LMS3DScanDevices, MeasureTheSameByAllMethods)
{
  auto scan = MakeDeviceScan(MakeBoxScene({ 3.0, 2.0, 1.5 }), GetParam());
  SetGrid(scan, 19, 8);
  scan->Update();
  const std::vector<double> exact = GetValues(scan, "Range");
  ASSERT_EQ(exact.size(), 19u * 8u);
  for (int method = 1; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    scan->SetIntersectionMethod(method);
    scan->Update();
    const std::vector<double> ranges = GetValues(scan, "Range");
    ASSERT_EQ(ranges.size(), exact.size()) << scan->GetIntersectionMethodAsString();
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      EXPECT_NEAR(ranges[i], exact[i], 1e-9) << scan->GetIntersectionMethodAsString() << ' ' << i;
    }
  }
}

TEST_P(LMS3DScanDevices, CanBeStopped)
{
  auto scan = MakeDeviceScan(MakeBoxScene({ 3.0, 2.0, 1.5 }), GetParam());
  {
    const ProgressListener abort(scan,
      [&scan](double progress)
      {
        if (progress > 0.4 && progress < 1.0)
        {
          scan->AbortExecuteOn();
        }
      });
    scan->SetNumberOfThreads(1);
    scan->Update();
  }
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
  scan->AbortExecuteOff();
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 91 * 45);
}

TEST_P(LMS3DScanDevices, ReportProgressThatNeverFalls)
{
  auto scan = MakeDeviceScan(MakeBoxScene({ 3.0, 2.0, 1.5 }), GetParam());
  double last = 0.0;
  const ProgressListener listener(scan,
    [&last](double progress)
    {
      EXPECT_GE(progress, last);
      last = progress;
    });
  scan->Update();
  EXPECT_EQ(last, 1.0);
}

TEST_P(LMS3DScanDevices, KeepNothingFromScanToScan)
{
  auto room = ReadRoom();
  auto scan = MakeDeviceScan(room, GetParam());
  scan->Update();
  const std::uint64_t first = HashOutputs(scan);
  scan->SetAlphaResolution(37);
  scan->Update();
  scan->SetAlphaResolution(91);
  scan->Update();
  EXPECT_EQ(HashOutputs(scan), first);
}

INSTANTIATE_TEST_SUITE_P(All, LMS3DScanDevices, testing::ValuesIn(GetDevices()),
  [](const testing::TestParamInfo<Device>& device) { return std::string(device.param.Name); });

// Blocks of turns limit the memory; they change no result.
TEST(LMS3DScanDevice, ManyRaysAreMixedBlockByBlock)
{
  auto scene = MakeBoxScene({ 3.0, 2.0, 1.5 });
  const auto getRanges = [&scene](double first, double last, int turns)
  {
    auto scan = MakeScan(scene);
    SetGrid(scan, 91, turns);
    scan->SetBetaRange(first, last);
    scan->SetBeamDivergence(0.01);
    scan->SetBeamSamples(1000);
    scan->Update();
    return GetValues(scan, "Range");
  };
  // 91 beams in 30 turns with 1000 rays are several blocks; 10 turns are one.
  const std::vector<double> all = getRanges(0.0, 29.0, 30);
  for (int block = 0; block < 3; ++block)
  {
    const std::vector<double> some = getRanges(10.0 * block, 10.0 * block + 9.0, 10);
    ASSERT_EQ(some.size(), 910u);
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      ASSERT_NEAR(some[i], all[910 * block + i], 1e-12);
    }
  }
}

namespace
{
struct BadProperty
{
  const char* Name;
  void (*Apply)(vtkLMS3DScanFilter*);
};

const BadProperty BadProperties[] = {
  { "AxisOffset", [](vtkLMS3DScanFilter* scan) { scan->SetAxisOffset(0.0, NAN, 0.0); } },
  { "AxisOffset", [](vtkLMS3DScanFilter* scan) { scan->SetAxisOffset(0.0, 0.0, 2e18); } },
  { "TurnRate", [](vtkLMS3DScanFilter* scan) { scan->SetTurnRate(INFINITY); } },
  { "BeamDiameter", [](vtkLMS3DScanFilter* scan) { scan->SetBeamDiameter(-0.01); } },
  { "BeamDiameter", [](vtkLMS3DScanFilter* scan) { scan->SetBeamDiameter(INFINITY); } },
  { "BeamDivergence", [](vtkLMS3DScanFilter* scan) { scan->SetBeamDivergence(1.01); } },
  { "BeamDivergence", [](vtkLMS3DScanFilter* scan) { scan->SetBeamDivergence(NAN); } },
  { "BeamSamples", [](vtkLMS3DScanFilter* scan) { scan->SetBeamSamples(0); } },
  { "BeamSamples", [](vtkLMS3DScanFilter* scan) { scan->SetBeamSamples(1001); } },
  { "PulseLength", [](vtkLMS3DScanFilter* scan) { scan->SetPulseLength(-1.0); } },
  { "PulseLength", [](vtkLMS3DScanFilter* scan) { scan->SetPulseLength(NAN); } },
};
} // namespace

TEST(LMS3DScanDevice, BadPropertiesAreErrors)
{
  for (const BadProperty& bad : BadProperties)
  {
    auto scan = MakeScan(MakeBall(5.0));
    SetGrid(scan, 9, 8);
    bad.Apply(scan);
    const std::string error = UpdateAndGetError(scan);
    EXPECT_NE(error.find(bad.Name), std::string::npos) << bad.Name << ": " << error;
    EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(LMS3DScanDevice, LargestPropertiesAreGood)
{
  auto scan = MakeScan(MakeBall(5.0));
  SetGrid(scan, 9, 8);
  scan->SetBeamDiameter(0.5);
  scan->SetBeamDivergence(1.0);
  scan->SetBeamSamples(1000);
  scan->SetPulseLength(1e300);
  scan->SetTurnRate(-1e6);
  scan->SetMaximumRange(std::numeric_limits<double>::infinity());
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 72);
  // Wider than any scene: most rays miss it.
  scan->SetBeamDiameter(1e300);
  EXPECT_EQ(UpdateAndGetError(scan), "");
}
