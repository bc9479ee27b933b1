// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Listeners of all kinds, for tests: those that listen and those that only seem to.
 */
#ifndef ClientListener_h
#define ClientListener_h

#include "LMS3DScanner.hh"

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include <netinet/in.h>

/// Counts the scans that it is told of.
class Counter : public POA_LMS3D::ScanListener
{
public:
  void scanReady(const LMS3D::ScanHeader& header) override;

  bool WaitFor(int count);
  int GetCount() const;
  /// Of the scans' numbers from one call to the next, the least and the greatest.
  CORBA::LongLong GetLeastStep() const;
  CORBA::LongLong GetGreatestStep() const;

private:
  std::vector<CORBA::LongLong> GetSteps() const;

  mutable std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<CORBA::ULongLong> Numbers;
};

/// A listener that is there while this lives.
class ActiveListener
{
public:
  ActiveListener();
  ~ActiveListener();
  ActiveListener(const ActiveListener&) = delete;
  void operator=(const ActiveListener&) = delete;

  Counter* operator->() { return this->Servant.in(); }
  LMS3D::ScanListener_var GetReference() { return this->Servant->_this(); }

private:
  PortableServer::POA_var Adapter;
  PortableServer::Servant_var<Counter> Servant;
  PortableServer::ObjectId_var Id;
};

/// A port of this machine where nobody answers.
class SilentPort
{
public:
  /// Where `isFull`, connections do not come about, else they do and nothing follows.
  explicit SilentPort(bool isFull = false, const char* address = "127.0.0.1");
  ~SilentPort();
  SilentPort(const SilentPort&) = delete;
  void operator=(const SilentPort&) = delete;

  /// A reference to an object here.
  LMS3D::ScanListener_var GetReference() const;
  bool IsConnectedTo(int milliseconds) const;

private:
  int Socket;
  sockaddr_in Address = {};
  std::vector<int> Fillers;
};

/// A reference to an object that nobody has, "127.0.0.1:2810".
LMS3D::ScanListener_var MakeReference(const std::string& address);

/// Whether the server comes to have so many listeners.
bool HasListeners(LMS3D::LaserScanner_ptr scanner, CORBA::ULong count);

#endif
