// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Remote/lms3dRemoteServer.h"

#include "Client/lms3dScannerReference.h"
#include "Remote/lms3dClientORB.h"

#include <utility>

namespace
{
using Clock = std::chrono::steady_clock;

// A few dropped scans in a row are no problem.
constexpr int MaximumDroppedInARow = 10;

constexpr const char* NoServer = "no server answers there";
} // namespace

lms3dRemoteServer::lms3dRemoteServer(
  const std::string& url, std::chrono::milliseconds timeout, std::function<bool()> isStopped)
  : Timeout(timeout)
  , IsStopped(std::move(isStopped))
{
  this->Scanner = this->Invoke<LMS3D::LaserScanner_ptr>(
    [&url, timeout] {
      return lms3dFindScanner(lms3dGetClientORB(), url, static_cast<CORBA::ULong>(timeout.count()));
    });
}

// Calls, and converts the exceptions of the server and of the ORB to messages.
template <typename Result, typename Call>
Result lms3dRemoteServer::Invoke(const Call& call) const
{
  try
  {
    return call();
  }
  catch (const LMS3D::InvalidArgument& refusal)
  {
    throw lms3dRemoteRefusal("the server rejects the value: " + std::string(refusal.reason));
  }
  catch (const LMS3D::NotPermitted& refusal)
  {
    throw lms3dRemoteRefusal("the server does not permit this: " + std::string(refusal.reason));
  }
  catch (const LMS3D::LimitExceeded& refusal)
  {
    throw lms3dRemoteRefusal("the server's limit is reached: " + std::string(refusal.reason));
  }
  catch (const CORBA::TIMEOUT&)
  {
    throw std::runtime_error("the server does not answer in time");
  }
  catch (const CORBA::TRANSIENT&)
  {
    throw std::runtime_error(NoServer);
  }
  catch (const CORBA::COMM_FAILURE&)
  {
    throw std::runtime_error(NoServer);
  }
  catch (const CORBA::OBJECT_NOT_EXIST&)
  {
    throw std::runtime_error("the server there has no object of that name");
  }
  catch (const CORBA::SystemException& exception)
  {
    throw lms3dRemoteRefusal(std::string("the call failed, ") + exception._name());
  }
}

LMS3D::ScanHeader_var lms3dRemoteServer::WaitForHeader(std::uint32_t milliseconds)
{
  return this->Invoke<LMS3D::ScanHeader*>(
    [this, milliseconds]() -> LMS3D::ScanHeader*
    {
      try
      {
        return lms3dWaitForScan(this->Scanner, this->LastNumber, 0, milliseconds,
          std::chrono::milliseconds(milliseconds));
      }
      catch (const LMS3D::NoScanYet&)
      {
        return nullptr;
      }
    });
}

lms3dRemoteScanPointer lms3dRemoteServer::WaitForScan(std::uint32_t milliseconds)
{
  const LMS3D::ScanHeader_var header = this->WaitForHeader(milliseconds);
  if (!header.operator->())
  {
    return nullptr;
  }
  this->CheckRun(header->incarnation);
  this->LastNumber = header->number;
  auto scan = this->Invoke<lms3dRemoteScanPointer>([this, &header] { return this->Fetch(header); });
  this->DroppedInARow = scan ? 0 : this->DroppedInARow + 1;
  if (this->DroppedInARow == MaximumDroppedInARow)
  {
    throw std::runtime_error(
      "the server drops scans before they are fetched; start it with a lower --rate or "
      "a higher --keep");
  }
  return scan;
}

lms3dRemoteScanPointer lms3dRemoteServer::Fetch(const LMS3D::ScanHeader& header) const
{
  lms3dRemoteScanPointer scan;
  try
  {
    this->FetchInTime(
      [&](const std::function<void()>& beforePart)
      {
        scan = std::make_shared<const lms3dRemoteScan>(
          lms3dFetchScan(this->Scanner, header, beforePart));
      },
      "a scan cannot be fetched within the Timeout; set a longer one");
  }
  catch (const LMS3D::ScanGone&)
  {
    this->LimitCalls(this->Timeout);
  }
  return scan;
}

lms3dRemoteFusedMapPointer lms3dRemoteServer::FetchFusedMap()
{
  return this->Invoke<lms3dRemoteFusedMapPointer>(
    [this]() -> lms3dRemoteFusedMapPointer
    {
      bool isNew = false;
      try
      {
        this->FetchInTime([&](const std::function<void()>& beforePart)
          { isNew = this->FusedMap.Update(this->Scanner, beforePart); },
          "the fused map cannot be fetched within the Timeout; set a longer one");
      }
      catch (const LMS3D::FusedMapGone&)
      {
        this->LimitCalls(this->Timeout);
      }
      catch (const LMS3D::NoFusedMap& refusal)
      {
        throw lms3dRemoteRefusal("no fused map: " + std::string(refusal.reason));
      }
      catch (const CORBA::BAD_OPERATION&)
      {
        throw lms3dRemoteRefusal("no fused map: the server is older than this");
      }
      if (isNew)
      {
        this->NewestFusedMap = std::make_shared<const lms3dRemoteFusedMap>(this->FusedMap);
      }
      return this->NewestFusedMap;
    });
}

void lms3dRemoteServer::FetchInTime(
  const std::function<void(const std::function<void()>&)>& fetch, const char* problem) const
{
  const Clock::time_point end = Clock::now() + this->Timeout;
  const auto beforePart = [this, end]
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0 || this->IsStopped())
    {
      throw CORBA::TIMEOUT();
    }
    this->LimitCalls(left);
  };
  try
  {
    fetch(beforePart);
  }
  catch (const CORBA::TIMEOUT&)
  {
    this->LimitCalls(this->Timeout);
    throw std::runtime_error(problem);
  }
  this->LimitCalls(this->Timeout);
}

void lms3dRemoteServer::LimitCalls(std::chrono::milliseconds timeout) const
{
  omniORB::setClientCallTimeout(this->Scanner, static_cast<CORBA::ULong>(timeout.count()));
}

// The ORB reconnects automatically, but a new run of the server counts scans and generations from 1
// again.
void lms3dRemoteServer::CheckRun(std::uint64_t incarnation)
{
  if (this->Incarnation != 0 && this->Incarnation != incarnation)
  {
    throw std::runtime_error("the server was restarted");
  }
  this->Incarnation = incarnation;
}

std::string lms3dRemoteServer::GetProblem()
{
  return this->Invoke<std::string>(
    [this]
    {
      const LMS3D::Status_var status = this->Scanner->getStatus();
      this->CheckRun(status->incarnation);
      return std::string(status->problem);
    });
}

std::uint64_t lms3dRemoteServer::SetPose(const LMS3D::Pose& pose)
{
  return this->Invoke<CORBA::ULongLong>([this, &pose] { return this->Scanner->setPose(pose); });
}
