/**
 * @file ArrayTables.h
 * @brief Compares the arrays of the outputs with the tables of the filters (Core/OutputArrays.h).
 */
#ifndef isthmus_digests_ArrayTables_h
#define isthmus_digests_ArrayTables_h

#include "Core/OutputArrays.h"

#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

class vtkAlgorithm;

namespace isthmus::digests
{

using ArrayTable = std::vector<OutputArray>;

/// The table of a class; null if it has none.
template <typename Filter, typename = void>
struct TableOf
{
  static const ArrayTable* Get() { return nullptr; }
};
template <typename Filter>
struct TableOf<Filter, std::void_t<decltype(Filter::OutputArrayTable())>>
{
  static const ArrayTable* Get() { return &Filter::OutputArrayTable(); }
};

class ArrayTables
{
public:
  /// Compares all outputs with the table. An array that is in no row must have the name and place
  /// of one of an input.
  void Compare(const std::string& className, const ArrayTable& table, vtkAlgorithm* algorithm);

  /// Complains about a class with outputs that has no table.
  void AddMissing(const std::string& className);

  /// A class with a case that could not run: its rows may be in no output.
  void AddSkipped(const std::string& className);

  /// Complaints about the outputs compared so far; with `all`, also about rows whose array was in
  /// none of them.
  std::vector<std::string> Complaints(bool all) const;

private:
  std::set<std::string> Wrong;
  std::set<std::string> Skipped;          ///< classes
  std::map<std::string, bool> RowIsFound; ///< by class, output, place and name
};

}

#endif
