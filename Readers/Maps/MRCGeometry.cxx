#include "Maps/MRCGeometry.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr double radiansPerDegree = Pi / 180.0;

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The ending of a file name, small letters, without a compression's.
std::string NameWithoutCompression(std::string path)
{
  std::transform(path.begin(), path.end(), path.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* const compression : { ".gz", ".bz2" })
  {
    if (EndsWith(path, compression))
    {
      path.resize(path.rfind('.'));
    }
  }
  return path;
}

/// Columns a, b, c of a cell with these edges and angles (degrees).
Matrix3 CellMatrix(const std::array<double, 3>& edge, const std::array<double, 3>& angles)
{
  const double alpha = std::cos(angles[0] * radiansPerDegree);
  const double beta = std::cos(angles[1] * radiansPerDegree);
  const double gamma = std::cos(angles[2] * radiansPerDegree);
  const double sine = std::sin(angles[2] * radiansPerDegree);
  const double y = (alpha - beta * gamma) / sine;
  const double z = std::sqrt(1.0 - beta * beta - y * y);
  return { { { edge[0], edge[1] * gamma, edge[2] * beta }, { 0.0, edge[1] * sine, edge[2] * y },
    { 0.0, 0.0, edge[2] * z } } };
}

}

MRCStack DescribeStack(MRCHeader& header, const std::string& path)
{
  const int sections = header.Counts[2];
  const MRCStack single{ MRCStack::Kind::None, 1, sections };
  if (header.SpaceGroup >= 401)
  {
    const int each = header.Sampling[static_cast<std::size_t>(header.AxisOrder[2] - 1)];
    if (sections % each == 0)
    {
      return { MRCStack::Kind::Volumes, sections / each, each };
    }
    header.Repairs.push_back("The space group (word 23) is " + std::to_string(header.SpaceGroup) +
      ", a stack of volumes, but the " + std::to_string(sections) +
      " sections are not a multiple of the " + std::to_string(each) +
      " that each should have: taken as one volume.");
    return single;
  }
  const std::string name = NameWithoutCompression(path);
  const bool tilts = EndsWith(name, ".st") || EndsWith(name, ".ali");
  // Space group 0 alone does not mean images: ChimeraX and cryoSPARC write volumes with it.
  const bool imagesByHeader = header.SpaceGroup == 0 && header.Sampling[2] == 1 && sections > 1;
  if (imagesByHeader || EndsWith(name, ".mrcs") || (tilts && header.SpaceGroup == 0))
  {
    return { MRCStack::Kind::Images, sections, 1 };
  }
  return single;
}

bool HasOrthogonalCell(const MRCHeader& header)
{
  return std::all_of(header.CellAngles.begin(), header.CellAngles.end(),
    [](double angle) { return std::abs(angle - 90.0) <= 0.01; });
}

VoxelLattice MakeLattice(const MRCHeader& header, int sections, bool keepCellAxes)
{
  const bool skewed = !keepCellAxes && !HasOrthogonalCell(header);
  VoxelLattice lattice;
  std::array<double, 3> edge{};
  std::array<double, 3> start{};
  for (std::size_t f = 0; f < 3; ++f)
  {
    const auto axis = static_cast<std::size_t>(header.AxisOrder[f] - 1);
    lattice.Dimensions[axis] = f == 2 ? sections : header.Counts[f];
    start[axis] = header.Start[f];
    edge[f] = header.CellLengths[f] / header.Sampling[f];
  }
  if (skewed)
  {
    lattice.Steps = CellMatrix(edge, header.CellAngles);
  }
  else
  {
    lattice.Steps = { { { edge[0], 0, 0 }, { 0, edge[1], 0 }, { 0, 0, edge[2] } } };
  }
  // What programs leave of an ORIGIN of 0 by rounding does not state a position.
  constexpr double rounding = 1e-4;
  const double least = *std::min_element(edge.begin(), edge.end());
  const bool stated = std::any_of(header.Origin.begin(), header.Origin.end(),
    [=](double position) { return std::abs(position) > rounding * least; });
  // ChimeraX's rule: ORIGIN and start are alternatives, never added up.
  lattice.Origin = stated ? header.Origin : Times(lattice.Steps, start);
  if (header.Skewed)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        lattice.Rotation[i][j] = header.SkewMatrix[j][i]; // the inverse of a rotation
      }
    }
    lattice.Translation = header.SkewTranslation;
  }
  return lattice;
}

}
