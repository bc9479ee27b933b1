// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RawEmbreeBuild.h"

#include "Casting/lms3dEmbreeConfiguration.h"
#include "EmbreeHandles.h"
#include "Timer.h"

#include <tbb/task_arena.h>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <limits>

RawEmbreeBuild::RawEmbreeBuild(vtkPolyData* surface)
{
  this->Boxes.reserve(surface->GetNumberOfPolys());
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* corners;
    it->GetCurrentCell(count, corners);
    Box box;
    box.Low.fill(std::numeric_limits<float>::infinity());
    box.High.fill(-std::numeric_limits<float>::infinity());
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      surface->GetPoint(corners[i], point);
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Low[axis] = std::min(box.Low[axis], static_cast<float>(point[axis]));
        box.High[axis] = std::max(box.High[axis], static_cast<float>(point[axis]));
      }
    }
    this->Boxes.push_back(box);
  }
}

double RawEmbreeBuild::GetMilliseconds(Quality quality, int threads) const
{
  const EmbreeDevice device(rtcNewDevice(lms3dGetEmbreeConfiguration()));
  EmbreeScene scene;
  tbb::task_arena arena(threads);
  const auto build = [&]
  {
    scene.reset(rtcNewScene(device.get()));
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(this->Boxes.size()));
    rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* args)
      {
        const Box& box = static_cast<const Box*>(args->geometryUserPtr)[args->primID];
        *args->bounds_o = { box.Low[0], box.Low[1], box.Low[2], 0.0f, box.High[0], box.High[1],
          box.High[2], 0.0f };
      },
      nullptr);
    rtcSetGeometryUserData(geometry, const_cast<Box*>(this->Boxes.data()));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(
      scene.get(), quality == LOW ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
    rtcCommitScene(scene.get());
  };
  return ::GetMilliseconds([&] { arena.execute(build); });
}
