/**
 * @file IonTransportArrays.h
 * @brief Rows of the table of output arrays that vtkIonTransport and vtkIonTransportMovingSurface
 * have.
 */
#ifndef isthmus_IonTransportArrays_h
#define isthmus_IonTransportArrays_h

#define ISTHMUS_ION_TRANSPORT_ARRAY_ROWS                                                           \
  { 0, ArrayPlace::Points, "Potential", 1, "kT/e", ArrayChoice::None, "electrostatic potential" }, \
    { 0, ArrayPlace::Points, "Concentration_NAME", 1, "mol/l", ArrayChoice::None,                  \
      "of the species NAME" },                                                                     \
    { 0, ArrayPlace::Points, "Flux_NAME", 3, "1/(ns angstrom^2)", ArrayChoice::None,               \
      "of the species NAME" },                                                                     \
    { 0, ArrayPlace::Points, "CurrentDensity", 3, "pA/angstrom^2", ArrayChoice::None,              \
      "of all species" },                                                                          \
    { 0, ArrayPlace::Points, "SignedDistance", 1, "angstrom", ArrayChoice::None,                   \
      "to atoms and membrane, negative within" },                                                  \
    { 0, ArrayPlace::Field, "Voltage", 1, "mV", ArrayChoice::None,                                 \
      "bath below minus bath above" },                                                             \
    { 0, ArrayPlace::Field, "Current", 1, "pA", ArrayChoice::None, "positive along the normal" },  \
    { 0, ArrayPlace::Field, "Current_NAME", 1, "pA", ArrayChoice::None, "of the species NAME" },   \
    { 0, ArrayPlace::Field, "CurrentError", 1, "pA", ArrayChoice::None,                            \
      "estimated from a coarser grid" },                                                           \
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,                                     \
      "the current and its error in words; what was dropped from the input" },                     \
    { 0, ArrayPlace::Field, "CurrentSpread", 1, "", ArrayChoice::None,                             \
      "largest relative difference between sections" },                                            \
    { 0, ArrayPlace::Field, "Converged", 1, "", ArrayChoice::None,                                 \
      "1 if the iteration has converged; of a moving surface, only if the surface has "            \
      "converged as well" },                                                                       \
    { 0, ArrayPlace::Field, "Changes", 1, "kT/e", ArrayChoice::None,                               \
      "of the potential, by iteration" },                                                          \
    { 0, ArrayPlace::Field, "BottleneckRadius", 1, "angstrom", ArrayChoice::None,                  \
      "of the widest path through the channel, at most 4.5 spacings" },                            \
    { 0, ArrayPlace::Field, "BottleneckPosition", 1, "angstrom", ArrayChoice::None, "x, y, z" },   \
    { 1, ArrayPlace::Rows, "Along", 1, "angstrom", ArrayChoice::None,                              \
      "position of the section along the normal, from the center of the membrane" },               \
    { 1, ArrayPlace::Rows, "Current_NAME", 1, "pA", ArrayChoice::None, "of the species NAME" },    \
  {                                                                                                \
    1, ArrayPlace::Rows, "Current", 1, "pA", ArrayChoice::None, "of all species"                   \
  }

#endif
