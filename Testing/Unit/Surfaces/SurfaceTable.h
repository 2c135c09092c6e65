/**
 * @file SurfaceTable.h
 * @brief Known properties of the surfaces of the shared data.
 *
 * Numbers of a script of its own (numpy, own parsers), not of the library under test.
 */
#ifndef isthmus_SurfaceTable_h
#define isthmus_SurfaceTable_h

namespace isthmus::testing
{

struct KnownSurface
{
  const char* File;
  bool Closed; ///< closed, manifold and oriented
  int Components;
  int Genus; ///< of all components together; closed surfaces only
  double Area;
  double Volume;        ///< negative when it faces inward
  double SmallestAngle; ///< degrees
};

inline constexpr KnownSurface KnownSurfaces[] = {
  { "129110__sf.obj", true, 1, 24, 46845.64, 58859.36, 9.25 },
  { "1514499.stl", true, 15, 15, 23556.99, 23100.14, 0.0101 },
  { "2sphere.off", true, 2, 0, 3.473938, 0.4998602, 54.1 },
  { "3holes.off", true, 1, 3, 1.724672, 0.09946526, 18.7 },
  { "65004.stl", true, 1, 2, 19061.04, 12890.59, 0.0148 },
  { "697224__sf.obj", true, 1, 1, 3992.493, 13196.21, 10.2 },
  { "72214.stl", true, 1, 1, 21346.77, 30300.03, 0.0039 },
  { "Kitten.off", true, 1, 1, 14240.84, 95935.89, 10.7 },
  { "armadillo.obj", true, 1, 0, 1.605692, 0.06832287, 19.1 },
  { "block.off", true, 1, 3, 3676.646, 7395.932, 0.0618 },
  { "botijo.off", true, 1, 5, 13.97348, 2.108773, 17.3 },
  { "bucky_c60_polyhedron.obj", true, 1, 0, 11.41032, 3.445664, 29 },
  { "bumpy.off", true, 1, 0, 155.8968, 141.0105, 36.1 },
  { "bunny.off", true, 1, 0, 0.05821292, 0.0007539342, 2.74 },
  { "bunny10k.ply", false, 1, 0, 0.0571252, 0.0007287864, 0.431 },
  { "casting.off", true, 1, 9, 2.353271, 0.03391226, 1.78 },
  { "casting_inverted.off", true, 1, 9, 2.353271, -0.03391226, 1.78 },
  { "casting_ttk.vtu", true, 1, 9, 7.178566, 0.180678, 1.78 },
  { "conrod.stl", false, 1, 0, 97.35578, 7.748372, 0.00542 },
  { "cup_input_simple_10000.off", true, 1, 2, 2880.393, 2913.737, 34.3 },
  { "double-torus.obj", true, 1, 2, 6.554692, 0.6687615, 22 },
  { "dragon.off", true, 1, 0, 12494, 27017.12, 2.53 },
  { "eight.off", true, 1, 2, 1.014325, 0.04044252, 21.4 },
  { "elk.off", true, 1, 1, 67738.37, 429313.2, 10.8 },
  { "emd_5043.obj", true, 1, 36, 150320, 938814.1, 0.00556 },
  { "fandisk.off", true, 1, 0, 60.64493, 20.26731, 18.4 },
  { "fertility.off", true, 1, 4, 59829.05, 432186, 5.43 },
  { "genus3.off", true, 1, 3, 2.026747, 0.09195599, 8.33 },
  { "helix.off", true, 1, 0, 96.35677, 21.92932, 22.5 },
  { "helmet.off", true, 1, 3, 2.139288, 0.2283961, 2.34 },
  { "hero_broken.off", false, 104, 0, 69482.79, 200360.7, 0.592 },
  { "knot1.off", true, 1, 1, 2.411393, 0.09517473, 24.6 },
  { "knot_max_simplified.STL", true, 1, 1, 99606.18, 714796.2, 0.56 },
  { "neptune.off", true, 1, 3, 0.7709708, 0.01312105, 0.0328 },
  { "non_manif_hole.ply", false, 1, 0, 0.0009412845, 7.141319e-07, 1.36 },
  { "olivier_hand.off", true, 1, 0, 1.347927, 0.05921062, 0.926 },
  { "quadknot.obj", true, 1, 1, 112056.6, 1057308, 15.5 },
  { "rocker-arm.obj", true, 1, 1, 1.296552, 0.04251362, 2.56 },
  { "rocker_arm_1600.off", true, 1, 1, 4.289385, 0.2784161, 30.6 },
  { "sharp_sphere.off", true, 1, 0, 2088.022, 3571.012, 0.155 },
  { "skull_low_resolution.obj", true, 1, 2, 498.0316, 562.5215, 20.6 },
  { "soccerball.obj", true, 1, 31, 35.57122, 2.491662, 20 },
  { "sphere.off", true, 1, 0, 3.126544, 0.5190856, 54.1 },
  { "spot.obj", true, 1, 0, 5.709519, 0.7182588, 10.2 },
  { "torus.obj", true, 1, 1, 9.856221, 1.228915, 18.4 },
  { "torus_binary.stl", true, 1, 1, 19.71551, 4.917547, 29.9 },
  { "torus_rdzhao.off", true, 1, 1, 2.302475, 0.2137809, 18.4 },
  { "trim-star.off", true, 1, 1, 1006.09, 1191.501, 0.152 },
  { "two-tori.obj", true, 2, 2, 19.47969, 2.349471, 36.8 },
};

}

#endif
