// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRemoteServer.h"

#include "lms3dClientORB.h"
#include "lms3dScannerReference.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace
{
// One may be unlucky.
constexpr int MostGoneInARow = 10;

constexpr const char* NoServer = "no server answers there";
} // namespace

lms3dRemoteServer::lms3dRemoteServer(const std::string& url, std::chrono::milliseconds timeout)
{
  this->Scanner = this->Ask<LMS3D::LaserScanner_ptr>(
    [&url, timeout] {
      return lms3dFindScanner(lms3dGetClientORB(), url, static_cast<CORBA::ULong>(timeout.count()));
    });
}

// The result of a call, with what the server and the ORB object to in words.
template <typename Result, typename Call>
Result lms3dRemoteServer::Ask(const Call& call) const
{
  try
  {
    return call();
  }
  catch (const LMS3D::InvalidArgument& refusal)
  {
    throw std::runtime_error("the server cannot take that: " + std::string(refusal.reason));
  }
  catch (const LMS3D::NotPermitted& refusal)
  {
    throw std::runtime_error("the server does not permit that: " + std::string(refusal.reason));
  }
  catch (const LMS3D::LimitExceeded& refusal)
  {
    throw std::runtime_error("the server limits that: " + std::string(refusal.reason));
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
    throw std::runtime_error(std::string("the call failed, ") + exception._name());
  }
}

LMS3D::ScanHeader_var lms3dRemoteServer::WaitForHeader(std::uint32_t milliseconds)
{
  return this->Ask<LMS3D::ScanHeader*>(
    [this, milliseconds]() -> LMS3D::ScanHeader*
    {
      try
      {
        return this->Scanner->waitForScan(this->Seen, 0, milliseconds);
      }
      catch (const LMS3D::NoScanYet& none)
      {
        // Less than that where the server was started anew.
        this->Seen = std::min<std::uint64_t>(this->Seen, none.newest);
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
  this->Seen = header->number;
  auto scan = this->Ask<lms3dRemoteScanPointer>([this, &header] { return this->Fetch(header); });
  this->GoneInARow = scan ? 0 : this->GoneInARow + 1;
  if (this->GoneInARow == MostGoneInARow)
  {
    throw std::runtime_error(
      "scans are made faster than they can be fetched; start the server with a "
      "lower --rate or with more to --keep");
  }
  return scan;
}

lms3dRemoteScanPointer lms3dRemoteServer::Fetch(const LMS3D::ScanHeader& header) const
{
  try
  {
    return std::make_shared<const lms3dRemoteScan>(lms3dFetchScan(this->Scanner, header));
  }
  catch (const LMS3D::ScanGone&)
  {
    return nullptr;
  }
}

std::string lms3dRemoteServer::GetProblem()
{
  return this->Ask<std::string>(
    [this]
    {
      const LMS3D::Status_var status = this->Scanner->getStatus();
      return std::string(status->problem);
    });
}

void lms3dRemoteServer::SetPose(const LMS3D::Pose& pose)
{
  this->Ask<CORBA::ULongLong>([this, &pose] { return this->Scanner->setPose(pose); });
}
