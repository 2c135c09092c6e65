#include "Potentials/OpenDXWriter.h"

#include "Files/TextFileWriter.h"

namespace isthmus
{
namespace
{

void WriteGrid(TextFileWriter& file, const VoxelLattice& grid)
{
  const auto& n = grid.Dimensions;
  const auto counts = [&](const char* object)
  { file << object << n[0] << " " << n[1] << " " << n[2] << "\n"; };
  counts("object 1 class gridpositions counts ");
  file << "origin " << grid.Origin[0] << " " << grid.Origin[1] << " " << grid.Origin[2] << "\n";
  for (std::size_t a = 0; a < 3; ++a)
  {
    file << "delta " << grid.Steps[0][a] << " " << grid.Steps[1][a] << " " << grid.Steps[2][a]
         << "\n";
  }
  counts("object 2 class gridconnections counts ");
}

/// Without the characters that would end a text in quotes or a comment.
std::string OneLine(std::string text)
{
  for (char& c : text)
  {
    c = c == '"' || c == '\n' || c == '\r' ? ' ' : c;
  }
  return text;
}

}

template <typename T>
void WriteOpenDX(const std::string& path, const VoxelLattice& grid, const T* values, int components,
  const OpenDXLabels& labels, const ProgressCallback& progress)
{
  TextFileWriter file(path);
  for (const std::string& comment : labels.Comments)
  {
    file << "# " << OneLine(comment) << "\n";
  }
  WriteGrid(file, grid);
  const auto& n = grid.Dimensions;
  // PyMOL and others refuse any type but double, which as text is the same.
  file << "object 3 class array type double";
  if (components == 1)
  {
    file << " rank 0";
  }
  else
  {
    file << " rank 1 shape " << components;
  }
  file << " items " << n[0] * n[1] * n[2] << " data follows\n";
  int onLine = 0;
  for (std::int64_t i = 0; i < n[0]; ++i)
  {
    for (std::int64_t row = 0; row < n[1] * n[2]; ++row)
    {
      const std::int64_t node = i + n[0] * (row / n[2] + n[1] * (row % n[2]));
      for (int c = 0; c < components; ++c)
      {
        onLine = (onLine + 1) % 3; // readers that read by lines expect three values on each
        file << values[node * components + c] << (onLine == 0 ? "\n" : " ");
      }
    }
    Report(progress, static_cast<double>(i + 1) / static_cast<double>(n[0]));
  }
  file << (onLine == 0 ? "" : "\n") << "attribute \"dep\" string \"positions\"\n"
       << "object \"" << OneLine(labels.FieldName) << "\" class field\n"
       << "component \"positions\" value 1\ncomponent \"connections\" value 2\n"
       << "component \"data\" value 3\n";
  file.Close();
}

template void WriteOpenDX(const std::string&, const VoxelLattice&, const float*, int,
  const OpenDXLabels&, const ProgressCallback&);
template void WriteOpenDX(const std::string&, const VoxelLattice&, const double*, int,
  const OpenDXLabels&, const ProgressCallback&);

}
