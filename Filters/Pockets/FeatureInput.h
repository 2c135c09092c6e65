/**
 * @file FeatureInput.h
 * @brief The features of one time step in VTK data: rows of a table, points, or groups with the
 * same id.
 */
#ifndef isthmus_FeatureInput_h
#define isthmus_FeatureInput_h

#include "Pockets/FeatureTracks.h"

#include <array>
#include <cstdint>

class vtkDataObject;
class vtkTable;

namespace isthmus
{

/// A feature, the values passed on (Radius, Volume, Score; NaN: not known), and its number in
/// the input.
struct InputFeature
{
  TrackedFeature Feature;
  std::array<double, 3> Values;
  std::int64_t Number;
};

/**
 * From a table: one feature per row, at CenterX, CenterY, CenterZ or BottleneckX, ...
 *
 * From points: one feature per value of the cell or point array PocketId (per mouth, if there is a
 * MouthId), PoreId (per bottleneck, if there is a Rank) or FeatureId; without any of these arrays,
 * one feature per point. The position of a pocket is the mean of its tetrahedra with the weights of
 * its score, that of a pore is its narrowest place, and that of any other feature is the mean of
 * its points. The residues of a point are those named in its array `Residues`, separated by "; ".
 *
 * `lining`, or null: the residues by PocketId or PoreId, for rows, pockets and pores. It does not
 * apply to single mouths or bottlenecks.
 *
 * Throws std::invalid_argument for a table without positions.
 */
std::vector<InputFeature> ReadFeatures(vtkDataObject* input, vtkTable* lining);

}

#endif
