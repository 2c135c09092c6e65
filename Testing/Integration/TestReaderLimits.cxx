// Files other than valid ones that readers encounter: folders, pipes, files cut short, highly
// compressed, replaced while being read, and bytes that are not text. Each gives an error message.

#include "vtkCombinatorialMeshReader.h"
#include "vtkMRCMapReader.h"
#include "vtkMSMSReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkOpenDXReader.h"

#include "Core/ChildProcess.h"
#include "Core/PrintableText.h"
#include "Files/ReaderError.h"
#include "MRCTestFile.h"
#include "Meshes/MSMSReader.h"
#include "TemporaryFile.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>

using namespace isthmus::testing;

namespace
{

/// The reader's message for `path`, and its error code.
template <typename Reader>
std::pair<std::string, unsigned long> Complaint(const std::string& path)
{
  vtkNew<Reader> reader;
  vtkNew<vtkTest::ErrorObserver> observer, pipeline;
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->AddObserver(vtkCommand::WarningEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  reader->CanReadFile(path.c_str());
  reader->SetFileName(path.c_str());
  reader->Update();
  return { observer->GetErrorMessage(), reader->GetErrorCode() };
}

/// One folder for all tests of this process.
const std::filesystem::path& Folder()
{
  static const isthmus::TemporaryFolder folder;
  return folder.Path();
}

/// A pair of MSMS files with `faces` of four, whose first line states four.
std::filesystem::path MSMSPair(int vertices, int faces)
{
  const auto stem = Folder() / "cut";
  std::ofstream v(stem.string() + ".vert"), f(stem.string() + ".face");
  v << "# MSMS solvent excluded surface vertices\n#vertex #sphere density probe_r\n"
    << "4 4 1.00 1.50\n";
  for (int i = 0; i < vertices; ++i)
  {
    v << (i == 1) << " " << (i == 2) << " " << (i == 3) << " 0 0 1 0 1 2\n";
  }
  f << "# MSMS solvent excluded surface faces\n#faces #sphere density probe_r\n4 4 1.00 1.50\n";
  const char* rows[] = { "1 3 2 1 1\n", "1 2 4 1 1\n", "2 3 4 1 1\n", "1 4 3 1 1\n" };
  for (int i = 0; i < faces; ++i)
  {
    f << rows[i];
  }
  return stem.string() + ".vert";
}

std::string OpenDX(const std::string& type, const std::string& values)
{
  return "object 1 class gridpositions counts 2 1 1\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\n"
         "delta 0 0 1\nobject 2 class gridconnections counts 2 1 1\n"
         "object 3 class array type " +
    type + values;
}

}

TEST(ReaderLimits, PipesAreRefusedWithoutWaiting)
{
  for (const char* name :
    { "pipe.cmesh", "pipe.vert", "pipe.face", "pipe.pdb", "pipe.dx", "pipe.mrc" })
  {
    const std::string path = Folder() / name;
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  }
  const std::string stem = Folder() / "pipe";
  EXPECT_NE(Complaint<vtkCombinatorialMeshReader>(stem + ".cmesh").first.find("not a regular file"),
    std::string::npos);
  EXPECT_NE(
    Complaint<vtkMSMSReader>(stem + ".vert").first.find("not a regular file"), std::string::npos);
  EXPECT_NE(
    Complaint<vtkMSMSReader>(stem + ".face").first.find("not a regular file"), std::string::npos);
  EXPECT_NE(Complaint<vtkMacromoleculeReader>(stem + ".pdb").first.find("not a regular file"),
    std::string::npos);
  EXPECT_NE(
    Complaint<vtkOpenDXReader>(stem + ".dx").first.find("not a regular file"), std::string::npos);
  EXPECT_NE(
    Complaint<vtkMRCMapReader>(stem + ".mrc").first.find("not a regular file"), std::string::npos);
}

TEST(ReaderLimits, FoldersAreReportedAsFolders)
{
  for (const char* name : { "folder.cmesh", "folder.vert", "folder.pqr" })
  {
    std::filesystem::create_directories(Folder() / name);
  }
  const std::string stem = Folder() / "folder";
  EXPECT_NE(Complaint<vtkCombinatorialMeshReader>(stem + ".cmesh").first.find("this is a folder"),
    std::string::npos);
  EXPECT_NE(
    Complaint<vtkMSMSReader>(stem + ".vert").first.find("this is a folder"), std::string::npos);
  EXPECT_NE(Complaint<vtkMacromoleculeReader>(stem + ".pqr").first.find("this is a folder"),
    std::string::npos);
}

/// ParaView queries the readers for a file name one after another, and then offers those that do
/// not examine files: in ParaView 5.11, one of them never returns for an empty file, and GDAL's
/// waits for pipes.
TEST(ReaderLimits, EmptyFilesAreJudgedByTheirName)
{
  const std::string empty = Folder() / "empty.any";
  std::ofstream(empty).flush();
  const std::string folder = Folder() / "folder.any";
  std::filesystem::create_directories(folder);
  const std::string pipe = Folder() / "pipe.any";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string other = Folder() / "other.any";
  std::ofstream(other) << "of another format\n";
  const auto expect = [&](auto reader, const char* name)
  {
    for (const std::string& path : { empty, folder, pipe })
    {
      EXPECT_EQ(reader->CanReadFile(path.c_str()), 1) << name << " " << path;
    }
    EXPECT_EQ(reader->CanReadFile(other.c_str()), 0) << name;
    EXPECT_EQ(reader->CanReadFile((other + ".missing").c_str()), 0) << name;
    EXPECT_EQ(reader->CanReadFile(nullptr), 0) << name;
  };
  expect(vtkSmartPointer<vtkCombinatorialMeshReader>::New(), "cmesh");
  expect(vtkSmartPointer<vtkMSMSReader>::New(), "MSMS");
  expect(vtkSmartPointer<vtkMacromoleculeReader>::New(), "molecule");
  expect(vtkSmartPointer<vtkOpenDXReader>::New(), "OpenDX");
  expect(vtkSmartPointer<vtkMRCMapReader>::New(), "map");
}

TEST(ReaderLimits, MSMSCountsMustMatchTheHeader)
{
  EXPECT_EQ(Complaint<vtkMSMSReader>(MSMSPair(4, 4)).first, "");
  const auto [faces, code] = Complaint<vtkMSMSReader>(MSMSPair(4, 3));
  EXPECT_NE(faces.find("states 4 faces, but there are 3"), std::string::npos) << faces;
  EXPECT_EQ(code, static_cast<unsigned long>(vtkErrorCode::PrematureEndOfFileError));
  const auto vertices = Complaint<vtkMSMSReader>(MSMSPair(3, 4)).first;
  EXPECT_NE(vertices.find("states 4 vertices, but there are 3"), std::string::npos) << vertices;
}

TEST(ReaderLimits, DecompressionBombsAreRefusedEarly)
{
  const TemporaryFile newlines(Gzip(std::string(100'000'000, '\n')), "newlines.cif.gz");
  EXPECT_NE(
    Complaint<vtkMacromoleculeReader>(newlines.Path()).first.find("decompress to more than"),
    std::string::npos);
  const std::string line =
    "ATOM      1  N   ALA A   1      11.104   6.134  -6.504  1.00  0.00           N  \n";
  std::string many;
  for (int i = 0; i < 900'000; ++i)
  {
    many += line;
  }
  const TemporaryFile lines(Gzip(many), "lines.pdb.gz");
  EXPECT_NE(Complaint<vtkMacromoleculeReader>(lines.Path()).first.find("decompress to more than"),
    std::string::npos);
  // A small file may be arbitrarily compressible.
  const TemporaryFile few(Gzip(many.substr(0, 1000 * line.size())), "few.pdb.gz");
  EXPECT_EQ(Complaint<vtkMacromoleculeReader>(few.Path()).first, "");
}

TEST(ReaderLimits, OpenDXUnsignedIntegersHaveNoSign)
{
  const std::uint32_t values[] = { 4294967295u, 7u };
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), values, 8);
  const TemporaryFile file(
    OpenDX("unsigned int rank 0 items 2 lsb ieee data follows\n", bytes + "\n"), "unsigned.dx");
  vtkNew<vtkOpenDXReader> reader;
  reader->SetFileName(file.Path());
  reader->Update();
  vtkDataArray* array = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetComponent(0, 0), 4294967295.0);
  EXPECT_EQ(array->GetComponent(1, 0), 7.0);
}

TEST(ReaderLimits, OpenDXGridsThatDoNotMatchTheArrayAreReported)
{
  const std::string two = "object 1 class gridpositions counts 2 1 1\norigin 0 0 0\ndelta 1 0 0\n"
                          "delta 0 1 0\ndelta 0 0 1\n"
                          "object 5 class gridpositions counts 2 1 1\norigin 9 9 9\ndelta 3 0 0\n"
                          "delta 0 3 0\ndelta 0 0 3\n"
                          "object 3 class array type float rank 0 items 2 data follows\n1 2\n";
  const auto field = [](const char* grid)
  {
    return std::string("object \"f\" class field\ncomponent \"positions\" value ") + grid +
      "\ncomponent \"data\" value 3\n";
  };
  const TemporaryFile wrong(two + field("1"), "wrong.dx");
  EXPECT_NE(
    Complaint<vtkOpenDXReader>(wrong.Path()).first.find("lies on the grid 1"), std::string::npos);
  const TemporaryFile right(two + field("5"), "right.dx");
  EXPECT_EQ(Complaint<vtkOpenDXReader>(right.Path()).first, "");
}

TEST(ReaderLimits, AMapThatWasReplacedIsNotShownInTheOldGeometry)
{
  const auto map = [](int side)
  {
    MRCTestFile file({ side, side, side }, 2);
    file.SetFloats(11, { 8.0f, 8.0f, 8.0f });
    return file;
  };
  const std::string path = Folder() / "replaced.mrc";
  const auto write = [&path](const std::string& bytes)
  { std::ofstream(path, std::ios::binary) << bytes; };
  const auto bytes = [&map](int side)
  {
    auto file = map(side);
    const auto values = static_cast<std::size_t>(side * side * side);
    return file.Bytes() + std::string(4 * values, '\0');
  };
  write(bytes(4));
  vtkNew<vtkMRCMapReader> reader;
  vtkNew<vtkTest::ErrorObserver> observer, pipeline;
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->AddObserver(vtkCommand::WarningEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  write(bytes(8));
  reader->Update();
  EXPECT_NE(observer->GetErrorMessage().find("has changed"), std::string::npos);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ReaderLimits, MessagesAreValidTextForAnyFile)
{
  EXPECT_EQ(isthmus::Printable("a\xff\x01z"), "a??z");
  EXPECT_EQ(isthmus::Printable("\xc3\xa5ngstr\xc3\xb6m\n"), "\xc3\xa5ngstr\xc3\xb6m\n");
  EXPECT_EQ(isthmus::Printable("\xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80"), "?? ??? ????");
  EXPECT_EQ(isthmus::Printable("cut \xe2\x82"), "cut ??");
  const TemporaryFile file("object \xff\xfe\x80 is no class", "bytes.dx");
  const std::string sentence = Complaint<vtkOpenDXReader>(file.Path()).first;
  EXPECT_NE(sentence, "");
  EXPECT_EQ(sentence.find('\xff'), std::string::npos);
  EXPECT_EQ(sentence.find('\x80'), std::string::npos);
}
