#include "Maps/MRCFieldData.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <array>
#include <cstdio>

namespace isthmus
{
namespace
{

template <typename Array, typename T, std::size_t Size>
void Add(vtkFieldData* fields, const char* name, const std::array<T, Size>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(Size));
  array->InsertNextTypedTuple(values.data());
  fields->AddArray(array);
}

void AddNumber(vtkFieldData* fields, const char* name, int value)
{
  Add<vtkIntArray>(fields, name, std::array<int, 1>{ value });
}

void AddNumber(vtkFieldData* fields, const char* name, double value)
{
  Add<vtkDoubleArray>(fields, name, std::array<double, 1>{ value });
}

void AddTexts(vtkFieldData* fields, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  fields->AddArray(array);
}

std::string NameOf(MRCStack::Kind kind)
{
  return kind == MRCStack::Kind::None ? "none"
                                      : (kind == MRCStack::Kind::Images ? "images" : "volumes");
}

std::string Degrees(const std::array<double, 3>& angles)
{
  char text[96];
  std::snprintf(text, sizeof(text), "%.6g, %.6g, %.6g", angles[0], angles[1], angles[2]);
  return text;
}

}

std::vector<std::string> MRCNotes(const MRCMap& map)
{
  std::vector<std::string> notes;
  const MRCHeader& header = map.Header();
  if (header.Voxel.Mode == 3 || header.Voxel.Mode == 4)
  {
    notes.push_back("Mode " + std::to_string(header.Voxel.Mode) +
      " is a Fourier transform: components are its real and imaginary part as stored (often half "
      "of the transform; the other half is not filled in from Hermitian symmetry).");
  }
  if (!HasOrthogonalCell(header))
  {
    notes.push_back("The cell angles are " + Degrees(header.CellAngles) + " degrees: " +
      (map.Resampled()
          ? "resampled to an orthogonal grid by trilinear interpolation; nodes outside the map "
            "are 0, as is the array InsideMap there."
          : "shown with right angles as asked (KeepCellAxes), so shapes and positions are "
            "distorted."));
  }
  return notes;
}

void AddMRCFieldData(const MRCMap& map, int volumeIndex, vtkFieldData* fields)
{
  const MRCHeader& header = map.Header();
  const MRCStack& stack = map.Stack();
  Add<vtkDoubleArray>(fields, "CellLengths", header.CellLengths);
  Add<vtkDoubleArray>(fields, "CellAngles", header.CellAngles);
  Add<vtkIntArray>(fields, "FileDimensions", header.Counts);
  Add<vtkIntArray>(fields, "FileStart", header.Start);
  Add<vtkIntArray>(fields, "CellSampling", header.Sampling);
  Add<vtkIntArray>(fields, "AxisOrder", header.AxisOrder);
  Add<vtkDoubleArray>(fields, "FileOrigin", header.Origin);
  AddNumber(fields, "Mode", header.Voxel.Mode);
  AddNumber(fields, "SpaceGroup", header.SpaceGroup);
  AddNumber(fields, "RecordedMinimum", header.Minimum);
  AddNumber(fields, "RecordedMaximum", header.Maximum);
  AddNumber(fields, "RecordedMean", header.Mean);
  AddNumber(fields, "RecordedRms", header.Rms);
  AddNumber(fields, "IsStack", stack.What == MRCStack::Kind::None ? 0 : 1);
  AddTexts(fields, "StackType", { NameOf(stack.What) });
  AddNumber(fields, "NumberOfVolumes", stack.Items);
  AddNumber(fields, "VolumeIndex", volumeIndex);
  AddNumber(fields, "ExtendedHeaderBytes", static_cast<int>(header.ExtendedHeaderBytes));
  AddTexts(fields, "ExtendedHeaderType", { header.ExtendedHeaderType });
  AddNumber(fields, "FormatVersion", header.Version);
  AddTexts(fields, "ByteOrder", { header.BigEndian ? "big endian" : "little endian" });
  AddTexts(fields, "Compression", { map.Compression() });
  AddTexts(fields, "LengthUnit", { "angstrom" });
  AddTexts(fields, "Labels", header.Labels);
  AddTexts(fields, "Repairs", header.Repairs);
  AddTexts(fields, "Notes", MRCNotes(map));
}

}
