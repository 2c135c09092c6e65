// An existing file survives if a writer cannot complete its replacement.
#include "Files/TextFileWriter.h"
#include "TemporaryFile.h"
#include "vtkCombinatorialMeshWriter.h"
#include "vtkMEDITReader.h"
#include "vtkMEDITWriter.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOFFSurfaceWriter.h"
#include "vtkOpenDXReader.h"
#include "vtkOpenDXWriter.h"
#include "vtkTetGenMeshWriter.h"
#include "vtkVolumeTextWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using isthmus::testing::TemporaryFile;

namespace
{

constexpr int Resolution = 60; // about 3,500 points: all files are larger than the limit

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(Resolution);
  source->SetPhiResolution(Resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> Grid(int cellType, int corners)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(Sphere()->GetPoints());
  for (vtkIdType i = 0; i + 3 < grid->GetNumberOfPoints(); ++i)
  {
    const std::array<vtkIdType, 4> ids{ i, i + 1, i + 2, i + 3 };
    grid->InsertNextCell(cellType, corners, ids.data());
  }
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra()
{
  return Grid(VTK_TETRA, 4);
}

vtkSmartPointer<vtkImageData> Image()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(30, 20, 10);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, std::sin(static_cast<double>(i)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

using Files = std::map<std::string, std::string>;

/// Names and contents of all files of a folder.
Files In(const std::filesystem::path& folder)
{
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    std::ifstream file(entry.path(), std::ios::binary);
    files[entry.path().filename().string()] =
      std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return files;
}

/// A writer's message, and whether it wrote.
struct Outcome
{
  int Returned = 0;
  bool Error = false;
  std::string Message;
};

using Prepare = std::function<void(vtkAlgorithm*)>;

template <typename Writer>
Outcome WriteTo(
  const std::string& path, vtkDataObject* input, const Prepare& prepare = [](vtkAlgorithm*) {})
{
  vtkNew<Writer> writer;
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputDataObject(input);
  writer->SetFileName(path.c_str());
  prepare(writer);
  Outcome outcome;
  outcome.Returned = writer->Write();
  outcome.Error = writer->GetErrorCode() != static_cast<unsigned long>(vtkErrorCode::NoError);
  outcome.Message = observer->GetErrorMessage();
  return outcome;
}

Prepare AsText()
{
  return [](vtkAlgorithm* writer)
  { vtkCombinatorialMeshWriter::SafeDownCast(writer)->SetBinary(false); };
}

/// Each writer, the file name that it is given, and all files that it writes.
struct Trial
{
  std::function<Outcome(const std::string&, const Prepare&)> Write;
  std::string Name;
  std::vector<std::string> Written;
};

template <typename Writer>
std::function<Outcome(const std::string&, const Prepare&)> With(vtkSmartPointer<vtkDataObject> data)
{
  return [data](const std::string& path, const Prepare& prepare)
  { return WriteTo<Writer>(path, data, prepare); };
}

std::vector<Trial> Trials()
{
  const auto mesh = With<vtkCombinatorialMeshWriter>(Tetrahedra());
  return {
    { With<vtkOFFSurfaceWriter>(Sphere()), "a.off", { "a.off" } },
    { With<vtkOFFSurfaceWriter>(Sphere()), "a.off.gz", { "a.off.gz" } },
    { With<vtkMEDITWriter>(Tetrahedra()), "a.mesh", { "a.mesh" } },
    { With<vtkTetGenMeshWriter>(Tetrahedra()), "a.ele", { "a.ele", "a.node" } },
    { With<vtkTetGenMeshWriter>(Grid(VTK_TRIANGLE, 3)), "a.face", { "a.face", "a.node" } },
    { mesh, "a.cmesh", { "a.cmesh" } },
    { [mesh](const std::string& path, const Prepare& prepare)
      {
        return mesh(path,
          [&](vtkAlgorithm* writer)
          {
            AsText()(writer);
            prepare(writer);
          });
      },
      "b.cmesh", { "b.cmesh" } },
    { With<vtkVolumeTextWriter>(Image()), "a.dat", { "a.dat" } },
    { With<vtkOpenDXWriter>(Image()), "a.dx", { "a.dx" } },
  };
}

/// No file may grow beyond `bytes` while this object exists: writes fail as on a full disk.
class FileLimit
{
public:
  explicit FileLimit(rlim_t bytes)
    : OldAction(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &this->Old);
    const rlimit limit{ bytes, this->Old.rlim_max };
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit()
  {
    setrlimit(RLIMIT_FSIZE, &this->Old);
    std::signal(SIGXFSZ, this->OldAction);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

private:
  rlimit Old{};
  void (*OldAction)(int);
};

/// Root may write anywhere, so the process acts as another user while this object exists.
class OrdinaryUser
{
public:
  OrdinaryUser()
    : WasRoot(geteuid() == 0 && seteuid(65534) == 0)
  {
  }
  ~OrdinaryUser()
  {
    if (this->WasRoot)
    {
      EXPECT_EQ(seteuid(0), 0);
    }
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;

private:
  bool WasRoot;
};

/// A folder with a file of each name that a trial writes, and a file that it must not change.
class OldFiles
{
public:
  explicit OldFiles(const Trial& trial)
    : Place("not to be touched", "other")
  {
    for (const std::string& name : trial.Written)
    {
      std::ofstream(this->Folder() / name) << "the old " << name << "\n";
    }
    this->Before = In(this->Folder());
  }

  std::filesystem::path Folder() const
  {
    return std::filesystem::path(this->Place.Path()).parent_path();
  }
  std::string Path(const std::string& name) const { return (this->Folder() / name).string(); }
  void ExpectUnchanged(const std::string& what) const
  {
    const Files now = In(this->Folder());
    EXPECT_EQ(now.size(), this->Before.size()) << what;
    for (const auto& [name, content] : this->Before)
    {
      EXPECT_TRUE(now.count(name) == 1 && now.at(name) == content) << what << ": " << name;
    }
  }

private:
  TemporaryFile Place;
  Files Before;
};

void ExpectFailure(const Outcome& outcome, const std::string& name)
{
  EXPECT_EQ(outcome.Returned, 0) << name;
  EXPECT_TRUE(outcome.Error) << name;
  EXPECT_NE(outcome.Message.find("can't be written to its end"), std::string::npos)
    << name << ": " << outcome.Message;
}

const Prepare Plain = [](vtkAlgorithm*) {};

}

TEST(FileReplacement, WholeFilesReplaceOldOnes)
{
  for (const Trial& trial : Trials())
  {
    const OldFiles files(trial);
    const Outcome outcome = trial.Write(files.Path(trial.Name), Plain);
    EXPECT_EQ(outcome.Returned, 1) << trial.Name << outcome.Message;
    EXPECT_FALSE(outcome.Error) << trial.Name;
    const Files now = In(files.Folder());
    EXPECT_EQ(now.size(), trial.Written.size() + 1) << trial.Name;
    for (const std::string& name : trial.Written)
    {
      EXPECT_GT(now.at(name).size(), 9000u) << name; // beyond the limits below
    }
  }
}

TEST(FileReplacement, OldFilesSurviveAFullDisk)
{
  // With the second limit the head of a file can be written; with the first, nothing can.
  for (const rlim_t bytes : { 0, 8192 })
  {
    for (const Trial& trial : Trials())
    {
      const OldFiles files(trial);
      Outcome outcome;
      {
        const FileLimit limit(bytes);
        outcome = trial.Write(files.Path(trial.Name), Plain);
      }
      ExpectFailure(outcome, trial.Name);
      files.ExpectUnchanged(trial.Name);
    }
  }
}

/// A failed upstream filter provides no points: the old file was replaced by an empty one.
TEST(FileReplacement, OldFilesSurviveAFailureOfTheFilterBefore)
{
  std::vector<Trial> trials = Trials();
  trials.push_back({ With<vtkTetGenMeshWriter>(Tetrahedra()), "a.node", { "a.node" } });
  for (const Trial& trial : trials)
  {
    const OldFiles files(trial);
    const std::string missing = files.Path("missing");
    vtkNew<vtkOFFSurfaceReader> surface;
    surface->SetFileName((missing + ".off").c_str());
    vtkNew<vtkMEDITReader> mesh;
    mesh->SetFileName((missing + ".mesh").c_str());
    vtkNew<vtkOpenDXReader> image;
    image->SetFileName((missing + ".dx").c_str());
    const auto is = [&](const char* end) { return trial.Name.find(end) != std::string::npos; };
    vtkAlgorithm* before = mesh;
    if (is(".off"))
    {
      before = surface;
    }
    else if (is(".d"))
    {
      before = image;
    }
    vtkNew<vtkTest::ErrorObserver> observer;
    before->AddObserver(vtkCommand::ErrorEvent, observer);
    const Outcome outcome = trial.Write(files.Path(trial.Name),
      [&](vtkAlgorithm* writer) { writer->SetInputConnection(before->GetOutputPort()); });
    EXPECT_TRUE(observer->GetError()) << trial.Name;
    EXPECT_EQ(outcome.Returned, 0) << trial.Name;
    EXPECT_TRUE(outcome.Error) << trial.Name;
    EXPECT_NE(outcome.Message, "") << trial.Name;
    files.ExpectUnchanged(trial.Name);
  }
}

/// Points and cells belong together: the old points are kept if there is no space for the new
/// cells.
TEST(FileReplacement, FilesOfOneMeshAreReplacedTogether)
{
  const Trial trial{ With<vtkTetGenMeshWriter>(Tetrahedra()), "a.ele", { "a.ele", "a.node" } };
  std::uintmax_t nodes = 0;
  {
    const OldFiles files(trial);
    trial.Write(files.Path(trial.Name), Plain);
    nodes = std::filesystem::file_size(files.Folder() / "a.node");
    ASSERT_NE(nodes, std::filesystem::file_size(files.Folder() / "a.ele"));
  }
  // Many cells with middle nodes: their file is larger than that of the points.
  vtkNew<vtkUnstructuredGrid> quadratic;
  quadratic->SetPoints(Sphere()->GetPoints());
  for (vtkIdType i = 0; i + 9 < quadratic->GetNumberOfPoints(); ++i)
  {
    std::array<vtkIdType, 10> ids{};
    for (std::size_t c = 0; c < ids.size(); ++c)
    {
      ids[c] = i + static_cast<vtkIdType>(c);
    }
    quadratic->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids.data());
    quadratic->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids.data());
  }
  const OldFiles files(trial);
  Outcome outcome;
  {
    const FileLimit limit(nodes + 100);
    outcome = WriteTo<vtkTetGenMeshWriter>(files.Path("a.ele"), quadratic);
  }
  ExpectFailure(outcome, "a.ele");
  files.ExpectUnchanged("a.ele");
}

TEST(FileReplacement, OldFilesSurviveWhereWritingIsForbidden)
{
  for (const Trial& trial : Trials())
  {
    const OldFiles files(trial);
    ASSERT_EQ(::chmod(files.Folder().c_str(), 0555), 0);
    Outcome outcome;
    {
      const OrdinaryUser user;
      outcome = trial.Write(files.Path(trial.Name), Plain);
    }
    ::chmod(files.Folder().c_str(), 0755);
    ExpectFailure(outcome, trial.Name);
    files.ExpectUnchanged(trial.Name);

    // A file that is write-protected itself, in a folder that is not.
    for (const std::string& name : trial.Written)
    {
      ::chmod(files.Path(name).c_str(), 0444);
    }
    ::chmod(files.Folder().c_str(), 0777);
    {
      const OrdinaryUser user;
      outcome = trial.Write(files.Path(trial.Name), Plain);
    }
    ExpectFailure(outcome, trial.Name);
    files.ExpectUnchanged(trial.Name);
  }
}

TEST(FileReplacement, OldFilesSurviveAnAbort)
{
  struct Stop
  {
    int At = -1; ///< the report that stops the writer
    int Heard = 0;
  };
  for (const Trial& trial : Trials())
  {
    const OldFiles files(trial);
    vtkNew<vtkCallbackCommand> command;
    Stop stop;
    command->SetClientData(&stop);
    command->SetCallback(
      [](vtkObject* who, unsigned long, void* data, void*)
      {
        auto* const counted = static_cast<Stop*>(data);
        if (counted->Heard++ == counted->At)
        {
          static_cast<vtkAlgorithm*>(who)->SetAbortExecute(1);
        }
      });
    const auto write = [&](const OldFiles& to, int at)
    {
      stop = { at, 0 };
      const Outcome outcome = trial.Write(to.Path(trial.Name),
        [&](vtkAlgorithm* writer) { writer->AddObserver(vtkCommand::ProgressEvent, command); });
      EXPECT_EQ(outcome.Message, "") << trial.Name;
      EXPECT_FALSE(outcome.Error) << trial.Name;
      return outcome.Returned;
    };
    EXPECT_EQ(write(OldFiles(trial), -1), 1) << trial.Name;
    const int reports = stop.Heard;
    EXPECT_GT(reports, 2) << trial.Name;
    // The last report is VTK's own, when all is written.
    for (int at = 0; at + 1 < reports; ++at)
    {
      EXPECT_EQ(write(files, at), 0) << trial.Name << ", report " << at;
      files.ExpectUnchanged(trial.Name);
    }
  }
}

/// Cells of an earlier mesh must not be read with the points of a new one.
TEST(FileReplacement, OldCellFilesAreRemovedWithTheOldPoints)
{
  const std::string oldFaces = "1 0\n1 1 2 3\n", oldCells = "1 4 0\n1 1 2 3 4\n";
  const std::string ofMSMS = "# MSMS\n4 4 1.00 1.50\n";
  struct Case
  {
    vtkSmartPointer<vtkUnstructuredGrid> Mesh;
    const char* Name;
    const char* Other; ///< the second file, which the mesh does not need
    std::string Content;
    bool IsRemoved;
  };
  vtkNew<vtkUnstructuredGrid> points;
  points->SetPoints(Sphere()->GetPoints());
  const Case cases[] = { { Tetrahedra(), "a.ele", "a.face", oldFaces, true },
    { Tetrahedra(), "a.node", "a.face", oldFaces, true },
    { Grid(VTK_TRIANGLE, 3), "a.face", "a.ele", oldCells, true },
    { points, "a.node", "a.ele", oldCells, true }, { points, "a.node", "a.face", oldFaces, true },
    { Tetrahedra(), "a.ele", "a.face", ofMSMS, false } };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(std::string(c.Name) + ", " + c.Other);
    const auto write = With<vtkTetGenMeshWriter>(c.Mesh);
    const TemporaryFile old(c.Content, c.Other);
    const auto folder = std::filesystem::path(old.Path()).parent_path();
    const std::string path = (folder / c.Name).string();
    const Files before = In(folder);
    {
      const FileLimit limit(8192);
      EXPECT_EQ(write(path, Plain).Returned, 0);
    }
    EXPECT_EQ(In(folder), before);
    vtkNew<vtkCallbackCommand> stop;
    stop->SetCallback([](vtkObject* who, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(who)->SetAbortExecute(1); });
    const Outcome aborted = write(
      path, [&](vtkAlgorithm* writer) { writer->AddObserver(vtkCommand::ProgressEvent, stop); });
    EXPECT_EQ(aborted.Returned, 0);
    EXPECT_EQ(In(folder), before);
    // The file of points cannot be renamed, so the old file of cells is kept.
    std::filesystem::create_directory(folder / "a.node");
    EXPECT_EQ(write(path, Plain).Returned, 0);
    std::filesystem::remove(folder / "a.node");
    EXPECT_EQ(In(folder), before);
    const Outcome outcome = write(path, Plain);
    EXPECT_EQ(outcome.Returned, 1) << outcome.Message;
    Files now = In(folder);
    EXPECT_EQ(now.count(c.Other), c.IsRemoved ? 0u : 1u);
    EXPECT_EQ(now.count("a.node"), 1u);
    EXPECT_EQ(now.size(), (c.Mesh == points.Get() ? 1u : 2u) + (c.IsRemoved ? 0u : 1u));
  }
}

TEST(FileReplacement, AHiddenFileIsThereAgainUnlessItIsRemoved)
{
  const TemporaryFile file("old", "a.face");
  {
    isthmus::FileRemoval removal(file.Path());
    removal.Hide();
    EXPECT_FALSE(std::filesystem::exists(file.Path()));
  }
  EXPECT_EQ(std::filesystem::file_size(file.Path()), 3u);
  {
    isthmus::FileRemoval removal(file.Path());
    removal.Hide();
    removal.Remove();
  }
  EXPECT_TRUE(std::filesystem::is_empty(std::filesystem::path(file.Path()).parent_path()));
  isthmus::FileRemoval none(file.Path());
  EXPECT_THROW(none.Hide(), std::runtime_error);
}

/// Data that the format cannot store are refused before the old file is touched.
TEST(FileReplacement, OldFilesSurviveBadInput)
{
  const Trial trial{ {}, "a.cmesh", { "a.cmesh", "a.ele", "a.face", "a.node" } };
  const OldFiles files(trial);
  vtkNew<vtkUnstructuredGrid> broken;
  broken->DeepCopy(Tetrahedra());
  broken->GetPoints()->SetPoint(7, 0.0, std::nan(""), 0.0);
  for (const bool text : { false, true })
  {
    const Outcome outcome =
      WriteTo<vtkCombinatorialMeshWriter>(files.Path("a.cmesh"), broken, text ? AsText() : Plain);
    EXPECT_EQ(outcome.Returned, 0);
    EXPECT_NE(outcome.Message.find("Point 7 has a coordinate that is not a finite number"),
      std::string::npos)
      << outcome.Message;
  }
  const std::pair<const char*, vtkSmartPointer<vtkUnstructuredGrid>> unnamed[] = {
    { "a.ele", Grid(VTK_TRIANGLE, 3) }, { "a.face", Tetrahedra() }
  };
  for (const auto& [name, grid] : unnamed)
  {
    const Outcome outcome = WriteTo<vtkTetGenMeshWriter>(files.Path(name), grid);
    EXPECT_EQ(outcome.Returned, 0) << name;
    EXPECT_TRUE(outcome.Error) << name;
    EXPECT_NE(outcome.Message.find("The mesh has no "), std::string::npos) << outcome.Message;
  }
  files.ExpectUnchanged("bad input");
}

TEST(FileReplacement, LinksAndPermissionsStay)
{
  const Trial trial{ {}, "a.off", { "a.off" } };
  const OldFiles files(trial);
  ::chmod(files.Path("a.off").c_str(), 0640);
  std::filesystem::create_symlink("a.off", files.Folder() / "link.off");
  std::filesystem::create_symlink("new.off", files.Folder() / "dangling.off");
  EXPECT_EQ(WriteTo<vtkOFFSurfaceWriter>(files.Path("link.off"), Sphere()).Returned, 1);
  EXPECT_EQ(WriteTo<vtkOFFSurfaceWriter>(files.Path("dangling.off"), Sphere()).Returned, 1);
  EXPECT_TRUE(std::filesystem::is_symlink(files.Folder() / "link.off"));
  EXPECT_TRUE(std::filesystem::is_symlink(files.Folder() / "dangling.off"));
  const Files now = In(files.Folder());
  EXPECT_NE(now.at("a.off").find("OFF"), std::string::npos);
  EXPECT_EQ(now.at("new.off"), now.at("a.off"));
  struct stat status = {};
  ASSERT_EQ(::stat(files.Path("a.off").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(FileReplacement, DevicesAreWrittenThemselves)
{
  EXPECT_EQ(WriteTo<vtkOFFSurfaceWriter>("/dev/null", Sphere()).Returned, 1);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  ExpectFailure(WriteTo<vtkOFFSurfaceWriter>("/dev/full", Sphere()), "/dev/full");
  ExpectFailure(WriteTo<vtkCombinatorialMeshWriter>("/dev/full", Tetrahedra()), "/dev/full");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(TextFileWriter, WritesASingleCharacter)
{
  const TemporaryFile file("", "one.txt");
  isthmus::TextFileWriter writer(file.Path());
  writer << "x";
  writer.Close();
  std::string text;
  std::getline(std::ifstream(file.Path()), text);
  EXPECT_EQ(text, "x");
}
