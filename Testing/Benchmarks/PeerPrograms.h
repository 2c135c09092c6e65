/**
 * @file PeerPrograms.h
 * @brief Persistence of a volume by other programs, run as separate processes.
 *
 * The environment variable ISTHMUS_PEERS names their folder, which must hold
 *   cubicalripser -m 2 -o OUT.diagram IN.complex
 *     Cubical Ripser (github.com/shizuo-kaji/CubicalRipser_3dim), volumes of three axes;
 *   ttk_grid_persistence IN.complex OUT.diagram
 *     TTK (github.com/topology-tool-kit/ttk, 1.2 or newer) with Peers/ttk_grid_persistence.cxx;
 *   ttk_mesh_persistence IN.tetrahedra OUT.diagram OUT.seconds [THREADS]
 *     TTK with Peers/ttk_mesh_persistence.cxx, on tetrahedra.
 * Volumes (.complex) and pairs (.diagram) are in DIPHA's format (Peers/DiphaFiles.h), meshes
 * (.tetrahedra) as Peers/TetrahedraFiles.h describes; OUT.seconds gets the CPU and the wall seconds
 * without files. Missing programs are named in the row, which then has no ratio.
 */
#ifndef isthmus_PeerPrograms_h
#define isthmus_PeerPrograms_h

#include "CubicalPeer.h"
#include "Peers/TetrahedraFiles.h"

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

/// Runs a program with these arguments, discarding its output; throws std::runtime_error if it
/// fails.
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

inline std::filesystem::path FindPeerProgram(PeerProgram peer)
{
  const char* folder = std::getenv("ISTHMUS_PEERS");
  return std::filesystem::path(folder ? folder : "") /
    (peer == PeerProgram::TTK ? "ttk_grid_persistence" : "cubicalripser");
}

/// Nothing where the program is missing.
inline std::optional<PeerRun> RunPeer(
  PeerProgram peer, const VolumeView& volume, bool superlevel = false)
{
  const std::filesystem::path program = FindPeerProgram(peer);
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

struct MeshPeerRun
{
  double Seconds = 0.0; ///< CPU of preconditioning and pairing alone
  double Wall = 0.0;
  DiphaPairs Pairs;
};

/// TTK on tetrahedra; nothing where its program is missing.
inline std::optional<MeshPeerRun> RunMeshPeer(const ValuedTetrahedra& mesh, int threads)
{
  const char* peers = std::getenv("ISTHMUS_PEERS");
  const auto program = std::filesystem::path(peers ? peers : "") / "ttk_mesh_persistence";
  if (!std::filesystem::exists(program))
  {
    return {};
  }
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string stem = (folder / ("isthmus_peer_" + std::to_string(getpid()))).string();
  WriteTetrahedra(stem + ".tetrahedra", mesh);
  RunProgram({ program.string(), stem + ".tetrahedra", stem + ".diagram", stem + ".seconds",
    std::to_string(threads) });
  MeshPeerRun run;
  if (!(std::ifstream(stem + ".seconds") >> run.Seconds >> run.Wall))
  {
    throw std::runtime_error(program.string() + " told no times.");
  }
  run.Pairs = ReadDiphaPairs(stem + ".diagram");
  for (const char* ending : { ".tetrahedra", ".diagram", ".seconds" })
  {
    std::filesystem::remove(stem + ending);
  }
  return run;
}

}

#endif
