// A small file of each format, cut at every byte: an error and an empty output, the data of the
// whole file, or, for files that cannot be distinguished from whole ones, what the readers' headers
// state.

#include "TemporaryFile.h"
#include "vtkCombinatorialMeshReader.h"
#include "vtkMEDITReader.h"
#include "vtkMSMSReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOpenDXReader.h"
#include "vtkTetGenMeshReader.h"
#include "vtkVolumeTextReader.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using isthmus::testing::TemporaryFile;

namespace
{

/// The result of a reader for a file.
struct Outcome
{
  std::string Data; ///< points, cells and arrays as text
  std::string Error;
  std::string Warning;
};

std::string JoinText(vtkDataSet* data)
{
  std::ostringstream text;
  text.precision(17);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    text << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    vtkCell* const cell = data->GetCell(i);
    text << cell->GetCellType();
    for (int c = 0; c < static_cast<int>(cell->GetNumberOfPoints()); ++c)
    {
      text << " " << cell->GetPointId(c);
    }
    text << "\n";
  }
  for (vtkDataSetAttributes* arrays : { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* const array = arrays->GetAbstractArray(a);
      text << array->GetName() << ":";
      for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
      {
        text << " " << array->GetVariantValue(i).ToString();
      }
      text << "\n";
    }
  }
  return text.str();
}

template <typename Reader>
Outcome ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  vtkNew<vtkTest::ErrorObserver> observer, pipeline;
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->AddObserver(vtkCommand::WarningEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  reader->SetFileName(path.c_str());
  reader->Update();
  Outcome outcome{ JoinText(vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0))),
    observer->GetErrorMessage(), observer->GetWarningMessage() };
  EXPECT_EQ(outcome.Error.empty(),
    reader->GetErrorCode() == static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_TRUE(
    outcome.Error.empty() || outcome.Data.find_first_of("0123456789") == std::string::npos)
    << "an error and data: " << outcome.Error;
  return outcome;
}

/// Accepted results for truncated files other than an error or the complete data.
enum Allowed : unsigned
{
  Nothing = 0,
  LastNumber = 1, ///< without some digits of the last number
  Warned = 2,     ///< anything, with a warning
  Records = 4,    ///< shorter, of whole records
  Fields = 8      ///< where a field of PDB's columns ends: without values of the last record
};

struct Format
{
  std::string Name;
  std::string Text;
  std::function<Outcome(const std::string&)> Read;
  unsigned Allowed = Nothing;
  std::string Partner{}; ///< a file beside it
  std::string PartnerText{};
};

/// Where the last number that is read begins; the file may have text after it.
std::size_t FindLastNumber(const std::string& text, std::size_t end)
{
  return text.find_last_of(" \n\t", end - 1) + 1;
}

const std::string facesOfMSMS = "     1      2      3  1     11\n     1      2      4  1     12\n  "
                                "   2      3      4  1     12\n";
const std::string verticesOfMSMS =
  "    0.000     0.000     0.000     0.000     0.000     1.000       0       1  2\n"
  "    1.000     0.000     0.000     0.000     0.000     1.000       0       1  2\n"
  "    0.000     1.000     0.000     0.000     0.000     1.000       0       1  2\n"
  "    0.000     0.000     1.250     0.000     0.000     1.000      10      12  2\n";
const std::string headOfMSMS = "# MSMS solvent excluded surface\n#number #sphere density probe_r\n";
const std::string nodes = "4 3 1 1\n1 0 0 0 0.5 1\n2 10 0 0 1 1\n3 0 10 0 0.25 1\n4 0 0 10 2 12\n";

std::vector<Format> Formats()
{
  const auto molecule = ReadWith<vtkMacromoleculeReader>;
  const std::string atomsOfPDB =
    "ATOM      1  N   ALA A  11      11.104   6.134  -6.504  1.00 10.25           N  \n"
    "ATOM      2  CA  ALA A  11      11.639   6.071  -5.147  1.00 11.75           C  \n";
  const std::string zincOfPDB =
    "HETATM    3 ZN   ZN  A 142      18.325  12.125  10.125  0.50 12.50          ZN2+\n";
  const std::string headOfDX =
    "# potential\nobject 1 class gridpositions counts 2 1 2\norigin 0 0 0\ndelta 1 0 0\n"
    "delta 0 1 0\ndelta 0 0 1\nobject 2 class gridconnections counts 2 1 2\n"
    "object 3 class array type double rank 0 items 4 data follows\n";
  const std::string atomsOfMOL2 =
    "@<TRIPOS>MOLECULE\nx\n 3 2 0 0 0\nSMALL\nUSER_CHARGES\n\n@<TRIPOS>ATOM\n"
    "  1 C1 0.0 0.0 0.0 C.3 1 LIG -0.25\n  2 O1 1.4 0 0 O.3 1 LIG 0.125\n"
    "  3 O2 3.8 0 0 O.3 1 LIG 0.125\n";
  const std::string ions =
    "@<TRIPOS>MOLECULE\nx\n 2 0 0 0 0\nSMALL\nUSER_CHARGES\n\n@<TRIPOS>ATOM\n"
    "  1 C1 0.0 0.0 0.0 C.3 1 LIG -0.25\n  2 O1 1.4 0 0 O.3 1 LIG 0.125\n";
  const std::string cif =
    "data_x\n#\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
    "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
    "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
    "_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n_atom_site.pdbx_PDB_model_num\n"
    "ATOM 1 N N ALA A 11 11.104 6.134 -6.504 1.00 10.25 1\n"
    "ATOM 2 C CA ALA A 11 11.639 6.071 -5.147 1.00 11.75 1\n#\n";
  return {
    { "x.off",
      "OFF\n# a comment\n11 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 0\n6 0 0\n7 0 0\n8 0 0\n9 0 0\n"
      "10 0 0\n11 0.5 1.25\n3 0 1 2\n4 0 2 3 4\n3 0 2 10\n",
      ReadWith<vtkOFFSurfaceReader>, LastNumber },
    { "colours.off",
      "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0.5 0 0 1\n0 1 0 1 2 3 4\n3 0 1 2 10 20\n",
      ReadWith<vtkOFFSurfaceReader> },
    { "x.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 10.5 12\n"
      "Triangles\n1\n1 2 3 7\nCorners\n2\n1\n2\nTetrahedra\n1\n1 2 3 4 25\nEnd\n",
      ReadWith<vtkMEDITReader>, Warned },
    { "x.node", nodes, ReadWith<vtkTetGenMeshReader>, LastNumber },
    { "x.ele", "2 4 1\n1 1 2 3 4 0.25\n2 2 1 4 3 0.75\n", ReadWith<vtkTetGenMeshReader>, LastNumber,
      "x.node", nodes },
    { "x.face", "2 1\n1 1 2 3 10\n2 1 2 4 -11\n# Generated by tetgen\n",
      ReadWith<vtkTetGenMeshReader>, LastNumber, "x.node", nodes },
    { "nn.face", "1 1\n1 1 2 3 1 2 -1\n", ReadWith<vtkTetGenMeshReader>, Nothing, "nn.node",
      nodes },
    { "x.cmesh",
      "isthmus-combinatorial-mesh 1 text\ntypes 1\ntype 4 4 tetrahedron\n3 0 2 1\n3 0 1 3\n3 1 2 "
      "3\n"
      "3 2 0 3\nvertices 4 float32\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nblocks 1\nblock 0 1\n0 1 2 3\n"
      "attributes 1\nattribute cells uint8 1 Material\n10\nend\n",
      ReadWith<vtkCombinatorialMeshReader> },
    { "x.face", headOfMSMS + "3 4 1.00 1.50\n" + facesOfMSMS, ReadWith<vtkMSMSReader>, LastNumber,
      "x.vert", headOfMSMS + "4 4 1.00 1.50\n" + verticesOfMSMS },
    { "x.vert", headOfMSMS + "4 4 1.00 1.50\n" + verticesOfMSMS, ReadWith<vtkMSMSReader>, Nothing,
      "x.face", headOfMSMS + "3 4 1.00 1.50\n" + facesOfMSMS },
    { "bare.face", facesOfMSMS, ReadWith<vtkMSMSReader>, LastNumber | Records, "bare.vert",
      verticesOfMSMS },
    { "bare.vert", verticesOfMSMS, ReadWith<vtkMSMSReader>, Nothing, "bare.face", facesOfMSMS },
    { "x.dx", headOfDX + "1.5 2.25 10\n-12.5\n", ReadWith<vtkOpenDXReader>, LastNumber },
    { "field.dx",
      headOfDX +
        "1.5 2.25 10\n7\nattribute \"dep\" string \"positions\"\n"
        "object \"f\" class field\ncomponent \"positions\" value 1\n"
        "component \"connections\" value 2\ncomponent \"data\" value 3\n",
      ReadWith<vtkOpenDXReader> },
    { "x.dat", "2 2 1\n1.5 2.5\n3.5 -10.25\n", ReadWith<vtkVolumeTextReader>, LastNumber },
    { "x.mol2", atomsOfMOL2 + "@<TRIPOS>BOND\n 1 1 2 1\n 2 2 3 ar\n", molecule },
    { "ions.mol2", ions, molecule, LastNumber },
    { "x.gro",
      "title t= 0.0\n    2\n    1ALA      N    1   1.110   0.613  -0.650\n"
      "    1ALA     CA    2   1.210   0.663  -0.557\n   5.00000   5.00000   5.00000\n",
      molecule },
    { "x.sdf",
      "a\nb\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n    0.0000    0.0000    0.0000 C   0  0\n"
      "    1.5000    0.0000    0.0000 Cl  0  5\n  1  2  1  0\nM  CHG  2   1  10   2  -1\nM  END\n"
      "> <x>\n12\n\n$$$$\n",
      molecule, Warned },
    { "v3000.sdf",
      "a\nb\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\n"
      "M  V30 COUNTS 2 1 0 0 0\nM  V30 BEGIN ATOM\nM  V30 10 Zn 1.0 2.0 3.0 0 CHG=-2\n"
      "M  V30 20 Cl 4.0 2.0 3.0 0\nM  V30 END ATOM\nM  V30 BEGIN BOND\nM  V30 1 1 10 20\n"
      "M  V30 END BOND\nM  V30 END CTAB\nM  END\n$$$$\n",
      molecule },
    { "x.xyz", "2\na comment\nC 0 0 0\nO 1.25 0 10.75\n", molecule, LastNumber },
    { "extended.xyz",
      "2\nProperties=species:S:1:pos:R:3:q:R:1\nC 0 0 0 0.5\nO 1.25 0 10.75 -0.25\n", molecule,
      LastNumber },
    { "tinker.xyz", "3 t\n1 O 0 0 0 1 2 3\n2 H 1 0 0 2 1\n3 H 0 1.5 0 2 1\n", molecule },
    { "x.pdb", atomsOfPDB + zincOfPDB + "TER\nCONECT    1    2    3\nEND\n", molecule,
      Records | Fields },
    { "atoms.pdb", atomsOfPDB, molecule, Records | Fields },
    { "models.pdb",
      "MODEL        1\n" + atomsOfPDB + "ENDMDL\nMODEL        2\n" + atomsOfPDB + "ENDMDL\nEND\n",
      molecule, Records | Fields },
    { "x.pqr",
      "REMARK x\nATOM      1  N   ALA A  11      11.104   6.134  -6.504 -0.4157 1.8240\n"
      "ATOM      2  CA  ALA A  11      11.639   6.071  -5.147  0.0337 1.9080\nTER\nEND\n",
      molecule, Records | LastNumber },
    { "number.pqr",
      "ATOM 1 N ALA A 11 1.1 6.1 -6.5 0.25 1.75\nATOM 2 CA ALA 1 11 1.6 6.0 5.1 1.5 1.9\n",
      molecule, Records | LastNumber },
    { "x.pdbqt",
      "ROOT\nATOM      1  C   LIG A   2      14.607 -11.551  25.793  1.00  0.00     0.127 C \n"
      "ATOM      2  O   LIG A   2      15.607 -11.551  25.793  1.00  0.50    -0.127 OA\nENDROOT\n",
      molecule, Records },
    { "x.cif", cif, molecule, Records },
  };
}

/// Is `size` within a number that is the last one of its line, where the file may end?
bool IsWithinLastNumber(const std::string& text, std::size_t size)
{
  return size > FindLastNumber(text, size) &&
    text.find_first_of(" \n", size) == text.find('\n', size);
}

/// Whether a PDB file ends at the end of a field of an atom or a CONECT record: of the coordinates,
/// occupancy, B factor or element, or of a serial number.
bool IsAtEndOfField(const std::string& text)
{
  const std::string line = text.substr(text.find_last_of('\n') + 1);
  const std::vector<std::size_t> ends = line.rfind("CONECT", 0) == 0
    ? std::vector<std::size_t>{ 11, 16, 21, 26 }
    : std::vector<std::size_t>{ 54, 60, 66, 78 };
  return std::find(ends.begin(), ends.end(), line.size()) != ends.end();
}

}

TEST(TruncatedFiles, AreErrorsOrWholeOrAsDocumented)
{
  for (const Format& format : Formats())
  {
    SCOPED_TRACE(format.Name);
    const TemporaryFile place(format.Text, format.Name);
    const std::filesystem::path path = place.Path();
    if (!format.Partner.empty())
    {
      std::ofstream(path.parent_path() / format.Partner) << format.PartnerText;
    }
    const auto read = [&](const std::string& text)
    {
      std::ofstream(path, std::ios::binary) << text;
      return format.Read(path.string());
    };
    const bool mayBeHalf = (format.Allowed & LastNumber) != 0;
    const bool mayBeShorter = (format.Allowed & Records) != 0;
    const bool mayLackFields = (format.Allowed & Fields) != 0;
    const bool mayWarn = (format.Allowed & Warned) != 0;
    const Outcome whole = read(format.Text);
    ASSERT_EQ(whole.Error, "");
    ASSERT_EQ(whole.Warning, "");
    Outcome records; // from the whole lines before the cut
    std::size_t errors = 0, halves = 0, shorter = 0;
    for (std::size_t size = 1; size < format.Text.size(); ++size)
    {
      const std::string cut = format.Text.substr(0, size);
      const Outcome outcome = read(cut);
      if (!outcome.Error.empty())
      {
        ++errors;
      }
      else if (outcome.Data != whole.Data && !(mayWarn && !outcome.Warning.empty()))
      {
        const auto end = format.Text.find('\n', size - 1) + 1;
        const bool isShorter = mayBeShorter &&
          (outcome.Data == records.Data || outcome.Data == read(format.Text.substr(0, end)).Data);
        const bool isHalf = !isShorter && mayBeHalf && IsWithinLastNumber(format.Text, size);
        const bool isField = mayLackFields && IsAtEndOfField(cut);
        EXPECT_TRUE(isShorter || isHalf || isField)
          << "cut behind " << cut.substr(cut.find_last_of('\n') + 1) << ":\n"
          << outcome.Data;
        shorter += isShorter ? 1 : 0;
        halves += isHalf ? 1 : 0;
      }
      if (cut.back() == '\n')
      {
        records = outcome;
      }
    }
    EXPECT_GT(errors, 5u);
    EXPECT_EQ(halves > 0, mayBeHalf); // the statements of the headers are true
    EXPECT_EQ(shorter > 0, mayBeShorter);
  }
}
