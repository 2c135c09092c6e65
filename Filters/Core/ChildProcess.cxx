#include "Core/ChildProcess.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace isthmus
{
namespace
{

/// A started program; killed by the destructor unless it has ended and was waited for.
class Child
{
public:
  Child(std::vector<std::string> command, const std::filesystem::path& log)
  {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (std::string& word : command)
    {
      arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(
      &actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, S_IRUSR | S_IWUSR);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    const int error =
      posix_spawn(&this->Pid, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
    {
      throw std::runtime_error(
        "No process could be started (" + std::string(std::strerror(error)) + ").");
    }
  }

  ~Child()
  {
    if (!this->HasEnded())
    {
      kill(this->Pid, SIGKILL);
      while (waitpid(this->Pid, &this->State, 0) < 0 && errno == EINTR)
      {
      }
    }
  }

  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool HasEnded()
  {
    // An error other than EINTR (another caller has waited) also means that there is nothing to
    // wait for.
    if (!this->Done)
    {
      const pid_t answer = waitpid(this->Pid, &this->State, WNOHANG);
      this->Done = answer == this->Pid || (answer < 0 && errno != EINTR);
    }
    return this->Done;
  }

  int Status() const { return this->State; }
  pid_t Id() const { return this->Pid; }

private:
  pid_t Pid = -1;
  int State = 0;
  bool Done = false;
};

/**
 * Kills a program and removes a folder when this process dies, for whatever reason: a shell in a
 * separate session waits at a pipe that only this process holds open. PR_SET_PDEATHSIG would kill
 * the program with the thread that started it.
 */
class Watchdog
{
public:
  Watchdog(pid_t program, const std::filesystem::path& folder)
  {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
    {
      return; // the time limit of the program itself remains
    }
    this->Lifeline = ends[1];
    const std::string pid = std::to_string(program);
    const std::string script = "read -r word && exit 0; kill -9 \"$1\" 2>/dev/null; rm -rf \"$2\"";
    const std::string path = folder.string();
    const char* arguments[] = { "/bin/sh", "-c", script.c_str(), "sh", pid.c_str(), path.c_str(),
      nullptr };
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
    if (posix_spawn(&this->Pid, arguments[0], &actions, &attributes,
          const_cast<char* const*>(arguments), environ) != 0)
    {
      this->Pid = -1;
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
  }

  ~Watchdog()
  {
    if (this->Lifeline >= 0)
    {
      // Success. If the watchdog was killed, the pipe is broken, which is not an error.
      struct sigaction ignore = {}, before = {};
      ignore.sa_handler = SIG_IGN;
      sigaction(SIGPIPE, &ignore, &before);
      const ssize_t written = write(this->Lifeline, "\n", 1);
      static_cast<void>(written);
      close(this->Lifeline);
      int state = 0;
      while (this->Pid > 0 && waitpid(this->Pid, &state, 0) < 0 && errno == EINTR)
      {
      }
      sigaction(SIGPIPE, &before, nullptr);
    }
  }

  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

private:
  int Lifeline = -1;
  pid_t Pid = -1;
};

/// posix_spawn sets no limits, so a shell sets them and then executes the program.
std::vector<std::string> AddLimits(
  const std::vector<std::string>& command, const ChildLimits& limits)
{
  // The limit of processor time is a safeguard: it holds even if this process dies meanwhile.
  std::string script = "ulimit -c 0; ulimit -t " +
    std::to_string(static_cast<std::int64_t>(limits.TimeLimit) + 2) + "; ";
  if (limits.Bytes > 0)
  {
    script += "ulimit -v " + std::to_string(limits.Bytes / 1024) + "; ";
  }
  std::vector<std::string> full{ "/bin/sh", "-c",
    script + "command -v \"$1\" >/dev/null || exit 127; exec \"$@\"", "sh" };
  full.insert(full.end(), command.begin(), command.end());
  return full;
}

std::string ReadTail(const std::filesystem::path& log)
{
  constexpr std::streamoff most = 4000;
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : 0;
  std::string text(static_cast<std::size_t>(std::min(size, most)), '\0');
  file.seekg(size - static_cast<std::streamoff>(text.size()));
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

}

TemporaryFolder::TemporaryFolder()
{
  std::error_code missing;
  const std::filesystem::path place = std::filesystem::temp_directory_path(missing);
  if (missing)
  {
    const char* named = std::getenv("TMPDIR");
    throw std::runtime_error("The folder for temporary files, " +
      std::string(named ? named : "/tmp") + ", does not exist (" + missing.message() +
      "): create it, or set TMPDIR to an existing folder.");
  }
  std::string name = (place / "isthmus-XXXXXX").string();
  if (!mkdtemp(name.data()))
  {
    throw std::runtime_error("No temporary folder could be created in " + place.string() + " (" +
      std::strerror(errno) + "): free some space or set TMPDIR.");
  }
  this->Folder = name;
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Folder, ignored);
}

ChildResult RunChild(const std::vector<std::string>& command, const ChildLimits& limits,
  const std::filesystem::path& log, const ProgressCallback& progress)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Child child(AddLimits(command, limits), log);
  const Watchdog watchdog(child.Id(), log.parent_path());
  auto pause = std::chrono::milliseconds(1); // poll short programs often, long ones rarely
  while (!child.HasEnded())
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds > limits.TimeLimit)
    {
      return { ChildEnd::TimedOut, 0, ReadTail(log) };
    }
    Report(progress, seconds / limits.TimeLimit);
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
  const int status = child.Status();
  if (WIFSIGNALED(status))
  {
    // The limit of processor time exceeds that of wall time, so an earlier one was set by another
    // program.
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const bool outOfTime = WTERMSIG(status) == SIGXCPU && seconds > 0.9 * limits.TimeLimit;
    return { outOfTime ? ChildEnd::TimedOut : ChildEnd::Crashed, WTERMSIG(status), ReadTail(log) };
  }
  const int code = WEXITSTATUS(status);
  const ChildEnd end = code == 127 ? ChildEnd::NotFound
    : code == 126                  ? ChildEnd::NotRun
                                   : ChildEnd::Exited;
  return { end, code, ReadTail(log) };
}

}
