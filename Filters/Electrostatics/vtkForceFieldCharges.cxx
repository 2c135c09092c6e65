#include "vtkForceFieldCharges.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/PipelineInputs.h"
#include "Electrostatics/ForceFieldAtoms.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <stdexcept>

vtkStandardNewMacro(vtkForceFieldCharges);

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
  };
  return table;
}

vtkForceFieldCharges::vtkForceFieldCharges()
  : Cache(std::make_unique<isthmus::ForceFieldAtomsCache>())
{
}

vtkForceFieldCharges::~vtkForceFieldCharges() = default;

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
        return;
      }
      output->ShallowCopy(this->Cache->Get(atoms, arrays,
        static_cast<isthmus::ChargeTable>(this->ForceField), isthmus::MakeProgress(this)));
      output->GetFieldData()->PassData(atoms->GetFieldData());
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
}
