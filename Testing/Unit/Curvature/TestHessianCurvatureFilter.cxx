// The vtk class: types, arrays, geometry of the image, pieces, and what it says to bad input.
#include "FieldImage.h"
#include "vtkHessianCurvature.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace isthmus::testing;

const std::vector<std::string> sixNames = { "GaussianCurvature", "MeanCurvature",
  "MaximumCurvature", "MinimumCurvature", "ShapeIndex", "Curvedness" };

/// 1 / (1 + q), level sets around the origin with half axes 4 : 3 : 2, turned to no grid axis.
double Ellipsoids(double x, double y, double z)
{
  return 1.0 / (1.0 + x * x / 16.0 + y * y / 9.0 + z * z / 4.0);
}

double Spheres(double x, double y, double z)
{
  return 1.0 / (1.0 + x * x + y * y + z * z);
}

Lattice Block()
{
  Lattice lattice = CentredCube(17, 1.0);
  lattice.Dimensions = { 17, 15, 13 };
  lattice.Origin = { 0.3, 0.4, 0.5 };
  return lattice;
}

/// The lattice turned about an axis that is none of its own.
Lattice Turned(Lattice lattice)
{
  const double c = std::cos(0.6), s = std::sin(0.6), t = std::cos(1.1), u = std::sin(1.1);
  lattice.Direction = { c, -s * t, s * u, s, c * t, -c * u, 0.0, u, t };
  return lattice;
}

double Value(vtkHessianCurvature* filter, const char* name, vtkIdType id)
{
  return PointArray(filter->GetOutputDataObject(0), name)->GetComponent(id, 0);
}

TEST(HessianCurvatureFilter, EveryScalarType)
{
  const auto counts = [](double x, double y, double z)
  { return std::round(120.0 * Spheres(x, y, z)); };
  vtkNew<vtkHessianCurvature> reference;
  reference->SetInputData(SampledImage(Block(), counts));
  reference->Update();
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<vtkHessianCurvature> filter;
    filter->SetInputData(SampledImage(Block(), counts, type));
    filter->Update();
    for (const std::string& name : sixNames)
    {
      vtkDataArray* values = PointArray(filter->GetOutput(), name.c_str());
      ASSERT_NE(values, nullptr);
      EXPECT_EQ(values->GetDataType(), type == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
      vtkDataArray* expected = PointArray(reference->GetOutput(), name.c_str());
      for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
      {
        const double exact = expected->GetComponent(id, 0);
        ASSERT_NEAR(values->GetComponent(id, 0), exact, 1e-6 * std::max(1e-3, std::abs(exact)));
      }
    }
  }
}

TEST(HessianCurvatureFilter, KeepsWhatTheInputHad)
{
  const auto image = SampledImage(Turned(Block()), Ellipsoids, VTK_FLOAT);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(image->GetNumberOfPoints());
  other->Fill(3.0);
  image->GetPointData()->AddArray(other);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("Cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(2.0);
  image->GetCellData()->AddArray(cells);
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  note->InsertNextValue("kept");
  image->GetFieldData()->AddArray(note);
  vtkNew<vtkImageData> before;
  before->DeepCopy(image);

  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkImageData* output = filter->GetImageDataOutput();
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("Other"), other);
  EXPECT_EQ(output->GetCellData()->GetArray("Cells"), cells);
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("Note"), note);
  EXPECT_EQ(output->GetPointData()->GetScalars(), image->GetPointData()->GetScalars());
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(output->GetOrigin()[axis], image->GetOrigin()[axis]);
    EXPECT_EQ(output->GetSpacing()[axis], image->GetSpacing()[axis]);
    EXPECT_EQ(output->GetDirectionMatrix()->GetElement(axis, 1),
      image->GetDirectionMatrix()->GetElement(axis, 1));
  }
  EXPECT_EQ(
    image->GetPointData()->GetNumberOfArrays(), before->GetPointData()->GetNumberOfArrays());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    ASSERT_EQ(image->GetPointData()->GetScalars()->GetComponent(id, 0),
      before->GetPointData()->GetScalars()->GetComponent(id, 0));
  }
}

TEST(HessianCurvatureFilter, EachArrayCanBeSwitched)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(SampledImage(Block(), Ellipsoids));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 1 + 6 + 1);
  filter->GenerateGaussianCurvatureOff();
  filter->GenerateMeanCurvatureOff();
  filter->GenerateMaximumCurvatureOff();
  filter->GenerateMinimumCurvatureOff();
  filter->GenerateShapeIndexOff();
  filter->GenerateCurvednessOff();
  filter->GeneratePrincipalDirection1On();
  filter->GeneratePrincipalDirection2On();
  filter->GenerateSurfaceTypeOn();
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 1 + 3 + 1);
  EXPECT_EQ(data->GetArray("PrincipalDirection1")->GetNumberOfComponents(), 3);
  EXPECT_EQ(data->GetArray("PrincipalDirection2")->GetNumberOfComponents(), 3);
  EXPECT_EQ(data->GetArray("SurfaceType")->GetDataType(), VTK_UNSIGNED_CHAR);
  auto* names = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("SurfaceTypeNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetNumberOfValues(), 9);
  EXPECT_EQ(names->GetValue(8), "Peak");
}

TEST(HessianCurvatureFilter, UnnamedAndNamedArrays)
{
  const auto image = SampledImage(Block(), Spheres);
  image->GetPointData()->GetScalars()->SetName(nullptr);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->Update();
  const double unnamed = Value(filter, "MeanCurvature", 1500);
  EXPECT_GT(unnamed, 0.0);

  const auto second = SampledImage(Block(), Ellipsoids);
  vtkSmartPointer<vtkDataArray> spheres = image->GetPointData()->GetScalars();
  spheres->SetName("Spheres");
  second->GetPointData()->AddArray(spheres);
  filter->SetInputData(second);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Spheres");
  filter->Update();
  EXPECT_EQ(Value(filter, "MeanCurvature", 1500), unnamed);
}

/// Mean and Gaussian curvature and directions of Ellipsoids at nodes of any lattice; checks all.
void ExpectEllipsoids(const Lattice& lattice)
{
  const auto image = SampledImage(lattice, Ellipsoids);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->SetAccuracy(4);
  filter->GeneratePrincipalDirection1On();
  filter->GeneratePrincipalDirection2On();
  filter->Update();
  vtkIdType checked = 0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    if (Value(filter, "CurvatureValid", id) == 0.0)
    {
      continue;
    }
    const double* p = image->GetPoint(id);
    const double g[3] = { p[0] / 16.0, p[1] / 9.0, p[2] / 4.0 }; // outward
    const double size = std::hypot(g[0], g[1], g[2]);
    const double second[3] = { 1.0 / 16.0, 1.0 / 9.0, 1.0 / 4.0 };
    double d[2][3];
    PointArray(filter->GetOutput(), "PrincipalDirection1")->GetTuple(id, d[0]);
    PointArray(filter->GetOutput(), "PrincipalDirection2")->GetTuple(id, d[1]);
    double length[2] = {}, along[2] = {}, bend[2] = {}, across = 0.0, twist = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 2; ++i)
      {
        length[i] += d[i][axis] * d[i][axis];
        along[i] += d[i][axis] * g[axis] / size;
        bend[i] += d[i][axis] * d[i][axis] * second[axis] / size;
      }
      across += d[0][axis] * d[1][axis];
      twist += d[0][axis] * d[1][axis] * second[axis] / size;
    }
    constexpr double tolerance = 1e-4; // fourth-order differences at this spacing
    ASSERT_NEAR(length[0], 1.0, 1e-12);
    ASSERT_NEAR(length[1], 1.0, 1e-12);
    ASSERT_NEAR(across, 0.0, 1e-12);
    ASSERT_NEAR(along[0], 0.0, tolerance) << "directions are tangent";
    ASSERT_NEAR(along[1], 0.0, tolerance);
    ASSERT_NEAR(bend[0], Value(filter, "MaximumCurvature", id), tolerance);
    ASSERT_NEAR(bend[1], Value(filter, "MinimumCurvature", id), tolerance);
    ASSERT_NEAR(twist, 0.0, tolerance) << "and conjugate";
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

TEST(HessianCurvatureFilter, AnisotropicSpacing)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, 0.07, 0.13 };
  ExpectEllipsoids(lattice);
}

TEST(HessianCurvatureFilter, DirectionMatrix)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, 0.07, 0.13 };
  ExpectEllipsoids(Turned(lattice));
}

TEST(HessianCurvatureFilter, NegativeSpacing)
{
  Lattice lattice = Block();
  lattice.Origin = { 2.0, 0.4, 2.0 };
  lattice.Spacing = { -0.1, 0.07, -0.09 };
  ExpectEllipsoids(lattice);
  ExpectEllipsoids(Turned(lattice));
}

TEST(HessianCurvatureFilter, PointsOfATurnedImage)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, -0.07, 0.13 };
  lattice.Origin = { 0.3, 1.4, 0.5 };
  const auto image = SampledImage(Turned(lattice), Spheres);
  vtkNew<vtkPoints> points;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double* p = image->GetPoint(id);
    points->InsertNextPoint(p[0], p[1], p[2]); // float
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkHessianCurvature> atNodes;
  atNodes->SetInputData(image);
  atNodes->Update();
  vtkNew<vtkHessianCurvature> atPoints;
  atPoints->SetInputData(0, image);
  atPoints->SetInputData(1, places);
  atPoints->Update();
  ASSERT_NE(atPoints->GetPolyDataOutput(), nullptr);
  for (const std::string& name : { std::string("CurvatureValid"), std::string("MeanCurvature") })
  {
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      ASSERT_NEAR(Value(atPoints, name.c_str(), id), Value(atNodes, name.c_str(), id), 1e-5);
    }
  }
}

TEST(HessianCurvatureFilter, CylinderDirectionsAndUmbilics)
{
  const auto cylinder =
    SampledImage(CentredCube(15, 1.0), [](double x, double y, double) { return -x * x - y * y; });
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(cylinder);
  filter->GeneratePrincipalDirection1On();
  filter->GeneratePrincipalDirection2On();
  filter->GenerateSurfaceTypeOn();
  filter->Update();
  const vtkIdType id = cylinder->FindPoint(4.0 / 7.0, 3.0 / 7.0, 0.0);
  const double* p = cylinder->GetPoint(id);
  const double r = std::hypot(p[0], p[1]);
  const double* around = PointArray(filter->GetOutput(), "PrincipalDirection1")->GetTuple3(id);
  EXPECT_NEAR(std::abs(around[0] * p[1] - around[1] * p[0]), r, 1e-12);
  EXPECT_NEAR(around[2], 0.0, 1e-12);
  const double* axis = PointArray(filter->GetOutput(), "PrincipalDirection2")->GetTuple3(id);
  EXPECT_NEAR(std::abs(axis[2]), 1.0, 1e-12);
  EXPECT_NEAR(Value(filter, "MaximumCurvature", id), 1.0 / r, 1e-12);
  EXPECT_NEAR(Value(filter, "MinimumCurvature", id), 0.0, 1e-12);
  EXPECT_EQ(Value(filter, "SurfaceType", id), 7.0);
  EXPECT_NEAR(Value(filter, "ShapeIndex", id), -0.5, 1e-12);
  filter->SetShapeIndexConvention(vtkHessianCurvature::Koenderink);
  filter->InsideIsHigherOff();
  filter->Update();
  EXPECT_NEAR(Value(filter, "ShapeIndex", id), -0.5, 1e-12);
  EXPECT_NEAR(Value(filter, "MinimumCurvature", id), -1.0 / r, 1e-12);
  EXPECT_EQ(Value(filter, "SurfaceType", id), 2.0);

  filter->SetInputData(SampledImage(CentredCube(15, 1.0), Spheres));
  filter->Update();
  const double* u = PointArray(filter->GetOutput(), "PrincipalDirection1")->GetTuple3(id);
  EXPECT_NEAR(std::hypot(u[0], u[1], u[2]), 1.0, 1e-12);
}

TEST(HessianCurvatureFilter, ScaleTamesNoise)
{
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 0.01);
  const auto image = SampledImage(
    CentredCube(41, 20.0),
    [&](double x, double y, double z)
    { return std::exp(-(x * x + y * y + z * z) / 200.0) + noise(random); },
    VTK_FLOAT);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(SampledImage(CentredCube(41, 20.0),
    [](double x, double y, double z) { return std::exp(-(x * x + y * y + z * z) / 200.0); }));
  contour->SetValue(0, std::exp(-0.5));
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, image);
  filter->SetInputConnection(1, contour->GetOutputPort());
  const auto worst = [&]()
  {
    filter->Update();
    double largest = 0.0;
    for (vtkIdType id = 0; id < filter->GetOutput()->GetNumberOfPoints(); ++id)
    {
      largest = std::max(largest, std::abs(Value(filter, "MeanCurvature", id) - 0.1));
    }
    return largest;
  };
  const double rough = worst();
  filter->SetScale(3.0);
  const double smooth = worst();
  EXPECT_GT(rough, 0.2);
  EXPECT_LT(smooth, 0.02);
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 1) << "the input is left as it was";
}

TEST(HessianCurvatureFilter, ScaleIsVtksGaussian)
{
  const auto image = SampledImage(Block(), Ellipsoids);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  const double h = image->GetSpacing()[0];
  smooth->SetStandardDeviations(0.2 / h, 0.2 / h, 0.2 / h);
  smooth->SetRadiusFactor(4.0);
  vtkNew<vtkHessianCurvature> byHand;
  byHand->SetInputConnection(smooth->GetOutputPort());
  byHand->Update();
  vtkNew<vtkHessianCurvature> byScale;
  byScale->SetInputData(image);
  byScale->SetScale(0.2);
  byScale->Update();
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    ASSERT_EQ(Value(byHand, "MeanCurvature", id), Value(byScale, "MeanCurvature", id));
  }
}

/// Any part asked for has the values of the whole, with and without smoothing.
TEST(HessianCurvatureFilter, PiecesAreThoseOfTheWhole)
{
  for (const double scale : { 0.0, 1.5 })
  {
    vtkNew<vtkRTAnalyticSource> source;
    source->SetWholeExtent(-10, 12, -9, 11, -8, 13);
    vtkNew<vtkHessianCurvature> whole;
    whole->SetInputConnection(source->GetOutputPort());
    whole->SetScale(scale);
    whole->Update();
    vtkNew<vtkRTAnalyticSource> again;
    again->SetWholeExtent(-10, 12, -9, 11, -8, 13);
    vtkNew<vtkHessianCurvature> part;
    part->SetInputConnection(again->GetOutputPort());
    part->SetScale(scale);
    const int asked[6] = { -10, 1, 2, 9, 5, 13 };
    part->UpdateExtent(asked);
    vtkImageData* piece = part->GetImageDataOutput();
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_EQ(piece->GetExtent()[i], asked[i]);
    }
    EXPECT_LT(again->GetOutput()->GetNumberOfPoints(), source->GetOutput()->GetNumberOfPoints())
      << "the rest is not asked for";
    for (vtkIdType id = 0; id < piece->GetNumberOfPoints(); ++id)
    {
      const vtkIdType other = whole->GetOutput()->FindPoint(piece->GetPoint(id));
      ASSERT_EQ(Value(part, "CurvatureValid", id), Value(whole, "CurvatureValid", other));
      const double expected = Value(whole, "MeanCurvature", other);
      ASSERT_NEAR(Value(part, "MeanCurvature", id), expected, 1e-6 * std::abs(expected));
    }
  }
}

/// A source that gives the same half of its image whatever it is asked for.
class HalfSource : public vtkImageAlgorithm
{
public:
  static HalfSource* New() { VTK_STANDARD_NEW_BODY(HalfSource); }
  vtkTypeMacro(HalfSource, vtkImageAlgorithm);

protected:
  HalfSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    int whole[6] = { 0, 16, 0, 16, 0, 16 };
    outputVector->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    Lattice lattice = CentredCube(17, 1.0);
    lattice.Dimensions[2] = 9;
    vtkImageData::GetData(outputVector)->ShallowCopy(SampledImage(lattice, Ellipsoids));
    return 1;
  }
};

TEST(HessianCurvatureFilter, ASourceThatGivesTooLittleIsAskedOnlyTwice)
{
  vtkNew<HalfSource> source;
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->UpdatePiece(0, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 17 * 17 * 9);
  EXPECT_EQ(Value(filter, "CurvatureValid", 17 * 17 * 8 + 17 * 8 + 8), 0.0);
  EXPECT_EQ(Value(filter, "CurvatureValid", 17 * 17 * 7 + 17 * 8 + 4), 1.0);
}

/// Runs the filter on `image` and answers the error that it gave, checking that nothing came out.
std::string ErrorOf(vtkHessianCurvature* filter, vtkDataObject* image)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executive;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
  filter->SetInputDataObject(0, image);
  filter->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
  filter->RemoveAllObservers();
  return observer->GetErrorMessage();
}

TEST(HessianCurvatureFilter, BadParametersAreNamed)
{
  const auto image = SampledImage(Block(), Spheres);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetAccuracy(3);
  EXPECT_NE(ErrorOf(filter, image).find("Accuracy is 3"), std::string::npos);
  filter->SetAccuracy(2);
  filter->SetScale(-1.0);
  EXPECT_NE(ErrorOf(filter, image).find("Scale is -1"), std::string::npos);
  filter->SetScale(std::nan(""));
  EXPECT_NE(ErrorOf(filter, image).find("Scale is nan"), std::string::npos);
  filter->SetScale(0.0);
  filter->SetMeanTolerance(-0.1);
  EXPECT_NE(ErrorOf(filter, image).find("MeanTolerance is -0.1"), std::string::npos);
  filter->SetMeanTolerance(0.001);
  filter->SetShapeIndexConvention(2);
  EXPECT_NE(ErrorOf(filter, image).find("ShapeIndexConvention is 2"), std::string::npos);
}

TEST(HessianCurvatureFilter, BadInputIsNamed)
{
  vtkNew<vtkHessianCurvature> filter;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(5, 5, 5);
  EXPECT_NE(ErrorOf(filter, bare).find("no active scalars"), std::string::npos);

  vtkNew<vtkImageData> colours;
  colours->SetDimensions(5, 5, 5);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  colours->GetPointData()->GetScalars()->SetName("Colours");
  EXPECT_NE(ErrorOf(filter, colours).find("Array 'Colours' has 3 components"), std::string::npos);

  vtkNew<vtkDoubleArray> brief;
  brief->SetName("Brief");
  brief->SetNumberOfTuples(7);
  brief->Fill(1.0);
  bare->GetPointData()->SetScalars(brief);
  EXPECT_NE(
    ErrorOf(filter, bare).find("Array 'Brief' has 7 values for the 125"), std::string::npos);

  const auto image = SampledImage(Block(), Spheres);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("Cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(1.0);
  image->GetCellData()->AddArray(cells);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Cells");
  EXPECT_NE(ErrorOf(filter, image).find("Array 'Cells' is not on points"), std::string::npos);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Absent");
  EXPECT_NE(ErrorOf(filter, image).find("no array 'Absent' to work on; its point arrays are: '"),
    std::string::npos);
}

TEST(HessianCurvatureFilter, SurfaceWithoutAVolume)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(1, surface);
  vtkNew<vtkImageData> empty;
  EXPECT_NE(ErrorOf(filter, empty).find("The image is empty"), std::string::npos);

  vtkNew<vtkHessianCurvature> unconnected;
  vtkNew<vtkTest::ErrorObserver> observer;
  unconnected->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  unconnected->SetInputData(1, surface);
  unconnected->Update();
  EXPECT_TRUE(observer->GetError()) << "VTK's own sentence about the missing input";
}

TEST(HessianCurvatureFilter, EmptyInputIsNoError)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkHessianCurvature> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  vtkNew<vtkImageData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(0, SampledImage(Block(), Spheres));
  filter->SetInputData(1, nothing);
  filter->Update();
  ASSERT_NE(filter->GetPolyDataOutput(), nullptr);
  EXPECT_NE(PointArray(filter->GetOutput(), "MeanCurvature"), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(0, empty);
  filter->Update();
  EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
  EXPECT_FALSE(observer->GetWarning()) << observer->GetWarningMessage();
}

TEST(HessianCurvatureFilter, ASliceHasNoValidNode)
{
  Lattice slice = Block();
  slice.Dimensions[2] = 1;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkHessianCurvature> filter;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(SampledImage(slice, Spheres));
  filter->Update();
  EXPECT_NE(
    observer->GetWarningMessage().find("Along z the image has 1 of the 3 nodes"), std::string::npos)
    << observer->GetWarningMessage();
  EXPECT_EQ(PointArray(filter->GetOutput(), "CurvatureValid")->GetRange()[1], 0.0);
  EXPECT_EQ(PointArray(filter->GetOutput(), "GaussianCurvature")->GetRange()[1], 0.0);
}

TEST(HessianCurvatureFilter, ProgressIsMonotoneAndStopsOnRequest)
{
  struct Watch
  {
    double Last = 0.0;
    bool Monotone = true;
    bool Stop = false;
  } watch;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&watch);
  listener->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* fraction)
    {
      auto& w = *static_cast<Watch*>(client);
      w.Monotone = w.Monotone && *static_cast<double*>(fraction) >= w.Last;
      w.Last = *static_cast<double*>(fraction);
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(w.Stop ? 1 : 0);
    });
  for (const double scale : { 0.0, 0.1 })
  {
    watch = Watch();
    vtkNew<vtkHessianCurvature> filter;
    filter->AddObserver(vtkCommand::ProgressEvent, listener);
    filter->SetInputData(SampledImage(CentredCube(80, 1.0), Ellipsoids));
    filter->SetScale(scale);
    filter->Update();
    EXPECT_TRUE(watch.Monotone);
    EXPECT_EQ(watch.Last, 1.0);
    watch = Watch();
    watch.Stop = true;
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(HessianCurvatureFilter, PrintsItsParameters)
{
  vtkNew<vtkHessianCurvature> filter;
  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "Accuracy: 2", "Scale: 0", "InsideIsHigher: 1",
         "ShapeIndexConvention: 0", "GenerateSurfaceType: 0", "MeanTolerance: 0.001" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

}
