#include "Inputs.h"

#include "SharedData.h"
#include "VolumeMeshFiles.h"
#include "vtkChokingLoops.h"
#include "vtkHighOrderDiffusion.h"
#include "vtkMEDITReader.h"
#include "vtkMRCMapReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkMapSurface.h"
#include "vtkMolecularFlowSurface.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkPoissonBoltzmann.h"
#include "vtkPolarizedCurvature.h"
#include "vtkSurfaceCurvature.h"
#include "vtkSurfaceToGrid.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

#include <fstream>
#include <iomanip>

namespace isthmus::digests
{

std::string Inputs::File(const std::string& relative) const
{
  const auto path = isthmus::testing::SharedDataFolder() / relative;
  if (!std::filesystem::exists(path))
  {
    throw MissingData("There is no " + path.string() + ": set ISTHMUS_DATA_DIR.");
  }
  return path.string();
}

std::string Inputs::NewFile(const std::string& name)
{
  for (const auto& entry : std::filesystem::directory_iterator(this->NewFiles.Path()))
  {
    std::filesystem::remove(entry);
  }
  return (this->NewFiles.Path() / name).string();
}

std::string Inputs::TextFile(const std::string& name, const std::string& content)
{
  const std::string path = (this->WrittenFiles.Path() / name).string();
  std::ofstream file(path);
  file << content;
  file.close();
  if (!file)
  {
    throw std::runtime_error(path + " cannot be written");
  }
  return path;
}

std::string Inputs::TakeError()
{
  const std::string error = this->Observer->GetError() ? this->Observer->GetErrorMessage() : "";
  this->Observer->Clear();
  return error;
}

void Inputs::Observe(vtkAlgorithm* algorithm)
{
  algorithm->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  algorithm->AddObserver(vtkCommand::WarningEvent, this->Observer);
}

vtkAlgorithmOutput* Inputs::Map()
{
  return this->Read<vtkMRCMapReader>("maps/emd_1832.map");
}

vtkAlgorithmOutput* Inputs::OtherMap()
{
  return this->Keep<vtkHighOrderDiffusion>("other map",
    [&](vtkHighOrderDiffusion* filter)
    {
      filter->SetInputConnection(this->Map());
      filter->SetTime(1.0);
    });
}

vtkAlgorithmOutput* Inputs::MapSurface()
{
  return this->Keep<vtkMapSurface>(
    "map surface", [&](vtkMapSurface* filter) { filter->SetInputConnection(this->Map()); });
}

vtkAlgorithmOutput* Inputs::Surface()
{
  return this->Read<vtkOFFSurfaceReader>("surfaces/3holes.off");
}

vtkAlgorithmOutput* Inputs::SmallSurface()
{
  return this->Read<vtkOFFSurfaceReader>("surfaces/eight.off");
}

vtkAlgorithmOutput* Inputs::Distance()
{
  return this->Keep<vtkSurfaceToGrid>(
    "distance", [&](vtkSurfaceToGrid* filter) { filter->SetInputConnection(this->Surface()); });
}

vtkAlgorithmOutput* Inputs::Loops()
{
  return this->Keep<vtkChokingLoops>("loops",
    [&](vtkChokingLoops* filter)
    {
      filter->SetInputConnection(this->Surface());
      filter->SetShortening(vtkChokingLoops::None);
    });
}

vtkAlgorithmOutput* Inputs::Cells()
{
  return this->Read<vtkMEDITReader>("volumes/octopus-low.mesh");
}

vtkAlgorithmOutput* Inputs::MixedCells()
{
  return this->Keep<vtkTrivialProducer>("mixed cells",
    [&](vtkTrivialProducer* producer)
    {
      const auto grid = isthmus::testing::ReadVolumeMesh(this->File("volumes/tinyzoo-3d.mesh"));
      vtkNew<vtkIntArray> numbers;
      numbers->SetName("Number");
      for (int i = 0; i < grid->GetNumberOfCells(); ++i)
      {
        numbers->InsertNextValue(i);
      }
      grid->GetCellData()->AddArray(numbers);
      producer->SetOutput(grid);
    });
}

vtkAlgorithmOutput* Inputs::Polyhedra()
{
  return this->Keep<vtkTrivialProducer>("polyhedra",
    [&](vtkTrivialProducer* producer)
    {
      producer->SetOutput(
        isthmus::testing::ReadVolumeMesh(this->File("volumes/cube_voronoi_3.ovm")));
    });
}

vtkAlgorithmOutput* Inputs::Protein()
{
  return this->Read<vtkMacromoleculeReader>("molecules/1hew.pdb");
}

vtkAlgorithmOutput* Inputs::ChargedAtoms()
{
  return this->Read<vtkMacromoleculeReader>("molecules/1crn_apbs.pqr");
}

vtkAlgorithmOutput* Inputs::ChargedProtein()
{
  return this->Read<vtkMacromoleculeReader>("molecules/1hew/1hew.pqr");
}

vtkAlgorithmOutput* Inputs::Peptide()
{
  return this->Read<vtkMacromoleculeReader>("molecules/1a1p.pdb");
}

vtkAlgorithmOutput* Inputs::PredictedResidue()
{
  return this->Keep<vtkMacromoleculeReader>("predicted residue",
    [&](vtkMacromoleculeReader* reader)
    {
      reader->SetFileName(
        this
          ->TextFile("predicted.cif",
            "data_gly\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
            "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
            "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
            "_atom_site.Cartn_z\n_atom_site.B_iso_or_equiv\n"
            "ATOM 1 N N GLY A 1 0 0 0 9\nATOM 2 C CA GLY A 1 1.46 0 0 9\n"
            "ATOM 3 C C GLY A 1 2 1.42 0 9\nATOM 4 O O GLY A 1 1.25 2.4 0 9\n"
            "loop_\n_ma_qa_metric.id\n_ma_qa_metric.mode\n_ma_qa_metric.name\n1 local pLDDT\n"
            "loop_\n_ma_qa_metric_local.label_asym_id\n_ma_qa_metric_local.label_comp_id\n"
            "_ma_qa_metric_local.label_seq_id\n_ma_qa_metric_local.metric_id\n"
            "_ma_qa_metric_local.metric_value\n_ma_qa_metric_local.model_id\n"
            "_ma_qa_metric_local.ordinal_id\nA GLY 1 1 91.25 1 1\n")
          .c_str());
    });
}

vtkAlgorithmOutput* Inputs::Crystal()
{
  return this->Keep<vtkMacromoleculeReader>("crystal",
    [&](vtkMacromoleculeReader* reader)
    {
      // Between neighbours on a cubic lattice of 5 angstrom.
      reader->SetFileName(
        this
          ->TextFile("crystal.cif",
            "data_crystal\n_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5.5\n"
            "_symmetry_space_group_name_H-M 'P 1'\nloop_\n_atom_site_label\n"
            "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
            "O1 0.5 0 0\nO2 0 0.5 0\nO3 0 0 0.5\n")
          .c_str());
    });
}

vtkAlgorithmOutput* Inputs::Channel()
{
  return this->Keep<vtkTrivialProducer>("channel",
    [&](vtkTrivialProducer* producer)
    {
      vtkNew<vtkMacromoleculeReader> reader;
      this->Observe(reader);
      reader->SetFileName(this->File("molecules/channels/1grm_hole_example.pdb").c_str());
      reader->Update();
      vtkNew<vtkPolyData> atoms;
      atoms->ShallowCopy(reader->GetOutput());
      // The program pdb2pqr does not know the residues of gramicidin.
      vtkNew<vtkDoubleArray> charges;
      charges->SetName("Charge");
      for (vtkIdType i = 0; i < atoms->GetNumberOfPoints(); ++i)
      {
        charges->InsertNextValue(i % 2 == 0 ? 0.1 : -0.1);
      }
      atoms->GetPointData()->AddArray(charges);
      producer->SetOutput(atoms);
    });
}

vtkAlgorithmOutput* Inputs::Models()
{
  return this->Keep<vtkMacromoleculeReader>("models",
    [&](vtkMacromoleculeReader* reader)
    {
      const std::string path = (this->WrittenFiles.Path() / "models.pdb").string();
      std::ofstream models(path);
      for (int model = 0; model < 5; ++model)
      {
        models << "MODEL     " << std::setw(4) << model + 1 << "\n";
        std::ifstream atoms(this->File("molecules/1hew.pdb"));
        for (std::string line; std::getline(atoms, line);)
        {
          if (line.compare(0, 6, "ATOM  ") == 0)
          {
            const double x = std::stod(line.substr(30, 8)) * (1.0 + 0.04 * model);
            models << line.substr(0, 30) << std::fixed << std::setprecision(3) << std::setw(8) << x
                   << line.substr(38) << "\n";
          }
        }
        models << "ENDMDL\n";
      }
      models << "END\n";
      reader->SetFileName(path.c_str());
    });
}

vtkAlgorithmOutput* Inputs::Fullerene()
{
  return this->Read<vtkMacromoleculeReader>("fullerenes/C60-Ih.xyz");
}

vtkAlgorithmOutput* Inputs::Potential()
{
  return this->Keep<vtkPoissonBoltzmann>("potential",
    [&](vtkPoissonBoltzmann* filter)
    {
      filter->SetInputConnection(this->ChargedProtein());
      filter->SetSpacing(1.0);
    });
}

vtkAlgorithmOutput* Inputs::PotentialSurface()
{
  return this->Keep<vtkSurfaceCurvature>("potential surface",
    [&](vtkSurfaceCurvature* filter)
    { filter->SetInputConnection(this->Potential()->GetProducer()->GetOutputPort(1)); });
}

vtkAlgorithmOutput* Inputs::PolarizedSurface()
{
  return this->Keep<vtkPolarizedCurvature>("polarized",
    [&](vtkPolarizedCurvature* filter)
    {
      filter->SetInputConnection(this->PotentialSurface());
      filter->SetPotentialConnection(this->Potential());
    });
}

vtkAlgorithmOutput* Inputs::FlowVolume()
{
  this->Keep<vtkMolecularFlowSurface>("flow surface",
    [&](vtkMolecularFlowSurface* filter)
    {
      filter->SetInputConnection(this->ChargedAtoms());
      filter->SetSpacing(1.0);
    });
  return this->Kept["flow surface"]->GetOutputPort(1);
}

}
