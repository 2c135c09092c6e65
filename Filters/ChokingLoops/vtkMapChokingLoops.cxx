#include "vtkMapChokingLoops.h"

#include "Contouring/AutomaticLevel.h"
#include "Contouring/ClosedLevelSet.h"
#include "Contouring/MapSurface.h"
#include "Contouring/MarchingCubes.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/ImageScalars.h"
#include "Core/InnerAlgorithm.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "vtkChokingLoops.h"

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
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkMapChokingLoops);

namespace
{

constexpr int SurfacePort = 4;

/// Values of the panel's Automatic Level with which the automatic level is or may be used.
constexpr int On = 1;
constexpr int UnlessGiven = 2;

/// Choking loops of a surface that is complete on this rank, while the others have nothing to do.
/// Nothing is gathered, since all ranks would have to take part in that.
class LoopsOfWholeSurface : public vtkChokingLoops
{
public:
  static LoopsOfWholeSurface* New();
  vtkTypeMacro(LoopsOfWholeSurface, vtkChokingLoops);

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override
  {
    this->FindLoops(vtkPolyData::GetData(input[0]), nullptr, output);
    return 1;
  }
};
vtkStandardNewMacro(LoopsOfWholeSurface);

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
  return isthmus::TextOf("the map has values from ", range[0], " to ", range[1]);
}

/// ParaView's default for a level: the middle of the range.
bool IsMiddle(double level, vtkDataArray* scalars)
{
  double range[2];
  scalars->GetFiniteRange(range, 0);
  return std::abs(level - 0.5 * (range[0] + range[1])) <= 1e-6 * (range[1] - range[0]);
}

}

/// The inputs of a surface. The image itself is another object after each update in ParaView.
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
  : Loops(vtkSmartPointer<LoopsOfWholeSurface>::New())
  , LevelOfMap(new isthmus::AutomaticLevel)
  , MadeOf(new Key)
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(SurfacePort + 1);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkMapChokingLoops::~vtkMapChokingLoops() = default;

#define FORWARD(name, type, result)                                                                \
  void vtkMapChokingLoops::Set##name(type value)                                                   \
  {                                                                                                \
    const vtkMTimeType before = this->Loops->GetMTime();                                           \
    this->Loops->Set##name(value);                                                                 \
    if (this->Loops->GetMTime() != before)                                                         \
    {                                                                                              \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  result vtkMapChokingLoops::Get##name()                                                           \
  {                                                                                                \
    return this->Loops->Get##name();                                                               \
  }

FORWARD(Side, int, int)
FORWARD(MaximumRadius, double, double)
FORWARD(MaximumRadiusUnit, int, int)
FORWARD(MinimumPersistence, double, double)
FORWARD(MinimumPersistenceUnit, int, int)
FORWARD(ThresholdMode, int, int)
FORWARD(MaximumNumberOfLoops, int, int)
FORWARD(TrustedOnly, bool, bool)
FORWARD(MaximumLength, double, double)
FORWARD(MaximumReach, double, double)
FORWARD(LoopOrder, int, int)
FORWARD(AlwaysReportHandles, bool, bool)
FORWARD(SampleSpacing, double, double)
FORWARD(Shortening, int, int)
FORWARD(ShorteningRounds, int, int)
FORWARD(AllowSelfIntersections, bool, bool)
FORWARD(MemoryLimit, int, int)
FORWARD(CapHoles, bool, bool)
FORWARD(Filtration, int, int)
FORWARD(MorseFunction, int, int)
FORWARD(MorseArrayName, const std::string&, std::string)

#undef FORWARD

void vtkMapChokingLoops::CapHolesOn()
{
  this->Loops->CapHolesOn();
  this->Modified();
}

void vtkMapChokingLoops::CapHolesOff()
{
  this->Loops->CapHolesOff();
  this->Modified();
}

double* vtkMapChokingLoops::GetStageTimes()
{
  return this->Loops->GetStageTimes();
}

void vtkMapChokingLoops::SetLevel(double level)
{
  const bool automatic = !std::isfinite(level); // as before 1.0: no level
  if (!automatic)
  {
    this->SetPanelLevel(level);
  }
  this->SetAutomaticLevel(automatic);
}

void vtkMapChokingLoops::SetPanelLevel(double level)
{
  if (this->Level != level)
  {
    this->Level = level;
    this->Modified();
  }
}

void vtkMapChokingLoops::SetAutomaticLevel(bool automatic)
{
  this->SetPanelAutomaticLevel(automatic ? On : 0);
}

void vtkMapChokingLoops::SetPanelAutomaticLevel(int mode)
{
  if (this->PanelMode != mode)
  {
    this->PanelMode = mode;
    this->AutomaticLevel = mode == On || mode == UnlessGiven;
    this->Modified();
  }
}

int vtkMapChokingLoops::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkMapChokingLoops::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 3 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkMapChokingLoops::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // A narrow place can be anywhere, so the whole map is needed whatever part is requested.
  isthmus::RequestWholeExtent(input[0]->GetInformationObject(0));
  return 1;
}

double vtkMapChokingLoops::ChooseLevel(vtkImageData* image, vtkDataArray* scalars)
{
  // Scripts of ParaView's trace, and state files of former versions, have no ProposedLevel. A level
  // that was proposed once keeps that status when the range changes upstream.
  if (this->PanelMode == UnlessGiven && IsMiddle(this->Level, scalars))
  {
    this->FormerMiddle = this->Level;
  }
  const bool isProposed = this->Level == this->ProposedLevel || this->Level == this->FormerMiddle;
  const bool isGiven = !this->AutomaticLevel || (this->PanelMode == UnlessGiven && !isProposed);
  const double level =
    isGiven ? this->Level : this->LevelOfMap->Of(image, scalars, this->InsideIsHigher);
  if (!std::isfinite(level))
  {
    throw std::invalid_argument("Level is not a finite number; " + RangeOf(scalars) + ".");
  }
  return level;
}

void vtkMapChokingLoops::Contour(vtkImageData* image)
{
  vtkDataArray* scalars = isthmus::ChosenScalars(this, image);
  const double level = this->ChooseLevel(image, scalars);
  this->UsedLevel = level;
  const Key key{ scalars, scalars->GetMTime(), FrameOf(image), level, this->InsideIsHigher,
    this->LargestComponents };
  if (this->Surface && *this->MadeOf == key)
  {
    return;
  }
  this->Surface = nullptr;
  isthmus::MarchingCubesParameters parameters;
  parameters.Level = level;
  parameters.InsideIsHigher = this->InsideIsHigher;
  isthmus::TriangleMesh mesh;
  isthmus::UseScalars(
    image, scalars, [&](const auto& grid) { mesh = isthmus::MarchingCubes(grid, parameters); });
  mesh = isthmus::HideDust(std::move(mesh), { 0.0, 0.0, this->LargestComponents }).Surface;
  if (mesh.Triangles.empty())
  {
    throw std::invalid_argument(isthmus::TextOf(
      "Nothing is inside the Level ", level, ": ", RangeOf(scalars), ". Choose another level."));
  }
  isthmus::ToWorld(image, mesh);
  this->Surface = vtkSmartPointer<vtkPolyData>::New();
  isthmus::SetMesh(mesh, this->Surface);
  *this->MadeOf = key;
}

void vtkMapChokingLoops::FindLoops(vtkInformationVector* output)
{
  this->Loops->SetContainerAlgorithm(this); // stops with this one
  this->Loops->SetInputData(this->Surface);
  this->Loops->Modified(); // an output that was stopped is not kept
  auto* loops = static_cast<LoopsOfWholeSurface*>(this->Loops.Get());
  isthmus::UpdateInner(loops, isthmus::ProgressOf(this),
    [this](const std::string& warning) { vtkWarningMacro(<< warning); });
  isthmus::Report(isthmus::ProgressOf(this), 1.0); // leaves where it was stopped
  for (int port = 0; port < SurfacePort; ++port)
  {
    vtkDataObject* const result = vtkDataObject::GetData(output, port);
    const auto ofMap = vtkSmartPointer<vtkFieldData>::New();
    ofMap->ShallowCopy(result->GetFieldData()); // which VTK's executive has passed on
    result->ShallowCopy(loops->GetOutputDataObject(port));
    result->GetFieldData()->PassData(ofMap);
  }
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
  return isthmus::Guarded(this, output,
    [&]
    {
      isthmus::RequireWholeExtent(input[0]->GetInformationObject(0));
      this->Contour(image);
      this->FindLoops(output);
      vtkPolyData::GetData(output, SurfacePort)->ShallowCopy(this->Surface);
      vtkNew<vtkDoubleArray> level;
      level->SetName("Level");
      level->InsertNextValue(this->UsedLevel);
      vtkPolyData::GetData(output, 0)->GetFieldData()->AddArray(level);
    });
}

void vtkMapChokingLoops::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "AutomaticLevel: " << this->AutomaticLevel << "\n";
  os << indent << "ProposedLevel: " << this->ProposedLevel << "\n";
  os << indent << "UsedLevel: " << this->UsedLevel << "\n";
  os << indent << "InsideIsHigher: " << this->InsideIsHigher << "\n";
  os << indent << "LargestComponents: " << this->LargestComponents << "\n";
  os << indent << "Loops:\n";
  this->Loops->PrintSelf(os, indent.GetNextIndent());
}
