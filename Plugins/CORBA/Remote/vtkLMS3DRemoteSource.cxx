// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Remote/vtkLMS3DRemoteSource.h"

#include "Client/lms3dRemoteData.h"
#include "Remote/lms3dRemoteThreads.h"
#include "Remote/lms3dRemoteWatch.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <chrono>
#include <cstdint>

vtkStandardNewMacro(vtkLMS3DRemoteSource);

namespace
{
std::chrono::milliseconds Milliseconds(double seconds)
{
  return std::chrono::milliseconds(static_cast<int>(1000.0 * seconds));
}

// In parallel, only the first process requests a piece that a scan has.
bool IsFirstPiece(vtkInformation* output)
{
  const auto piece = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) <= 0;
}

// The first of all problems.
std::string GetFirstProblem(const lms3dRemoteNews& news)
{
  for (const std::string* problem : { &news.Problem, &news.Refusal, &news.FusedMapProblem })
  {
    if (!problem->empty())
    {
      return *problem;
    }
  }
  return "";
}

LMS3D::Vector3 MakeVector(const double values[3])
{
  return { values[0], values[1], values[2] };
}
} // namespace

struct vtkLMS3DRemoteSource::Internals
{
  ~Internals() { this->Disconnect(); }

  /// The watch for these properties. Starts one if necessary.
  lms3dRemoteWatch& GetWatch(const std::string& url, double timeout)
  {
    if (!this->Watch || this->Url != url || this->Timeout != timeout)
    {
      this->Disconnect();
      this->Url = url;
      this->Timeout = timeout;
      this->Watch = std::make_shared<lms3dRemoteWatch>(url, Milliseconds(timeout));
      lms3dRemoteThreads::GetInstance().Start(this->Watch);
    }
    return *this->Watch;
  }

  /// Waits for a scan that was not shown. Returns false if there is none within the timeout, and
  /// true without a watch for these properties, since the next update starts one and waits itself.
  bool WaitForScan(const std::string& url, double timeout) const
  {
    const bool isWatched = this->Watch && this->Url == url && this->Timeout == timeout;
    return !isWatched || this->Watch->WaitForScan(this->ShownScans);
  }

  /// Stops following a server, and resets what was shown.
  void Disconnect()
  {
    if (this->Watch)
    {
      this->Watch->Stop();
    }
    this->Watch = nullptr;
    this->Shown = 0;
    this->ShownScans = 0;
    this->WarnedOf.clear();
    this->IsPosePending = false;
  }

  /// Warns once of each problem.
  void Warn(vtkLMS3DRemoteSource* source, const lms3dRemoteNews& news)
  {
    std::string problem = GetFirstProblem(news);
    if (problem.empty() && !news.Scan)
    {
      problem = "no scan arrived within the Timeout";
    }
    if (!problem.empty() && problem != this->WarnedOf)
    {
      vtkWarningWithObjectMacro(source,
        << this->Url << ": " << problem << ". "
        << (news.Scan ? "The last scan is shown." : "The output is empty until a scan arrives."));
    }
    this->WarnedOf = problem;
  }

  std::shared_ptr<lms3dRemoteWatch> Watch;
  /// The count of the news that the last update showed.
  std::uint64_t Shown = 0;
  /// The number of scans until that update.
  std::uint64_t ShownScans = 0;
  /// The state at the last update or SendPose().
  bool IsPosePending = false;

private:
  std::string WarnedOf;
  std::string Url;
  double Timeout = 0.0;
};

vtkLMS3DRemoteSource::vtkLMS3DRemoteSource()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(3);
}

vtkLMS3DRemoteSource::~vtkLMS3DRemoteSource() = default;

vtkPolyData* vtkLMS3DRemoteSource::GetLocalMap()
{
  return this->GetOutput(1);
}

vtkPolyData* vtkLMS3DRemoteSource::GetFusedMap()
{
  return this->GetOutput(2);
}

void vtkLMS3DRemoteSource::SendPose()
{
  if (this->URL.empty())
  {
    vtkErrorMacro("No server: set URL before sending a pose.");
    return;
  }
  this->Internal->GetWatch(this->URL, this->Timeout)
    .SendPose({ MakeVector(this->Position), MakeVector(this->Orientation) });
  this->Internal->IsPosePending = true;
}

bool vtkLMS3DRemoteSource::IsPosePending() const
{
  return this->Internal->IsPosePending;
}

bool vtkLMS3DRemoteSource::GetNeedsUpdate()
{
  const auto& watch = this->Internal->Watch;
  if (!watch || watch->GetCount() == this->Internal->Shown)
  {
    return false;
  }
  this->Modified();
  return true;
}

bool vtkLMS3DRemoteSource::Refresh()
{
  const bool isNew = this->Internal->WaitForScan(this->URL, this->Timeout);
  this->Modified();
  return isNew;
}

std::string vtkLMS3DRemoteSource::GetProblem() const
{
  if (!this->Internal->Watch)
  {
    return "";
  }
  const lms3dRemoteNews news = this->Internal->Watch->GetNews();
  return GetFirstProblem(news);
}

int vtkLMS3DRemoteSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!IsFirstPiece(outputVector->GetInformationObject(0)))
  {
    return 1;
  }
  if (this->URL.empty())
  {
    this->Internal->Disconnect();
    vtkErrorMacro("No server: set URL, for example to the line that the server prints.");
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  lms3dRemoteWatch& watch = this->Internal->GetWatch(this->URL, this->Timeout);
  watch.WantFusedMap(this->FetchFusedMap);
  const lms3dRemoteNews news = watch.WaitForNews();
  this->Internal->Shown = news.Count;
  this->Internal->ShownScans = news.Scans;
  this->Internal->IsPosePending = news.IsPosePending;
  this->Internal->Warn(this, news);
  if (news.Scan)
  {
    lms3dFillScan(*news.Scan, vtkPolyData::GetData(outputVector, 0));
    lms3dFillMap(*news.Scan, vtkPolyData::GetData(outputVector, 1));
  }
  if (news.FusedMap && this->FetchFusedMap)
  {
    news.FusedMap->Fill(vtkPolyData::GetData(outputVector, 2));
  }
  return 1;
}

void vtkLMS3DRemoteSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "URL: " << this->URL << '\n';
  os << indent << "Timeout: " << this->Timeout << '\n';
  os << indent << "FetchFusedMap: " << this->FetchFusedMap << '\n';
  os << indent << "Position: " << this->Position[0] << ' ' << this->Position[1] << ' '
     << this->Position[2] << '\n';
  os << indent << "Orientation: " << this->Orientation[0] << ' ' << this->Orientation[1] << ' '
     << this->Orientation[2] << '\n';
}
