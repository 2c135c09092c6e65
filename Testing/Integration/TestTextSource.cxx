// Byte order marks: every text reader skips that of UTF-8, and explains what to do with UTF-16.
// Line ends: every text reader gives the same for LF, CR LF and CR.

#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "Files/TextWords.h"
#include "MoleculeTexts.h"
#include "SharedData.h"
#include "TemporaryFile.h"
#include "vtkCombinatorialMeshReader.h"
#include "vtkMEDITReader.h"
#include "vtkMSMSReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOpenDXReader.h"
#include "vtkTetGenMeshReader.h"
#include "vtkVolumeTextReader.h"

#include <vtkCommand.h>
#include <vtkDataSet.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

const std::string Mark = "\xef\xbb\xbf";

std::string UTF16(const std::string& text, bool isLittle, bool hasMark)
{
  std::string wide = !hasMark ? "" : (isLittle ? "\xff\xfe" : "\xfe\xff");
  for (const char c : text)
  {
    wide += isLittle ? std::string{ c, '\0' } : std::string{ '\0', c };
  }
  return wide;
}

/// Points, cells and error messages for a file.
struct Result
{
  vtkIdType Points = 0;
  vtkIdType Cells = 0;
  int CanRead = 0;
  std::string Complaint;

  bool operator==(const Result& other) const
  {
    return this->Points == other.Points && this->Cells == other.Cells &&
      this->CanRead == other.CanRead && this->Complaint == other.Complaint;
  }
};

template <typename Reader>
Result Read(const std::string& path)
{
  vtkNew<Reader> reader;
  vtkNew<vtkTest::ErrorObserver> observer, pipeline;
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->AddObserver(vtkCommand::WarningEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  Result result;
  result.CanRead = reader->CanReadFile(path.c_str());
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkDataSet* const data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  result.Points = data ? data->GetNumberOfPoints() : 0;
  result.Cells = data ? data->GetNumberOfCells() : 0;
  result.Complaint = observer->GetErrorMessage() + observer->GetWarningMessage();
  return result;
}

/// A file that a reader needs, and its content; the first one is opened.
struct Text
{
  std::function<Result(const std::string&)> Reader;
  std::vector<std::pair<std::string, std::string>> Files;
  vtkIdType Points;
};

const std::vector<Text>& Texts()
{
  const auto molecule = Read<vtkMacromoleculeReader>;
  static const std::vector<Text> texts{
    { molecule,
      { { "a.pdb",
        "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00           N\n"
        "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00  0.00           C\n" } },
      2 },
    { molecule,
      { { "a.pqr",
        "ATOM 1 N GLY A 1 0.000 0.000 0.000 0.0 1.5\nATOM 2 CA GLY A 1 1.450 0 0 0.0 1.7\n" } },
      2 },
    { molecule,
      { { "a.cif",
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.type_symbol\n_atom_site.Cartn_x\n"
        "_atom_site.Cartn_y\n_atom_site.Cartn_z\nN N 0 0 0\nC C 1.45 0 0\n" } },
      2 },
    { molecule, { { "a.xyz", "2\n\nN 0 0 0\nC 1.45 0 0\n" } }, 2 },
    { molecule,
      { { "a.gro",
        "a pair\n    2\n    1GLY      N    1   0.000   0.000   0.000\n"
        "    1GLY     CA    2   0.145   0.000   0.000\n   1.0   1.0   1.0\n" } },
      2 },
    { molecule,
      { { "a.mol2",
        "@<TRIPOS>MOLECULE\na\n 2 1\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n1 N1 0 0 0 N.3\n"
        "2 C1 1.45 0 0 C.3\n@<TRIPOS>BOND\n1 1 2 1\n" } },
      2 },
    { molecule,
      { { "a.sdf",
        "a\n  by hand\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n"
        "    0.0000    0.0000    0.0000 N   0  0\n    1.4500    0.0000    0.0000 C   0  0\n"
        "  1  2  1  0\nM  END\n$$$$\n" } },
      2 },
    { molecule,
      { { "a.pdbqt",
        "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00    -0.063 N \n"
        "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00  0.00     0.063 C \n" } },
      2 },
    { Read<vtkMEDITReader>,
      { { "a.mesh",
        "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 "
        "0\nTriangles\n1\n"
        "1 2 3 0\nEnd\n" } },
      3 },
    { Read<vtkOFFSurfaceReader>, { { "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n" } }, 3 },
    { Read<vtkTetGenMeshReader>,
      { { "a.ele", "1 4 0\n0 0 1 2 3\n" },
        { "a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n" } },
      4 },
    { Read<vtkMSMSReader>,
      { { "a.vert",
          "#vertices\n#vertex #sphere density probe_r\n3 1 1.00 1.50\n0 0 0 0 0 1 0 1 2\n"
          "1 0 0 0 0 1 0 1 2\n0 1 0 0 0 1 0 1 2\n" },
        { "a.face", "#faces\n#faces #sphere density probe_r\n1 1 1.00 1.50\n1 2 3 1 1\n" } },
      3 },
    { Read<vtkOpenDXReader>,
      { { "a.dx",
        "object 1 class gridpositions counts 2 1 1\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\n"
        "delta 0 0 1\nobject 2 class gridconnections counts 2 1 1\n"
        "object 3 class array type double rank 0 items 2 data follows\n1 2\n" } },
      2 },
    { Read<vtkVolumeTextReader>, { { "a.dat", "2 1 1\n0.5\n1.5\n" } }, 2 },
    { Read<vtkCombinatorialMeshReader>,
      { { "a.cmesh",
        "isthmus-combinatorial-mesh 1 text\ntypes 1\ntype 4 4 tetrahedron\n3 0 2 1\n3 0 1 3\n"
        "3 1 2 3\n3 2 0 3\nvertices 4 float32\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nblocks 1\nblock 0 1\n"
        "0 1 2 3\nattributes 0\nend\n" } },
      4 },
  };
  return texts;
}

/// Writes the files of `text` after `change` has modified them, and reads the first one.
Result Written(const Text& text, const std::function<std::string(const std::string&)>& change)
{
  const TemporaryFile file(change(text.Files[0].second), text.Files[0].first);
  for (std::size_t i = 1; i < text.Files.size(); ++i)
  {
    std::ofstream(
      std::filesystem::path(file.Path()).parent_path() / text.Files[i].first, std::ios::binary)
      << change(text.Files[i].second);
  }
  Result result = text.Reader(file.Path());
  return result;
}

}

TEST(TextSource, MarksOfUTF8AreSkipped)
{
  for (const Text& text : Texts())
  {
    const Result plain = Written(text, [](const std::string& s) { return s; });
    EXPECT_EQ(plain.Points, text.Points) << text.Files[0].first << plain.Complaint;
    EXPECT_EQ(plain.Complaint, "") << text.Files[0].first;
    EXPECT_EQ(Written(text, [](const std::string& s) { return Mark + s; }), plain)
      << text.Files[0].first;
    EXPECT_EQ(Written(text, [](const std::string& s) { return Gzip(Mark + s); }), plain)
      << text.Files[0].first;
    EXPECT_EQ(Written(text, [](const std::string& s) { return Bzip2(Mark + s); }), plain)
      << text.Files[0].first;
  }
}

TEST(TextSource, UTF16AndOtherCompressionsAreReported)
{
  const auto complaint = [](const std::string& bytes)
  {
    const TemporaryFile file(bytes, "text");
    try
    {
      OpenTextSource(file.Path());
    }
    catch (const ReaderError& refusal)
    {
      return std::string(refusal.what());
    }
    return std::string();
  };
  for (const std::string& wide : { std::string("a\0b\0", 4), std::string("\0a\0b", 4) })
  {
    EXPECT_NE(complaint(wide).find("iconv -f UTF-16"), std::string::npos) << complaint(wide);
  }
  EXPECT_EQ(complaint(std::string("a\0b", 3)), "");
  for (const std::string magic : { "\xfd"
                                   "7zX",
         "\x28\xb5\x2f\xfd" })
  {
    EXPECT_NE(complaint(magic + "and more").find("compress"), std::string::npos)
      << complaint(magic);
  }
}

TEST(TextSource, LinesAreCountedAcrossQuotesAndRemainders)
{
  const TemporaryFile file("a \"b\nc\" d # note\ne\nf", "text");
  const auto source = OpenByteSource(file.Path());
  TextWords words(*source);
  EXPECT_EQ(words.Word(), "a");
  EXPECT_EQ(words.Word(), "b\nc");
  EXPECT_EQ(words.RestOfLine(), " d ");
  EXPECT_EQ(words.RestOfLine(), "e");
  EXPECT_EQ(words.Word(), "f");
  try
  {
    words.Reject("enough.");
  }
  catch (const ReaderError& refusal)
  {
    EXPECT_NE(std::string(refusal.what()).find("4"), std::string::npos) << refusal.what();
  }
}

TEST(TextSource, UTF16IsNamed)
{
  for (const Text& text : Texts())
  {
    for (const bool isLittle : { false, true })
    {
      for (const bool hasMark : { false, true })
      {
        const Result wide =
          Written(text, [&](const std::string& s) { return UTF16(s, isLittle, hasMark); });
        EXPECT_EQ(wide.Points, 0) << text.Files[0].first;
        EXPECT_NE(wide.Complaint.find("iconv -f UTF-16"), std::string::npos)
          << text.Files[0].first << ": " << wide.Complaint;
      }
    }
  }
}

namespace
{

std::string WithLineEnds(const std::string& text, const std::string& end)
{
  std::string changed;
  for (const char c : text)
  {
    changed += c == '\n' ? end : std::string(1, c);
  }
  return changed;
}

}

TEST(TextSource, AllLineEndsAreTheSame)
{
  for (const Text& text : Texts())
  {
    const Result plain = Written(text, [](const std::string& s) { return s; });
    for (const std::string end : { "\r", "\r\n" })
    {
      const auto changed = [&](const std::string& s) { return WithLineEnds(s, end); };
      EXPECT_EQ(Written(text, changed), plain) << text.Files[0].first;
      EXPECT_EQ(Written(text, [&](const std::string& s) { return Mark + changed(s); }), plain)
        << text.Files[0].first;
      EXPECT_EQ(Written(text, [&](const std::string& s) { return Gzip(changed(s)); }), plain)
        << text.Files[0].first;
    }
  }
}

/// "1,5 0 0" was read as the point (1, 5, 0), and "0 0 1,5" as (0, 0, 1).
TEST(TextSource, DecimalCommasAreRefused)
{
  for (const std::string point : { "1.5 0 0", "0 0 -1.5", "0 1.25 0", "0.5 0.5 0.5",
         "0.5, 0.5, 0.5", "0.5\t1\t1.5", "1e3 2.5e-3 0" })
  {
    const std::vector<Text> texts{
      { Read<vtkOFFSurfaceReader>, { { "a.off", "OFF\n2 1 0\n0 0 0\n" + point + "\n2 0 1\n" } },
        2 },
      { Read<vtkOFFSurfaceReader>, { { "a.off", "OFF\n2 0 0\n0 0 0\n" + point } }, 2 },
      { Read<vtkMEDITReader>,
        { { "a.mesh",
          "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n" + point + " 7\nEnd\n" } },
        1 },
      { Read<vtkTetGenMeshReader>, { { "a.node", "1 3 0 0\n0 " + point + "\n" } }, 1 },
      { Read<vtkTetGenMeshReader>,
        { { "a.ele", "1 4 3\n0 0 1 2 3 " + point + "\n" },
          { "a.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n" } },
        4 },
      { Read<vtkOpenDXReader>,
        { { "a.dx",
          "object 1 class gridpositions counts 2 1 1\norigin " + point +
            "\ndelta 1 0 0\ndelta 0 1 0\ndelta 0 0 1\nobject 2 class gridconnections counts 2 1 "
            "1\nobject 3 class array type double rank 0 items 2 data follows\n1 2\n" } },
        2 },
      { Read<vtkOpenDXReader>,
        { { "a.dx",
          "object 1 class gridpositions counts 3 1 1\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\n"
          "delta 0 0 1\nobject 2 class gridconnections counts 3 1 1\n"
          "object 3 class array type double rank 0 items 3 data follows\n" +
            point + "\n" } },
        3 },
    };
    for (const Text& text : texts)
    {
      const Result plain = Written(text, [](const std::string& s) { return s; });
      EXPECT_EQ(plain.Points, text.Points) << text.Files[0].second;
      EXPECT_EQ(plain.Complaint, "") << text.Files[0].second;
      const auto comma = [](std::string s)
      {
        std::replace(s.begin(), s.end(), '.', ',');
        return s;
      };
      const Result changed = Written(text, comma);
      EXPECT_EQ(changed.Points, 0) << text.Files[0].second;
      const auto says = [&](const char* part)
      { return changed.Complaint.find(part) != std::string::npos; };
      EXPECT_TRUE(says("decimal comma") || says("there are more values than"))
        << text.Files[0].second << changed.Complaint;
    }
  }
}

/// The text is read in parts of 1 MiB and 3 KiB; the next is fetched where less than 1 KiB is left.
TEST(TextSource, DecimalCommasAreFoundAtTheBordersOfParts)
{
  const auto sumOf = [](const std::string& line, std::size_t at)
  {
    const std::string blanks(at - line.size() / 2, ' ');
    const TemporaryFile file(blanks + "\n" + line + "\n" + std::string(2000000, ' ') + "7", "text");
    const auto source = OpenByteSource(file.Path());
    TextWords words(*source);
    std::array<double, 5> all{};
    words.Numbers(all.data(), 5);
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  constexpr std::size_t border = (1 << 20) + (2 << 10);
  for (std::size_t at = border - 4; at <= border + 4; ++at)
  {
    EXPECT_EQ(sumOf("0 1,2,3", at), 13.0) << at;
    EXPECT_THROW(sumOf("2 0 1,5", at), ReaderError) << at;
  }
}

TEST(TextSource, ListsWithCommasAreRead)
{
  for (const std::string list : { "1,5,0", "1, 5, 0", "1 ,5 ,0", "1,5,0,", "1,\t5,\t0", "1 5 0 ",
         "1,-5,0", "1.5,2.5,3.5", "1e3,5,0" })
  {
    for (const std::string front : { "", "0 ", "0, ", "0 1 " })
    {
      const TemporaryFile file(
        "0 0\n" + front + list + "\r\n" + list + " 1\n7\n8,9\n" + list, "text");
      const auto source = OpenByteSource(file.Path());
      TextWords words(*source);
      std::vector<double> all(2 + front.size() / 2 + 3 + 4 + 1 + 2 + 3);
      EXPECT_NO_THROW(words.Numbers(all.data(), static_cast<std::int64_t>(all.size())))
        << front << list;
      EXPECT_EQ(all[all.size() - 5], 8.0) << front << list;
      EXPECT_EQ(words.Word(), "") << front << list;
    }
  }
  // Colours, too.
  const TemporaryFile file("COFF\n1,0,0\n1,2,3,0,128,255,255\n", "a.off");
  vtkNew<vtkOFFSurfaceReader> reader;
  reader->SetFileName(file.Path());
  reader->Update();
  vtkDataArray* const colours = reader->GetOutput()->GetPointData()->GetArray("Colors");
  ASSERT_TRUE(colours);
  EXPECT_EQ(colours->GetComponent(0, 0), 0.0);
  EXPECT_EQ(colours->GetComponent(0, 1), 128.0);
}

/// Seeks beyond the part that determines the line ends, between arbitrary positions.
TEST(TextSource, CarriageReturnsAreGivenAsNewlines)
{
  std::string lines;
  for (int i = 0; i < 30000; ++i)
  {
    lines += "line " + std::to_string(i) + "\n";
  }
  const std::string returns = WithLineEnds(lines, "\r");
  for (const std::string& bytes : { returns, Mark + returns, Gzip(returns), Bzip2(returns) })
  {
    const TemporaryFile file(bytes, "text");
    EXPECT_EQ(ReadAll(*OpenTextSource(file.Path())), lines);
    const auto source = OpenTextSource(file.Path());
    EXPECT_TRUE(source->ChangesLineEnds());
    std::string read(50000, '\0');
    ASSERT_EQ(source->Read(100000, read.data(), read.size()), read.size());
    EXPECT_EQ(read, lines.substr(100000, 50000));
  }
  // A newline anywhere in the first part: carriage returns are not converted.
  const TemporaryFile mixed("a\rb\r\n" + returns, "text");
  EXPECT_EQ(ReadAll(*OpenTextSource(mixed.Path())), "a\rb\r\n" + returns);
}

/// A tool that changes line ends also changes raw bytes, which must not be read as numbers.
TEST(TextSource, RawBytesAmongCarriageReturnsAreRefused)
{
  const std::vector<Text> texts{
    { Read<vtkOpenDXReader>,
      { { "a.dx",
        "object 1 class gridpositions counts 2 1 1\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\n"
        "delta 0 0 1\nobject 2 class gridconnections counts 2 1 1\n"
        "object 3 class array type float rank 0 items 2 lsb ieee data follows\nabcdefgh\n" } },
      2 },
    { Read<vtkCombinatorialMeshReader>,
      { { "a.cmesh",
        "isthmus-combinatorial-mesh 1 binary\ntypes 1\ntype 4 4 tetrahedron\n3 0 2 1\n3 0 1 3\n"
        "3 1 2 3\n3 2 0 3\nvertices 1 float32\nabcdefghijkl\nblocks 0\nattributes 0\nend\n" } },
      1 }
  };
  for (const Text& text : texts)
  {
    const Result plain = Written(text, [](const std::string& s) { return s; });
    EXPECT_EQ(plain.Points, text.Points) << plain.Complaint;
    const Result changed =
      Written(text, [](const std::string& s) { return WithLineEnds(s, "\r"); });
    EXPECT_EQ(changed.Points, 0);
    EXPECT_NE(changed.Complaint.find("changed to carriage returns"), std::string::npos)
      << changed.Complaint;
  }
}

TEST(TextSource, ReportedFile)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/b01_bom.pqr");
  const Macromolecule molecule =
    ReadMacromolecule((SharedDataFolder() / "reports/b01_bom.pqr").string(), MoleculeOptions());
  ASSERT_EQ(molecule.Atoms.size(), 2u);
  EXPECT_EQ(molecule.Atoms[0].Charge + molecule.Atoms[1].Charge, 0.0);
}

TEST(TextSource, IsTheContentAfterTheMark)
{
  std::string content(300000, ' ');
  for (std::size_t i = 0; i < content.size(); ++i)
  {
    content[i] = static_cast<char>('a' + i * i % 26);
  }
  for (const std::string& bytes :
    { content, Mark + content, Gzip(content), Gzip(Mark + content), Bzip2(Mark + content) })
  {
    const TemporaryFile file(bytes, "text");
    const auto source = OpenTextSource(file.Path());
    // Seeks between arbitrary positions, across the few buffered bytes, and back to the beginning.
    for (const auto& [offset, size] : std::vector<std::pair<std::size_t, std::size_t>>{
           { 0, 1 }, { 0, 7 }, { 1, 2 }, { 3, 100 }, { 299990, 10 }, { 0, 300000 }, { 2, 5 } })
    {
      std::string read(size, '\0');
      ASSERT_EQ(source->Read(offset, read.data(), size), size);
      EXPECT_EQ(read, content.substr(offset, size)) << offset;
    }
    std::string end(20, '\0');
    EXPECT_EQ(source->Read(content.size() - 5, end.data(), end.size()), 5u);
    EXPECT_EQ(source->CountUpTo(content.size() + 10, {}), content.size());
    EXPECT_EQ(source->CountUpTo(1000, {}), 1000u);
    EXPECT_EQ(ReadAll(*OpenTextSource(file.Path())), content);
  }
  // Files shorter than a mark.
  for (const std::string few : { "a", "ab", "abc" })
  {
    const TemporaryFile file(few, "few");
    EXPECT_EQ(ReadAll(*OpenTextSource(file.Path())), few);
    const TemporaryFile packed(Gzip(few), "few.gz");
    EXPECT_EQ(ReadAll(*OpenTextSource(packed.Path())), few);
  }
  EXPECT_FALSE(BeginsAsUTF16("ATOM") || BeginsAsUTF16("") || BeginsAsUTF16("A"));
}
