#include "Molecules/CIFAtoms.h"

#include "Atoms/ChemicalElement.h"
#include "Core/LargePages.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/PeriodicMolecules.h"
#include "Molecules/ResidueOrder.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <gemmi/unitcell.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

namespace cif = gemmi::cif;

using Axes = std::array<std::string, 3>;

const Axes Cartesian{ "Cartn_x", "Cartn_y", "Cartn_z" };
const Axes Fractional{ "fract_x", "fract_y", "fract_z" };
const Axes Ideal{ "pdbx_model_Cartn_x_ideal", "pdbx_model_Cartn_y_ideal",
  "pdbx_model_Cartn_z_ideal" };
const Axes Example{ "model_Cartn_x", "model_Cartn_y", "model_Cartn_z" };
const Axes Plain{ "x", "y", "z" };

/// `?`, `.`, and other markers of programs for a missing number.
bool IsNoNumber(const std::string& value)
{
  if (!value.empty() && gemmi::is_digit(value[0]))
  {
    return false;
  }
  std::string_view word = CIFText(value);
  if (!word.empty() && (word[0] == '-' || word[0] == '+'))
  {
    word.remove_prefix(1);
  }
  if (word.empty() || gemmi::is_digit(word[0]) || word[0] == '.')
  {
    return word.empty();
  }
  const std::string small = gemmi::to_lower(std::string(word));
  return small == "nan" || small == "inf" || small == "infinity" || small == "none";
}

/// The value of a single item, in the spelling of mmCIF or core CIF; NaN: there is none.
double ReadNumber(cif::Block& block, const std::string& category, const std::string& name)
{
  for (const char* between : { ".", "_" })
  {
    std::string tag = category;
    tag.append(between).append(name);
    for (const std::string& value : block.find_values(tag))
    {
      return CIFNumber(value);
    }
  }
  return NAN;
}

gemmi::UnitCell ReadUnitCell(cif::Block& block)
{
  std::array<double, 6> values{};
  const std::array<const char*, 6> names{ "length_a", "length_b", "length_c", "angle_alpha",
    "angle_beta", "angle_gamma" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    values[i] = ReadNumber(block, "_cell", names[i]);
    if (i > 2 && std::isnan(values[i]))
    {
      values[i] = 90.0; // the default of the dictionary
    }
    if (!(values[i] > 0.0) || (i > 2 && values[i] >= 180.0))
    {
      throw std::invalid_argument(
        "the coordinates are fractional, and the cell (_cell_length_a, ...) is missing or wrong; "
        "write it into the file, or Cartesian coordinates in angstrom");
    }
  }
  gemmi::UnitCell cell;
  cell.set(values[0], values[1], values[2], values[3], values[4], values[5]);
  const gemmi::Position corner = cell.orthogonalize(gemmi::Fractional(1.0, 1.0, 1.0));
  if (!std::isfinite(corner.x + corner.y + corner.z))
  {
    throw std::invalid_argument("no cell has the angles of _cell_angle_alpha, _beta, _gamma");
  }
  return cell;
}

/// Symbols that the block itself lists in _atom_type.
std::set<std::string> ListedSymbols(cif::Block& block)
{
  std::set<std::string> symbols;
  for (const char* tag : { "_atom_type_symbol", "_atom_type.symbol" })
  {
    for (const std::string& value : block.find_values(tag))
    {
      std::string text = cif::as_string(value);
      const auto end = std::find_if_not(
        text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
      symbols.insert(gemmi::to_lower(std::string(text.begin(), end)));
    }
  }
  return symbols;
}

/// Whether two capitals at the beginning of a label are a symbol ("CL2", "CU1", "ZN1") rather than
/// a symbol of one letter and a locant ("CA1", "NB2", "CO1").
bool IsSymbolInCapitals(const std::string& two)
{
  constexpr int heaviest = 92; // CF3 and CM are carbons more often than californium and curium
  const int element = ElementFromSymbol(two);
  const bool isLocant = std::string_view("CHNOPS").find(two[0]) != std::string_view::npos &&
    std::string_view("ABDEGHOZ").find(two[1]) != std::string_view::npos;
  return element > 0 && element <= heaviest && (!isLocant || two == "SE" || two == "PD");
}

/// Labels of core CIF begin with the symbol: "Cl1", "C12A", "CL1". "CA1" is carbon unless Ca is
/// listed.
std::string SymbolFromLabel(const std::string& label, const std::set<std::string>& listed)
{
  std::string letters;
  for (const char c : label)
  {
    if (std::isalpha(static_cast<unsigned char>(c)) == 0)
    {
      break;
    }
    letters += c;
  }
  if (letters.size() > 1)
  {
    std::string two = letters.substr(0, 2);
    const bool isProper = std::islower(static_cast<unsigned char>(two[1])) != 0;
    if (ElementFromSymbol(two) > 0 &&
      (isProper || IsSymbolInCapitals(two) || listed.count(gemmi::to_lower(two)) > 0))
    {
      return two;
    }
  }
  const std::string one = letters.substr(0, 1);
  return ElementFromSymbol(one) > 0 ? one : "X";
}

/// "Cu2+" is copper with charge 2; "O2-" oxygen with -2. Charge 0: not given.
std::pair<std::string, int> SymbolAndCharge(const std::string& text)
{
  std::size_t letters = 0;
  while (letters < text.size() && std::isalpha(static_cast<unsigned char>(text[letters])) != 0)
  {
    ++letters;
  }
  int charge = 0;
  const std::string rest = text.substr(letters);
  if (!rest.empty() && rest.size() <= 2)
  {
    const bool signFirst = rest[0] == '+' || rest[0] == '-';
    const char sign = signFirst ? rest[0] : rest.back();
    const char digit = rest.size() == 1 ? '1' : signFirst ? rest[1] : rest[0];
    if ((sign == '+' || sign == '-') && digit >= '0' && digit <= '9')
    {
      charge = (sign == '-' ? -1 : 1) * (digit - '0');
    }
  }
  return { text.substr(0, letters), charge };
}

/// The columns of a table of atoms. Of two with the same contents, the authors' comes first.
struct Column
{
  enum : int
  {
    X,
    Y,
    Z,
    AuthorName,
    Name,
    AuthorResidue,
    Residue,
    AuthorChain,
    Chain,
    AuthorSequence,
    Sequence,
    InsertionCode,
    AltLoc,
    Symbol,
    Id,
    Occupancy,
    BFactor,
    UIso,
    Charge,
    Group,
    Model
  };
};

/// A kind of table, its coordinates in the order in which they are preferred, and its tags after
/// them.
struct TableKind
{
  const char* Prefix;
  CIFAtoms::Source From;
  std::vector<Axes> Coordinates;
  std::vector<std::string> Tags;
};

std::vector<TableKind> TableKinds(cif::Block& block)
{
  const auto tags = [](
                      const char* name, const char* residue, const char* altLoc, const char* charge)
  {
    return std::vector<std::string>{ "?auth_atom_id", name, "?auth_comp_id", residue,
      "?auth_asym_id", "?label_asym_id", "?auth_seq_id", "?label_seq_id", "?pdbx_PDB_ins_code",
      altLoc, "?type_symbol", "?id", "?occupancy", "?B_iso_or_equiv", "?U_iso_or_equiv", charge,
      "?group_PDB", "?pdbx_PDB_model_num" };
  };
  const auto usual =
    tags("?label_atom_id", "?label_comp_id", "?label_alt_id", "?pdbx_formal_charge");
  const auto core = tags("label", "?label_comp_id", "?disorder_group", "?pdbx_formal_charge");
  const auto component = tags("?atom_id", "?comp_id", "?label_alt_id", "?charge");
  using Source = CIFAtoms::Source;
  const std::vector<Axes> places{ Cartesian, Fractional };
  std::vector<TableKind> kinds{ { "_atom_site.", Source::MMCIF, places, usual },
    { "_atom_site_", Source::CoreCIF, places, core },
    { "_chem_comp_atom.", Source::ChemicalComponent, { Ideal, Example, Plain }, component } };
  // DDLm spells core CIF with the full stop of mmCIF.
  if (block.has_tag("_atom_site.label") && !block.has_tag("_atom_site.label_atom_id"))
  {
    kinds[0] = { "_atom_site.", Source::CoreCIF, places, core };
  }
  return kinds;
}

/// The table with the coordinates that fewest rows lack. A component may have none.
std::optional<cif::Table> FindTable(cif::Block& block, const TableKind& kind, Axes& axes)
{
  std::optional<cif::Table> best;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const Axes& one : kind.Coordinates)
  {
    std::vector<std::string> tags(one.begin(), one.end());
    tags.insert(tags.end(), kind.Tags.begin(), kind.Tags.end());
    cif::Table table = block.find(kind.Prefix, tags);
    std::size_t missing = 0;
    for (cif::Table::Row row : table)
    {
      missing +=
        IsNoNumber(row[Column::X]) || IsNoNumber(row[Column::Y]) || IsNoNumber(row[Column::Z]) ? 1
                                                                                               : 0;
    }
    const bool isNone =
      kind.From == CIFAtoms::Source::ChemicalComponent && missing == table.length();
    if (table.ok() && missing < fewest && !isNone)
    {
      best.emplace(table);
      axes = one;
      fewest = missing;
    }
  }
  return best;
}

/// Whole numbers that are none, by column.
struct OddNumbers
{
  std::atomic<std::size_t> Sequence{ 0 }, Charge{ 0 };
};

/// Reads the rows of a table, each independently.
class RowReader
{
public:
  RowReader(cif::Block& block, cif::Table& table, bool isCore)
    : Table(table)
    , IsCore(isCore)
  {
    if (isCore)
    {
      this->Listed = ListedSymbols(block);
    }
    if (!table.has_column(Column::AuthorName) && !table.has_column(Column::Name))
    {
      throw std::invalid_argument("no column of _atom_site has the names of the atoms "
                                  "(label_atom_id or auth_atom_id); add it");
    }
  }

  /// False: the row has no coordinates.
  bool Read(std::size_t number, Atom& atom, bool& isDummy)
  {
    cif::Table::Row row = this->Table[static_cast<int>(number)];
    atom.Name = Preferred(row, Column::AuthorName, Column::Name);
    atom.ResidueName = Preferred(row, Column::AuthorResidue, Column::Residue);
    atom.Chain = Preferred(row, Column::AuthorChain, Column::Chain);
    atom.InsertionCode = Letter(row, Column::InsertionCode);
    atom.AltLoc = Letter(row, Column::AltLoc);
    atom.Occupancy = Number(row, Column::Occupancy);
    atom.BFactor = row.has(Column::BFactor) || !this->IsCore
      ? Number(row, Column::BFactor)
      : Number(row, Column::UIso) * gemmi::u_to_b();
    const std::string_view group = Text(row, Column::Group);
    atom.IsHetero = !group.empty() && (group[0] & ~0x20) == 'H';
    atom.Serial = static_cast<int>(number) + 1;
    this->ReadNumbers(row, atom);
    this->ReadElement(row, atom, isDummy);
    for (const int axis : { Column::X, Column::Y, Column::Z })
    {
      double& place = atom.Position[static_cast<std::size_t>(axis)];
      place = CIFNumber(row[axis]);
      if (!std::isfinite(place) && IsNoNumber(row[axis]))
      {
        return false;
      }
    }
    return true;
  }

  std::string_view ModelName(std::size_t number)
  {
    cif::Table::Row row = this->Table[static_cast<int>(number)];
    const std::string_view name = Text(row, Column::Model);
    return name.empty() ? "1" : name;
  }

  std::array<std::string_view, 2> Labels(std::size_t number)
  {
    cif::Table::Row row = this->Table[static_cast<int>(number)];
    return { Preferred(row, Column::Chain, Column::AuthorChain), Text(row, Column::Sequence) };
  }

  /// Notes of what is missing or cannot be read in all rows.
  void ReportTo(ReadingReport& report) const
  {
    const auto has = [this](int column) { return this->Table.has_column(column); };
    std::string missing = has(Column::Occupancy) ? "" : "occupancy";
    if (!has(Column::BFactor) && !(this->IsCore && has(Column::UIso)))
    {
      missing += std::string(missing.empty() ? "" : " and ") + "B_iso_or_equiv";
    }
    if (!missing.empty())
    {
      report.Note("The file has no " + missing + ": unknown (NaN) for all atoms.");
    }
    const auto note = [&report](std::size_t count, const std::string& column)
    {
      if (count > 0)
      {
        report.Note(std::to_string(count) + (count == 1 ? " value" : " values") + " of " + column +
          " that " + (count == 1 ? "is" : "are") + " not an integer: taken as unknown.");
      }
    };
    note(this->Odd.Sequence, has(Column::AuthorSequence) ? "auth_seq_id" : "label_seq_id");
    note(this->Odd.Charge, "pdbx_formal_charge");
    if (this->IsCore && !has(Column::Symbol))
    {
      report.Note("The file has no elements (type_symbol); they were inferred from the labels.");
    }
  }

private:
  /// Empty where there is no such column, or no value.
  static std::string_view Text(cif::Table::Row& row, int column)
  {
    return row.has(static_cast<std::size_t>(column)) ? CIFText(row[column]) : std::string_view();
  }

  static double Number(cif::Table::Row& row, int column)
  {
    return row.has(static_cast<std::size_t>(column)) ? CIFNumber(row[column]) : Atom::Unknown;
  }

  static std::string_view Preferred(cif::Table::Row& row, int first, int second)
  {
    const std::string_view text = Text(row, first);
    return text.empty() ? Text(row, second) : text;
  }

  static char Letter(cif::Table::Row& row, int column)
  {
    const std::string_view text = Text(row, column);
    return text.empty() ? ' ' : text[0];
  }

  /// The text of a whole number. @throws std::invalid_argument if it has more than nine digits.
  static std::string_view Digits(cif::Table::Row& row, int column, const char* name)
  {
    constexpr std::size_t most = 9;
    const std::string_view text = Text(row, column);
    const auto digits =
      text.size() > most ? std::count_if(text.begin(), text.end(), gemmi::is_digit) : 0;
    if (digits > static_cast<std::ptrdiff_t>(most))
    {
      throw std::invalid_argument(std::string("_atom_site.") + name +
        " has a number of more than " + std::to_string(most) + " digits");
    }
    return text;
  }

  void ReadNumbers(cif::Table::Row& row, Atom& atom)
  {
    if (row.has(Column::Id) && !IsNumber(Digits(row, Column::Id, "id"), atom.Serial))
    {
      atom.Serial = 0;
    }
    const std::string_view label = Digits(row, Column::Sequence, "label_seq_id");
    const std::string_view number =
      row.has(Column::AuthorSequence) ? Digits(row, Column::AuthorSequence, "auth_seq_id") : label;
    if (!number.empty() && !IsNumber(number, atom.ResidueId))
    {
      // An insertion code beside the number; of two, the one with a column of its own is used.
      if (number.back() >= 'A' && IsNumber(number.substr(0, number.size() - 1), atom.ResidueId))
      {
        atom.InsertionCode = atom.InsertionCode == ' ' ? number.back() : atom.InsertionCode;
      }
      else
      {
        atom.ResidueId = 0;
        ++this->Odd.Sequence;
      }
    }
    const std::string_view charge = Digits(row, Column::Charge, "pdbx_formal_charge");
    if (!charge.empty())
    {
      const double value = ChargeIn(charge);
      atom.Charge = value == 0.0 ? Atom::Unknown : value;
      this->Odd.Charge += std::isnan(value) ? 1 : 0;
    }
  }

  /// "2", "-1", "1.0", and of some programs "2+" and "1-"; NaN: no whole number.
  static double ChargeIn(std::string_view text)
  {
    constexpr double largest = 100.0;
    double value = 0.0;
    const char last = text.back();
    const bool hasSign = last == '+' || last == '-';
    if (!IsNumber(hasSign ? text.substr(0, text.size() - 1) : text, value) ||
      value != std::round(value) || std::abs(value) >= largest)
    {
      return Atom::Unknown;
    }
    return last == '-' ? -value : value;
  }

  void ReadElement(cif::Table::Row& row, Atom& atom, bool& isDummy)
  {
    const std::string_view symbol = Text(row, Column::Symbol);
    if (!this->IsCore)
    {
      atom.Element = ElementFromSymbol(symbol);
      isDummy = atom.Element == 0 && !symbol.empty() && IsDummyName(symbol);
      return;
    }
    const auto [letters, charge] = SymbolAndCharge(std::string(symbol));
    atom.Element =
      ElementFromSymbol(letters.empty() ? SymbolFromLabel(atom.Name, this->Listed) : letters);
    if (charge != 0 && !row.has(Column::Charge))
    {
      atom.Charge = charge;
    }
    // Groups below 0 are disordered about a symmetry element, which is not applied.
    const std::string_view alternate = Text(row, Column::AltLoc);
    const bool isGroup = alternate.size() == 1 && alternate[0] > '0' && alternate[0] <= '9';
    atom.AltLoc = isGroup ? alternate[0] : ' ';
  }

  cif::Table& Table;
  bool IsCore;
  std::set<std::string> Listed;
  OddNumbers Odd;
};

/// Replaces fractional by Cartesian coordinates.
void Orthogonalize(cif::Block& block, CIFAtoms& atoms)
{
  const gemmi::UnitCell cell = ReadUnitCell(block);
  for (Atom& atom : atoms.Atoms)
  {
    const gemmi::Position place =
      cell.orthogonalize(gemmi::Fractional(atom.Position[0], atom.Position[1], atom.Position[2]));
    atom.Position = { place.x, place.y, place.z };
  }
}

/// Removes the rows without coordinates; `kept` gets the others.
void DropRows(const std::vector<char>& isDropped, std::vector<std::size_t>& kept, CIFAtoms& atoms)
{
  constexpr std::size_t mostNamed = 5;
  const std::size_t all = atoms.Atoms.size();
  std::string names;
  for (std::size_t row = 0; row < all; ++row)
  {
    if (isDropped[row] == 0)
    {
      kept.push_back(row);
      continue;
    }
    const std::size_t count = row + 1 - kept.size();
    names += count <= mostNamed ? (count > 1 ? ", " : "") + Describe(atoms.Atoms[row]) : "";
    names += count == mostNamed + 1 ? ", ..." : "";
  }
  if (kept.empty())
  {
    throw std::invalid_argument("none of its " + std::to_string(all) +
      " atoms has coordinates (they are ?, . or NaN); build or fetch a model that has them");
  }
  Reorder(atoms.Atoms, kept);
  atoms.Report.Warn(std::to_string(all - kept.size()) + " of " + std::to_string(all) +
    " atoms have no coordinates in the file (?, . or NaN) and were dropped: " + names + ".");
}
/// The rows of a table, without those that have no coordinates. O(values).
void ReadRows(cif::Block& block, cif::Table& table, bool withLabels, CIFAtoms& atoms)
{
  RowReader reader(block, table, atoms.From == CIFAtoms::Source::CoreCIF);
  const std::size_t rows = table.length();
  atoms.Atoms.reserve(rows);
  AdviseLargePages(atoms.Atoms.data(), rows * sizeof(Atom));
  atoms.Atoms.resize(rows);
  std::vector<char> isDropped(rows, 0);
  std::vector<char> isDummy(rows, 0);
  std::atomic<bool> anyDropped{ false }, anyDummy{ false }, anyElement{ false };
  constexpr std::int64_t rowsAtOnce = 1 << 12;
  ParallelFor(0, static_cast<std::int64_t>(rows), rowsAtOnce,
    [&](std::int64_t first, std::int64_t last)
    {
      bool dropped = false, dummy = false, element = false;
      for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(last); ++row)
      {
        bool isOne = false;
        isDropped[row] = reader.Read(row, atoms.Atoms[row], isOne) ? 0 : 1;
        isDummy[row] = isOne ? 1 : 0;
        dropped = dropped || isDropped[row] != 0;
        dummy = dummy || isOne;
        element = element || atoms.Atoms[row].Element > 0;
      }
      anyDropped = anyDropped || dropped;
      anyDummy = anyDummy || dummy;
      anyElement = anyElement || element;
    });
  std::vector<std::size_t> kept; // all if empty
  if (anyDropped)
  {
    DropRows(isDropped, kept, atoms);
  }
  const auto rowOf = [&kept](std::size_t atom) { return kept.empty() ? atom : kept[atom]; };
  const std::size_t count = atoms.Atoms.size();
  if (anyDummy && anyElement) // else symbols mean nothing
  {
    atoms.IsDummy.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      atoms.IsDummy[i] = isDummy[rowOf(i)] != 0;
    }
  }
  for (std::size_t i = 0; withLabels && i < count; ++i)
  {
    atoms.Labels.push_back(reader.Labels(rowOf(i)));
  }
  atoms.NumberOfModels = 1;
  std::map<std::string_view, int> models; // in the order in which they come
  std::string_view last;
  int model = -1;
  for (std::size_t i = 0; table.has_column(Column::Model) && i < count; ++i)
  {
    const std::string_view name = reader.ModelName(rowOf(i));
    if (model < 0 || name != last)
    {
      model = models.emplace(name, static_cast<int>(models.size())).first->second;
      last = name;
    }
    if (model > 0 && atoms.Model.empty())
    {
      atoms.Model.resize(count, 0);
    }
    if (!atoms.Model.empty())
    {
      atoms.Model[i] = model;
    }
  }
  atoms.NumberOfModels = std::max(static_cast<int>(models.size()), 1);
  reader.ReportTo(atoms.Report);
}

}

std::string_view CIFText(const std::string& value)
{
  std::string_view text = value;
  if (cif::is_null(value) || value.empty())
  {
    return {};
  }
  if (value.size() > 1 && (value[0] == '"' || value[0] == '\''))
  {
    return text.substr(1, text.size() - 2);
  }
  if (value.size() > 2 && value[0] == ';' && value[value.size() - 2] == '\n')
  {
    text = text.substr(1, text.size() - 3);
    return text.substr(0, text.size() - (!text.empty() && text.back() == '\r' ? 1 : 0));
  }
  return text;
}

double CIFNumber(const std::string& value)
{
  const std::string_view text = CIFText(value);
  double number = 0.0;
  return IsNumber(text.substr(0, text.find('(')), number) ? number : Atom::Unknown;
}

CIFAtoms ReadCIFAtoms(cif::Block& block, bool withLabels)
{
  CIFAtoms atoms;
  for (const TableKind& kind : TableKinds(block))
  {
    Axes axes{};
    std::optional<cif::Table> table = FindTable(block, kind, axes);
    if (!table)
    {
      continue;
    }
    atoms.From = kind.From;
    ReadRows(block, *table, withLabels, atoms);
    if (kind.From == CIFAtoms::Source::CoreCIF)
    {
      atoms.Report.Note("Crystal structure with fractional coordinates or labels of core CIF: "
                        "the atoms are those of the asymmetric unit, symmetry is not applied.");
    }
    if (kind.From == CIFAtoms::Source::ChemicalComponent)
    {
      const std::string which = axes == Ideal ? "ideal"
        : axes == Example                     ? "example's"
                                              : "library's";
      atoms.Report.Note("Chemical component: the " + which + " coordinates were read.");
      for (auto row : block.find("_chem_comp_bond.", { "atom_id_1", "atom_id_2", "?comp_id" }))
      {
        atoms.Bonded.push_back({ row.has(2) ? row.str(2) : "", row.str(0), row.str(1) });
      }
    }
    if (axes == Fractional)
    {
      Orthogonalize(block, atoms);
    }
    break;
  }
  return atoms;
}

std::vector<std::array<double, 3>> ReadCIFCell(cif::Block& block)
{
  const auto number = [&block](const char* name) { return ReadNumber(block, "_cell", name); };
  const auto angle = [&number](const char* name)
  {
    const double value = number(name);
    return std::isnan(value) ? 90.0 : value; // the default of the dictionary
  };
  const std::array<double, 3> lengths{ number("length_a"), number("length_b"), number("length_c") };
  return std::isnan(lengths[0] + lengths[1] + lengths[2])
    ? std::vector<std::array<double, 3>>()
    : CellVectors(lengths, { angle("angle_alpha"), angle("angle_beta"), angle("angle_gamma") });
}

std::string ReadCIFSpaceGroup(cif::Block& block)
{
  for (const char* tag : { "_symmetry.space_group_name_H-M", "_space_group.name_H-M_alt",
         "_symmetry_space_group_name_H-M", "_space_group_name_H-M_alt" })
  {
    for (const std::string& value : block.find_values(tag))
    {
      if (!cif::is_null(value))
      {
        return cif::as_string(value);
      }
    }
  }
  return {};
}

}
