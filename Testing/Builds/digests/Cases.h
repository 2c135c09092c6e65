/**
 * @file Cases.h
 * @brief The filters, readers and writers whose results ResultDigests prints, by family.
 */
#ifndef isthmus_digests_Cases_h
#define isthmus_digests_Cases_h

#include "ArrayTables.h"
#include "Inputs.h"

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus::digests
{

/// Thrown by a case whose external program is not installed.
struct MissingProgram : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A class with one set of inputs and properties.
struct Case
{
  std::string Class;
  std::string Variant; ///< empty for the defaults
  std::function<vtkSmartPointer<vtkAlgorithm>(Inputs&)> Make;
  const ArrayTable* Table = nullptr; ///< of its output arrays

  std::string Name() const
  {
    return this->Variant.empty() ? this->Class : this->Class + ":" + this->Variant;
  }
};

using Cases = std::vector<Case>;

/// Adds a case of `Filter` whose inputs and properties are set by `set`.
template <typename Filter>
void AddCase(Cases& cases, const std::string& variant, void (*set)(Filter*, Inputs&))
{
  const auto make = [set](Inputs& inputs)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    set(filter, inputs);
    return vtkSmartPointer<vtkAlgorithm>(filter);
  };
  cases.push_back({ vtkNew<Filter>()->GetClassName(), variant, make, TableOf<Filter>::Get() });
}

/// Throws MissingProgram unless `program` is installed.
void RequireProgram(const std::string& program);

void AddReaders(Cases& cases);
void AddMaps(Cases& cases);
void AddMeshes(Cases& cases);
void AddMolecules(Cases& cases);

}

#endif
