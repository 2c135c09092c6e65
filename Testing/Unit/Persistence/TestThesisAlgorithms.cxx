// Algorithms 4 to 6 of the thesis, as corrected (a vertex comes before the cells it completes; a
// boundary is asked whether it is empty before its youngest cell; a bar counts from its birth to
// before its death), written down step by step, beside vtkScalarPersistence.

#include "vtkScalarPersistence.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace
{

using Size = std::array<int, 3>;
using Cell = std::vector<int>; // its corners, sorted

struct Bar
{
  int Dimension;
  double Birth, Death;
  bool operator<(const Bar& other) const
  {
    return std::array<double, 3>{ double(this->Dimension), this->Birth, this->Death } <
      std::array<double, 3>{ double(other.Dimension), other.Birth, other.Death };
  }
  bool operator==(const Bar& other) const { return !(*this < other) && !(other < *this); }
};

/// Algorithm 5: vertices by value, each followed by the edges and faces that it completes; and
/// Algorithm 4, Pairing, on each of these.
class ThesisBars
{
public:
  ThesisBars(const Size& size, const std::vector<double>& values)
    : Dimensions(size)
    , Values(values)
    , Rank(values.size())
  {
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [&values](int a, int b) { return values[At(a)] < values[At(b)]; });
    for (std::size_t r = 0; r < order.size(); ++r)
    {
      this->Rank[At(order[r])] = static_cast<int>(r);
    }
    for (const int vertex : order)
    {
      this->Pairing({ vertex }, vertex);
      for (const std::size_t corners : { std::size_t(2), std::size_t(4) })
      {
        for (const Cell& cell : this->FindCompletedCells(vertex, corners))
        {
          this->Pairing(cell, vertex);
        }
      }
    }
  }

  /// With births and deaths at different values; those of dimension 1 are loops.
  std::vector<Bar> Bars() const
  {
    std::vector<Bar> bars;
    for (const auto& [cell, birth] : this->Unpaired)
    {
      bars.push_back({ this->Dimension[At(cell)], birth, HUGE_VAL });
    }
    for (const Bar& bar : this->Paired)
    {
      if (bar.Birth < bar.Death)
      {
        bars.push_back(bar);
      }
    }
    // Faces have no cubes to end them here.
    bars.erase(
      std::remove_if(bars.begin(), bars.end(), [](const Bar& b) { return b.Dimension > 1; }),
      bars.end());
    std::sort(bars.begin(), bars.end());
    return bars;
  }

private:
  static std::size_t At(int i) { return static_cast<std::size_t>(i); }

  /// Cells with a given number of corners whose last vertex is this one, by their corners.
  std::vector<Cell> FindCompletedCells(int vertex, std::size_t corners) const
  {
    const int nx = this->Dimensions[0], ny = this->Dimensions[1];
    const Size place{ vertex % nx, vertex / nx % ny, vertex / nx / ny };
    std::set<Cell> cells;
    for (int code = 0; code < 27; ++code)
    {
      const Size step{ code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1 };
      const int axes = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
      if ((1 << axes) != static_cast<int>(corners))
      {
        continue;
      }
      Cell cell;
      bool whole = true;
      for (int corner = 0; corner < 8; ++corner)
      {
        Size at = place;
        for (std::size_t a = 0; a < 3; ++a)
        {
          at[a] += corner >> a & 1 ? step[a] : 0;
        }
        const bool inside = at[0] >= 0 && at[0] < nx && at[1] >= 0 && at[1] < ny && at[2] >= 0 &&
          at[2] < this->Dimensions[2];
        const int id = inside ? at[0] + nx * (at[1] + ny * at[2]) : -1;
        whole = whole && inside && this->Rank[At(id)] <= this->Rank[At(vertex)];
        cell.push_back(id);
      }
      std::sort(cell.begin(), cell.end());
      cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
      if (whole)
      {
        cells.insert(cell);
      }
    }
    return { cells.begin(), cells.end() };
  }

  /// The cells of one dimension less, all of which exist.
  std::set<int> Boundary(const Cell& cell) const
  {
    std::set<int> boundary;
    for (const auto& [other, age] : this->Ages)
    {
      if (2 * other.size() == cell.size() &&
        std::includes(cell.begin(), cell.end(), other.begin(), other.end()))
      {
        boundary.insert(age);
      }
    }
    return boundary;
  }

  void Pairing(const Cell& cell, int vertex)
  {
    std::set<int> boundary = this->Boundary(cell);
    const int age = static_cast<int>(this->Dimension.size());
    const double value = this->Values[At(vertex)];
    this->Ages[cell] = age;
    this->Dimension.push_back(cell.size() == 1 ? 0 : cell.size() == 2 ? 1 : 2);
    while (!boundary.empty())
    {
      const int youngest = *boundary.rbegin();
      const auto open = this->Unpaired.find(youngest);
      if (open != this->Unpaired.end())
      {
        this->Paired.push_back({ this->Dimension[At(youngest)], open->second, value });
        this->Unpaired.erase(open);
        this->Columns[youngest] = boundary;
        return; // negative
      }
      for (const int other : this->Columns.at(youngest))
      {
        if (!boundary.erase(other))
        {
          boundary.insert(other);
        }
      }
    }
    this->Unpaired[age] = value; // positive
  }

  Size Dimensions;
  std::vector<double> Values;
  std::vector<int> Rank;
  std::map<Cell, int> Ages;
  std::vector<int> Dimension;
  std::map<int, double> Unpaired;
  std::map<int, std::set<int>> Columns; ///< reduced boundary of the cell paired with this one
  std::vector<Bar> Paired;
};

vtkSmartPointer<vtkImageData> MakeImage(const Size& size, const std::vector<double>& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], size[2]);
  vtkNew<vtkDoubleArray> array;
  array->SetName("Level");
  array->SetNumberOfValues(image->GetNumberOfPoints());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  image->GetPointData()->SetScalars(array);
  return image;
}

double Value(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

std::vector<Bar> CollectBars(vtkTable* diagram)
{
  std::vector<Bar> bars;
  for (vtkIdType row = 0; row < diagram->GetNumberOfRows(); ++row)
  {
    const Bar bar{ static_cast<int>(Value(diagram, row, "Dimension")), Value(diagram, row, "Birth"),
      Value(diagram, row, "Death") };
    if (bar.Dimension < 2)
    {
      bars.push_back(bar);
    }
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

}

// Drawn: a ring of ones, whose middle comes at 2: the loop is born at 1 and filled at 2. Where a
// corner of the ring is missing, there is none.
//   1 1 1        1 1 1
//   1 2 1        1 2 1
//   1 1 1        1 1 5
TEST(ThesisAlgorithms, ByHand)
{
  const ThesisBars open({ 3, 3, 1 }, { 1, 1, 1, 1, 2, 1, 1, 1, 5 });
  EXPECT_EQ(open.Bars(), (std::vector<Bar>{ { 0, 1, HUGE_VAL } })) << "a ring with a gap";
  const ThesisBars ring({ 3, 3, 1 }, { 1, 1, 1, 1, 2, 1, 1, 1, 1 });
  EXPECT_EQ(ring.Bars(), (std::vector<Bar>{ { 0, 1, HUGE_VAL }, { 1, 1, 2 } }));
  // Two components that meet at 4.
  const ThesisBars pits({ 3, 1, 1 }, { 0, 4, 3 });
  EXPECT_EQ(pits.Bars(), (std::vector<Bar>{ { 0, 0, HUGE_VAL }, { 0, 3, 4 } }));
}

TEST(ThesisAlgorithms, GiveOurBarsCurvesAndIntegral)
{
  std::mt19937 random(7);
  for (const Size& size : { Size{ 4, 4, 4 }, Size{ 6, 5, 1 }, Size{ 5, 3, 4 }, Size{ 2, 7, 3 } })
  {
    for (const int levels : { 3, 12, 1000 }) // plateaus, some, none
    {
      std::uniform_int_distribution<int> level(0, levels);
      std::vector<double> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
      std::generate(values.begin(), values.end(), [&]() { return 0.5 * level(random); });
      const std::vector<Bar> bars = ThesisBars(size, values).Bars();

      vtkNew<vtkScalarPersistence> filter;
      filter->SetInputData(MakeImage(size, values));
      filter->SetNumberOfLevels(17);
      filter->Update();
      EXPECT_EQ(CollectBars(filter->GetDiagram()), bars);

      // Algorithm 6: bars of delta or more, counted from birth to before death, and their area.
      const double delta = 0.2 * levels;
      filter->SetMinimumPersistence(delta);
      filter->Update();
      vtkTable* const curves = filter->GetBettiCurves();
      ASSERT_EQ(curves->GetNumberOfRows(), 17);
      for (vtkIdType row = 0; row < curves->GetNumberOfRows(); ++row)
      {
        const double s = Value(curves, row, "Level");
        int beta1 = 0, filtered = 0;
        double area = 0.0;
        for (const Bar& bar : bars)
        {
          const bool alive = bar.Dimension == 1 && bar.Birth <= s && s < bar.Death;
          const bool kept = bar.Dimension == 1 && bar.Death - bar.Birth >= delta;
          beta1 += alive;
          filtered += alive && kept;
          area += kept ? std::max(0.0, std::min(bar.Death, s) - bar.Birth) : 0.0;
        }
        EXPECT_EQ(Value(curves, row, "Beta1"), beta1) << "at " << s;
        EXPECT_EQ(Value(curves, row, "FilteredBeta1"), filtered) << "at " << s;
        EXPECT_NEAR(Value(curves, row, "IntegralFilteredBeta1"), area, 1e-9 * (1.0 + area));
        EXPECT_EQ(Value(curves, row, "EulerNumber"),
          Value(curves, row, "Beta0") - Value(curves, row, "Beta1") + Value(curves, row, "Beta2"));
      }
    }
  }
}
