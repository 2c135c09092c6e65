/**
 * @file Inputs.h
 * @brief The inputs that the cases of ResultDigests share, each created on first use.
 */
#ifndef isthmus_digests_Inputs_h
#define isthmus_digests_Inputs_h

#include "Core/ChildProcess.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace isthmus::digests
{

/// Thrown where a file of the shared data is missing.
struct MissingData : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

class Inputs
{
public:
  /// Path of a file of the shared data.
  std::string File(const std::string& relative) const;

  vtkAlgorithmOutput* Map();              ///< EMD-1832, 64^3 nodes
  vtkAlgorithmOutput* OtherMap();         ///< the same after diffusion, as a second half map
  vtkAlgorithmOutput* MapSurface();       ///< of Map, at its automatic level
  vtkAlgorithmOutput* Surface();          ///< genus 3, 3,596 points
  vtkAlgorithmOutput* SmallSurface();     ///< genus 2, 766 points
  vtkAlgorithmOutput* Distance();         ///< of Surface, on a grid
  vtkAlgorithmOutput* Loops();            ///< of Surface, not shortened
  vtkAlgorithmOutput* Cells();            ///< tetrahedra
  vtkAlgorithmOutput* MixedCells();       ///< a tetrahedron, a pyramid, a prism, a hexahedron
  vtkAlgorithmOutput* Polyhedra();        ///< Voronoi cells
  vtkAlgorithmOutput* Protein();          ///< 1HEW: lysozyme with ligand and water
  vtkAlgorithmOutput* ChargedAtoms();     ///< crambin with charges and radii
  vtkAlgorithmOutput* ChargedProtein();   ///< 1HEW with charges and radii
  vtkAlgorithmOutput* Peptide();          ///< 1A1P, without charges
  vtkAlgorithmOutput* PredictedResidue(); ///< glycine with pLDDT
  vtkAlgorithmOutput* Crystal();          ///< a framework of oxygen atoms with their cell
  vtkAlgorithmOutput* Channel();          ///< gramicidin with artificial charges; its axis is y
  vtkAlgorithmOutput* Models();           ///< Protein at five times, deformed more and more
  vtkAlgorithmOutput* Fullerene();        ///< C60
  vtkAlgorithmOutput* Potential();        ///< of ChargedProtein
  vtkAlgorithmOutput* PotentialSurface(); ///< of the same, with curvature
  vtkAlgorithmOutput* PolarizedSurface(); ///< PotentialSurface with polarized curvature
  vtkAlgorithmOutput* FlowVolume();       ///< volume of the flow surface of Charged

  /// An algorithm of this type for a file of the shared data.
  template <typename Reader>
  vtkAlgorithmOutput* Read(const std::string& relative)
  {
    return this->Keep<Reader>("file " + relative,
      [&](Reader* reader) { reader->SetFileName(this->File(relative).c_str()); });
  }

  /// Path of a file for a writer, in NewFolder(), which is emptied.
  std::string NewFile(const std::string& name);
  const std::filesystem::path& NewFolder() const { return this->NewFiles.Path(); }

  /// Path of a file that `Writer` has written.
  template <typename Writer>
  std::string Written(const std::string& name, vtkAlgorithmOutput* input)
  {
    const std::string path = (this->WrittenFiles.Path() / name).string();
    vtkNew<Writer> writer;
    this->Observe(writer);
    writer->SetInputConnection(input);
    writer->SetFileName(path.c_str());
    writer->Write();
    return path;
  }

  /// Path of a file with this content.
  std::string TextFile(const std::string& name, const std::string& content);

  /// The last error of an input since the previous call; empty if there is none.
  std::string TakeError();

private:
  /// Collects errors for TakeError. Warnings are expected and not printed.
  void Observe(vtkAlgorithm* algorithm);

  /// The first output of the algorithm of this name, which is made and set at the first call.
  template <typename Filter, typename Setting>
  vtkAlgorithmOutput* Keep(const std::string& name, const Setting& set)
  {
    vtkSmartPointer<vtkAlgorithm>& kept = this->Kept[name];
    if (!kept)
    {
      vtkNew<Filter> filter;
      this->Observe(filter);
      set(filter.Get());
      kept = filter;
    }
    return kept->GetOutputPort();
  }

  std::map<std::string, vtkSmartPointer<vtkAlgorithm>> Kept;
  vtkNew<vtkTest::ErrorObserver> Observer;
  TemporaryFolder NewFiles;
  TemporaryFolder WrittenFiles;
};

}

#endif
