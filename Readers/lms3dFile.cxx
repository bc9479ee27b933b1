// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dFile.h"

#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace
{
constexpr std::size_t BytesOfStep = 1 << 18;
constexpr int GzipWindow = 15 + 16;

/// So many bytes, or fewer at the end of the file.
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

/// Keeps what it has unpacked when the packed bytes turn out to be damaged.
class Unpacker
{
public:
  Unpacker() { inflateInit2(&this->Stream, GzipWindow); }
  ~Unpacker() { inflateEnd(&this->Stream); }
  Unpacker(const Unpacker&) = delete;
  void operator=(const Unpacker&) = delete;

  std::string Text;

  /// Appends to the text until it has so many bytes; false at the end or a fault of the packed file.
  bool Unpack(const std::string& bytes, std::size_t mostBytes)
  {
    this->Stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    this->Stream.avail_in = static_cast<uInt>(bytes.size());
    while (this->Stream.avail_in > 0 && this->Text.size() < mostBytes)
    {
      if (!this->UnpackStep(mostBytes) || !this->BeginNextMember())
      {
        return false;
      }
    }
    return this->Text.size() < mostBytes;
  }

  bool IsComplete() const { return this->Status == Z_STREAM_END; }

private:
  bool UnpackStep(std::size_t mostBytes)
  {
    const std::size_t before = this->Text.size();
    const std::size_t room = std::min(mostBytes - before, BytesOfStep);
    this->Text.resize(before + room);
    this->Stream.next_out = reinterpret_cast<Bytef*>(&this->Text[before]);
    this->Stream.avail_out = static_cast<uInt>(room);
    this->Status = inflate(&this->Stream, Z_NO_FLUSH);
    this->Text.resize(this->Text.size() - this->Stream.avail_out);
    return this->Status == Z_OK || this->Status == Z_STREAM_END;
  }

  // A file may have several packed parts, and filling behind the last.
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

lms3dFileContents ReadPacked(std::istream& file, std::string bytes, std::size_t mostBytes)
{
  Unpacker unpacker;
  bool isMore = unpacker.Unpack(bytes, mostBytes);
  while (isMore && file)
  {
    bytes = ReadBytes(file, BytesOfStep);
    isMore = unpacker.Unpack(bytes, mostBytes);
  }
  const bool isWhole = unpacker.IsComplete() || unpacker.Text.size() >= mostBytes;
  return { std::move(unpacker.Text),
    isWhole ? "" : "is damaged: it cannot be unpacked to its end" };
}

// All that there is in one step: the file may be large.
lms3dFileContents ReadPlain(
  std::istream& file, std::string bytes, std::size_t fileSize, std::size_t mostBytes)
{
  const std::size_t most = std::min(fileSize, mostBytes);
  const std::size_t before = std::min(bytes.size(), most);
  bytes.resize(most);
  file.read(&bytes[before], static_cast<std::streamsize>(most - before));
  bytes.resize(before + static_cast<std::size_t>(file.gcount()));
  return { std::move(bytes), "" };
}
} // namespace

bool lms3dIsRegularFile(const std::string& fileName)
{
  std::error_code error;
  return std::filesystem::is_regular_file(fileName, error);
}

std::string lms3dReadBeginning(const std::string& fileName, std::size_t count)
{
  if (!lms3dIsRegularFile(fileName))
  {
    return "";
  }
  std::ifstream file(fileName, std::ios::binary);
  std::string bytes = ReadBytes(file, std::max(count, BytesOfStep));
  bytes = IsPacked(bytes) ? ReadPacked(file, std::move(bytes), count).Text : bytes;
  return bytes.substr(0, count);
}

lms3dFileContents lms3dReadFile(const std::string& fileName, std::int64_t mostBytes)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  if (error || !lms3dIsRegularFile(fileName))
  {
    return { "", "is not there or is no regular file" };
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    return { "", "cannot be opened" };
  }
  // One byte more tells whether there is more.
  const std::size_t most = static_cast<std::size_t>(mostBytes);
  std::string bytes = ReadBytes(file, std::min<std::size_t>(size, BytesOfStep));
  lms3dFileContents contents = IsPacked(bytes) ? ReadPacked(file, std::move(bytes), most + 1)
                                               : ReadPlain(file, std::move(bytes), size, most + 1);
  if (contents.Text.size() > most)
  {
    contents.Text.resize(most);
    contents.Problem = "is longer than MaximumFileSize lets it be; the rest is not read";
  }
  return contents;
}
