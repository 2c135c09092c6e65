#include "Molecules/CIFAtomTable.h"

#include "Atoms/ChemicalElement.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/GemmiAtom.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include <gemmi/numb.hpp>
#include <gemmi/unitcell.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

namespace cif = gemmi::cif;

using Axes = std::array<const char*, 3>;

constexpr Axes Cartesian{ "Cartn_x", "Cartn_y", "Cartn_z" };
constexpr Axes UnknownCartesian{ "unknown_x", "unknown_y", "unknown_z" };
constexpr Axes Fractional{ "fract_x", "fract_y", "fract_z" };
constexpr Axes Ideal{ "pdbx_model_Cartn_x_ideal", "pdbx_model_Cartn_y_ideal",
  "pdbx_model_Cartn_z_ideal" };
constexpr Axes Example{ "model_Cartn_x", "model_Cartn_y", "model_Cartn_z" };
constexpr Axes Plain{ "x", "y", "z" };

/// `?`, `.`, and other markers of programs for a missing number.
bool IsNoNumber(const std::string& value)
{
  if (cif::is_null(value))
  {
    return true;
  }
  const std::string text = gemmi::to_lower(cif::as_string(value));
  const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::string word = text.substr(sign);
  return word.empty() || word == "nan" || word == "inf" || word == "infinity" || word == "none";
}

/// Cheaper than IsNoNumber: false for all that begins as a number.
bool IsMissingNumber(const std::string& value)
{
  const char first = value.empty() ? '?' : value[0];
  const char second = value.size() > 1 ? value[1] : '?';
  const auto isStart = [](char c) { return (c >= '0' && c <= '9'); };
  return !isStart(first) &&
    !((first == '-' || first == '+' || first == '.') && (isStart(second) || second == '.'));
}

/// The loop `_atom_site` of a block, whose columns are found without their category.
class AtomTable
{
public:
  explicit AtomTable(cif::Loop& loop)
    : Loop(loop)
  {
  }

  std::size_t Width() const { return this->Loop.tags.size(); }
  std::size_t Rows() const { return this->Loop.values.size() / this->Width(); }

  /// -1: there is none.
  int Find(const std::string& name) const { return this->Loop.find_tag("_atom_site." + name); }

  bool Has(const Axes& axes) const
  {
    return std::all_of(
      axes.begin(), axes.end(), [this](const char* name) { return this->Find(name) >= 0; });
  }

  std::string& At(std::size_t row, int column)
  {
    return this->Loop.values[row * this->Width() + static_cast<std::size_t>(column)];
  }

  /// Empty where there is no such column, or no value.
  std::string Text(std::size_t row, int column)
  {
    return column < 0 ? std::string() : cif::as_string(this->At(row, column));
  }

  void Rename(const char* from, const char* to)
  {
    const int column = this->Find(from);
    if (column >= 0 && this->Find(to) < 0)
    {
      this->Loop.tags[static_cast<std::size_t>(column)] = std::string("_atom_site.") + to;
    }
  }

  /// Columns that AddColumns appends to the table.
  void Plan(const std::string& name, std::function<std::string(std::size_t)> value)
  {
    this->Planned.emplace_back(name, std::move(value));
  }

  void AddColumns()
  {
    if (this->Planned.empty())
    {
      return;
    }
    const std::size_t rows = this->Rows();
    const std::size_t width = this->Width();
    std::vector<std::string> values;
    values.reserve(rows * (width + this->Planned.size()));
    for (std::size_t row = 0; row < rows; ++row)
    {
      const std::size_t before = values.size();
      for (const auto& [name, value] : this->Planned)
      {
        values.push_back(value(row)); // computed from the old values before they are moved
      }
      const auto first = this->Loop.values.begin() + static_cast<std::ptrdiff_t>(row * width);
      values.insert(values.begin() + static_cast<std::ptrdiff_t>(before),
        std::make_move_iterator(first),
        std::make_move_iterator(first + static_cast<std::ptrdiff_t>(width)));
    }
    for (const auto& planned : this->Planned)
    {
      this->Loop.tags.push_back("_atom_site." + planned.first);
    }
    this->Loop.values = std::move(values);
    this->Planned.clear();
  }

  /// Removes the rows for which `drops` holds. Returns how many.
  std::size_t DropRows(const std::vector<bool>& drops)
  {
    const std::size_t width = this->Width();
    std::size_t kept = 0;
    for (std::size_t row = 0; row < drops.size(); ++row)
    {
      if (!drops[row])
      {
        for (std::size_t i = 0; kept != row && i < width; ++i)
        {
          this->Loop.values[kept * width + i] = std::move(this->Loop.values[row * width + i]);
        }
        ++kept;
      }
    }
    this->Loop.values.resize(kept * width);
    return drops.size() - kept;
  }

  /// Calls `work(row)` for each row, several at once; it may change values of its row.
  template <typename Work>
  void ForEachRow(Work&& work)
  {
    constexpr std::int64_t rowsAtOnce = 1 << 12;
    ParallelFor(0, static_cast<std::int64_t>(this->Rows()), rowsAtOnce,
      [&work](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t row = first; row < last; ++row)
        {
          work(static_cast<std::size_t>(row));
        }
      });
  }

private:
  cif::Loop& Loop;
  std::vector<std::pair<std::string, std::function<std::string(std::size_t)>>> Planned;
};

bool IsIn(const std::string& tag, const std::string& prefix)
{
  return gemmi::starts_with(gemmi::to_lower(tag), prefix);
}

/// Is `tag` a column of the table of atoms that begins with `prefix`?
bool IsOfTable(const std::string& tag, const std::string& prefix)
{
  return IsIn(tag, prefix) && !IsIn(tag, "_atom_site_aniso");
}

/// The table whose tags begin with `prefix`: a loop, or the single values of one atom made a loop.
cif::Loop* FindTable(cif::Block& block, const std::string& prefix)
{
  cif::Item* largest = nullptr;
  for (cif::Item& item : block.items)
  {
    if (item.type == cif::ItemType::Loop && !item.loop.tags.empty() &&
      IsOfTable(item.loop.tags[0], prefix) &&
      (!largest || item.loop.tags.size() > largest->loop.tags.size()))
    {
      largest = &item;
    }
  }
  if (largest)
  {
    return &largest->loop;
  }
  cif::Item made{ cif::LoopArg{} };
  for (cif::Item& item : block.items)
  {
    if (item.type == cif::ItemType::Pair && IsOfTable(item.pair[0], prefix))
    {
      made.loop.tags.push_back(item.pair[0]);
      made.loop.values.push_back(item.pair[1]);
    }
  }
  if (made.loop.tags.empty())
  {
    return nullptr;
  }
  block.items.erase(std::remove_if(block.items.begin(), block.items.end(),
                      [&prefix](const cif::Item& item) {
                        return item.type == cif::ItemType::Pair && IsOfTable(item.pair[0], prefix);
                      }),
    block.items.end());
  block.items.push_back(std::move(made));
  return &block.items.back().loop;
}

/// Gives the tags of a table the category `_atom_site.`.
void RenameCategory(cif::Loop& loop, const std::string& prefix)
{
  for (std::string& tag : loop.tags)
  {
    if (IsIn(tag, prefix))
    {
      tag = "_atom_site." + tag.substr(prefix.size());
    }
  }
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
      return cif::as_number(value);
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

std::string FormatValue(double value)
{
  return FormatNumber(value, 17);
}

std::size_t CountMissing(AtomTable& table, const Axes& axes)
{
  std::size_t missing = 0;
  for (std::size_t row = 0; row < table.Rows(); ++row)
  {
    missing += std::any_of(axes.begin(), axes.end(),
                 [&](const char* axis) { return IsNoNumber(table.At(row, table.Find(axis))); })
      ? 1
      : 0;
  }
  return missing;
}

/// Whether the columns of such coordinates exist and any row has values.
bool HasAny(AtomTable& table, const Axes& axes)
{
  return table.Has(axes) && CountMissing(table, axes) < table.Rows();
}

/// Replaces fractional by Cartesian coordinates.
void Orthogonalize(cif::Block& block, AtomTable& table)
{
  const gemmi::UnitCell cell = ReadUnitCell(block);
  std::array<int, 3> columns{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    columns[i] = table.Find(Fractional[i]);
    table.Rename(Cartesian[i], UnknownCartesian[i]); // they are unknown in all rows
  }
  for (std::size_t row = 0; row < table.Rows(); ++row)
  {
    gemmi::Fractional place;
    double* const xyz[3] = { &place.x, &place.y, &place.z };
    for (std::size_t i = 0; i < 3; ++i)
    {
      *xyz[i] = cif::as_number(table.At(row, columns[i]));
    }
    const gemmi::Position position = cell.orthogonalize(place);
    if (std::isfinite(position.x + position.y + position.z))
    {
      table.At(row, columns[0]) = FormatValue(position.x);
      table.At(row, columns[1]) = FormatValue(position.y);
      table.At(row, columns[2]) = FormatValue(position.z);
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    table.Rename(Fractional[i], Cartesian[i]);
  }
}

/// "O1" from the columns of a row, for messages.
std::string DescribeRow(AtomTable& table, std::size_t row)
{
  const auto text = [&](const char* label, const char* auth)
  {
    const std::string first = table.Text(row, table.Find(auth));
    return first.empty() ? table.Text(row, table.Find(label)) : first;
  };
  std::string described = text("label_atom_id", "auth_atom_id");
  const std::string residue = text("label_comp_id", "auth_comp_id");
  if (!residue.empty())
  {
    described += " of " + residue + " " + text("label_seq_id", "auth_seq_id") + " " +
      text("label_asym_id", "auth_asym_id");
  }
  return described;
}

void DropRowsWithoutCoordinates(AtomTable& table, CIFAtoms& atoms)
{
  const std::size_t rows = table.Rows();
  const std::array<int, 3> columns{ table.Find(Cartesian[0]), table.Find(Cartesian[1]),
    table.Find(Cartesian[2]) };
  const auto isDropped = [&table, &columns](std::size_t row)
  {
    return std::any_of(columns.begin(), columns.end(),
      [&](int column)
      {
        const std::string& value = table.At(row, column);
        return IsMissingNumber(value) && IsNoNumber(value);
      });
  };
  std::atomic<bool> any{ false };
  table.ForEachRow(
    [&](std::size_t row)
    {
      if (isDropped(row))
      {
        any = true;
      }
    });
  std::vector<bool> drops(any ? rows : 0, false);
  std::string names;
  std::size_t count = 0;
  for (std::size_t row = 0; row < drops.size(); ++row)
  {
    drops[row] = isDropped(row);
    if (drops[row])
    {
      constexpr std::size_t mostNamed = 5;
      names += ++count <= mostNamed ? (count > 1 ? ", " : "") + DescribeRow(table, row) : "";
      names += count == mostNamed + 1 ? ", ..." : "";
    }
  }
  if (count == 0)
  {
    return;
  }
  if (count == rows)
  {
    throw std::invalid_argument("none of its " + std::to_string(rows) +
      " atoms has coordinates (they are ?, . or NaN); build or fetch a model that has them");
  }
  table.DropRows(drops);
  atoms.Report.Warn(std::to_string(count) + " of " + std::to_string(rows) +
    " atoms have no coordinates in the file (?, . or NaN) and were dropped: " + names + ".");
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

/// The columns of core CIF as mmCIF has them.
void TranslateCoreCIF(cif::Block& block, AtomTable& table, CIFAtoms& atoms)
{
  table.Rename("label", "label_atom_id");
  table.Rename("disorder_group", "label_alt_id");
  const std::set<std::string> listed = ListedSymbols(block);
  const int symbol = table.Find("type_symbol");
  const int label = table.Find("label_atom_id");
  const int group = table.Find("label_alt_id");
  const int uIso = table.Find("U_iso_or_equiv");
  std::vector<int> charges(table.Rows(), 0);
  for (std::size_t row = 0; row < table.Rows(); ++row)
  {
    if (symbol >= 0)
    {
      const auto [letters, charge] = SymbolAndCharge(table.Text(row, symbol));
      table.At(row, symbol) =
        letters.empty() ? SymbolFromLabel(table.Text(row, label), listed) : letters;
      charges[row] = charge;
    }
    if (group >= 0)
    {
      // Groups below 0 are disordered about a symmetry element, which is not applied.
      std::string& value = table.At(row, group);
      value = value.size() == 1 && value[0] > '0' && value[0] <= '9' ? value : ".";
    }
    if (uIso >= 0)
    {
      std::string& value = table.At(row, uIso);
      const double u = cif::as_number(value);
      value = std::isnan(u) ? "?" : FormatValue(u * gemmi::u_to_b());
    }
  }
  if (symbol < 0 && label >= 0)
  {
    table.Plan("type_symbol",
      [&table, label, listed](std::size_t row)
      { return SymbolFromLabel(table.Text(row, label), listed); });
    atoms.Report.Note(
      "The file has no elements (type_symbol); they were inferred from the labels.");
  }
  if (table.Find("pdbx_formal_charge") < 0 &&
    std::any_of(charges.begin(), charges.end(), [](int charge) { return charge != 0; }))
  {
    table.Plan(
      "pdbx_formal_charge", [charges](std::size_t row) { return std::to_string(charges[row]); });
  }
  table.AddColumns();
  if (table.Find("B_iso_or_equiv") < 0)
  {
    table.Rename("U_iso_or_equiv", "B_iso_or_equiv");
  }
  atoms.Report.Note("Crystal structure with fractional coordinates or labels of core CIF: "
                    "the atoms are those of the asymmetric unit, symmetry is not applied.");
}

/// The columns of a chemical component as mmCIF has them. False: it has no coordinates.
bool TranslateComponent(cif::Block& block, AtomTable& table, CIFAtoms& atoms)
{
  const std::array<std::pair<Axes, const char*>, 3> sets{ { { Ideal, "ideal" },
    { Example, "example's" }, { Plain, "library's" } } };
  const std::pair<Axes, const char*>* best = nullptr;
  std::size_t fewest = table.Rows();
  for (const auto& set : sets)
  {
    const std::size_t missing = table.Has(set.first) ? CountMissing(table, set.first) : fewest;
    if (missing < fewest)
    {
      best = &set;
      fewest = missing;
    }
  }
  if (!best)
  {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    table.Rename(best->first[i], Cartesian[i]);
  }
  table.Rename("atom_id", "label_atom_id");
  table.Rename("comp_id", "label_comp_id");
  const int charge = table.Find("charge");
  for (std::size_t row = 0; charge >= 0 && row < table.Rows(); ++row)
  {
    const double value = cif::as_number(table.At(row, charge), 0.0);
    table.At(row, charge) =
      std::abs(value) < 100.0 ? std::to_string(static_cast<int>(std::lround(value))) : "?";
  }
  table.Rename("charge", "pdbx_formal_charge");
  for (auto row : block.find("_chem_comp_bond.", { "atom_id_1", "atom_id_2", "?comp_id" }))
  {
    atoms.Bonded.push_back({ row.has(2) ? row.str(2) : "", row.str(0), row.str(1) });
  }
  atoms.Report.Note(
    std::string("Chemical component: the ") + best->second + " coordinates were read.");
  return true;
}

/// Fills unknown values of `to` with those of `from`. Both are columns of the table, or -1.
void FillUnknown(AtomTable& table, int to, int from)
{
  if (to < 0 || from < 0)
  {
    return;
  }
  table.ForEachRow(
    [&](std::size_t row)
    {
      if (cif::is_null(table.At(row, to)))
      {
        table.At(row, to) = table.At(row, from);
      }
    });
}

/**
 * Gives atoms without element the symbol X: SetElements decides by names. Those to which the file
 * gives symbols that mean none (X) are kept as such in `atoms`, unless it gives no element to any.
 */
void CompleteElements(AtomTable& table, CIFAtoms& atoms)
{
  const int column = table.Find("type_symbol");
  if (column < 0)
  {
    table.Plan("type_symbol", [](std::size_t) { return std::string("X"); });
    return;
  }
  const int id = table.Find("id");
  std::atomic<bool> hasElements{ false };
  std::mutex mutex;
  table.ForEachRow(
    [&](std::size_t row)
    {
      std::string& symbol = table.At(row, column);
      if (cif::is_null(symbol))
      {
        symbol = "X";
      }
      else if (ElementFromSymbol(symbol) > 0 || ElementFromSymbol(cif::as_string(symbol)) > 0)
      {
        if (!hasElements)
        {
          hasElements = true;
        }
      }
      else if (IsDummyName(cif::as_string(symbol)))
      {
        int number = static_cast<int>(row) + 1; // as assigned if the file has no ids
        if (id < 0 || IsNumber(std::string_view(table.At(row, id)), number))
        {
          const std::lock_guard<std::mutex> lock(mutex);
          atoms.Dummies.insert(number);
        }
      }
    });
  if (!hasElements)
  {
    atoms.Dummies.clear();
  }
}

/// Plans a column that the file lacks: the values of `like`, or `unknown` where that is missing,
/// too.
void PlanCopy(AtomTable& table, const char* name, const char* like, const char* unknown)
{
  const int own = table.Find(name);
  const int other = table.Find(like);
  if (own < 0)
  {
    table.Plan(name,
      [&table, other, unknown](std::size_t row)
      { return other < 0 ? std::string(unknown) : table.At(row, other); });
  }
  FillUnknown(table, own, other);
}

/// A sign, digits and, where `suffix` allows it, one letter.
bool IsWholeNumber(const std::string& value, bool suffix)
{
  std::size_t at = !value.empty() && (value[0] == '-' || value[0] == '+') ? 1 : 0;
  const std::size_t first = at;
  while (at < value.size() && gemmi::is_digit(value[at]))
  {
    ++at;
  }
  const bool hasSuffix = suffix && at + 1 == value.size() && value[at] >= 'A';
  return at > first && (at == value.size() || hasSuffix);
}

/// "2+" and "1-" of some programs as "2" and "-1"; anything but an integer as unknown.
std::string CleanCharge(const std::string& value)
{
  const char last = value.empty() ? ' ' : value.back();
  if ((last == '+' || last == '-') && IsWholeNumber(value.substr(0, value.size() - 1), false))
  {
    return (last == '-' ? "-" : "") + value.substr(0, value.size() - 1);
  }
  const double number = cif::as_number(value);
  return number == std::round(number) && std::abs(number) < 100.0
    ? std::to_string(static_cast<int>(number))
    : "?";
}

/// The letter of a value that should be one.
void KeepFirstLetter(AtomTable& table, const char* name)
{
  const int column = table.Find(name);
  if (column < 0)
  {
    return;
  }
  table.ForEachRow(
    [&](std::size_t row)
    {
      std::string& value = table.At(row, column);
      if (value.size() > 1)
      {
        const std::string text = cif::as_string(value);
        value = text.size() > 1 ? text.substr(0, 1) : value;
      }
    });
}

/// gemmi refuses a file with a single malformed number: such values become unknown and are counted.
void CleanWholeNumbers(AtomTable& table, CIFAtoms& atoms)
{
  const int insertion = table.Find("pdbx_PDB_ins_code");
  for (const char* name : { "auth_seq_id", "label_seq_id", "pdbx_formal_charge" })
  {
    const int column = table.Find(name);
    const bool isCharge = name[0] == 'p';
    const bool isAuthor = name[0] == 'a';
    if (column < 0)
    {
      continue;
    }
    std::atomic<std::size_t> unknown{ 0 };
    table.ForEachRow(
      [&](std::size_t row)
      {
        std::string& value = table.At(row, column);
        if (cif::is_null(value) || IsWholeNumber(value, false))
        {
          return;
        }
        const std::string text = cif::as_string(value);
        if (isAuthor && IsWholeNumber(text, true))
        {
          // Of two insertion codes, the one with a column of its own is used.
          const bool twice = insertion >= 0 && !cif::is_null(table.At(row, insertion));
          value = twice ? text.substr(0, text.size() - 1) : text;
          return;
        }
        value = isCharge ? CleanCharge(text) : IsWholeNumber(text, false) ? text : "?";
        unknown += value == "?" ? 1 : 0;
      });
    const std::size_t dropped = unknown;
    if (dropped > 0)
    {
      atoms.Report.Note(std::to_string(dropped) + (dropped == 1 ? " value" : " values") + " of " +
        name + " that " + (dropped == 1 ? "is" : "are") + " not an integer: taken as unknown.");
    }
  }
  KeepFirstLetter(table, "label_alt_id");
  KeepFirstLetter(table, "pdbx_PDB_ins_code");
}

/// Adds the columns that gemmi requires.
void CompleteColumns(AtomTable& table, CIFAtoms& atoms)
{
  if (table.Find("label_atom_id") < 0 && table.Find("auth_atom_id") < 0)
  {
    throw std::invalid_argument("no column of _atom_site has the names of the atoms "
                                "(label_atom_id or auth_atom_id); add it");
  }
  std::string missing;
  for (const char* name : { "occupancy", "B_iso_or_equiv" })
  {
    if (table.Find(name) < 0)
    {
      missing += std::string(missing.empty() ? "" : " and ") + name;
      table.Plan(name, [](std::size_t) { return std::string(BlankText); });
    }
  }
  if (!missing.empty())
  {
    atoms.Report.Note("The file has no " + missing + ": unknown (NaN) for all atoms.");
  }
  CompleteElements(table, atoms);
  CleanWholeNumbers(table, atoms);
  FillUnknown(table, table.Find("auth_atom_id"), table.Find("label_atom_id"));
  FillUnknown(table, table.Find("auth_comp_id"), table.Find("label_comp_id"));
  FillUnknown(table, table.Find("auth_asym_id"), table.Find("label_asym_id"));
  if (table.Find("label_comp_id") < 0 && table.Find("auth_comp_id") < 0)
  {
    table.Plan("label_comp_id", [](std::size_t) { return std::string("."); });
  }
  PlanCopy(table, "label_asym_id", "auth_asym_id", ".");
  PlanCopy(table, "auth_seq_id", "label_seq_id", ".");
  if (table.Find("label_alt_id") < 0)
  {
    table.Plan("label_alt_id", [](std::size_t) { return std::string("."); });
  }
  if (table.Find("id") < 0)
  {
    table.Plan("id", [](std::size_t row) { return std::to_string(row + 1); });
  }
  const int model = table.Find("pdbx_PDB_model_num");
  if (model >= 0)
  {
    table.ForEachRow(
      [&](std::size_t row)
      {
        if (cif::is_null(table.At(row, model)))
        {
          table.At(row, model) = "1";
        }
      });
  }
  table.AddColumns();
}

/// pLDDT of ModelCIF by model, chain (label_asym_id) and residue (label_seq_id).
void ReadConfidence(cif::Block& block, CIFAtoms& atoms)
{
  std::set<std::string> metrics;
  for (auto row : block.find("_ma_qa_metric.", { "id", "name" }))
  {
    if (gemmi::to_lower(row.str(1)) == "plddt")
    {
      metrics.insert(row.str(0));
    }
  }
  std::map<std::string, std::int64_t> models; // numbered in the order in which they come
  for (auto row : block.find("_ma_qa_metric_local.",
         { "metric_id", "label_asym_id", "label_seq_id", "metric_value", "?model_id" }))
  {
    const double value = cif::as_number(row[3]);
    if (metrics.count(row.str(0)) > 0 && !std::isnan(value))
    {
      const std::string model = row.has(4) ? row.str(4) : std::string();
      const auto number = static_cast<std::int64_t>(models.size());
      atoms.Confidence[{ models.emplace(model, number).first->second, row.str(1), row.str(2) }] =
        value;
    }
  }
}

}

CIFAtoms CompleteAtomTable(cif::Block& block)
{
  CIFAtoms atoms;
  using Source = CIFAtoms::Source;
  const std::array<std::pair<const char*, Source>, 3> tables{ { { "_atom_site.", Source::MMCIF },
    { "_atom_site_", Source::CoreCIF }, { "_chem_comp_atom.", Source::ChemicalComponent } } };
  for (const auto& [prefix, source] : tables)
  {
    cif::Loop* const loop = FindTable(block, prefix);
    if (!loop || loop->values.empty())
    {
      continue;
    }
    std::vector<std::string> tags = loop->tags;
    RenameCategory(*loop, prefix);
    AtomTable table(*loop);
    const bool isComponent = source == Source::ChemicalComponent;
    const bool isFractional = table.Has(Fractional) && !HasAny(table, Cartesian);
    if (isComponent ? !TranslateComponent(block, table, atoms)
                    : !isFractional && !table.Has(Cartesian))
    {
      loop->tags = std::move(tags);
      continue;
    }
    // DDLm spells core CIF with the full stop of mmCIF.
    const bool isCore = source == Source::CoreCIF ||
      (!isComponent && table.Find("label") >= 0 && table.Find("label_atom_id") < 0);
    if (isCore)
    {
      TranslateCoreCIF(block, table, atoms);
    }
    if (isFractional)
    {
      Orthogonalize(block, table);
    }
    DropRowsWithoutCoordinates(table, atoms);
    CompleteColumns(table, atoms);
    atoms.From = isCore ? Source::CoreCIF : source;
    atoms.Rows = table.Rows();
    ReadConfidence(block, atoms);
    break;
  }
  return atoms;
}

}
