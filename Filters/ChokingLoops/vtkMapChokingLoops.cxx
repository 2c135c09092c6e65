#include "vtkMapChokingLoops.h"

#include "Contouring/ClosedLevelSet.h"
#include "Contouring/LevelTriangles.h"
#include "Contouring/MapSurface.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/PolyDataTriangles.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkMapChokingLoops);

namespace
{

constexpr int SurfacePort = 4;

/// Nodes along each axis, origin, spacing and direction.
std::array<double, 18> FrameOf(vtkImageData* image)
{
  std::array<double, 18> frame{};
  std::copy_n(image->GetDimensions(), 3, frame.begin());
  image->GetPoint(0, frame.data() + 3);
  std::copy_n(image->GetSpacing(), 3, frame.begin() + 6);
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, frame.begin() + 9);
  return frame;
}

std::string RangeOf(vtkDataArray* scalars)
{
  double range[2];
  scalars->GetFiniteRange(range, 0);
  std::ostringstream text;
  text << "the map has values from " << range[0] << " to " << range[1];
  return text.str();
}

}

/// What a surface is made of. The image itself is another object after each update in ParaView.
struct vtkMapChokingLoops::Key
{
  vtkDataArray* Scalars = nullptr; // compared only
  vtkMTimeType Time = 0;
  std::array<double, 18> Frame{};
  double Level = 0.0;
  bool InsideIsHigher = true;
  int LargestComponents = 0;

  bool operator==(const Key& other) const
  {
    return this->Scalars == other.Scalars && this->Time == other.Time &&
      this->Frame == other.Frame && this->Level == other.Level &&
      this->InsideIsHigher == other.InsideIsHigher &&
      this->LargestComponents == other.LargestComponents;
  }
};

vtkMapChokingLoops::vtkMapChokingLoops()
  : MadeOf(new Key)
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(SurfacePort + 1);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkMapChokingLoops::~vtkMapChokingLoops() = default;

int vtkMapChokingLoops::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMapChokingLoops::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // A narrow place can be anywhere, so all of the map is needed whatever part is asked for.
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

void vtkMapChokingLoops::Contour(vtkImageData* image)
{
  vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
  if (!std::isfinite(this->Level))
  {
    throw std::invalid_argument("Choking loops of a map need a Level, and none was given: " +
      RangeOf(scalars) + ", and Map Surface proposes one.");
  }
  const Key key{ scalars, scalars->GetMTime(), FrameOf(image), this->Level, this->InsideIsHigher,
    this->LargestComponents };
  if (this->Surface && *this->MadeOf == key)
  {
    return;
  }
  this->Surface = nullptr;
  isthmus::LevelTrianglesParameters parameters;
  parameters.Level = this->Level;
  parameters.InsideIsHigher = this->InsideIsHigher;
  isthmus::TriangleMesh mesh;
  isthmus::UseScalars(
    image, scalars, [&](const auto& grid) { mesh = isthmus::LevelTriangles(grid, parameters); });
  mesh = isthmus::HideDust(std::move(mesh), { 0.0, 0.0, this->LargestComponents }).Surface;
  if (mesh.Triangles.empty())
  {
    std::ostringstream text;
    text << "Nothing is inside the Level " << this->Level << ": " << RangeOf(scalars) << ".";
    throw std::invalid_argument(text.str());
  }
  isthmus::ToWorld(image, mesh);
  this->Surface = vtkSmartPointer<vtkPolyData>::New();
  isthmus::SetMesh(mesh, this->Surface);
  *this->MadeOf = key;
}

int vtkMapChokingLoops::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(input[0]);
  if (!isthmus::IsFirstPiece(output->GetInformationObject(0)) ||
    (image && image->GetNumberOfPoints() == 0))
  {
    return 1;
  }
  auto* loops = vtkPolyData::GetData(output, 0);
  auto* surface = vtkPolyData::GetData(output, SurfacePort);
  const auto contour = [&]
  {
    isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
    this->Contour(image);
  };
  if (isthmus::Succeeds(this, output, contour) && this->FindLoops(this->Surface, nullptr, output))
  {
    surface->ShallowCopy(this->Surface);
    vtkNew<vtkDoubleArray> level;
    level->SetName("Level");
    level->InsertNextValue(this->Level);
    loops->GetFieldData()->AddArray(level);
  }
  return 1;
}

void vtkMapChokingLoops::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "LargestComponents: " << this->LargestComponents << "\n";
}
