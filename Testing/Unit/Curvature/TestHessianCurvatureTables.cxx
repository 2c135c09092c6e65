// Tables 5.3 to 5.6 of the thesis, through the filter: all 32 errors to the four printed digits,
// and the errors with differences of fourth order.
#include "FieldImage.h"
#include "vtkHessianCurvature.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace
{

using namespace isthmus::testing;

/// Height function Z(x, y) with its derivatives; the level sets of z - Z are shifted copies of it.
struct Height
{
  double Z, X, Y, XX, YY, XY;
};

using Surface = Height (*)(double x, double y);

/// Test case 1 of the thesis (5.52).
Height Quintic(double x, double y)
{
  const double s = 1.0 / 2000.0;
  return { s * (x * x - y * y) * (x * x * x - y * y * y),
    s * (5 * std::pow(x, 4) - 2 * x * std::pow(y, 3) - 3 * x * x * y * y),
    s * (-3 * x * x * y * y - 2 * std::pow(x, 3) * y + 5 * std::pow(y, 4)),
    s * (20 * std::pow(x, 3) - 2 * std::pow(y, 3) - 6 * x * y * y),
    s * (-6 * x * x * y - 2 * std::pow(x, 3) + 20 * std::pow(y, 3)),
    s * (-6 * x * y * y - 6 * x * x * y) };
}

/// Test case 2 of the thesis (5.55).
Height Cubic(double x, double y)
{
  return { (x * x * x - y * y * y) / 30.0, x * x / 10.0, -y * y / 10.0, x / 5.0, -y / 5.0, 0.0 };
}

Height Sine(double x, double y)
{
  const double a = 0.5 * x;
  const double b = 0.4 * y + 0.3;
  return { std::sin(a) * std::sin(b), 0.5 * std::cos(a) * std::sin(b),
    0.4 * std::sin(a) * std::cos(b), -0.25 * std::sin(a) * std::sin(b),
    -0.16 * std::sin(a) * std::sin(b), 0.2 * std::cos(a) * std::cos(b) };
}

/// Gaussian and mean curvature of a graph (5.53, 5.54), positive H where it is concave upwards.
std::pair<double, double> ExactCurvature(const Height& h)
{
  const double w = 1.0 + h.X * h.X + h.Y * h.Y;
  return { (h.XX * h.YY - h.XY * h.XY) / (w * w),
    ((1.0 + h.X * h.X) * h.YY - 2.0 * h.X * h.Y * h.XY + (1.0 + h.Y * h.Y) * h.XX) /
      (2.0 * w * std::sqrt(w)) };
}

struct Errors
{
  double GaussianMaximum = 0.0, GaussianRms = 0.0, MeanMaximum = 0.0, MeanRms = 0.0;
  double LargestGaussian = 0.0, LargestMean = 0.0; // of the exact values
  vtkIdType Nodes = 0;
};

/// Errors at all nodes with a value of an n x n grid on [-10, 10]^2, as thick as the stencil.
Errors RecordErrors(Surface surface, int n, int accuracy)
{
  const double h = 20.0 / (n - 1);
  Lattice lattice;
  lattice.Dimensions = { n, n, accuracy + 1 };
  lattice.Origin = { -10.0, -10.0, -h };
  lattice.Spacing = { h, h, h };
  const auto image =
    SampledImage(lattice, [surface](double x, double y, double z) { return z - surface(x, y).Z; });
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->SetAccuracy(accuracy);
  filter->Update();
  vtkDataArray* gaussian = PointArray(filter->GetOutput(), "GaussianCurvature");
  vtkDataArray* mean = PointArray(filter->GetOutput(), "MeanCurvature");
  vtkDataArray* valid = PointArray(filter->GetOutput(), "CurvatureValid");
  Errors errors;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    if (valid->GetComponent(id, 0) != 0.0)
    {
      const double* p = image->GetPoint(id);
      const auto [exactGaussian, exactMean] = ExactCurvature(surface(p[0], p[1]));
      const double k = std::abs(gaussian->GetComponent(id, 0) - exactGaussian);
      const double m = std::abs(mean->GetComponent(id, 0) - exactMean);
      errors.GaussianMaximum = std::max(errors.GaussianMaximum, k);
      errors.MeanMaximum = std::max(errors.MeanMaximum, m);
      errors.GaussianRms += k * k;
      errors.MeanRms += m * m;
      errors.LargestGaussian = std::max(errors.LargestGaussian, std::abs(exactGaussian));
      errors.LargestMean = std::max(errors.LargestMean, std::abs(exactMean));
      ++errors.Nodes;
    }
  }
  errors.GaussianRms = std::sqrt(errors.GaussianRms / static_cast<double>(errors.Nodes));
  errors.MeanRms = std::sqrt(errors.MeanRms / static_cast<double>(errors.Nodes));
  return errors;
}

/// `value` as the tables print it.
std::string FourDigits(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3e", value);
  return text;
}

struct Row
{
  Surface Case;
  int Nodes;
  const char* Printed[4]; // K maximum, K rms, H maximum, H rms
};

const std::vector<Row> tables = {
  { Quintic, 21, { "1.483e-01", "1.543e-02", "4.498e-01", "3.735e-02" } },
  { Quintic, 41, { "7.049e-02", "4.280e-03", "4.057e-02", "2.667e-03" } },
  { Quintic, 81, { "2.028e-02", "8.494e-04", "2.231e-03", "5.262e-04" } },
  { Quintic, 161, { "5.348e-03", "1.816e-04", "6.893e-04", "1.343e-04" } },
  { Cubic, 11, { "2.682e-02", "6.295e-03", "4.451e-02", "1.009e-02" } },
  { Cubic, 21, { "7.268e-03", "1.420e-03", "1.146e-02", "2.415e-03" } },
  { Cubic, 41, { "1.846e-03", "3.528e-04", "2.923e-03", "5.942e-04" } },
  { Cubic, 81, { "4.927e-04", "8.751e-05", "7.604e-04", "1.470e-04" } },
};

TEST(HessianCurvatureTables, AllPrintedErrorsOfTheThesis)
{
  for (const Row& row : tables)
  {
    const Errors errors = RecordErrors(row.Case, row.Nodes, 2);
    EXPECT_EQ(errors.Nodes, static_cast<vtkIdType>(row.Nodes - 2) * (row.Nodes - 2));
    EXPECT_EQ(FourDigits(errors.GaussianMaximum), row.Printed[0]) << row.Nodes << " K maximum";
    EXPECT_EQ(FourDigits(errors.GaussianRms), row.Printed[1]) << row.Nodes << " K rms";
    EXPECT_EQ(FourDigits(errors.MeanMaximum), row.Printed[2]) << row.Nodes << " H maximum";
    EXPECT_EQ(FourDigits(errors.MeanRms), row.Printed[3]) << row.Nodes << " H rms";
  }
}

void ExpectFourthOrder(Surface surface, int n, const char* name)
{
  const Errors coarse = RecordErrors(surface, n, 4);
  const Errors fine = RecordErrors(surface, 2 * n - 1, 4);
  const double gaussian = std::log2(coarse.GaussianMaximum / fine.GaussianMaximum);
  const double gaussianRms = std::log2(coarse.GaussianRms / fine.GaussianRms);
  const double mean = std::log2(coarse.MeanMaximum / fine.MeanMaximum);
  const double meanRms = std::log2(coarse.MeanRms / fine.MeanRms);
  std::printf("%s, %d to %d nodes: order of K %.3f (maximum) %.3f (rms), of H %.3f %.3f\n", name, n,
    2 * n - 1, gaussian, gaussianRms, mean, meanRms);
  EXPECT_GE(gaussian, 3.9);
  EXPECT_GE(gaussianRms, 3.9);
  EXPECT_GE(mean, 3.9);
  EXPECT_GE(meanRms, 3.9);
}

TEST(HessianCurvatureTables, FourthOrderOnCaseOne)
{
  ExpectFourthOrder(Quintic, 161, "case 1");
}

TEST(HessianCurvatureTables, FourthOrderOnASineSurface)
{
  ExpectFourthOrder(Sine, 81, "sine");
}

TEST(HessianCurvatureTables, FourthOrderIsExactOnTheCubicCase)
{
  for (const int n : { 11, 21, 41, 81 })
  {
    const Errors errors = RecordErrors(Cubic, n, 4);
    std::printf("case 2, %d nodes: K %.2e of %.2e, H %.2e of %.2e\n", n, errors.GaussianMaximum,
      errors.LargestGaussian, errors.MeanMaximum, errors.LargestMean);
    EXPECT_LT(errors.GaussianMaximum, 1e-12 * errors.LargestGaussian);
    EXPECT_LT(errors.MeanMaximum, 1e-12 * errors.LargestMean);
  }
}

}
