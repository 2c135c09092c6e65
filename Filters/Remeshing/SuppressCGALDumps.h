/**
 * @file SuppressCGALDumps.h
 * @brief Prevents CGAL's Mesh_3 from leaving files behind when it fails.
 *
 * The refinement of facets and other steps write dump-bug.mesh and dump-bug.binary.cgal into the
 * current folder and a line to the terminal before they throw (CGAL 5.5). Include this before any
 * header of Mesh_3, so that these steps call a function that does nothing.
 */
#ifndef isthmus_SuppressCGALDumps_h
#define isthmus_SuppressCGALDumps_h

#include <CGAL/Mesh_3/Dump_c3t3.h>

#include <string>

namespace CGAL
{

template <typename C3t3>
void DiscardDump(const C3t3&, const std::string&)
{
}

}

#define dump_c3t3 DiscardDump

#endif
