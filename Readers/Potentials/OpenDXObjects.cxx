#include "Potentials/OpenDXObjects.h"

#include "Files/NumberTypes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

/// Refuses axes that are not finite or lie in one plane.
void CheckAxes(const VoxelLattice& grid, const TextWords& text)
{
  const std::array<double, 3> spacing = grid.Spacing();
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (!(spacing[a] > 0.0) || !std::isfinite(spacing[a]) || !std::isfinite(grid.Origin[a]))
    {
      text.Refuse("origin and deltas should be finite, and no delta of length zero.");
    }
  }
  const Matrix3& m = grid.Steps;
  const double volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  if (!(std::abs(volume / (spacing[0] * spacing[1] * spacing[2])) > 1e-6))
  {
    text.Refuse("the three deltas lie in one plane, so they span no grid.");
  }
}

/// The words behind `type`.
void ReadArrayType(TextWords& text, std::string& word, OpenDXArray& array)
{
  word = text.Word();
  array.Unsigned = word == "unsigned";
  if (word == "signed" || word == "unsigned")
  {
    word = text.Word();
  }
  array.Single = word == "float";
  array.Whole = word == "int";
  array.ItemBytes = word == "double" ? 8 : 4;
  if (!array.Single && !array.Whole && word != "double")
  {
    text.Refuse("values of type " + word + " are not read, only float, double and int.");
  }
}

}

VoxelLattice ReadOpenDXPositions(TextWords& text, std::string& word)
{
  VoxelLattice grid;
  word = text.Word();
  if (word != "counts")
  {
    text.Refuse("the grid should have its counts, not '" + word + "'.");
  }
  for (std::int64_t& count : grid.Dimensions)
  {
    count = text.Whole("a count of the grid");
    if (count < 1 || count > std::numeric_limits<int>::max())
    {
      text.Refuse("a count of the grid is " + std::to_string(count) +
        ", but should be between 1 and 2147483647.");
    }
  }
  word = text.Word();
  if (word == "origin")
  {
    for (double& position : grid.Origin)
    {
      position = text.Number("a coordinate of the origin");
    }
    word = text.Word();
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (word != "delta")
    {
      text.Refuse("three rows of delta should follow, but '" + word + "' stands where one should.");
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      grid.Steps[i][axis] = text.Number("a delta");
    }
    word = text.Word();
  }
  CheckAxes(grid, text);
  return grid;
}

OpenDXArray ReadOpenDXArray(TextWords& text, std::string& word)
{
  OpenDXArray array;
  array.Single = true; // OpenDX' default
  array.ItemBytes = 4;
  bool bigEndian = !IsLittleEndian();
  for (word = text.Word(); word != "follows"; word = text.Word())
  {
    if (word == "type")
    {
      ReadArrayType(text, word, array);
    }
    else if (word == "rank")
    {
      if (text.Whole("the rank") > 1)
      {
        text.Refuse("values of rank 2 and more (matrices) are not read.");
      }
    }
    else if (word == "shape")
    {
      const std::int64_t shape = text.Whole("the shape");
      array.Components = static_cast<int>(std::clamp<std::int64_t>(shape, 0, 1000));
    }
    else if (word == "items")
    {
      array.Items = text.Whole("the number of items");
    }
    else if (word == "lsb" || word == "msb")
    {
      bigEndian = word == "msb";
      array.Binary = true;
    }
    else if (word == "binary" || word == "ieee")
    {
      array.Binary = true;
    }
    else if (word == "text" || word == "ascii")
    {
      array.Binary = false;
    }
    else if (word != "data" && word != "category" && word != "real")
    {
      text.Refuse(word.empty() ? std::string("the file ends within the description of an array.")
                               : "'" + word +
            "' is not understood in the description of an array: its values "
            "should follow in this file, as text or IEEE numbers.");
    }
  }
  array.Swap = bigEndian == IsLittleEndian();
  return array;
}

}
