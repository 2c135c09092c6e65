#include "Atoms/ChemicalElement.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>

namespace isthmus
{
namespace
{

constexpr double None = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<const char*, NumberOfElements> Symbols{ "X", "H", "He", "Li", "Be", "B", "C",
  "N", "O", "F", "Ne", "Na", "Mg", "Al", "Si", "P", "S", "Cl", "Ar", "K", "Ca", "Sc", "Ti", "V",
  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",
  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I", "Xe", "Cs",
  "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu",
  "Hf", "Ta", "W", "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr",
  "Ra", "Ac", "Th", "Pa", "U", "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr",
  "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og" };

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
    radii[static_cast<std::size_t>(ElementOfSymbol(entry.Symbol))] = entry.Radius;
  }
  return radii;
}

double Look(const Radii& radii, int element)
{
  return element > 0 && element < NumberOfElements ? radii[static_cast<std::size_t>(element)]
                                                   : None;
}

bool IsOneOf(std::string_view text, std::string_view list)
{
  // Lists are "A B C " with a blank after each.
  const auto at = list.find(std::string(text) + " ");
  return !text.empty() && at != std::string_view::npos && (at == 0 || list[at - 1] == ' ');
}

/// Residues in which no atom is of an element with two letters, whatever its name.
bool IsBiopolymerResidue(std::string_view name)
{
  // AMBER's and CHARMM's names of terminal and protonated residues end or begin with one letter
  // more.
  constexpr std::string_view names =
    "ALA ARG ASN ASP CYS GLN GLU GLY HIS ILE LEU LYS MET PHE PRO SER THR TRP TYR VAL HID HIE HIP "
    "HSD HSE HSP CYX CYM ASH GLH LYN A C G U DA DC DG DT DU RA RC RG RU ";
  return IsOneOf(name, names) ||
    (name.size() == 4 && (IsOneOf(name.substr(1), names) || IsOneOf(name.substr(0, 3), names)));
}

}

const char* ElementSymbol(int element)
{
  return Symbols[element > 0 && element < NumberOfElements ? static_cast<std::size_t>(element) : 0];
}

int ElementOfSymbol(std::string_view symbol)
{
  const auto same = [symbol](const char* other)
  {
    const std::string_view o(other);
    return o.size() == symbol.size() &&
      std::equal(o.begin(), o.end(), symbol.begin(),
        [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  };
  if (same("D") || same("T")) // the isotopes of hydrogen
  {
    return 1;
  }
  const auto at = std::find_if(Symbols.begin() + 1, Symbols.end(), same);
  return at == Symbols.end() ? 0 : static_cast<int>(at - Symbols.begin());
}

int ElementOfAtomName(std::string_view name, std::string_view residueName)
{
  const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const auto first = std::find_if(name.begin(), name.end(), isLetter);
  const auto last = std::find_if_not(first, name.end(), isLetter);
  const std::string_view letters = name.substr(
    static_cast<std::size_t>(first - name.begin()), static_cast<std::size_t>(last - first));
  if (letters.empty())
  {
    return 0;
  }
  const bool isIon = residueName.substr(0, letters.size()) == letters &&
    (residueName.size() == letters.size() || !isLetter(residueName[letters.size()]));
  if (isIon && ElementOfSymbol(letters) > 0)
  {
    return ElementOfSymbol(letters);
  }
  const std::string_view two = letters.substr(0, 2);
  if (IsOneOf(two, "CL BR ZN FE MG MN SE SI ") && !IsBiopolymerResidue(residueName))
  {
    return ElementOfSymbol(two);
  }
  return ElementOfSymbol(letters.substr(0, 1));
}

double VanDerWaalsRadius(int element, RadiusTable table)
{
  static const Radii bondi = ByElement(Bondi);
  static const Radii alvarez = ByElement(Alvarez);
  static const Radii united = ByElement(United);
  return Look(table == RadiusTable::Bondi ? bondi
      : table == RadiusTable::Alvarez     ? alvarez
                                          : united,
    element);
}

double CovalentRadius(int element)
{
  static const Radii covalent = ByElement(Covalent);
  return Look(covalent, element);
}

bool IsWater(std::string_view residueName)
{
  return IsOneOf(
    residueName, "HOH DOD WAT H2O OH2 SOL TIP TIP3 TIP4 TP3 TP4 T3P T4P T3H T4H SPC SPCE ");
}

}
