#include "Molecules/CIFAssemblies.h"

#include "Core/PrintableText.h"
#include "Files/TextLines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <gemmi/numb.hpp>

namespace isthmus
{
namespace
{

constexpr std::size_t MostProducts = 100000;

[[noreturn]] void RefuseExpression(const std::string& expression, const std::string& why)
{
  throw std::invalid_argument("the oper_expression " + Printable(expression.substr(0, 100)) + " " +
    why + ". Correct the file or leave Assembly empty");
}

/// "1-60" as 1, 2, ..., 60; a name otherwise.
void AddOperators(const std::string& item, const std::vector<std::string>& known,
  const std::string& expression, std::vector<std::string>& to)
{
  const std::size_t hyphen = item.find('-', 1);
  const bool isName = std::find(known.begin(), known.end(), item) != known.end();
  if (item.empty())
  {
    RefuseExpression(expression, "has an empty place");
  }
  if (isName || hyphen == std::string::npos)
  {
    to.push_back(item);
    return;
  }
  long first = 0;
  long last = 0;
  if (!IsNumber(Trim(std::string_view(item).substr(0, hyphen)), first) ||
    !IsNumber(Trim(std::string_view(item).substr(hyphen + 1)), last) || last < first)
  {
    RefuseExpression(expression, "has a range that is not one of whole numbers");
  }
  if (last - first >= static_cast<long>(MostProducts))
  {
    RefuseExpression(expression, "has more than 100,000 operators");
  }
  for (long number = first; number <= last; ++number)
  {
    to.push_back(std::to_string(number));
  }
}

/// The items of a list separated by commas.
std::vector<std::string> ParseGroup(
  std::string_view list, const std::vector<std::string>& known, const std::string& expression)
{
  std::vector<std::string> group;
  for (std::size_t at = 0; at <= list.size();)
  {
    const std::size_t end = std::min(list.find(',', at), list.size());
    AddOperators(std::string(Trim(list.substr(at, end - at))), known, expression, group);
    at = end + 1;
  }
  return group;
}

/// The groups of a product: "(1-3)(X0,X1)" has two; without brackets, all is one group.
std::vector<std::vector<std::string>> ParseGroups(
  const std::string& expression, const std::vector<std::string>& known)
{
  std::vector<std::vector<std::string>> groups;
  std::string_view rest = Trim(expression);
  if (rest.find_first_of("()") == std::string_view::npos)
  {
    return { ParseGroup(rest, known, expression) };
  }
  while (!rest.empty())
  {
    const std::size_t end = rest.find(')');
    if (rest[0] != '(' || end == std::string_view::npos ||
      rest.find('(', 1) < end) // brackets within brackets, or text between them
    {
      RefuseExpression(expression, "is not a list of operators, nor a product of such in brackets");
    }
    groups.push_back(ParseGroup(rest.substr(1, end - 1), known, expression));
    rest = Trim(rest.substr(end + 1));
  }
  return groups;
}

gemmi::Transform ReadTransform(const gemmi::cif::Table::Row& row, const std::string& name)
{
  gemmi::Transform transform;
  const auto number = [&](int column)
  {
    const double value = gemmi::cif::as_number(row[column]);
    if (!std::isfinite(value))
    {
      throw std::invalid_argument("operator " + Printable(name) +
        " of _pdbx_struct_oper_list has an element that is not a number. Correct the file or "
        "leave Assembly empty");
    }
    return value;
  };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      transform.mat[i][j] = number(1 + 4 * i + j);
    }
    transform.vec.at(i) = number(4 + 4 * i);
  }
  return transform;
}

/// The rows of pdbx_struct_oper_list with a name, by which they are read when needed.
gemmi::cif::Table FindOperators(gemmi::cif::Block& block)
{
  return block.find("_pdbx_struct_oper_list.",
    { "id", "matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "vector[1]", "matrix[2][1]",
      "matrix[2][2]", "matrix[2][3]", "vector[2]", "matrix[3][1]", "matrix[3][2]", "matrix[3][3]",
      "vector[3]" });
}

gemmi::cif::Table FindGenerators(gemmi::cif::Block& block)
{
  return block.find(
    "_pdbx_struct_assembly_gen.", { "assembly_id", "oper_expression", "asym_id_list" });
}

}

std::vector<std::vector<std::string>> ParseOperatorExpression(
  const std::string& expression, const std::vector<std::string>& known)
{
  std::vector<std::vector<std::string>> products{ {} };
  for (const std::vector<std::string>& group : ParseGroups(expression, known))
  {
    if (products.size() > MostProducts / std::max<std::size_t>(group.size(), 1))
    {
      RefuseExpression(expression, "has more than 100,000 operators");
    }
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& product : products)
    {
      for (const std::string& factor : group)
      {
        longer.push_back(product);
        longer.back().push_back(factor);
      }
    }
    products = std::move(longer);
  }
  return products;
}

std::vector<std::string> CIFAssemblyNames(gemmi::cif::Block& block)
{
  std::vector<std::string> names;
  for (const auto row : FindGenerators(block))
  {
    if (std::find(names.begin(), names.end(), row.str(0)) == names.end())
    {
      names.push_back(row.str(0));
    }
  }
  return names;
}

gemmi::Assembly ReadCIFAssembly(gemmi::cif::Block& block, const std::string& name)
{
  std::vector<std::string> known;
  std::map<std::string, gemmi::Transform> operators;
  gemmi::cif::Table table = FindOperators(block);
  for (const auto row : table)
  {
    known.push_back(row.str(0));
  }
  const auto find = [&](const std::string& wanted) -> const gemmi::Transform&
  {
    const auto found = operators.find(wanted);
    if (found != operators.end())
    {
      return found->second;
    }
    const auto at = std::find(known.begin(), known.end(), wanted);
    if (at == known.end())
    {
      throw std::invalid_argument("assembly " + Printable(name) + " needs operator " +
        Printable(wanted) +
        ", which is not in _pdbx_struct_oper_list. Correct the file or leave "
        "Assembly empty");
    }
    return operators
      .emplace(wanted, ReadTransform(table[static_cast<int>(at - known.begin())], wanted))
      .first->second;
  };
  gemmi::Assembly assembly(name);
  for (const auto row : FindGenerators(block))
  {
    if (row.str(0) != name)
    {
      continue;
    }
    assembly.generators.emplace_back();
    gemmi::Assembly::Gen& generator = assembly.generators.back();
    const std::string chains = row.str(2);
    for (std::size_t at = 0; at < chains.size();)
    {
      const std::size_t end = std::min(chains.find(',', at), chains.size());
      generator.subchains.emplace_back(Trim(std::string_view(chains).substr(at, end - at)));
      at = end + 1;
    }
    for (const std::vector<std::string>& product : ParseOperatorExpression(row.str(1), known))
    {
      gemmi::Assembly::Operator applied;
      for (const std::string& factor : product)
      {
        applied.name += (applied.name.empty() ? "" : " ") + factor;
        applied.transform = applied.transform.combine(find(factor));
      }
      generator.operators.push_back(applied);
    }
  }
  return assembly;
}

}
