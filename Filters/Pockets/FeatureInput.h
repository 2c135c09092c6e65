/**
 * @file FeatureInput.h
 * @brief The features of one time step in VTK's data: rows of a table, points, or what an id
 * groups.
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

/// A feature, what is carried along (Radius, Volume, Score; NaN: not known), and its number there.
struct InputFeature
{
  TrackedFeature Feature;
  std::array<double, 3> Values;
  std::int64_t Number;
};

/**
 * Of a table: a feature for each row, at CenterX, CenterY, CenterZ or BottleneckX, ...
 *
 * Of points: a feature for each PocketId (each of its mouths, where there is a MouthId), PoreId
 * (each of its bottlenecks, where there is a Rank) or FeatureId, an array of the cells or points;
 * each point, where there is none of them. A pocket's tetrahedra are weighed as in its score, a
 * pore is where it is narrowest, any other feature where its points are in the mean. The residues
 * of a point are those that its array `Residues` names, separated by commas.
 *
 * `lining`, or null: the residues by PocketId or PoreId, for rows, pockets and pores; those of a
 * single mouth or bottleneck they are not.
 *
 * Throws std::invalid_argument for a table without places.
 */
std::vector<InputFeature> FeaturesOf(vtkDataObject* input, vtkTable* lining);

}

#endif
