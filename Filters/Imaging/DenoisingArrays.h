/**
 * @file DenoisingArrays.h
 * @brief The output arrays that the automatic denoising filters have in common.
 */
#ifndef isthmus_DenoisingArrays_h
#define isthmus_DenoisingArrays_h

#include "Core/OutputArrays.h"

/// Rows of their tables of output arrays.
#define ISTHMUS_DENOISING_ARRAY_ROWS                                                               \
  { 0, ArrayPlace::Points, "INPUT", 1, "of the scalars", ArrayChoice::None,                        \
    "the denoised values, with the input array's name" },                                          \
    { 0, ArrayPlace::Field, "NoiseLevel", 1, "of the scalars", ArrayChoice::None,                  \
      "standard deviation of the noise" },                                                         \
    { 0, ArrayPlace::Field, "UsedOrder", 1, "", ArrayChoice::None,                                 \
      "Order of the chosen equation" },                                                            \
    { 0, ArrayPlace::Field, "UsedEdgeStopping", 1, "", ArrayChoice::None, "0 none, 1 Gaussian" },  \
    { 0, ArrayPlace::Field, "UsedSigma", 1, "of the scalars per voxel", ArrayChoice::None,         \
      "of the chosen equation; 0: no edge stopping" },                                             \
    { 0, ArrayPlace::Field, "UsedPreSmoothing", 1, "voxels", ArrayChoice::None,                    \
      "of the chosen equation; 0: no edge stopping" },                                             \
    { 0, ArrayPlace::Field, "UsedTime", 1, "", ArrayChoice::None,                                  \
      "time of the diffusion, in voxels and data units" },                                         \
    { 0, ArrayPlace::Field, "EstimatedGain", 1, "dB", ArrayChoice::None,                           \
      "estimated decrease of the mean squared error" },                                            \
    { 0, ArrayPlace::Field, "EstimatedGainError", 1, "dB", ArrayChoice::None,                      \
      "standard error of EstimatedGain" },                                                         \
    { 0, ArrayPlace::Field, "Choice", 1, "", ArrayChoice::None,                                    \
      "the choice and its reason, in words" },                                                     \
    { 0, ArrayPlace::Field, "RiskTime", 1, "", ArrayChoice::None,                                  \
      "times at which the error was estimated for the chosen order and Sigma" },                   \
    { 0, ArrayPlace::Field, "RiskValue", 1, "", ArrayChoice::None,                                 \
      "estimated squared error at each RiskTime: for Goal Surfaces that of the Laplacian, "        \
      "unless that of the values decided" },                                                       \
    { 0, ArrayPlace::Field, "StepTime", 1, "", ArrayChoice::None,                                  \
      "time at the end of each step" },                                                            \
    { 0, ArrayPlace::Field, "StepChange", 1, "of the scalars", ArrayChoice::None,                  \
      "rms of what the step changed" },                                                            \
  {                                                                                                \
    0, ArrayPlace::Field, "StepResidual", 1, "of the scalars per time", ArrayChoice::None,         \
      "rms of the rate at the start of the step"                                                   \
  }

#endif
