#include "Files/PlainFile.h"

#include "Core/NumberText.h"
#include "Files/ReaderError.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

namespace isthmus
{
namespace
{

HANDLE HandleOf(std::intptr_t descriptor)
{
  return reinterpret_cast<HANDLE>(descriptor);
}

std::string LastMessage()
{
  return std::system_category().message(static_cast<int>(GetLastError()));
}

}

PlainFile::PlainFile(const std::string& path)
  : Name(path)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status))
  {
    throw ReaderError(ReaderFailure::NoSuchFile, path + ": there is no such file. Check its name.");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    throw ReaderError(ReaderFailure::CannotRead,
      path +
        (std::filesystem::is_directory(status)
            ? ": this is a folder. Choose a file in it."
            : ": this is not a regular file. Copy it to one first."));
  }
  const HANDLE handle =
    CreateFileW(file.c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
      nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE)
  {
    throw ReaderError(ReaderFailure::CannotRead,
      path + ": the file can't be opened (" + LastMessage() + "). Check its permissions.");
  }
  LARGE_INTEGER size{};
  if (!GetFileSizeEx(handle, &size) || size.QuadPart == 0)
  {
    CloseHandle(handle);
    throw ReaderError(
      ReaderFailure::Truncated, path + ": the file is empty (0 bytes). Fetch or write it again.");
  }
  this->Descriptor = reinterpret_cast<std::intptr_t>(handle);
  this->Bytes = static_cast<std::uint64_t>(size.QuadPart);
  BY_HANDLE_FILE_INFORMATION about{};
  GetFileInformationByHandle(handle, &about);
  this->Version = JoinText(path, ' ', about.dwVolumeSerialNumber, ' ', about.nFileIndexHigh, ' ',
    about.nFileIndexLow, ' ', this->Bytes, ' ', about.ftLastWriteTime.dwHighDateTime, ' ',
    about.ftLastWriteTime.dwLowDateTime);
}

PlainFile::PlainFile(PlainFile&& other) noexcept
  : Name(std::move(other.Name))
  , Version(std::move(other.Version))
  , Descriptor(std::exchange(other.Descriptor, -1))
  , Bytes(other.Bytes)
{
}

PlainFile::~PlainFile()
{
  if (this->Descriptor != -1)
  {
    CloseHandle(HandleOf(this->Descriptor));
  }
}

std::size_t PlainFile::Read(std::uint64_t offset, void* to, std::size_t size) const
{
  constexpr std::size_t most = std::size_t{ 1 } << 30;
  std::size_t done = 0;
  while (done < size)
  {
    // With a place of its own, a call does not depend on the position that threads share.
    const std::uint64_t begin = offset + done;
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(begin & 0xffffffffu);
    place.OffsetHigh = static_cast<DWORD>(begin >> 32);
    DWORD got = 0;
    if (!ReadFile(HandleOf(this->Descriptor), static_cast<char*>(to) + done,
          static_cast<DWORD>(std::min(size - done, most)), &got, &place) &&
      GetLastError() != ERROR_HANDLE_EOF)
    {
      throw ReaderError(ReaderFailure::CannotRead,
        this->Name + ": reading failed at byte " + std::to_string(begin) + " (" + LastMessage() +
          ").");
    }
    if (got == 0)
    {
      break;
    }
    done += got;
  }
  return done;
}

}
