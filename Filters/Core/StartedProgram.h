/**
 * @file StartedProgram.h
 * @brief What RunChild() needs of the operating system; one source for each system.
 */
#ifndef isthmus_StartedProgram_h
#define isthmus_StartedProgram_h

#include "Core/ChildLimits.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isthmus
{

/// A new, empty folder in `place`, which no other user may enter; its path is empty, and errno set,
/// on failure.
std::filesystem::path NewFolderIn(const std::filesystem::path& place);

/**
 * A program that was started; killed by the destructor unless it has ended. If this process dies
 * meanwhile, the program is killed, too, and the folder of its output is removed (except on
 * Windows).
 */
class StartedProgram
{
public:
  /// @throws std::runtime_error when no process can be started.
  StartedProgram(const std::vector<std::string>& command, const ChildLimits& limits,
    const std::filesystem::path& log);
  ~StartedProgram();
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  bool HasEnded();

  struct Ending
  {
    ChildEnd End;
    int Code;
  };
  /// How it ended after `seconds`. @pre HasEnded().
  Ending HowItEnded(double seconds) const;

private:
  class Internals;
  std::unique_ptr<Internals> State;
};

}

#endif
