#include "Solvation/IonTransportOutput.h"

#include "Core/NamedColumns.h"
#include "Core/ParallelFor.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Doubles of the solution may exceed the range of float.
void RequireFinite(vtkFloatArray* array)
{
  const float* const values = array->GetPointer(0);
  if (!std::all_of(
        values, values + array->GetNumberOfValues(), [](float v) { return std::isfinite(v); }))
  {
    throw std::runtime_error(std::string(array->GetName()) +
      " leaves the range of its numbers (3.4e38) at some nodes: such charges attract more ions "
      "than is physically possible. Correct the charges of the atoms, which are in units of e.");
  }
}

/// The fluxes of all species at a node, and their current in pA per square angstrom.
void WriteFluxes(const PoissonNernstPlanck& solution, std::int64_t node,
  const std::vector<float*>& fluxes, float* density)
{
  Point3 current{ 0.0, 0.0, 0.0 };
  for (std::size_t k = 0; k < fluxes.size(); ++k)
  {
    const Point3 flux = FluxAt(solution, SpeciesId(k), node);
    for (std::size_t a = 0; a < 3; ++a)
    {
      fluxes[k][3 * node + static_cast<std::int64_t>(a)] = static_cast<float>(flux[a]);
      current[a] += solution.GetParameters().Species[k].Valence * PicoamperePerIon() * flux[a];
    }
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    density[3 * node + static_cast<std::int64_t>(a)] = static_cast<float>(current[a]);
  }
}

}

void SetImageGeometry(const TransportDomain& domain, vtkImageData* image)
{
  image->SetDimensions(static_cast<int>(domain.Dimensions[0]),
    static_cast<int>(domain.Dimensions[1]), static_cast<int>(domain.Dimensions[2]));
  image->SetOrigin(domain.Origin.data());
  image->SetSpacing(domain.Spacing, domain.Spacing, domain.Spacing);
  vtkNew<vtkMatrix3x3> axes;
  for (int a = 0; a < 3; ++a)
  {
    for (int c = 0; c < 3; ++c)
    {
      axes->SetElement(c, a, domain.Axes[static_cast<std::size_t>(a)][static_cast<std::size_t>(c)]);
    }
  }
  image->SetDirectionMatrix(axes);
}

TransportDomain ImageBox(const TransportDomain& domain)
{
  TransportDomain box = domain;
  box.Axes = TransportDomain().Axes;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double along = std::abs(domain.Normal[a]);
    const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
    const double half = along * domain.HalfLength + across * domain.Radius;
    const double nodes = std::ceil(half / domain.Spacing - 1e-6) + 1.0;
    box.Dimensions[a] = 2 * static_cast<std::int64_t>(nodes) + 1;
    box.Origin[a] = domain.Center[a] - domain.Spacing * nodes;
  }
  return box;
}

namespace
{

/// Potential (active), concentrations and fluxes, current density and distance at the nodes.
void AddNodeArrays(
  const PoissonNernstPlanck& solution, vtkPointData* to, const ProgressCallback& progress)
{
  const TransportGrid& grid = solution.GetGrid();
  const std::int64_t nodes = grid.Domain.Size();
  auto potential = NamedArray<vtkDoubleArray>("Potential", nodes);
  auto density = NamedArray<vtkFloatArray>("CurrentDensity", nodes, 3);
  auto distance = NamedArray<vtkFloatArray>("SignedDistance", nodes);
  std::copy(
    solution.GetPotential().begin(), solution.GetPotential().end(), potential->GetPointer(0));
  std::copy(grid.Distance.begin(), grid.Distance.end(), distance->GetPointer(0));
  to->SetScalars(potential);
  std::vector<float*> concentrations;
  std::vector<float*> fluxes;
  for (const TransportSpecies& s : solution.GetParameters().Species)
  {
    auto concentration = NamedArray<vtkFloatArray>("Concentration_" + s.Name, nodes);
    auto flux = NamedArray<vtkFloatArray>("Flux_" + s.Name, nodes, 3);
    concentrations.push_back(concentration->GetPointer(0));
    fluxes.push_back(flux->GetPointer(0));
    to->AddArray(concentration);
    to->AddArray(flux);
  }
  to->AddArray(density);
  to->AddArray(distance);
  float* const current = density->GetPointer(0);
  ParallelFor(
    0, nodes, 1 << 12,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        for (std::size_t k = 0; k < concentrations.size(); ++k)
        {
          concentrations[k][node] = static_cast<float>(solution.Concentration(SpeciesId(k), node));
        }
        WriteFluxes(solution, node, fluxes, current);
      }
    },
    progress);
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    if (auto* const written = vtkFloatArray::SafeDownCast(to->GetArray(i)))
    {
      RequireFinite(written);
    }
  }
}

/// The nodes of a grid around a place, and their weights in trilinear interpolation. Places beyond
/// the grid have the values of its border.
struct NodesAround
{
  std::array<std::int64_t, 8> Nodes{};
  std::array<double, 8> Weights{};

  NodesAround(const TransportDomain& grid, const Point3& place)
  {
    const Point3 at = grid.InAxes(place);
    const std::array<std::int64_t, 3> steps = grid.Steps();
    this->Weights[0] = 1.0;
    for (std::size_t a = 0, known = 1; a < 3; ++a, known *= 2)
    {
      const double last = static_cast<double>(grid.Dimensions[a] - 1);
      const double x = std::clamp(at[a] / grid.Spacing, 0.0, last);
      const double low = std::min(std::floor(x), last - 1.0);
      for (std::size_t i = 0; i < known; ++i)
      {
        this->Nodes[i] += static_cast<std::int64_t>(low) * steps[a];
        this->Nodes[known + i] = this->Nodes[i] + steps[a];
        this->Weights[known + i] = this->Weights[i] * (x - low);
        this->Weights[i] *= 1.0 - (x - low);
      }
    }
  }
};

template <typename Array>
void Interpolate(const TransportDomain& grid, Array* from, const TransportDomain& box, Array* to)
{
  const int components = from->GetNumberOfComponents();
  const auto* const known = from->GetPointer(0);
  auto* const result = to->GetPointer(0);
  ParallelFor(0, box.Size(), 1 << 12,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const NodesAround around(grid, box.Place(node));
        for (int c = 0; c < components; ++c)
        {
          double sum = 0.0;
          for (std::size_t i = 0; i < around.Nodes.size(); ++i)
          {
            sum += around.Weights[i] * static_cast<double>(known[components * around.Nodes[i] + c]);
          }
          result[components * node + c] = static_cast<typename Array::ValueType>(sum);
        }
      }
    });
}

/// A new array in `box`.
template <typename Array>
vtkSmartPointer<Array> Interpolated(
  const TransportDomain& grid, Array* from, const TransportDomain& box)
{
  auto to = NamedArray<Array>(from->GetName(), box.Size(), from->GetNumberOfComponents());
  Interpolate(grid, from, box, to.Get());
  return to;
}

}

void FillTransportImage(
  const PoissonNernstPlanck& solution, vtkImageData* image, const ProgressCallback& progress)
{
  const TransportDomain& grid = solution.GetGrid().Domain;
  const TransportDomain box = ImageBox(grid);
  SetImageGeometry(box, image);
  if (grid.Axes == box.Axes)
  {
    AddNodeArrays(solution, image->GetPointData(), progress);
    return;
  }
  vtkNew<vtkPointData> nodes;
  AddNodeArrays(solution, nodes, Between(progress, 0.0, 0.5));
  const int count = nodes->GetNumberOfArrays();
  for (int i = 0; i < count; ++i)
  {
    if (auto* const floats = vtkFloatArray::SafeDownCast(nodes->GetArray(i)))
    {
      image->GetPointData()->AddArray(Interpolated(grid, floats, box));
    }
    else if (auto* const doubles = vtkDoubleArray::SafeDownCast(nodes->GetArray(i)))
    {
      image->GetPointData()->SetScalars(Interpolated(grid, doubles, box));
    }
    Report(progress, 0.5 + 0.5 * (i + 1) / count);
  }
}

void FillTransportNumbers(const PoissonNernstPlanck& solution, const CurrentProfile& profile,
  double currentError, const ChannelPassage& passage, vtkImageData* image)
{
  const std::vector<TransportSpecies>& species = solution.GetParameters().Species;
  const IonTransportReport& report = solution.GetReport();
  vtkFieldData* const data = image->GetFieldData();
  AddColumn<vtkDoubleArray>(data, "Voltage", { solution.GetVoltage() });
  for (std::size_t k = 0; k < species.size(); ++k)
  {
    AddColumn<vtkDoubleArray>(data, "Current_" + species[k].Name, { profile.Mean(k) });
  }
  AddColumn<vtkDoubleArray>(data, "Current", { profile.Mean() });
  AddColumn<vtkDoubleArray>(data, "CurrentError", { currentError });
  AddColumn<vtkDoubleArray>(data, "CurrentSpread", { profile.Spread() });
  AddColumn<vtkDoubleArray>(data, "Converged", { report.Converged ? 1.0 : 0.0 });
  AddColumn<vtkDoubleArray>(data, "Changes", report.Changes);
  AddColumn<vtkDoubleArray>(data, "BottleneckRadius", { passage.Radius });
  const Point3& at = passage.Bottleneck;
  AddColumn<vtkDoubleArray>(data, "BottleneckPosition", { at[0], at[1], at[2] });
}

void FillSections(
  const CurrentProfile& profile, const std::vector<TransportSpecies>& species, vtkTable* table)
{
  std::vector<double> whole(profile.Along.size(), 0.0);
  AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Along", profile.Along, [](double along) { return along; });
  for (std::size_t k = 0; k < species.size(); ++k)
  {
    AddComputedColumn<vtkDoubleArray>(table->GetRowData(), "Current_" + species[k].Name,
      profile.Currents[k], [](double x) { return x; });
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      whole[i] += profile.Currents[k][i];
    }
  }
  AddComputedColumn<vtkDoubleArray>(
    table->GetRowData(), "Current", whole, [](double current) { return current; });
}

namespace
{

struct MotionColumn
{
  const char* Name;
  double (*Value)(const ChannelUpdate&);
};

constexpr MotionColumn MotionColumns[] = {
  { "Time", [](const ChannelUpdate& u) { return u.Time; } },
  { "AreaChange", [](const ChannelUpdate& u) { return u.AreaChange; } },
  { "LumenVolume", [](const ChannelUpdate& u) { return u.LumenVolume; } },
  { "EnergyChange", [](const ChannelUpdate& u) { return u.EnergyChange; } },
  { "OnObstacle", [](const ChannelUpdate& u) { return u.OnObstacle; } },
  { "BottleneckRadius", [](const ChannelUpdate& u) { return u.Bottleneck; } },
};

}

void FillMotion(const MovingChannel& moving, const std::vector<TransportSpecies>& species,
  vtkImageData* image, vtkTable* table)
{
  vtkFieldData* const data = image->GetFieldData();
  if (!moving.HasConverged())
  {
    data->GetArray("Converged")->SetComponent(0, 0, 0.0);
  }
  AddColumn<vtkDoubleArray>(data, "ShownUpdate", { moving.GetShown() + 1 });
  vtkFieldData* const rows = table->GetRowData();
  const std::vector<ChannelUpdate>& updates = moving.GetUpdates();
  AddComputedColumn<vtkDoubleArray>(
    rows, "Update", updates.size(), [](std::size_t row) { return row + 1; });
  for (const MotionColumn& column : MotionColumns)
  {
    AddComputedColumn<vtkDoubleArray>(rows, column.Name, updates, column.Value);
  }
  for (std::size_t k = 0; k < species.size(); ++k)
  {
    AddComputedColumn<vtkDoubleArray>(rows, "Current_" + species[k].Name, updates,
      [k](const ChannelUpdate& u) { return u.Currents[k]; });
  }
  AddComputedColumn<vtkDoubleArray>(
    rows, "Current", updates, [](const ChannelUpdate& u) { return u.Current(); });
}

}
