#include "Electrostatics/PoissonBoltzmannInput.h"

#include "Core/ImageScalars.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Core/TrilinearField.h"
#include "Electrostatics/SoluteVolume.h"
#include "Surfaces/GridImages.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace isthmus
{
namespace
{

void RequireOneComponent(vtkDataArray* array, const char* what)
{
  if (array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(std::string("The array of ") + what +
      " has several components, but one number for each point is needed: extract one first.");
  }
}

/// Trilinear in the level function, which is extrapolated beyond the volume.
double LevelAt(const LevelFunction& level, const Point3& x)
{
  std::array<std::int64_t, 3> low;
  double t[3];
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double place = x[a] / level.Spacing()[a];
    low[a] = static_cast<std::int64_t>(std::floor(place));
    t[a] = place - std::floor(place);
  }
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    value += (i ? t[0] : 1.0 - t[0]) * (j ? t[1] : 1.0 - t[1]) * (k ? t[2] : 1.0 - t[2]) *
      level(low[0] + i, low[1] + j, low[2] + k);
  }
  return value;
}

/// A potential on a separate grid, trilinear; NaN beyond it.
std::function<double(const Point3&)> MakeGridInterpolator(
  vtkImageData* potential, vtkDataArray* values, vtkImageData* grid)
{
  // A copy: the filter's input may be deleted before the function.
  auto copy =
    std::make_shared<std::vector<double>>(static_cast<std::size_t>(potential->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < potential->GetNumberOfPoints(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      throw std::invalid_argument("The potential of input 2 is not a finite number at node " +
        std::to_string(i) + ": replace it, or disconnect the input.");
    }
    (*copy)[static_cast<std::size_t>(i)] = value;
  }
  const GridShape shape = GetGridShape(potential);
  const vtkSmartPointer<vtkImageData> here = grid;
  const vtkSmartPointer<vtkImageData> there = potential;
  return [copy, shape, here, there](const Point3& place)
  {
    Point3 x = ToGrid(there, ToWorld(here, place));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double end = shape.Spacing[a] * static_cast<double>(shape.Dimensions[a] - 1);
      const double rounding = 1e-6 * shape.Spacing[a];
      if (x[a] < -rounding || x[a] > end + rounding)
      {
        return std::numeric_limits<double>::quiet_NaN();
      }
      x[a] = std::min(std::max(x[a], 0.0), end);
    }
    return TrilinearField<double>{ { copy->data(), shape.Dimensions, shape.Spacing } }(x);
  };
}

}

std::vector<ChargedAtom> MakeChargedAtoms(
  vtkDataObject* input, const MoleculeAtoms& atoms, const std::string& name)
{
  const std::vector<double> charges = AtomCharges(input, atoms, name);
  std::vector<ChargedAtom> charged;
  for (std::size_t i = 0; i < charges.size(); ++i)
  {
    charged.push_back({ {}, charges[i], 0.0 });
    AtomPoints(input)->GetPoint(atoms.Kept[i], charged.back().Position.data());
  }
  return charged;
}

SoluteAtoms ReadSolute(vtkAlgorithm* filter, vtkPointSet* points, bool radiiNeeded)
{
  AtomOptions all;
  all.RadiusArray = InputArrayName(filter, 0);
  all.ZeroRadii = true;
  all.KeepCopies = true; // output 2 has a value for each atom
  all.Fallback = radiiNeeded ? RadiusFallback::None : RadiusFallback::Zero;
  all.Missing = MissingRadius::Refuse;
  const MoleculeAtoms atoms = ReadAtoms(points, all);
  SoluteAtoms solute;
  solute.Atoms = MakeChargedAtoms(points, atoms, InputArrayName(filter, 1));
  double absolute = 0.0;
  for (std::size_t i = 0; i < solute.Atoms.size(); ++i)
  {
    ChargedAtom& atom = solute.Atoms[i];
    atom.Radius = atoms.Balls[i].Radius; // atoms and balls have the same indices
    if (std::binary_search(atoms.Copies.begin(), atoms.Copies.end(), atoms.Kept[i]))
    {
      atom.Charge = atom.Radius = 0.0;
    }
    solute.NetCharge += atom.Charge;
    absolute += std::abs(atom.Charge);
  }
  if (!(absolute > 0.0))
  {
    throw std::invalid_argument("All charges are 0, so there is no potential: read a PQR file, or "
                                "choose another array of charges.");
  }
  for (const std::string& warning : atoms.Warnings)
  {
    solute.Warning += warning + " ";
  }
  if (std::abs(solute.NetCharge - std::round(solute.NetCharge)) > 0.01)
  {
    solute.Warning += "The net charge is " + FormatNumber(solute.NetCharge) +
      " e, not a whole number: atoms may be missing, or their charges.";
  }
  return solute;
}

vtkDataArray* SurfaceScalars(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars && image->GetPointData()->GetNumberOfArrays() == 1)
  {
    scalars = image->GetPointData()->GetArray(0);
  }
  if (!scalars)
  {
    throw std::invalid_argument("The volume on input 1 has no active point scalars whose level "
                                "would be the surface; it has:" +
      ArrayNames(image->GetPointData()) + ". Make one of these active.");
  }
  RequireOneComponent(scalars, "the surface's scalars");
  return scalars;
}

void PlaceOnGrid(const SoluteVolume& volume, std::vector<ChargedAtom>& atoms)
{
  std::size_t outside = 0;
  std::size_t first = 0;
  std::size_t index = 0;
  for (ChargedAtom& atom : atoms)
  {
    atom.Position = ToGrid(volume.Grid, atom.Position);
    if (atom.Charge != 0.0 && !(LevelAt(volume.Level, atom.Position) < 0.0))
    {
      first = outside++ == 0 ? index : first;
    }
    ++index;
  }
  if (outside > 0 && volume.Decay > 0.0)
  {
    throw std::invalid_argument("The grid is too coarse to show the ball of atom " +
      std::to_string(first) + ", which has a charge: choose a Spacing below its radius.");
  }
  if (outside > 0)
  {
    throw std::invalid_argument(std::to_string(outside) +
      " charged atoms lie outside the surface, the first is atom " + std::to_string(first) +
      ": charges belong inside. Choose another Level, toggle InsideIsHigher, use a surface farther "
      "out, or remove these atoms.");
  }
}

void SetPotentialInput(
  vtkImageData* potential, vtkImageData* grid, PoissonBoltzmannParameters& parameters)
{
  const bool border = parameters.BoundaryCondition == BoundaryCondition::Given;
  if (!potential || potential->GetNumberOfPoints() == 0)
  {
    if (border)
    {
      throw std::invalid_argument("BoundaryCondition is FromInput, but there is no potential on "
                                  "input 2: connect one, or choose another condition.");
    }
    return;
  }
  vtkDataArray* values = potential->GetPointData()->GetArray("Potential");
  values = values ? values : potential->GetPointData()->GetScalars();
  if (!values)
  {
    throw std::invalid_argument("The potential on input 2 has no such point array; it has:" +
      ArrayNames(potential->GetPointData()) + ".");
  }
  RequireOneComponent(values, "the potential");
  const auto function = MakeGridInterpolator(potential, values, grid);
  if (!border)
  {
    parameters.Start = [function](const Point3& x)
    {
      const double value = function(x);
      return std::isnan(value) ? 0.0 : value;
    };
    return;
  }
  parameters.Boundary = [function](const Point3& x)
  {
    const double value = function(x);
    if (std::isnan(value))
    {
      throw std::invalid_argument("The potential on input 2 does not cover the border of the grid: "
                                  "connect a larger one, or choose another BoundaryCondition.");
    }
    return value;
  };
}

}
