// Readers and writers. Formats without a file in the shared data are written first.

#include "Cases.h"
#include "vtkCombinatorialMeshReader.h"
#include "vtkCombinatorialMeshWriter.h"
#include "vtkMEDITReader.h"
#include "vtkMEDITWriter.h"
#include "vtkMRCMapReader.h"
#include "vtkMSMSReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOFFSurfaceWriter.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"
#include "vtkTetGenMeshReader.h"
#include "vtkTetGenMeshWriter.h"
#include "vtkVolumeTextReader.h"
#include "vtkVolumeTextWriter.h"

#include <vtkAlgorithmOutput.h>

namespace isthmus::digests
{

namespace
{

template <typename Writer>
void AddWriter(Cases& cases, const std::string& variant, vtkAlgorithmOutput* (Inputs::*input)(),
  const std::string& file)
{
  const auto make = [input, file](Inputs& inputs)
  {
    auto writer = vtkSmartPointer<Writer>::New();
    writer->SetInputConnection((inputs.*input)());
    writer->SetFileName(inputs.NewFile(file).c_str());
    return vtkSmartPointer<vtkAlgorithm>(writer);
  };
  cases.push_back({ vtkNew<Writer>()->GetClassName(), variant, make });
}

template <typename Reader>
void AddReader(Cases& cases, const std::string& variant, const std::string& file)
{
  const auto make = [file](Inputs& inputs)
  {
    auto reader = vtkSmartPointer<Reader>::New();
    reader->SetFileName(inputs.File(file).c_str());
    return vtkSmartPointer<vtkAlgorithm>(reader);
  };
  cases.push_back({ vtkNew<Reader>()->GetClassName(), variant, make, TableOf<Reader>::Get() });
}

void AddImageFiles(Cases& cases)
{
  AddReader<vtkMRCMapReader>(cases, "", "maps/emd_1832.map");
  AddReader<vtkMRCMapReader>(cases, "big endian", "maps/pymol_web_map_bigendian.ccp4");
  AddReader<vtkMRCMapReader>(cases, "compressed", "maps/EMD-3001.map.bz2");
  AddReader<vtkMRCMapReader>(cases, "skewed", "maps/h2o-elf-nstart-skwtrn.ccp4");
  AddCase<vtkMRCMapReader>(cases, "skewed, cell axes",
    [](vtkMRCMapReader* reader, Inputs& inputs)
    {
      reader->SetFileName(inputs.File("maps/h2o-elf-nstart-skwtrn.ccp4").c_str());
      reader->SetNonOrthogonalCellToKeepCellAxes();
    });
  AddCase<vtkMRCMapReader>(cases, "cropped",
    [](vtkMRCMapReader* reader, Inputs& inputs)
    {
      reader->SetFileName(inputs.File("maps/emd_1832.map").c_str());
      reader->SetCropExtent(10, 40, 12, 42, 14, 44);
      reader->SetSampleRate(2, 2, 2);
    });
  AddReader<vtkMRCMapReader>(cases, "no data", "reports/k06_sentinel_m9999.mrc");
  AddReader<vtkMRCMapReader>(cases, "recommended level", "reports/emdb/emd_90001.map");
  AddReader<vtkOpenDXReader>(cases, "", "maps/dx/test.dx");
  AddReader<vtkOpenDXReader>(cases, "skewed", "maps/dx/mapskewed.dx");
  AddCase<vtkOpenDXReader>(cases, "named field",
    [](vtkOpenDXReader* reader, Inputs& inputs)
    {
      reader->SetFileName(
        inputs.Written<vtkOpenDXWriter>("distance.dx", inputs.Distance()).c_str());
    });
  AddWriter<vtkOpenDXWriter>(cases, "", &Inputs::Distance, "distance.dx");
  AddCase<vtkVolumeTextReader>(cases, "",
    [](vtkVolumeTextReader* reader, Inputs& inputs)
    {
      reader->SetFileName(
        inputs.Written<vtkVolumeTextWriter>("distance.dat", inputs.Distance()).c_str());
    });
  AddWriter<vtkVolumeTextWriter>(cases, "", &Inputs::Distance, "distance.dat");
}

void AddMeshFiles(Cases& cases)
{
  AddCase<vtkCombinatorialMeshReader>(cases, "",
    [](vtkCombinatorialMeshReader* reader, Inputs& inputs)
    {
      reader->SetFileName(
        inputs.Written<vtkCombinatorialMeshWriter>("mixed.cmesh", inputs.MixedCells()).c_str());
    });
  AddCase<vtkCombinatorialMeshReader>(cases, "polyhedra",
    [](vtkCombinatorialMeshReader* reader, Inputs& inputs)
    {
      reader->SetFileName(
        inputs.Written<vtkCombinatorialMeshWriter>("polyhedra.cmesh", inputs.Polyhedra()).c_str());
    });
  AddCase<vtkCombinatorialMeshReader>(cases, "tetrahedra",
    [](vtkCombinatorialMeshReader* reader, Inputs& inputs)
    {
      reader->SetFileName(
        inputs.Written<vtkCombinatorialMeshWriter>("cells.cmesh", inputs.Cells()).c_str());
    });
  AddWriter<vtkCombinatorialMeshWriter>(cases, "", &Inputs::MixedCells, "mixed.cmesh");
  AddCase<vtkCombinatorialMeshWriter>(cases, "text",
    [](vtkCombinatorialMeshWriter* writer, Inputs& inputs)
    {
      writer->SetInputConnection(inputs.MixedCells());
      writer->SetFileName(inputs.NewFile("mixed.cmesh").c_str());
      writer->BinaryOff();
    });
  AddReader<vtkMEDITReader>(cases, "", "volumes/octopus-low.mesh");
  AddReader<vtkMEDITReader>(cases, "hexahedra", "volumes/rockerarm_hex.mesh");
  AddReader<vtkMEDITReader>(cases, "tangled", "reports/n02f_tangled.mesh");
  AddWriter<vtkMEDITWriter>(cases, "", &Inputs::Cells, "cells.mesh");
  AddWriter<vtkMEDITWriter>(cases, "mixed", &Inputs::MixedCells, "mixed.mesh");
  AddReader<vtkMSMSReader>(cases, "", "surfaces/lysozyme_msms/Lys1.vert");
  AddReader<vtkOFFSurfaceReader>(cases, "", "surfaces/3holes.off");
  AddCase<vtkOFFSurfaceReader>(cases, "colors, normals",
    [](vtkOFFSurfaceReader* reader, Inputs& inputs)
    {
      reader->SetFileName(inputs
                            .TextFile("colors.off",
                              "CNOFF 3 1 0\n"
                              "0 0 0 0 0 1 255 0 0 255\n"
                              "1 0 0 0 0 1 0 255 0 255\n"
                              "0 1 0 0 0 1 0 0 255 255\n"
                              "3 0 1 2\n")
                            .c_str());
    });
  AddWriter<vtkOFFSurfaceWriter>(cases, "", &Inputs::MapSurface, "surface.off");
  AddReader<vtkTetGenMeshReader>(cases, "quadratic", "volumes/tetgen_one_tet10.ele");
  AddReader<vtkTetGenMeshReader>(cases, "faces", "reports/tetgen_o2/cube.1.face");
  AddCase<vtkTetGenMeshReader>(cases, "attributes, one inverted",
    [](vtkTetGenMeshReader* reader, Inputs& inputs)
    {
      inputs.TextFile("inverted.node",
        "6 3 1 1\n"
        "0  0 0 0  0.5 1\n"
        "1  1 0 0  0.5 1\n"
        "2  0 1 0  0.5 1\n"
        "3  0 0 3  0.5 1\n"
        "4  1 1 1  0.5 0\n"
        "5  0 0 -1  0.5 1\n");
      reader->SetFileName(inputs
                            .TextFile("inverted.ele",
                              "3 4 1\n"
                              "0  0 1 2 3  7\n"
                              "1  1 4 2 3  7\n"
                              "2  0 1 2 5  8\n")
                            .c_str());
    });
  AddCase<vtkTetGenMeshReader>(cases, "",
    [](vtkTetGenMeshReader* reader, Inputs& inputs) {
      reader->SetFileName(inputs.Written<vtkTetGenMeshWriter>("cells.ele", inputs.Cells()).c_str());
    });
  AddWriter<vtkTetGenMeshWriter>(cases, "", &Inputs::Cells, "cells.ele");
}

}

void AddReaders(Cases& cases)
{
  AddImageFiles(cases);
  AddMeshFiles(cases);
  AddReader<vtkMacromoleculeReader>(cases, "PDB", "molecules/1hew.pdb");
  AddReader<vtkMacromoleculeReader>(
    cases, "XYZ, models", "fullerenes/trajectories/C20_000000001opt.xyz");
  AddReader<vtkMacromoleculeReader>(cases, "mmCIF", "molecules/1FAS.cif");
  AddReader<vtkMacromoleculeReader>(cases, "PQR", "molecules/1crn_apbs.pqr");
  AddReader<vtkMacromoleculeReader>(cases, "GRO", "reports/m01c_whole.gro");
  AddReader<vtkMacromoleculeReader>(cases, "PDBQT", "reports/pdbqt_inputpdbqt.pdbqt");
  AddReader<vtkMacromoleculeReader>(cases, "XYZ", "fullerenes/C60-Ih.xyz");
  AddCase<vtkMacromoleculeReader>(cases, "mmCIF, predicted",
    [](vtkMacromoleculeReader* reader, Inputs& inputs)
    {
      auto* const same =
        vtkMacromoleculeReader::SafeDownCast(inputs.PredictedResidue()->GetProducer());
      reader->SetFileName(same->GetFileName());
    });
  AddCase<vtkMacromoleculeReader>(cases, "PDB, alternate locations",
    [](vtkMacromoleculeReader* reader, Inputs& inputs)
    {
      reader->SetAltLoc("*");
      reader->SetFileName(
        inputs
          .TextFile("alternate.pdb",
            "ATOM      1  N   ALA A  10A      0.000   0.000   0.000  1.00 10.00           N\n"
            "ATOM      2  CA AALA A  10A      1.450   0.000   0.000  0.60 10.00           C\n"
            "ATOM      3  CA BALA A  10A      1.450   0.300   0.000  0.40 10.00           C\n"
            "END\n")
          .c_str());
    });
}

}
