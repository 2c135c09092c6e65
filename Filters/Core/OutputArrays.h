/**
 * @file OutputArrays.h
 * @brief The table of the arrays that a filter adds to its outputs, and the choice of those that
 * are optional.
 *
 * The table is in the .cxx of the filter and is the only list of these arrays. ResultDigests
 * compares it with the outputs; Wrapping/Python/output_arrays.py reads it for guide and Python
 * functions, so every row is written as strings, numbers and enumerators, without expressions.
 */
#ifndef isthmus_OutputArrays_h
#define isthmus_OutputArrays_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkDataArraySelection.h>
#include <vtkIndent.h>
#include <vtkNew.h>

#include <initializer_list>
#include <ostream>
#include <vector>

class vtkFieldData;
class vtkObject;

namespace isthmus
{

enum class ArrayPlace
{
  Points, ///< or atoms of a vtkMolecule
  Cells,  ///< or bonds of a vtkMolecule
  Field,
  Rows, ///< of a table
};

/// Whether users choose the array, and whether it is chosen by default.
enum class ArrayChoice
{
  None,
  On,
  Off,
};

/// An array that a filter adds to an output.
struct OutputArray
{
  int Port; ///< -1: all outputs
  ArrayPlace Place;
  /// NAME in it stands for any text, where there is an array for each of several names. INPUT: the
  /// name of an array of an input, whose values are changed.
  const char* Name;
  int Components;   ///< 0: depends on the input
  const char* Unit; ///< empty: none
  ArrayChoice Choice;
  const char* Text; ///< what the values are, for the guide
};

/// The optional arrays of a filter, and which of them are chosen.
class VTKISTHMUSFILTERSCORE_EXPORT OutputArraySelection
{
public:
  /// `owner` is modified with the selection. @pre `table` outlives the selection.
  OutputArraySelection(vtkObject* owner, const std::vector<OutputArray>& table);

  /// With a name for each optional array of the table, even after all were removed.
  vtkDataArraySelection* Get();

  bool Has(const char* name) const;
  bool HasAny(std::initializer_list<const char*> names) const;

  /// Removes the arrays of `names` that are not chosen, if several are computed together.
  void RemoveOthers(std::initializer_list<const char*> names, vtkFieldData* data) const;

  /// @throws std::invalid_argument if the selection has a name that is none of the table's optional
  /// arrays.
  void Check() const;

  /// One line with the names of the chosen arrays.
  void Print(std::ostream& os, vtkIndent indent) const;

private:
  const std::vector<OutputArray>* Table;
  vtkNew<vtkDataArraySelection> Selection;
};

}

/// At the end of the public part of a class whose constructor initialises OutputArrays with `this`
/// and its table: the selection, as VTK's readers have it.
#define ISTHMUS_OUTPUT_ARRAY_SELECTION()                                                           \
public:                                                                                            \
  vtkDataArraySelection* GetOutputArraySelection()                                                 \
  {                                                                                                \
    return this->OutputArrays.Get();                                                               \
  }                                                                                                \
                                                                                                   \
protected:                                                                                         \
  isthmus::OutputArraySelection OutputArrays

#endif
