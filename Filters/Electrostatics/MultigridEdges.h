/**
 * @file MultigridEdges.h
 * @brief The permittivities of a level's edges, from codes or as they are, behind one call.
 */
#ifndef isthmus_MultigridEdges_h
#define isthmus_MultigridEdges_h

#include "Electrostatics/MultigridLevel.h"

namespace isthmus
{

/// Permittivity times weight of edges, from codes or as stored.
struct CodedEdges
{
  const unsigned char* Code[3];
  float Table[3][256];

  explicit CodedEdges(const MultigridLevel& level)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Code[a] = level.Coded.Code[a].data();
      for (std::size_t c = 0; c < 256; ++c)
      {
        this->Table[a][c] = level.Weight[a] * level.Coded.Table[c];
      }
    }
  }
  float operator()(std::size_t axis, std::int64_t node) const
  {
    return this->Table[axis][this->Code[axis][node]];
  }
};

struct StoredEdges
{
  const float* Edge[3];

  explicit StoredEdges(const MultigridLevel& level)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Edge[a] = level.Edge[a].data();
    }
  }
  float operator()(std::size_t axis, std::int64_t node) const { return this->Edge[axis][node]; }
};

/// Calls `use` with the edges of the level.
template <typename Use>
void WithEdges(const MultigridLevel& level, Use&& use)
{
  if (level.Finest())
  {
    use(CodedEdges(level));
  }
  else
  {
    use(StoredEdges(level));
  }
}

}

#endif
