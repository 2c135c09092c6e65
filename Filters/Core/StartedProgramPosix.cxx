#include "Core/StartedProgram.h"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __APPLE__
#include <crt_externs.h>
#else
extern char** environ;
#endif

namespace isthmus
{
namespace
{

char** Environment()
{
#ifdef __APPLE__
  return *_NSGetEnviron(); // libraries have no environ there
#else
  return environ;
#endif
}

/// A pipe that programs started meanwhile by other threads do not inherit; macOS leaves a moment in
/// which they do.
bool OpenPipe(int (&ends)[2])
{
#ifdef __APPLE__
  return pipe(ends) == 0 && fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 &&
    fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
#else
  return pipe2(ends, O_CLOEXEC) == 0;
#endif
}

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
      posix_spawn(&this->Pid, arguments[0], &actions, nullptr, arguments.data(), Environment());
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
    if (!OpenPipe(ends))
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
          const_cast<char* const*>(arguments), Environment()) != 0)
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

}

std::filesystem::path NewFolderIn(const std::filesystem::path& place)
{
  std::string name = (place / "isthmus-XXXXXX").string();
  return mkdtemp(name.data()) ? std::filesystem::path(name) : std::filesystem::path();
}

class StartedProgram::Internals
{
public:
  Internals(const std::vector<std::string>& command, const ChildLimits& limits,
    const std::filesystem::path& log)
    : TimeLimit(limits.TimeLimit)
    , Program(AddLimits(command, limits), log)
    , Guard(Program.Id(), log.parent_path())
  {
  }

  double TimeLimit;
  Child Program;
  Watchdog Guard;
};

StartedProgram::StartedProgram(const std::vector<std::string>& command, const ChildLimits& limits,
  const std::filesystem::path& log)
  : State(std::make_unique<Internals>(command, limits, log))
{
}

StartedProgram::~StartedProgram() = default;

bool StartedProgram::HasEnded()
{
  return this->State->Program.HasEnded();
}

StartedProgram::Ending StartedProgram::HowItEnded(double seconds) const
{
  const int status = this->State->Program.Status();
  if (WIFSIGNALED(status))
  {
    // The limit of processor time exceeds that of wall time, so an earlier one was set by another
    // program.
    const bool outOfTime = WTERMSIG(status) == SIGXCPU && seconds > 0.9 * this->State->TimeLimit;
    return { outOfTime ? ChildEnd::TimedOut : ChildEnd::Crashed, WTERMSIG(status) };
  }
  const int code = WEXITSTATUS(status);
  const ChildEnd end = code == 127 ? ChildEnd::NotFound
    : code == 126                  ? ChildEnd::NotRun
                                   : ChildEnd::Exited;
  return { end, code };
}

}
