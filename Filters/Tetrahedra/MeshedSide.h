/**
 * @file MeshedSide.h
 * @brief Which side of a surface is filled with tetrahedra.
 */
#ifndef isthmus_MeshedSide_h
#define isthmus_MeshedSide_h

namespace isthmus
{

enum class MeshedSide
{
  Inside,  ///< the solids
  Outside, ///< what is between the solids and the box, cavities included
  Both
};

}

#endif
