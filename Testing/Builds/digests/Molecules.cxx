// Filters of atoms: shapes, surfaces, electrostatics, solvation, pockets.

#include "Cases.h"
#include "vtkAtomSelection.h"
#include "vtkBindingSites.h"
#include "vtkFeatureTracks.h"
#include "vtkForceFieldCharges.h"
#include "vtkIonTransport.h"
#include "vtkIonTransportMovingSurface.h"
#include "vtkMolecularDensity.h"
#include "vtkMolecularFlowSurface.h"
#include "vtkMolecularPockets.h"
#include "vtkMoleculeCartoon.h"
#include "vtkNonpolarSolvation.h"
#include "vtkPoissonBoltzmann.h"
#include "vtkPolarizedCurvature.h"
#include "vtkPoreProfile.h"
#include "vtkSolvationSurface.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

namespace isthmus::digests
{

namespace
{

void AddShapes(Cases& cases)
{
  AddCase<vtkAtomSelection>(cases, "",
    [](vtkAtomSelection* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Protein()); });
  AddCase<vtkAtomSelection>(cases, "ligands",
    [](vtkAtomSelection* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Protein());
      filter->IncludeChainsOff();
      filter->IncludeLigandsOn();
    });
  AddCase<vtkMolecularDensity>(cases, "",
    [](vtkMolecularDensity* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.ChargedAtoms()); });
  AddCase<vtkMolecularDensity>(cases, "balls",
    [](vtkMolecularDensity* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Protein());
      filter->SetForm(vtkMolecularDensity::UnionOfBalls);
      filter->SetSpacing(1.0);
    });
  AddCase<vtkMoleculeCartoon>(cases, "",
    [](vtkMoleculeCartoon* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Protein()); });
  AddCase<vtkMoleculeCartoon>(cases, "predicted",
    [](vtkMoleculeCartoon* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.PredictedResidue()); });
  AddCase<vtkMolecularFlowSurface>(cases, "",
    [](vtkMolecularFlowSurface* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.ChargedAtoms()); });
  AddCase<vtkMolecularFlowSurface>(cases, "channel",
    [](vtkMolecularFlowSurface* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Channel());
      filter->SetPreset(vtkMolecularFlowSurface::Channel);
      filter->SetSpacing(0.8);
    });
  AddCase<vtkMolecularFlowSurface>(cases, "thesis, time steps",
    [](vtkMolecularFlowSurface* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedAtoms());
      filter->SetMethod(vtkMolecularFlowSurface::ThesisFlow);
      filter->SetSpacing(1.0);
      filter->SetTimeSteps(4);
    });
  AddCase<vtkNonpolarSolvation>(cases, "",
    [](vtkNonpolarSolvation* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedAtoms());
      filter->SetInputConnection(1, inputs.FlowVolume());
    });
}

void AddElectrostatics(Cases& cases)
{
  AddCase<vtkForceFieldCharges>(cases, "",
    [](vtkForceFieldCharges* filter, Inputs& inputs)
    {
      RequireProgram("pdb2pqr");
      filter->SetInputConnection(inputs.Peptide());
    });
  AddCase<vtkForceFieldCharges>(cases, "insertion codes",
    [](vtkForceFieldCharges* filter, Inputs& inputs)
    {
      RequireProgram("pdb2pqr");
      vtkAlgorithm* const producer = inputs.Peptide()->GetProducer();
      producer->Update();
      vtkNew<vtkPolyData> atoms;
      atoms->DeepCopy(producer->GetOutputDataObject(0));
      vtkNew<vtkStringArray> codes;
      codes->SetName("InsertionCode");
      codes->SetNumberOfValues(atoms->GetNumberOfPoints());
      atoms->GetPointData()->AddArray(codes);
      filter->SetInputData(atoms);
    });
  AddCase<vtkPoissonBoltzmann>(cases, "",
    [](vtkPoissonBoltzmann* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedAtoms());
      filter->SetSpacing(1.0);
    });
  AddCase<vtkPoissonBoltzmann>(cases, "maps and forces",
    [](vtkPoissonBoltzmann* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedAtoms());
      filter->SetSpacing(1.0);
      filter->NonlinearOn();
      filter->GetOutputArraySelection()->EnableAllArrays();
    });
  AddCase<vtkPoissonBoltzmann>(cases, "volume, smooth",
    [](vtkPoissonBoltzmann* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedAtoms());
      filter->SetSurfaceConnection(inputs.FlowVolume());
      filter->SetLevel(0.0);
      filter->InsideIsHigherOff();
      filter->SetDielectricModel(vtkPoissonBoltzmann::SmoothDielectric);
    });
}

void AddSolvation(Cases& cases)
{
  AddCase<vtkIonTransport>(cases, "",
    [](vtkIonTransport* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Channel());
      filter->SetMembraneCenter(0.1, 0.0, 3.97);
      filter->SetMembraneNormal(0.0, 1.0, 0.0);
      filter->SetSpacing(1.0);
    });
  AddCase<vtkIonTransportMovingSurface>(cases, "",
    [](vtkIonTransportMovingSurface* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Channel());
      filter->SetMembraneCenter(0.1, 0.0, 3.97);
      filter->SetMembraneNormal(0.0, 1.0, 0.0);
      filter->SetSpacing(1.0);
      filter->SetMaximumUpdates(2);
    });
  AddCase<vtkSolvationSurface>(cases, "",
    [](vtkSolvationSurface* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedAtoms());
      filter->SetSpacing(1.0);
      filter->SetMaximumUpdates(3);
    });
}

void AddPockets(Cases& cases)
{
  AddCase<vtkBindingSites>(cases, "",
    [](vtkBindingSites* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.PolarizedSurface());
      filter->SetAtomsConnection(inputs.ChargedProtein());
    });
  AddCase<vtkBindingSites>(cases, "patches",
    [](vtkBindingSites* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.PolarizedSurface()); });
  AddCase<vtkFeatureTracks>(cases, "",
    [](vtkFeatureTracks* filter, Inputs& inputs)
    {
      vtkNew<vtkMolecularPockets> pockets;
      pockets->SetInputConnection(inputs.Models());
      pockets->FindSitesOff();
      filter->SetInputConnection(pockets->GetOutputPort(1));
      filter->SetLiningConnection(pockets->GetOutputPort(4));
    });
  AddCase<vtkFeatureTracks>(cases, "choke points",
    [](vtkFeatureTracks* filter, Inputs& inputs)
    { filter->SetInputConnection(inputs.Loops()->GetProducer()->GetOutputPort(2)); });
  AddCase<vtkMolecularPockets>(cases, "",
    [](vtkMolecularPockets* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Protein());
      filter->GetOutputArraySelection()->EnableAllArrays();
    });
  AddCase<vtkMolecularPockets>(cases, "surface",
    [](vtkMolecularPockets* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.ChargedProtein());
      filter->SetSurfaceConnection(inputs.PolarizedSurface());
    });
  AddCase<vtkMolecularPockets>(cases, "crystal",
    [](vtkMolecularPockets* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Crystal());
      filter->UsePeriodicCellOn();
    });
  AddCase<vtkPolarizedCurvature>(cases, "",
    [](vtkPolarizedCurvature* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.PotentialSurface());
      filter->SetPotentialConnection(inputs.Potential());
    });
  AddCase<vtkPoreProfile>(cases, "",
    [](vtkPoreProfile* filter, Inputs& inputs) { filter->SetInputConnection(inputs.Channel()); });
  AddCase<vtkPoreProfile>(cases, "crystal",
    [](vtkPoreProfile* filter, Inputs& inputs)
    {
      filter->SetInputConnection(inputs.Crystal());
      filter->SetMode(vtkPoreProfile::CellVectors);
    });
}

}

void AddMolecules(Cases& cases)
{
  AddShapes(cases);
  AddElectrostatics(cases);
  AddSolvation(cases);
  AddPockets(cases);
}

}
