/**
 * @file PeerPrograms.h
 * @brief Persistence of a volume by programs of others, run as processes of their own.
 *
 * Peers/build.sh builds them; the environment variable ISTHMUS_PEERS names their folder.
 */
#ifndef isthmus_PeerPrograms_h
#define isthmus_PeerPrograms_h

#include "CubicalPeer.h"
#include "Peers/DiphaFiles.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

extern char** environ;

namespace isthmus::testing
{

enum class PeerProgram
{
  CubicalRipser,
  TTK
};

struct PeerRun
{
  double Seconds = 0.0; ///< CPU of its process, files included
  double Peak = 0.0;    ///< resident bytes; not less than what we hold when it starts
  Bars Pairs;           ///< sorted, without those of length 0
};

/// Runs a program with its words and without a voice; throws std::runtime_error if it fails.
inline PeerRun RunProgram(const std::vector<std::string>& words)
{
  std::vector<char*> arguments;
  for (const std::string& word : words)
  {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed =
    posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = -1;
  rusage used{};
  while (failed == 0 && wait4(child, &status, 0, &used) < 0 && errno == EINTR)
  {
  }
  if (failed != 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
  {
    throw std::runtime_error(words[0] + " failed.");
  }
  const auto seconds = [](const timeval& t)
  { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return { seconds(used.ru_utime) + seconds(used.ru_stime),
    1024.0 * static_cast<double>(used.ru_maxrss), {} };
}

inline std::filesystem::path PathOf(PeerProgram peer)
{
  const char* folder = std::getenv("ISTHMUS_PEERS");
  return std::filesystem::path(folder ? folder : "") /
    (peer == PeerProgram::TTK ? "ttk_grid_persistence" : "cubicalripser");
}

/// Nothing where the program is missing.
inline std::optional<PeerRun> RunPeer(
  PeerProgram peer, const VolumeView& volume, bool superlevel = false)
{
  const std::filesystem::path program = PathOf(peer);
  if (!std::filesystem::exists(program))
  {
    return {};
  }
  const double sign = superlevel ? -1.0 : 1.0;
  DiphaImage image{ volume.Dimensions, {} };
  for (std::int64_t node = 0; node < volume.NodeCount(); ++node)
  {
    image.Values.push_back(sign * volume.Value(node));
  }
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string stem = (folder / ("isthmus_peer_" + std::to_string(getpid()))).string();
  WriteDiphaImage(stem + ".complex", image);
  std::vector<double>().swap(image.Values);
  PeerRun run = peer == PeerProgram::TTK
    ? RunProgram({ program.string(), stem + ".complex", stem + ".diagram" })
    : RunProgram({ program.string(), "-m", "2", "-o", stem + ".diagram", stem + ".complex" });
  for (const DiphaPair& pair : ReadDiphaPairs(stem + ".diagram"))
  {
    const bool never = pair.Death >= std::numeric_limits<double>::max();
    run.Pairs.push_back({ static_cast<double>(pair.Dimension), sign * pair.Birth,
      sign * (never ? std::numeric_limits<double>::infinity() : pair.Death) });
  }
  std::sort(run.Pairs.begin(), run.Pairs.end());
  std::filesystem::remove(stem + ".complex");
  std::filesystem::remove(stem + ".diagram");
  return run;
}

}

#endif
