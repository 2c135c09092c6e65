#include "Atoms/AtomRadii.h"

#include "Atoms/ChemicalElement.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double None = std::numeric_limits<double>::quiet_NaN();

struct RadiusEntry
{
  const char* Symbol;
  double Radius;
};

constexpr RadiusEntry Bondi[] = { { "H", 1.20 }, { "He", 1.40 }, { "Li", 1.82 }, { "Be", 1.53 },
  { "B", 1.92 }, { "C", 1.70 }, { "N", 1.55 }, { "O", 1.52 }, { "F", 1.47 }, { "Ne", 1.54 },
  { "Na", 2.27 }, { "Mg", 1.73 }, { "Al", 1.84 }, { "Si", 2.10 }, { "P", 1.80 }, { "S", 1.80 },
  { "Cl", 1.75 }, { "Ar", 1.88 }, { "K", 2.75 }, { "Ca", 2.31 }, { "Ni", 1.63 }, { "Cu", 1.40 },
  { "Zn", 1.39 }, { "Ga", 1.87 }, { "Ge", 2.11 }, { "As", 1.85 }, { "Se", 1.90 }, { "Br", 1.85 },
  { "Kr", 2.02 }, { "Rb", 3.03 }, { "Sr", 2.49 }, { "Pd", 1.63 }, { "Ag", 1.72 }, { "Cd", 1.58 },
  { "In", 1.93 }, { "Sn", 2.17 }, { "Sb", 2.06 }, { "Te", 2.06 }, { "I", 1.98 }, { "Xe", 2.16 },
  { "Cs", 3.43 }, { "Ba", 2.68 }, { "Pt", 1.75 }, { "Au", 1.66 }, { "Hg", 1.55 }, { "Tl", 1.96 },
  { "Pb", 2.02 }, { "Bi", 2.07 }, { "Po", 1.97 }, { "At", 2.02 }, { "Rn", 2.20 }, { "Fr", 3.48 },
  { "Ra", 2.83 }, { "U", 1.86 } };

constexpr RadiusEntry United[] = { { "H", 1.00 }, { "C", 1.85 }, { "N", 1.75 }, { "O", 1.65 },
  { "P", 2.10 }, { "S", 2.00 } };

constexpr RadiusEntry Alvarez[] = { { "H", 1.20 }, { "He", 1.43 }, { "Li", 2.12 }, { "Be", 1.98 },
  { "B", 1.91 }, { "C", 1.77 }, { "N", 1.66 }, { "O", 1.50 }, { "F", 1.46 }, { "Ne", 1.58 },
  { "Na", 2.50 }, { "Mg", 2.51 }, { "Al", 2.25 }, { "Si", 2.19 }, { "P", 1.90 }, { "S", 1.89 },
  { "Cl", 1.82 }, { "Ar", 1.83 }, { "K", 2.73 }, { "Ca", 2.62 }, { "Sc", 2.58 }, { "Ti", 2.46 },
  { "V", 2.42 }, { "Cr", 2.45 }, { "Mn", 2.45 }, { "Fe", 2.44 }, { "Co", 2.40 }, { "Ni", 2.40 },
  { "Cu", 2.38 }, { "Zn", 2.39 }, { "Ga", 2.32 }, { "Ge", 2.29 }, { "As", 1.88 }, { "Se", 1.82 },
  { "Br", 1.86 }, { "Kr", 2.25 }, { "Rb", 3.21 }, { "Sr", 2.84 }, { "Y", 2.75 }, { "Zr", 2.52 },
  { "Nb", 2.56 }, { "Mo", 2.45 }, { "Tc", 2.44 }, { "Ru", 2.46 }, { "Rh", 2.44 }, { "Pd", 2.15 },
  { "Ag", 2.53 }, { "Cd", 2.49 }, { "In", 2.43 }, { "Sn", 2.42 }, { "Sb", 2.47 }, { "Te", 1.99 },
  { "I", 2.04 }, { "Xe", 2.06 }, { "Cs", 3.48 }, { "Ba", 3.03 }, { "La", 2.98 }, { "Ce", 2.88 },
  { "Pr", 2.92 }, { "Nd", 2.95 }, { "Sm", 2.90 }, { "Eu", 2.87 }, { "Gd", 2.83 }, { "Tb", 2.79 },
  { "Dy", 2.87 }, { "Ho", 2.81 }, { "Er", 2.83 }, { "Tm", 2.79 }, { "Yb", 2.80 }, { "Lu", 2.74 },
  { "Hf", 2.63 }, { "Ta", 2.53 }, { "W", 2.57 }, { "Re", 2.49 }, { "Os", 2.48 }, { "Ir", 2.41 },
  { "Pt", 2.29 }, { "Au", 2.32 }, { "Hg", 2.45 }, { "Tl", 2.47 }, { "Pb", 2.60 }, { "Bi", 2.54 },
  { "Ac", 2.80 }, { "Th", 2.93 }, { "Pa", 2.88 }, { "U", 2.71 }, { "Np", 2.82 }, { "Pu", 2.81 },
  { "Am", 2.83 }, { "Cm", 3.05 }, { "Bk", 3.40 }, { "Cf", 3.05 }, { "Es", 2.70 } };

constexpr RadiusEntry Covalent[] = { { "H", 0.31 }, { "B", 0.84 }, { "C", 0.76 }, { "N", 0.71 },
  { "O", 0.66 }, { "F", 0.57 }, { "Si", 1.11 }, { "P", 1.07 }, { "S", 1.05 }, { "Cl", 1.02 },
  { "Ge", 1.20 }, { "As", 1.19 }, { "Se", 1.20 }, { "Br", 1.20 }, { "Te", 1.38 }, { "I", 1.39 } };

using Radii = std::array<double, NumberOfElements>;

template <std::size_t N>
Radii ByElement(const RadiusEntry (&entries)[N])
{
  Radii radii;
  radii.fill(None);
  for (const RadiusEntry& entry : entries)
  {
    radii[static_cast<std::size_t>(ElementFromSymbol(entry.Symbol))] = entry.Radius;
  }
  return radii;
}

double LookUp(const Radii& radii, int element)
{
  return element > 0 && element < NumberOfElements ? radii[static_cast<std::size_t>(element)]
                                                   : None;
}

bool MatchTable(
  const std::vector<double>& radii, const std::vector<int>& elements, RadiusTable table)
{
  constexpr double rounding = 1e-5; // for radii stored as floats
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const double expected = VanDerWaalsRadius(elements[i], table);
    if (!std::isnan(radii[i]) && !(std::abs(radii[i] - expected) < rounding))
    {
      return false;
    }
  }
  return true;
}

/// The reader's array of radii.
constexpr const char* DefaultArray = "Radius";

}

double VanDerWaalsRadius(int element, RadiusTable table)
{
  static const Radii bondi = ByElement(Bondi);
  static const Radii alvarez = ByElement(Alvarez);
  static const Radii united = ByElement(United);
  return LookUp(table == RadiusTable::Bondi ? bondi
      : table == RadiusTable::Alvarez       ? alvarez
                                            : united,
    element);
}

double CovalentRadius(int element)
{
  static const Radii covalent = ByElement(Covalent);
  return LookUp(covalent, element);
}

double DefaultRadius(int element)
{
  const double radius = VanDerWaalsRadius(element, RadiusTable::Bondi);
  return std::isnan(radius) ? VanDerWaalsRadius(element, RadiusTable::Alvarez) : radius;
}

AtomRadii ReadRadii(vtkDataSetAttributes* data, vtkIdType count, const std::vector<int>& elements,
  const std::string& name, RadiusFallback fallback)
{
  const std::string chosen =
    name.empty() ? DefaultArray : name; // a panel without data sends an empty name
  AtomRadii radii;
  radii.Values.assign(static_cast<std::size_t>(count), 0.0);
  if (vtkDataArray* array = data->GetArray(chosen.c_str()))
  {
    if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < count)
    {
      throw std::invalid_argument("The array " + chosen +
        " of radii does not have one number for each atom: it has several components, or ends "
        "before the last atom. Extract one component, or choose another array.");
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      radii.Values[static_cast<std::size_t>(i)] = array->GetComponent(i, 0);
    }
    return radii;
  }
  const bool byElement = fallback == RadiusFallback::Element;
  if (byElement && !elements.empty())
  {
    radii.ByElement = true;
    std::transform(elements.begin(), elements.end(), radii.Values.begin(), DefaultRadius);
    if (chosen != DefaultArray)
    {
      radii.Warning = "There is no point array " + chosen +
        " of radii: van der Waals radii (Bondi, Alvarez) are used. Choose another array.";
    }
    return radii;
  }
  if (fallback != RadiusFallback::Zero)
  {
    throw std::invalid_argument("The atoms have no point array " + chosen +
      " of radii; they have:" + ArrayNames(data) +
      (byElement ? ". There is no array Element by which radii could be looked up either: read the "
                   "atoms with vtkMacromoleculeReader, or choose one of these arrays."
                 : ". The radii of a force field are needed: read a PQR file, choose one of these "
                   "arrays, or connect a surface."));
  }
  return radii;
}

bool AssignUnitedRadii(
  const std::vector<std::size_t>& kept, const std::vector<int>& elements, AtomRadii& radii)
{
  const bool hydrogens =
    std::any_of(kept.begin(), kept.end(), [&elements](std::size_t i) { return elements[i] == 1; });
  if (hydrogens ||
    !(radii.ByElement || MatchTable(radii.Values, elements, RadiusTable::Bondi) ||
      MatchTable(radii.Values, elements, RadiusTable::Alvarez)))
  {
    return false;
  }
  for (const std::size_t i : kept)
  {
    const double united = VanDerWaalsRadius(elements[i], RadiusTable::UnitedAtom);
    radii.Values[i] = std::isnan(united) ? radii.Values[i] : united;
  }
  return true;
}

std::string ArrayNames(vtkDataSetAttributes* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    names += std::string(" ") + (name ? name : "(unnamed)");
  }
  return names.empty() ? " none" : names;
}

}
