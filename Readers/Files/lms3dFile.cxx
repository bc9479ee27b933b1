// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/lms3dFile.h"

#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace
{
constexpr std::size_t ChunkSize = 1 << 18;
constexpr int GzipWindow = 15 + 16;

/// Returns `count` bytes, or fewer at the end of the file.
std::string ReadBytes(std::istream& file, std::size_t count)
{
  std::string bytes(count, '\0');
  file.read(&bytes[0], static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool IsPacked(const std::string& bytes)
{
  return bytes.compare(0, 2, "\x1f\x8b") == 0;
}

/// Unpacks gzip. If the packed bytes are damaged, the text up to the damage remains.
class Unpacker
{
public:
  Unpacker() { inflateInit2(&this->Stream, GzipWindow); }
  ~Unpacker() { inflateEnd(&this->Stream); }
  Unpacker(const Unpacker&) = delete;
  void operator=(const Unpacker&) = delete;

  std::string Text;

  /// Appends to Text until it has `maximumBytes` bytes. Returns false at the end of the packed
  /// file, at a fault in it, or if Text is full.
  bool Unpack(const std::string& bytes, std::size_t maximumBytes)
  {
    this->Stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    this->Stream.avail_in = static_cast<uInt>(bytes.size());
    while (this->Stream.avail_in > 0 && this->Text.size() < maximumBytes)
    {
      if (!this->UnpackStep(maximumBytes) || !this->BeginNextMember())
      {
        return false;
      }
    }
    return this->Text.size() < maximumBytes;
  }

  bool IsComplete() const { return this->Status == Z_STREAM_END; }

private:
  bool UnpackStep(std::size_t maximumBytes)
  {
    const std::size_t before = this->Text.size();
    const std::size_t room = std::min(maximumBytes - before, ChunkSize);
    this->Text.resize(before + room);
    this->Stream.next_out = reinterpret_cast<Bytef*>(&this->Text[before]);
    this->Stream.avail_out = static_cast<uInt>(room);
    this->Status = inflate(&this->Stream, Z_NO_FLUSH);
    this->Text.resize(this->Text.size() - this->Stream.avail_out);
    return this->Status == Z_OK || this->Status == Z_STREAM_END;
  }

  // A gzip file can have several members, and padding after the last one.
  bool BeginNextMember()
  {
    const bool isNext =
      this->Status == Z_STREAM_END && this->Stream.avail_in > 0 && *this->Stream.next_in == 0x1f;
    if (isNext)
    {
      inflateReset(&this->Stream);
    }
    return isNext || this->Status == Z_OK;
  }

  z_stream Stream = {};
  int Status = Z_OK;
};

lms3dFileContents ReadPacked(std::istream& file, std::string bytes, std::size_t maximumBytes)
{
  Unpacker unpacker;
  bool isMore = unpacker.Unpack(bytes, maximumBytes);
  while (isMore && file)
  {
    bytes = ReadBytes(file, ChunkSize);
    isMore = unpacker.Unpack(bytes, maximumBytes);
  }
  const bool isWhole = unpacker.IsComplete() || unpacker.Text.size() >= maximumBytes;
  return { std::move(unpacker.Text),
    isWhole ? "" : "is damaged: only its beginning can be unpacked" };
}

// Reads the rest in one step, because the file can be large.
lms3dFileContents ReadPlain(
  std::istream& file, std::string bytes, std::size_t fileSize, std::size_t maximumBytes)
{
  const std::size_t wanted = std::min(fileSize, maximumBytes);
  const std::size_t before = std::min(bytes.size(), wanted);
  bytes.resize(wanted);
  file.read(&bytes[before], static_cast<std::streamsize>(wanted - before));
  bytes.resize(before + static_cast<std::size_t>(file.gcount()));
  return { std::move(bytes), "" };
}
} // namespace

bool lms3dIsRegularFile(const std::string& fileName)
{
  std::error_code error;
  return std::filesystem::is_regular_file(fileName, error);
}

bool lms3dIsPackedFile(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return IsPacked(ReadBytes(file, 2));
}

std::string lms3dReadBeginning(const std::string& fileName, std::size_t count)
{
  if (!lms3dIsRegularFile(fileName))
  {
    return "";
  }
  std::ifstream file(fileName, std::ios::binary);
  std::string bytes = ReadBytes(file, std::max(count, ChunkSize));
  bytes = IsPacked(bytes) ? ReadPacked(file, std::move(bytes), count).Text : bytes;
  return bytes.substr(0, count);
}

lms3dFileContents lms3dReadFile(const std::string& fileName, std::int64_t maximumBytes)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  if (error || !lms3dIsRegularFile(fileName))
  {
    return { "", "does not exist or is not a regular file" };
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    return { "", "cannot be opened" };
  }
  // One more byte shows whether the file is longer.
  const std::size_t limit = static_cast<std::size_t>(maximumBytes);
  std::string bytes = ReadBytes(file, std::min<std::size_t>(size, ChunkSize));
  lms3dFileContents contents = IsPacked(bytes) ? ReadPacked(file, std::move(bytes), limit + 1)
                                               : ReadPlain(file, std::move(bytes), size, limit + 1);
  if (contents.Text.size() > limit)
  {
    contents.Text.resize(limit);
    contents.Problem = "is longer than MaximumFileSize allows; the rest is not read";
  }
  return contents;
}
