// Prints a digest of each array of each output of each filter, reader and writer on the shared
// data. Two builds on one machine are compared by diff:
//
//     [ISTHMUS_DATA_DIR=FOLDER] ResultDigests [NAME...] > before
//     [ISTHMUS_DATA_DIR=FOLDER] ResultDigests [NAME...] > after
//     diff before after
//
// With NAMEs, only the cases whose names begin with one of them. A line is
//
//     CLASS[:VARIANT]/OUTPUT/PLACE/ARRAY TYPE COMPONENTS TUPLES DIGEST [ROLE]
//
// so an array that is removed or renamed is one line of difference, and no other line changes.
// PLACE is points, topology, point data, cell data, field data, rows, vertex data, edge data,
// pipeline or file (of a writer); ROLE says that the array is active. A digest is 64-bit FNV-1a
// over the values, numbers bit by bit. Lines are sorted. They do not depend on the number of
// threads.
//
// Fails if a class of a module has neither a case (digests/*.cxx) nor a reason below not to have
// one, if a case has an error, if an output of a class is empty in all its cases, if a class with
// outputs has no OutputArrayTable(), or if an array that a class adds is in no row of it, or a row
// is in no output of any case.

#include "SharedData.h"
#include "digests/Cases.h"
#include "digests/Lines.h"

#include <vtkExecutive.h>
#include <vtkTestErrorObserver.h>
#include <vtkWriter.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace isthmus::digests;

namespace
{

/// Classes without results of their own.
const std::map<std::string, const char*> Exceptions{
  { "vtkDiffusionAlgorithm", "abstract: base of the filters of Imaging" },
  { "vtkGuardedFileWriter", "abstract: base of all writers" },
  { "vtkImageArrayWriter", "abstract: base of writers of images" },
  { "vtkMeshFileReader", "abstract: base of readers of meshes" },
  { "vtkMeshFileWriter", "abstract: base of writers of meshes" },
};

std::vector<std::string> ClassesOfModules()
{
  std::istringstream words(ISTHMUS_CLASSES);
  std::vector<std::string> classes;
  for (std::string word; words >> word;)
  {
    classes.push_back(word);
  }
  return classes;
}

/// Reports classes without a case and exceptions that are not needed. True if there are none.
bool AllClassesAreCovered(const Cases& cases)
{
  std::set<std::string> covered;
  for (const Case& one : cases)
  {
    covered.insert(one.Class);
  }
  bool all = true;
  const std::vector<std::string> classes = ClassesOfModules();
  for (const std::string& name : classes)
  {
    const bool isException = Exceptions.count(name) > 0;
    if (isException != (covered.count(name) > 0))
    {
      continue;
    }
    std::fprintf(stderr, "%s: %s.\n", name.c_str(),
      isException ? "has a case, remove the exception" : "add a case to Testing/Builds/digests");
    all = false;
  }
  for (const auto& [name, reason] : Exceptions)
  {
    if (std::count(classes.begin(), classes.end(), name) == 0)
    {
      std::fprintf(stderr, "%s (%s) is not a class of a module: remove the exception.\n",
        name.c_str(), reason);
      all = false;
    }
  }
  return all;
}

/// Results of the cases.
struct Results
{
  Lines Text;
  std::map<std::string, bool> OutputHasData; ///< by class and output: in any case
  ArrayTables Tables;
  bool Failed = false;
};

void AddFiles(Results& results, const Case& one, const std::filesystem::path& folder)
{
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    AddFile(results.Text, one.Name() + "/0/file", entry.path());
  }
}

void AddOutputs(Results& results, const Case& one, vtkAlgorithm* algorithm)
{
  algorithm->Update();
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    const std::string output = "/" + std::to_string(port);
    vtkDataObject* const object = algorithm->GetOutputDataObject(port);
    AddLines(results.Text, one.Name() + output, object);
    AddTimeSteps(results.Text, one.Name() + output, algorithm, port);
    bool& hasData = results.OutputHasData[one.Class + output];
    hasData = hasData || !IsEmpty(object);
  }
  if (one.Table)
  {
    results.Tables.Compare(one.Class, *one.Table, algorithm);
  }
  else if (algorithm->IsA(one.Class.c_str())) // else the case shows an object without outputs
  {
    results.Tables.AddMissing(one.Class);
  }
}

void Run(Results& results, const Case& one, Inputs& inputs)
{
  inputs.TakeError();
  const vtkSmartPointer<vtkAlgorithm> algorithm = one.Make(inputs);
  vtkNew<vtkTest::ErrorObserver> observer;
  for (vtkObject* const object : { static_cast<vtkObject*>(algorithm.Get()),
         static_cast<vtkObject*>(algorithm->GetExecutive()) })
  {
    object->AddObserver(vtkCommand::ErrorEvent, observer);
    object->AddObserver(vtkCommand::WarningEvent, observer);
  }
  if (auto* writer = vtkWriter::SafeDownCast(algorithm))
  {
    writer->Write();
    AddFiles(results, one, inputs.NewFolder());
  }
  else
  {
    AddOutputs(results, one, algorithm);
  }
  if (observer->GetError())
  {
    throw std::runtime_error(observer->GetErrorMessage());
  }
  if (const std::string error = inputs.TakeError(); !error.empty())
  {
    throw std::runtime_error(error);
  }
}

bool IsChosen(const Case& one, const std::vector<std::string>& names)
{
  return names.empty() ||
    std::any_of(names.begin(), names.end(),
      [&](const std::string& name) { return one.Name().compare(0, name.size(), name) == 0; });
}

/// @throws MissingData
Results RunAll(const Cases& cases, const std::vector<std::string>& names)
{
  Results results;
  Inputs inputs;
  for (const Case& one : cases)
  {
    if (!IsChosen(one, names))
    {
      continue;
    }
    try
    {
      Run(results, one, inputs);
    }
    catch (const MissingProgram& missing)
    {
      results.Text.push_back(one.Name() + " " + missing.what());
      results.Tables.AddSkipped(one.Class);
    }
    catch (const MissingData&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "%s: %s\n", one.Name().c_str(), error.what());
      results.Failed = true;
    }
  }
  for (const auto& [output, hasData] : results.OutputHasData)
  {
    if (!hasData && names.empty())
    {
      std::fprintf(stderr, "%s is empty in all cases.\n", output.c_str());
      results.Failed = true;
    }
  }
  for (const std::string& complaint : results.Tables.Complaints(names.empty()))
  {
    std::fprintf(stderr, "%s.\n", complaint.c_str());
    results.Failed = true;
  }
  std::sort(results.Text.begin(), results.Text.end());
  return results;
}

}

int main(int argc, char** argv)
{
  Cases cases;
  AddReaders(cases);
  AddMaps(cases);
  AddMeshes(cases);
  AddMolecules(cases);
  if (!AllClassesAreCovered(cases))
  {
    return 1;
  }
  try
  {
    const Results results = RunAll(cases, { argv + 1, argv + argc });
    for (const std::string& line : results.Text)
    {
      std::puts(line.c_str());
    }
    return results.Failed ? 1 : 0;
  }
  catch (const MissingData& missing)
  {
    std::fprintf(stderr, "%s\n", missing.what());
    return isthmus::testing::SharedDataRequired() ? 1 : 77;
  }
}
