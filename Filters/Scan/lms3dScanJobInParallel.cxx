// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dEmptyArrays.h"
#include "Scan/lms3dScanJob.h"
#include "Scan/lms3dSurfaceAttributes.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

// In the following functions, collective calls stay outside of Threads.Run: MPI need not allow
// calls from other threads.
bool lms3dScanJob::CastInParallel(const Scan& scan)
{
  const lms3dProcesses& processes = scan.Processes;
  const lms3dRayCaster* caster = this->Scene.GetCaster();
  const lms3dProcesses::Cells cells = processes.GatherCells(this->Scene.GetPart());
  lms3dCheckScene(processes.AnyOf(caster != nullptr), cells.Whole, this->Scene.GetSkippedCells());
  if (processes.IsFirst())
  {
    this->WarnIfIncomplete(cells.Whole, scan);
  }
  if (!this->CastAndDetect(scan, cells.First))
  {
    return false;
  }
  this->FillOutputsInParallel(scan);
  return true;
}

void lms3dScanJob::FillOutputsInParallel(const Scan& scan)
{
  const lms3dProcesses& processes = scan.Processes;
  const lms3dScanSettings& settings = scan.Request.Settings;
  const auto run = [&](const auto& work) { this->Threads.Run(settings.NumberOfThreads, work); };
  vtkInformation* image = scan.Request.Outputs->GetInformationObject(1);
  const lms3dImagePiece piece = { processes.GetRank(), processes.GetCount(),
    image->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) };
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        run(
          [&]
          {
            this->Output.Fill(nullptr, scan.Geometry, scan.Start.Pose, scan.Points, nullptr);
            AddPoses(scan);
          });
      }
      this->Output.FillRangeImagePiece(scan.Geometry, piece, scan.Image);
      this->Detection.AddStatus(
        scan.Geometry, processes.IsFirst() ? scan.Points : nullptr, scan.Image);
    });
  if (lms3dSurfaceArrays(settings).AreAny())
  {
    vtkNew<vtkFieldData> own;
    processes.RunCollectively([&] { run([&] { this->AddSurfaceAttributes(scan, own); }); });
    lms3dGatherSurfaceAttributes(processes, this->Output.GetOwnTriangles(), own, scan.Points);
  }
  lms3dAddEmptyArrays(processes, scan.Points->GetPointData());
}
