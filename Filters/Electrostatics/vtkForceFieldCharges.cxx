#include "vtkForceFieldCharges.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/PipelineInputs.h"
#include "Electrostatics/ForceFieldAtoms.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkStringArray.h>

#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkForceFieldCharges);

namespace
{

/// The notes of the input, and further ones.
std::vector<std::string> JoinNotes(vtkPointSet* atoms, const std::vector<std::string>& further)
{
  std::vector<std::string> notes;
  auto* known = vtkStringArray::SafeDownCast(atoms->GetFieldData()->GetAbstractArray("Notes"));
  for (vtkIdType i = 0; known && i < known->GetNumberOfValues(); ++i)
  {
    notes.push_back(known->GetValue(i));
  }
  notes.insert(notes.end(), further.begin(), further.end());
  return notes;
}

}

const std::vector<isthmus::OutputArray>& vtkForceFieldCharges::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Charge", 1, "e", ArrayChoice::None, "of the force field" },
    { 0, ArrayPlace::Points, "Radius", 1, "angstrom", ArrayChoice::None, "of the force field" },
    { 0, ArrayPlace::Points, "AtomName", 1, "", ArrayChoice::None, "of the atom" },
    { 0, ArrayPlace::Points, "Element", 1, "", ArrayChoice::None, "atomic number" },
    { 0, ArrayPlace::Points, "InputAtom", 1, "", ArrayChoice::None,
      "point of the input; -1: a new atom" },
    { 0, ArrayPlace::Points, "ResidueName", 1, "", ArrayChoice::None,
      "of the residue; where the input has it" },
    { 0, ArrayPlace::Points, "ResidueId", 1, "", ArrayChoice::None,
      "of the residue; where the input has it" },
    { 0, ArrayPlace::Points, "Chain", 1, "", ArrayChoice::None,
      "of the residue; where the input has it" },
    { 0, ArrayPlace::Points, "InsertionCode", 1, "", ArrayChoice::None,
      "of the residue; where the input has it" },
    { 0, ArrayPlace::Points, "IsHetero", 1, "", ArrayChoice::None,
      "of the residue; where the input has it" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "hydrogens with unknown names; those of the input" },
  };
  return table;
}

vtkForceFieldCharges::vtkForceFieldCharges()
  : Cache(std::make_unique<isthmus::ForceFieldAtomsCache>())
{
  this->SetNumberOfInputPorts(2);
}

vtkForceFieldCharges::~vtkForceFieldCharges() = default;

int vtkForceFieldCharges::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkForceFieldCharges::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
      vtkPointSet* output = vtkPointSet::GetData(outputVector, 0);
      isthmus::RequireOneRank(this, atoms, "atoms");
      if (!atoms || atoms->GetNumberOfPoints() == 0)
      {
        return;
      }
      isthmus::RequireFinitePositions(atoms, "the atoms");
      vtkPointSet* ligands = vtkPointSet::GetData(inputVector[1], 0);
      isthmus::RequireFinitePositions(ligands, "the ligands");
      const isthmus::ChargeArrays arrays{ "Charge", "Radius" };
      if (!isthmus::LacksCharges(atoms, arrays))
      {
        if (!atoms->GetPointData()->GetArray("Charge"))
        {
          throw std::invalid_argument(
            "The atoms have neither charges nor names by which a force field could assign them: "
            "open a PDB, mmCIF or PQR file with the Macromolecule Reader.");
        }
        output->ShallowCopy(atoms);
        if (ligands)
        {
          isthmus::AddNotes(
            JoinNotes(atoms, { "The atoms have charges already: input 1 was not used." }), output);
        }
        return;
      }
      isthmus::ChargeOptions options(static_cast<isthmus::ChargeTable>(this->ForceField));
      options.UsePropka = this->UsePropka;
      options.PH = this->PH;
      output->ShallowCopy(
        this->Cache->Get(atoms, ligands, arrays, options, isthmus::MakeProgress(this)));
      output->GetFieldData()->PassData(atoms->GetFieldData());
      const std::vector<std::string> notes = JoinNotes(atoms, this->Cache->Notes());
      if (!notes.empty())
      {
        isthmus::AddNotes(notes, output);
      }
      if (!this->Cache->Warning().empty())
      {
        vtkWarningMacro(<< this->Cache->Warning());
      }
    });
}

void vtkForceFieldCharges::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ForceField: " << this->ForceField << "\n";
  os << indent << "UsePropka: " << this->UsePropka << "\n";
  os << indent << "PH: " << this->PH << "\n";
}
