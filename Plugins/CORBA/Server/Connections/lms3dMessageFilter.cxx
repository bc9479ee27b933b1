// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connections/lms3dMessageFilter.h"

#include <omniORB4/CORBA.h>
#include <omniORB4/giopEndpoint.h>
#include <omniORB4/minorCode.h>
#include <omniORB4/omniTransport.h>

// In this order, because they do not include each other.
#include <omniORB4/internal/giopStrand.h>
#include <omniORB4/internal/giopStream.h>

#include <omniORB4/internal/giopStreamImpl.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace
{
using Buffer = omni::giopStream_Buffer;
using Stream = omni::giopStream;

// The header of a message.
constexpr std::size_t HeaderBytes = 12;
constexpr std::size_t FlagsOffset = 6;
constexpr std::size_t KindOffset = 7;
constexpr std::size_t SizeOffset = 8;
constexpr unsigned char LittleEndianFlag = 1;
constexpr unsigned char FragmentsFlag = 2;

// The ORB's own function, which handles a message from its beginning.
decltype(omni::giopStreamImpl::inputMessageBegin) BeginOfORB = nullptr;

// The ORB receives, unmarshals and answers a call in one thread.
thread_local bool IsIncomplete = false;

// A buffer's bytes follow it in memory. Its offsets count from its own address.
unsigned char* GetByte(Buffer& buffer, CORBA::ULong offset)
{
  return reinterpret_cast<unsigned char*>(&buffer) + offset;
}

unsigned char* GetHeader(Buffer& buffer)
{
  return GetByte(buffer, buffer.start);
}

[[noreturn]] void CloseConnection(Stream& stream)
{
  {
    const omni_tracedmutex_lock lock(*omni::omniTransportLock);
    stream.strand().state(omni::giopStrand::DYING);
  }
  throw Stream::CommFailure(omni::COMM_FAILURE_UnMarshalArguments, CORBA::COMPLETED_NO, false);
}

// As the ORB does it, this fills the buffer as far as bytes have arrived, and closes the connection
// if there is no further byte.
void Receive(Stream& stream, Buffer& buffer)
{
  const std::size_t room = buffer.bufEnd() - buffer.bufLast();
  const int count =
    stream.strand().connection->Recv(GetByte(buffer, buffer.last), room, stream.getDeadline());
  if (count <= 0)
  {
    CloseConnection(stream);
  }
  buffer.last += static_cast<CORBA::ULong>(count);
}

// Puts the header first in the strand's queue, from which the ORB takes its next message.
Buffer& ReceiveHeader(Stream& stream)
{
  Buffer*& head = stream.strand().head;
  if (!head)
  {
    head = Buffer::newBuffer();
  }
  while (head->dataSize() < HeaderBytes)
  {
    Receive(stream, *head);
  }
  return *head;
}

std::uint64_t GetSize(Buffer& buffer)
{
  const unsigned char* const header = GetHeader(buffer);
  const bool isLittleEndian = header[FlagsOffset] & LittleEndianFlag;
  std::uint64_t size = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    size = size << 8 | header[SizeOffset + (isLittleEndian ? 3 - i : i)];
  }
  return HeaderBytes + size;
}

// Takes the first message out of the strand's queue. The buffer can hold further messages.
void Skip(Stream& stream, Buffer& buffer)
{
  std::uint64_t rest = GetSize(buffer);
  while (rest > buffer.dataSize())
  {
    rest -= buffer.dataSize();
    buffer.last = buffer.start;
    Receive(stream, buffer);
  }
  const std::size_t kept = buffer.dataSize() - rest;
  std::memmove(GetHeader(buffer), GetHeader(buffer) + rest, kept);
  buffer.last = buffer.start + static_cast<CORBA::ULong>(kept);
  if (kept == 0)
  {
    stream.strand().head = buffer.next;
    Buffer::deleteBuffer(&buffer);
  }
}

// The ORB checks all else.
bool IsSkipped(Buffer& buffer)
{
  const unsigned char* const header = GetHeader(buffer);
  const std::string_view name(reinterpret_cast<const char*>(header), 4);
  return name == "GIOP" &&
    (header[KindOffset] == GIOP::Fragment || header[KindOffset] == GIOP::CancelRequest);
}

// The thread that calls this has the strand's read lock.
void FilterNextMessage(Stream& stream)
{
  Buffer* buffer = &ReceiveHeader(stream);
  while (IsSkipped(*buffer))
  {
    Skip(stream, *buffer);
    buffer = &ReceiveHeader(stream);
  }
  unsigned char& flags = GetHeader(*buffer)[FlagsOffset];
  IsIncomplete = flags & FragmentsFlag;
  flags = static_cast<unsigned char>(flags & ~FragmentsFlag);
}

void Begin(Stream* stream, void (*unmarshalHeader)(Stream*))
{
  const bool isServer = unmarshalHeader == stream->impl()->unmarshalWildCardRequestHeader;
  if (isServer)
  {
    FilterNextMessage(*stream);
  }
  BeginOfORB(stream, unmarshalHeader);
}
} // namespace

void lms3dMessageFilter::Install()
{
  // Every request begins with the newest version of GIOP, which passes it on to its own.
  omni::giopStreamImpl* const newest = omni::giopStreamImpl::maxVersion();
  BeginOfORB = newest->inputMessageBegin;
  newest->inputMessageBegin = Begin;
}

bool lms3dMessageFilter::IsRequestIncomplete()
{
  return IsIncomplete;
}
