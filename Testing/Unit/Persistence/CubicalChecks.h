/**
 * @file CubicalChecks.h
 * @brief The tests of volumes: pairs must be those of GUDHI.
 */
#ifndef isthmus_CubicalChecks_h
#define isthmus_CubicalChecks_h

#include "CubicalPeer.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <string>

namespace isthmus::testing
{

/// The multisets of pairs are equal, to the bit. Skips, or fails where data are required, without
/// GUDHI.
inline void ExpectEqualToGudhi(const VolumeView& volume, const std::string& what, bool superlevel)
{
#if ISTHMUS_HAS_GUDHI_CUBICAL
  const Bars ours = CollectBars(volume, superlevel);
  EXPECT_TRUE(ours == BarsOfGudhi(volume, superlevel)) << what << ", superlevel " << superlevel;
  EXPECT_GE(ours.size(), 1u) << what;
#else
  static_cast<void>(volume);
  static_cast<void>(superlevel);
  static_cast<void>(what);
  GTEST_SKIP() << "GUDHI is not installed (libgudhi-dev)";
#endif
}

/// Compares both sublevels and superlevels.
inline void ExpectEqualToGudhi(const VolumeView& volume, const std::string& what)
{
  ExpectEqualToGudhi(volume, what, false);
  ExpectEqualToGudhi(volume, what, true);
}

}

#endif
