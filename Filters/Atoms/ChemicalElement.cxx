#include "Atoms/ChemicalElement.h"

#include "Atoms/NameLetters.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::array<const char*, NumberOfElements> Symbols{ "X", "H", "He", "Li", "Be", "B", "C",
  "N", "O", "F", "Ne", "Na", "Mg", "Al", "Si", "P", "S", "Cl", "Ar", "K", "Ca", "Sc", "Ti", "V",
  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",
  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I", "Xe", "Cs",
  "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu",
  "Hf", "Ta", "W", "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr",
  "Ra", "Ac", "Th", "Pa", "U", "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr",
  "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og" };

bool IsInList(std::string_view text, std::string_view list)
{
  // Lists are "A B C " with a blank after each.
  const auto isWord = [&](std::size_t at)
  {
    const std::size_t end = at + text.size();
    return (at == 0 || list[at - 1] == ' ') && end < list.size() && list[end] == ' ';
  };
  std::size_t at = text.empty() ? std::string_view::npos : list.find(text);
  while (at != std::string_view::npos && !isWord(at))
  {
    at = list.find(text, at + 1);
  }
  return at != std::string_view::npos;
}

/// Residues in which no atom is of an element with two letters, whatever its name.
bool IsBiopolymerResidue(std::string_view name)
{
  // AMBER's and CHARMM's names of terminal and protonated residues have one more letter at the
  // beginning or the end.
  constexpr std::string_view names =
    "ALA ARG ASN ASP CYS GLN GLU GLY HIS ILE LEU LYS MET PHE PRO SER THR TRP TYR VAL HID HIE HIP "
    "HSD HSE HSP CYX CYM ASH GLH LYN A C G U DA DC DG DT DU RA RC RG RU ";
  return IsInList(name, names) ||
    (name.size() == 4 && (IsInList(name.substr(1), names) || IsInList(name.substr(0, 3), names)));
}

constexpr int LastStable = 83; ///< bismuth, nearly

/// Whether a name is a symbol of two letters, where only that makes sense: "Li", "Cl2" with a small
/// letter; "IR", "PT" alone, but not "CA", "HG", "NE", "OS", "PB", "SG", whose first letters are
/// those of the atoms that most molecules consist of.
bool IsSymbolOfTwoLetters(std::string_view name, std::string_view letters)
{
  if (letters.size() != 2)
  {
    return false;
  }
  const int element = ElementFromSymbol(letters);
  if (element == 0 || element > LastStable)
  {
    return false;
  }
  const bool isProper = std::isupper(static_cast<unsigned char>(letters[0])) != 0 &&
    std::islower(static_cast<unsigned char>(letters[1])) != 0;
  return isProper ||
    (letters.size() == name.size() &&
      std::string_view("HDCNOPS").find(letters[0]) == std::string_view::npos);
}

/// Places of one or two letters in a table: a blank and the alphabet, squared.
constexpr std::size_t Letters = 27;
constexpr std::size_t LettersSquared = Letters * Letters;

/// LettersSquared if the text is not one or two letters.
std::size_t LettersIndex(std::string_view symbol)
{
  const auto placeOf = [](char c) { return static_cast<std::size_t>((c | 0x20) - 'a') + 1; };
  if (symbol.empty() || symbol.size() > 2 || !std::all_of(symbol.begin(), symbol.end(), IsLetter))
  {
    return LettersSquared;
  }
  return Letters * placeOf(symbol[0]) + (symbol.size() > 1 ? placeOf(symbol[1]) : 0);
}

std::array<std::uint8_t, LettersSquared> ElementsByLetters()
{
  std::array<std::uint8_t, LettersSquared> elements{};
  for (std::size_t element = 1; element < Symbols.size(); ++element)
  {
    elements[LettersIndex(Symbols[element])] = static_cast<std::uint8_t>(element);
  }
  elements[LettersIndex("D")] = elements[LettersIndex("T")] = 1; // isotopes of hydrogen
  return elements;
}

/// Ions whose names in CHARMM's and AMBER's force fields are not element symbols; 0 for all others.
int ElementFromCharmmIon(std::string_view name)
{
  constexpr std::pair<std::string_view, int> ions[] = { { "SOD", 11 }, { "POT", 19 }, { "CLA", 17 },
    { "CAL", 20 }, { "CES", 55 }, { "LIT", 3 }, { "RUB", 37 }, { "BAR", 56 }, { "CAD", 48 },
    { "IOD", 53 }, { "IP", 11 }, { "IM", 17 } };
  const auto found = std::find_if(
    std::begin(ions), std::end(ions), [name](const auto& ion) { return ion.first == name; });
  return found == std::end(ions) ? 0 : found->second;
}

}

const char* ElementSymbol(int element)
{
  return Symbols[element > 0 && element < NumberOfElements ? static_cast<std::size_t>(element) : 0];
}

int ElementFromSymbol(std::string_view symbol)
{
  static const std::array<std::uint8_t, LettersSquared> elements = ElementsByLetters();
  const std::size_t letters = LettersIndex(symbol);
  return letters < LettersSquared ? elements[letters] : 0;
}

int ElementFromIon(std::string_view nameOfAtom, std::string_view nameOfResidue)
{
  const std::string name = Capitals(nameOfAtom);
  const std::string residue = Capitals(nameOfResidue);
  const std::string_view residueName = residue;
  const std::string_view letters = FirstLetters(name);
  if (letters.empty())
  {
    return 0;
  }
  if (residueName == "ION" || residueName == "IONS")
  {
    const int charmm = ElementFromCharmmIon(letters);
    return charmm > 0 ? charmm : ElementFromSymbol(letters);
  }
  if (letters == residueName || ElementFromSymbol(letters) == ElementFromCharmmIon(residueName))
  {
    const int charmm = ElementFromCharmmIon(residueName);
    if (charmm > 0)
    {
      return charmm;
    }
  }
  const bool isNamedAlike = residueName.substr(0, letters.size()) == letters &&
    (residueName.size() == letters.size() || !IsLetter(residueName[letters.size()]));
  if (isNamedAlike)
  {
    return ElementFromSymbol(letters);
  }
  // Oxidation states of the PDB: 3CO, 4MO.
  const std::size_t digits =
    std::min(residueName.find_first_not_of("0123456789"), residueName.size());
  const bool isState = digits > 0 && letters.size() == 2 && residueName.substr(digits) == letters;
  const int element = isState ? ElementFromSymbol(letters) : 0;
  return element <= LastStable ? element : 0;
}

int ElementFromAtomName(std::string_view name, std::string_view residueName)
{
  const std::string_view letters = FirstLetters(name);
  if (letters.empty())
  {
    return 0;
  }
  if (const int ion = ElementFromIon(name, residueName))
  {
    return ion;
  }
  const std::string_view two = letters.substr(0, 2);
  const bool isBiopolymer = IsBiopolymerResidue(residueName);
  if (!isBiopolymer && IsSymbolOfTwoLetters(name, letters))
  {
    return ElementFromSymbol(two);
  }
  if (IsInList(two, "CL BR ZN FE MG MN SE SI ") && !isBiopolymer)
  {
    return ElementFromSymbol(two);
  }
  return ElementFromSymbol(letters.substr(0, 1));
}

bool IsWater(std::string_view residueName)
{
  return IsInList(
    residueName, "HOH DOD WAT H2O OH2 SOL TIP TIP3 TIP4 TP3 TP4 T3P T4P T3H T4H SPC SPCE ");
}

}
