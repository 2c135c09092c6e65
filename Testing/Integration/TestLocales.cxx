// Files, child processes and messages are the same in a host that writes numbers "1.234,5".
#include "GermanNumbers.h"
#include "SharedData.h"
#include "TemporaryFile.h"

#include "vtkCombinatorialMeshReader.h"
#include "vtkCombinatorialMeshWriter.h"
#include "vtkHighOrderDiffusion.h"
#include "vtkMEDITReader.h"
#include "vtkMEDITWriter.h"
#include "vtkMSMSReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkMapSurface.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOFFSurfaceWriter.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"
#include "vtkSurfaceMeasures.h"
#include "vtkTetGenMeshReader.h"
#include "vtkTetGenMeshWriter.h"
#include "vtkTetrahedralMesher.h"
#include "vtkVolumeTextReader.h"
#include "vtkVolumeTextWriter.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

using isthmus::testing::GermanNumbers;
using isthmus::testing::TemporaryFile;

namespace
{

/// More than a thousand points, so that their numbers would have separators.
vtkSmartPointer<vtkPolyData> Sphere(int resolution = 36)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(2.5);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> Grid()
{
  const auto sphere = Sphere();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(sphere->GetPoints());
  for (vtkIdType i = 0; i + 3 < sphere->GetNumberOfPoints(); ++i)
  {
    const std::array<vtkIdType, 4> corners{ i, i + 1, i + 2, i + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, corners.data());
  }
  return grid;
}

vtkSmartPointer<vtkImageData> Image(double sign = 1.0)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(12, 11, 10);
  image->SetSpacing(0.5, 0.75, 1.25);
  image->SetOrigin(-1.5, 1234.5, 0.25);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double x = static_cast<double>(i % 12) - 5.5, y = static_cast<double>(i / 12 % 11) - 5.0,
                 z = static_cast<double>(i / 132) - 4.5;
    values->SetValue(i, sign * (1234.5 * std::exp(-(x * x + y * y + z * z) / 6.0) + 0.125));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

std::string Content(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// All points and point values of the output of a reader or filter, bit by bit, and its messages.
template <typename Algorithm>
std::string FormatResult(Algorithm* algorithm)
{
  vtkNew<vtkTest::ErrorObserver> told;
  algorithm->AddObserver(vtkCommand::ErrorEvent, told);
  algorithm->AddObserver(vtkCommand::WarningEvent, told);
  algorithm->Update();
  auto* const data = vtkDataSet::SafeDownCast(algorithm->GetOutputDataObject(0));
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << told->GetErrorMessage() << told->GetWarningMessage() << data->GetNumberOfCells();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    text << " " << p[0] << " " << p[1] << " " << p[2];
    if (vtkDataArray* const values = data->GetPointData()->GetArray(0))
    {
      text << " " << values->GetComponent(i, 0);
    }
  }
  std::string result = text.str();
  // Messages begin with the address of their object.
  for (std::size_t at; (at = result.find("(0x")) != std::string::npos;)
  {
    result.erase(at, result.find(')', at) - at + 1);
  }
  return result;
}

/// The result of `make` must be the same without a locale and with the German one.
void ExpectSame(const std::function<std::string()>& make)
{
  const std::string wanted = make();
  ASSERT_FALSE(wanted.empty());
  const GermanNumbers german;
  ISTHMUS_NEEDS_GERMAN(german);
  EXPECT_EQ(make(), wanted);
}

/// The concatenated files of the writer, and the result of the reader for them.
template <typename Writer, typename Reader>
void ExpectSameFiles(
  vtkDataObject* input, const std::vector<std::string>& names,
  const std::function<void(Writer*)>& change = [](Writer*) {})
{
  ExpectSame(
    [&]
    {
      const TemporaryFile place("", names.front());
      const std::filesystem::path folder = std::filesystem::path(place.Path()).parent_path();
      vtkNew<Writer> writer;
      change(writer);
      writer->SetInputDataObject(input);
      writer->SetFileName(place.Path());
      EXPECT_EQ(writer->Write(), 1);
      std::string all;
      for (const std::string& name : names)
      {
        const std::string content = Content(folder / name);
        EXPECT_FALSE(content.empty());
        all += content;
      }
      vtkNew<Reader> reader;
      reader->SetFileName(place.Path());
      std::string read = FormatResult(reader.Get());
      for (std::size_t at; (at = read.find(folder.string())) != std::string::npos;)
      {
        read.erase(at, folder.string().size());
      }
      EXPECT_EQ(read.find("ERROR"), std::string::npos) << read.substr(0, 300);
      EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 1000);
      return all + read;
    });
}

TEST(Locales, TheTestSetsOne)
{
  const GermanNumbers german;
  ISTHMUS_NEEDS_GERMAN(german);
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f", 1.5);
  EXPECT_STREQ(text.data(), "1,5");
  std::ostringstream stream;
  stream << 12345;
  EXPECT_EQ(stream.str(), "12.345");
}

TEST(Locales, WritersAndReaders)
{
  using CMesh = vtkCombinatorialMeshWriter;
  ExpectSameFiles<vtkMEDITWriter, vtkMEDITReader>(Grid(), { "a.mesh" });
  ExpectSameFiles<vtkTetGenMeshWriter, vtkTetGenMeshReader>(Grid(), { "a.ele", "a.node" });
  ExpectSameFiles<vtkOFFSurfaceWriter, vtkOFFSurfaceReader>(Sphere(), { "a.off" });
  for (const bool binary : { false, true })
  {
    ExpectSameFiles<CMesh, vtkCombinatorialMeshReader>(
      Grid(), { "a.cmesh" }, [binary](CMesh* writer) { writer->SetBinary(binary); });
  }
  ExpectSameFiles<vtkVolumeTextWriter, vtkVolumeTextReader>(Image(), { "a.dat" });
  ExpectSameFiles<vtkOpenDXWriter, vtkOpenDXReader>(Image(), { "a.dx" });
}

TEST(Locales, ReadersOfMolecules)
{
  const std::vector<std::pair<const char*, const char*>> files{
    { "a.pdb", "ATOM      1  CA  SER A  10      27.340   0.500 -12.125  1.00 10.50           C\n" },
    { "a.pqr", "ATOM 1 CA SER 1 27.340 0.500 -12.125 0.25 1.75\n" },
    { "a.xyz", "1\n\nC 27.340 0.500 -12.125\n" },
    { "a.cif",
      "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
      "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.Cartn_x\n"
      "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.B_iso_or_equiv\n"
      "C CA SER A 27.340 0.500 -12.125 10.5\n" },
    { "b.cif",
      "data_a\n_cell_length_a 10.5\n_cell_length_b 11.5\n_cell_length_c 12.5\n"
      "_cell_angle_alpha 90.5\n_cell_angle_beta 100.5\n_cell_angle_gamma 95.5\nloop_\n"
      "_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
      "_atom_site_U_iso_or_equiv\nC1 0.125 0.5 0.75 0.05\n" },
  };
  for (const auto& [name, content] : files)
  {
    SCOPED_TRACE(name);
    const TemporaryFile file(content, name);
    ExpectSame(
      [&]
      {
        vtkNew<vtkMacromoleculeReader> reader;
        reader->SetFileName(file.Path());
        std::string result = FormatResult(reader.Get());
        EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 1) << result;
        return result;
      });
  }
}

TEST(Locales, SurfacesOfMSMS)
{
  const TemporaryFile vertices(
    "0.5 0 0 0 0 1 0 7 2\n1.5 0 0 0 0 1 3 8 1\n0 1.5 0 0 0 1 0 9 3\n", "a.vert");
  const std::string faces = std::filesystem::path(vertices.Path()).replace_extension(".face");
  std::ofstream(faces) << "1 2 3 1 12\n";
  ExpectSame(
    [&]
    {
      vtkNew<vtkMSMSReader> reader;
      reader->SetFileName(vertices.Path());
      std::string result = FormatResult(reader.Get());
      EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 1) << result;
      return result;
    });
}

/// TetGen reads its switches with a point: with "q1,5" it does not end, and "a2,5" is another size.
TEST(Locales, TetGen)
{
  if (std::system("command -v tetgen >/dev/null") != 0)
  {
    ASSERT_FALSE(isthmus::testing::SharedDataRequired()) << "tetgen is not installed.";
    GTEST_SKIP() << "tetgen is not installed.";
  }
  ExpectSame(
    []
    {
      vtkNew<vtkTetrahedralMesher> mesher;
      mesher->SetInputDataObject(Sphere(10));
      mesher->SetLibrary(vtkTetrahedralMesher::TetGen);
      mesher->SetRadiusEdgeRatio(1.5);
      mesher->SetMinimumDihedralAngle(12.5);
      mesher->SetMaximumVolume(0.25);
      mesher->SetTimeLimit(30.0);
      std::string result = FormatResult(mesher.Get());
      EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 100) << result.substr(0, 300);
      return result;
    });
}

TEST(Locales, Messages)
{
  // Errors of a parameter, a warning that a macro makes, and counts of more than a thousand.
  ExpectSame(
    []
    {
      vtkNew<vtkHighOrderDiffusion> filter;
      filter->SetInputDataObject(Image());
      filter->SetTime(-1.5);
      std::string said = FormatResult(filter.Get());
      EXPECT_NE(said.find("-1.5"), std::string::npos) << said;
      return said;
    });
  ExpectSame(
    []
    {
      vtkNew<vtkMapSurface> filter;
      filter->SetInputDataObject(Image(-1.0));
      std::string said = FormatResult(filter.Get());
      EXPECT_NE(said.find("(skewness -"), std::string::npos) << said;
      return said;
    });
  ExpectSame(
    []
    {
      vtkNew<vtkSurfaceMeasures> filter;
      const auto sphere = Sphere();
      vtkNew<vtkPolyData> separate; // triangles without neighbours
      vtkNew<vtkPoints> points;
      separate->SetPoints(points);
      separate->Allocate();
      for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
      {
        vtkIdType corners[3];
        for (int c = 0; c < 3; ++c)
        {
          const double* p = sphere->GetPoint(sphere->GetCell(cell)->GetPointId(c));
          corners[c] = points->InsertNextPoint(p[0] + 10.0 * static_cast<double>(cell), p[1], p[2]);
        }
        separate->InsertNextCell(VTK_TRIANGLE, 3, corners);
      }
      filter->SetInputDataObject(separate);
      std::string said = FormatResult(filter.Get());
      EXPECT_NE(said.find("not closed, so Volume is not a number: 7"), std::string::npos)
        << said.substr(0, 500);
      return said;
    });
}

/**
 * std::to_string of a floating point number and std::stod follow the locale; a text search cannot
 * see which to_string is called, but libstdc++ implements both by __to_xstring and __stoa.
 */
TEST(Locales, LibrariesAvoidLocaleDependentFormatting)
{
  // The tests link archives; the libraries lie in the build tree, and in that of one module not
  // all.
  const std::filesystem::path folder =
    std::filesystem::read_symlink("/proc/self/exe").parent_path() / "../../lib";
  if (!std::filesystem::exists(folder / "libvtkIsthmusFiltersCore.so") ||
    std::system("command -v nm >/dev/null") != 0)
  {
    GTEST_SKIP() << "needs shared libraries, and nm of binutils";
  }
  int looked = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    if (name.find("libvtkIsthmus") != 0 || entry.path().extension() != ".so")
    {
      continue;
    }
    ++looked;
    const std::string command = "nm -D -C '" + entry.path().string() + "'";
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    ASSERT_TRUE(pipe);
    std::string symbols;
    std::array<char, 4096> piece;
    for (std::size_t got; (got = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;)
    {
      symbols.append(piece.data(), got);
    }
    ::pclose(pipe);
    EXPECT_NE(symbols.find("isthmus"), std::string::npos) << name;
    for (const char* function : { "__gnu_cxx::__to_xstring", "__gnu_cxx::__stoa<double" })
    {
      EXPECT_EQ(symbols.find(function), std::string::npos)
        << name << " has " << function << ": use Core/NumberText.h";
    }
  }
  EXPECT_GT(looked, 10);
}

}
