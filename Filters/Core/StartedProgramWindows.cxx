#include "Core/StartedProgram.h"

#include <cerrno>
#include <cstdint>
#include <random>
#include <stdexcept>

#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

namespace isthmus
{
namespace
{

class OwnedHandle
{
public:
  explicit OwnedHandle(HANDLE value = nullptr)
    : Value(value == INVALID_HANDLE_VALUE ? nullptr : value)
  {
  }
  ~OwnedHandle()
  {
    if (this->Value)
    {
      CloseHandle(this->Value);
    }
  }
  OwnedHandle(const OwnedHandle&) = delete;
  OwnedHandle& operator=(const OwnedHandle&) = delete;

  HANDLE Get() const { return this->Value; }

private:
  HANDLE Value;
};

std::wstring WideText(const std::string& text)
{
  const int size = static_cast<int>(text.size());
  std::wstring wide(
    static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)),
    L'\0');
  MultiByteToWideChar(CP_UTF8, 0, text.data(), size, wide.data(), static_cast<int>(wide.size()));
  return wide;
}

/// A word of a command line that the program's start-up code splits into the same words: within
/// quotes, backslashes are doubled where a quote follows.
std::wstring QuotedWord(const std::wstring& word)
{
  std::wstring quoted = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word)
  {
    if (c == L'"')
    {
      quoted.append(backslashes + 1, L'\\');
    }
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    quoted += c;
  }
  quoted.append(backslashes, L'\\');
  return quoted + L'"';
}

/// A file that the program inherits as its input or output.
HANDLE OpenInherited(const wchar_t* path, DWORD access, DWORD disposition)
{
  SECURITY_ATTRIBUTES inherited{ sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE };
  return CreateFileW(path, access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
    &inherited, disposition, FILE_ATTRIBUTE_NORMAL, nullptr);
}

/// Kills its processes when the last handle to it is closed, also because this process dies.
HANDLE NewJob(const ChildLimits& limits)
{
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION information{};
  information.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (limits.Bytes > 0)
  {
    information.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    information.ProcessMemoryLimit = static_cast<SIZE_T>(limits.Bytes);
  }
  SetInformationJobObject(
    job, JobObjectExtendedLimitInformation, &information, sizeof(information));
  return job;
}

}

std::filesystem::path NewFolderIn(const std::filesystem::path& place)
{
  std::random_device random;
  std::error_code error;
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    std::filesystem::path folder = place / ("isthmus-" + std::to_string(random()));
    if (std::filesystem::create_directory(folder, error))
    {
      return folder;
    }
    if (error)
    {
      break;
    }
  }
  errno = error ? error.default_error_condition().value() : EEXIST;
  return {};
}

class StartedProgram::Internals
{
public:
  Internals(const std::vector<std::string>& command, const ChildLimits& limits,
    const std::filesystem::path& log)
    : Job(NewJob(limits))
  {
    std::wstring line;
    for (const std::string& word : command)
    {
      line += (line.empty() ? L"" : L" ") + QuotedWord(WideText(word));
    }
    const OwnedHandle input(OpenInherited(L"NUL", GENERIC_READ, OPEN_EXISTING));
    const OwnedHandle output(OpenInherited(log.c_str(), GENERIC_WRITE, CREATE_ALWAYS));
    STARTUPINFOW startup{};
    startup.cb = sizeof(startup);
    startup.dwFlags = STARTF_USESTDHANDLES;
    startup.hStdInput = input.Get();
    startup.hStdOutput = output.Get();
    startup.hStdError = output.Get();
    PROCESS_INFORMATION made{};
    // Suspended until it belongs to the job.
    if (!CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE,
          CREATE_SUSPENDED | CREATE_NO_WINDOW, nullptr, nullptr, &startup, &made))
    {
      this->Error = GetLastError();
      if (!this->IsMissing() && !this->IsNoProgram())
      {
        throw std::runtime_error(
          "No process could be started (error " + std::to_string(this->Error) + " of Windows).");
      }
      return;
    }
    this->Process = made.hProcess;
    AssignProcessToJobObject(this->Job.Get(), made.hProcess);
    ResumeThread(made.hThread);
    CloseHandle(made.hThread);
  }

  ~Internals()
  {
    if (this->Process)
    {
      TerminateJobObject(this->Job.Get(), 1);
      CloseHandle(this->Process);
    }
  }

  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  bool IsMissing() const
  {
    return this->Error == ERROR_FILE_NOT_FOUND || this->Error == ERROR_PATH_NOT_FOUND;
  }
  bool IsNoProgram() const
  {
    return this->Error == ERROR_ACCESS_DENIED || this->Error == ERROR_BAD_EXE_FORMAT;
  }

  OwnedHandle Job;
  HANDLE Process = nullptr;
  DWORD Error = 0;
};

StartedProgram::StartedProgram(const std::vector<std::string>& command, const ChildLimits& limits,
  const std::filesystem::path& log)
  : State(std::make_unique<Internals>(command, limits, log))
{
}

StartedProgram::~StartedProgram() = default;

bool StartedProgram::HasEnded()
{
  return !this->State->Process || WaitForSingleObject(this->State->Process, 0) == WAIT_OBJECT_0;
}

StartedProgram::Ending StartedProgram::HowItEnded(double) const
{
  if (!this->State->Process)
  {
    return { this->State->IsMissing() ? ChildEnd::NotFound : ChildEnd::NotRun, 0 };
  }
  DWORD code = 0;
  GetExitCodeProcess(this->State->Process, &code);
  // Exceptions end a program with the code of an error (0xC0000005: access violation).
  return { code >= 0xC0000000u ? ChildEnd::Crashed : ChildEnd::Exited, static_cast<int>(code) };
}

}
