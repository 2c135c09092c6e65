/**
 * @file MeshError.h
 * @brief The error for a list of cells that is not a valid mesh for a combinatorial map.
 */
#ifndef isthmus_MeshError_h
#define isthmus_MeshError_h

#include <stdexcept>
#include <string>

namespace isthmus
{

/// Thrown if cells are rejected; the message names the first of them.
class MeshError : public std::invalid_argument
{
public:
  enum class Reason
  {
    OutOfRange,   ///< a cell uses a vertex that does not exist
    Degenerate,   ///< a cell uses a vertex twice
    NonManifold,  ///< more than two cells share a face
    Orientation,  ///< two cells see their common face in the same direction
    Inconsistent, ///< the lists contradict each other
    TooLarge      ///< the ids do not fit
  };

  MeshError(Reason reason, const std::string& sentence)
    : std::invalid_argument(sentence)
    , Why(reason)
  {
  }
  Reason Kind() const { return this->Why; }

private:
  Reason Why;
};

}

#endif
