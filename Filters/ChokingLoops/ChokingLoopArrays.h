/**
 * @file ChokingLoopArrays.h
 * @brief The arrays of loops and choke points, which two filters have as different outputs.
 */
#ifndef isthmus_ChokingLoopArrays_h
#define isthmus_ChokingLoopArrays_h

#include "Core/OutputArrays.h"

/// Rows of a table of output arrays for the loops.
#define ISTHMUS_LOOP_ARRAY_ROWS(Port)                                                              \
  { Port, ArrayPlace::Cells, "Kind", 1, "", ArrayChoice::None,                                     \
    "0 handle, 1 tunnel, 2 additional" },                                                          \
    { Port, ArrayPlace::Cells, "KindName", 1, "", ArrayChoice::None, "the same as text" },         \
    { Port, ArrayPlace::Cells, "Side", 1, "", ArrayChoice::None, "0 inside, 1 outside" },          \
    { Port, ArrayPlace::Cells, "Radius", 1, "length", ArrayChoice::None,                           \
      "of the ball that gets stuck" },                                                             \
    { Port, ArrayPlace::Cells, "Birth", 1, "length", ArrayChoice::None, "equal to Radius" },       \
    { Port, ArrayPlace::Cells, "Death", 1, "length", ArrayChoice::None,                            \
      "radius at which the space behind the narrowing is filled" },                                \
    { Port, ArrayPlace::Cells, "Persistence", 1, "length", ArrayChoice::None, "Death - Birth" },   \
    { Port, ArrayPlace::Cells, "Uncertainty", 1, "length", ArrayChoice::None,                      \
      "the true radius lies in [Radius - Uncertainty, Radius]; on a surface of more than 40,000 "  \
      "points, and with TetrahedralMesh, in [Radius - Uncertainty, Radius + Uncertainty]. With "   \
      "TetrahedralMesh it is 0.61 times the longest edge of the tetrahedra on the same side that " \
      "come that close to the surface (with PointArray: the largest range of the array within "    \
      "one of them), since the distance is known only at the points of the mesh" },                \
    { Port, ArrayPlace::Cells, "Trusted", 1, "", ArrayChoice::None,                                \
      "1 for a feature of the surface, 0 if it may be caused by the sampling" },                   \
    { Port, ArrayPlace::Cells, "Length", 1, "length", ArrayChoice::None, "of the loop" },          \
    { Port, ArrayPlace::Cells, "Reach", 1, "", ArrayChoice::None,                                  \
      "of the feature, distance of its loops' farthest point from the choke point, in radii: 1 "   \
      "for "                                                                                       \
      "a round neck" },                                                                            \
    { Port, ArrayPlace::Cells, "FeatureId", 1, "", ArrayChoice::None,                              \
      "number of the feature in all outputs" },                                                    \
    { Port, ArrayPlace::Cells, "Component", 1, "", ArrayChoice::None, "of the surface" },          \
    { Port, ArrayPlace::Cells, "SharedWith", 1, "", ArrayChoice::None,                             \
      "if several narrowings have the same loop, such as the windows of a wall: the FeatureId of " \
      "the first of them, whose points the cells of the others use; otherwise -1" },               \
    { Port, ArrayPlace::Field, "NumberOfSamples", 1, "", ArrayChoice::None, "of the surface" },    \
    { Port, ArrayPlace::Field, "LargestSamplingError", 1, "length", ArrayChoice::None,             \
      "of all samples" },                                                                          \
    { Port, ArrayPlace::Field, "ReferenceLength", 1, "length", ArrayChoice::None,                  \
      "inside, outside" },                                                                         \
    { Port, ArrayPlace::Field, "NumberOfHandles", 1, "", ArrayChoice::None, "features" },          \
    { Port, ArrayPlace::Field, "NumberOfTunnels", 1, "", ArrayChoice::None, "features" },          \
    { Port, ArrayPlace::Field, "NumberOfAdditionalLoops", 1, "", ArrayChoice::None,                \
      "inside, outside; features, each counted once, however many loops it has" },                 \
    { Port, ArrayPlace::Field, "NumberOfFeatures", 1, "", ArrayChoice::None,                       \
      "selected by Side and the thresholds" },                                                     \
    { Port, ArrayPlace::Field, "NumberOfUntrustedFeatures", 1, "", ArrayChoice::None,              \
      "those of them that are not trusted" },                                                      \
    { Port, ArrayPlace::Field, "NumberOfShownFeatures", 1, "", ArrayChoice::None,                  \
      "those of them that remain after MaximumNumberOfLoops, TrustedOnly, MaximumLength and "      \
      "MaximumReach" },                                                                            \
  {                                                                                                \
    Port, ArrayPlace::Field, "ProposedThreshold", 2, "length", ArrayChoice::None,                  \
      "inside, outside: the persistence at the middle of the side's largest gap, and the width "   \
      "of "                                                                                        \
      "the gap, 0 if there is none"                                                                \
  }

/// The same for the choke points.
#define ISTHMUS_CHOKE_POINT_ARRAY_ROWS(Port)                                                       \
  { Port, ArrayPlace::Points, "Radius", 1, "length", ArrayChoice::None,                            \
    "of the ball that gets stuck" },                                                               \
    { Port, ArrayPlace::Points, "Birth", 1, "length", ArrayChoice::None, "equal to Radius" },      \
    { Port, ArrayPlace::Points, "Death", 1, "length", ArrayChoice::None,                           \
      "radius at which the space behind the narrowing is filled" },                                \
    { Port, ArrayPlace::Points, "Persistence", 1, "length", ArrayChoice::None, "Death - Birth" },  \
    { Port, ArrayPlace::Points, "Kind", 1, "", ArrayChoice::None,                                  \
      "0 handle, 1 tunnel, 2 additional" },                                                        \
    { Port, ArrayPlace::Points, "Side", 1, "", ArrayChoice::None, "0 inside, 1 outside" },         \
  {                                                                                                \
    Port, ArrayPlace::Points, "FeatureId", 1, "", ArrayChoice::None, "of the loops"                \
  }

#endif
