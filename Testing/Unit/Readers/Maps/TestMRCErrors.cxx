// Files that can't be read: an error message, an error code, an empty output, and no large
// allocation.

#include "Files/ReaderError.h"
#include "MRCTestFile.h"
#include "MRCTestReading.h"
#include "Maps/MRCVoxels.h"
#include "SharedData.h"

#include <vtkErrorCode.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>

namespace
{

using namespace isthmus::testing;

std::string GoodMap()
{
  MRCTestFile map({ 8, 8, 8 }, 2);
  map.AddVoxels([](int c, int, int, int) { return c; });
  return map.Bytes();
}

/// Expects that reading `path` fails with these words and code, and leaves nothing behind.
void ExpectFailure(
  MRCTestReading& reading, const std::string& words, unsigned long code, const char* path)
{
  reading->SetFileName(path);
  vtkImageData* const image = reading.Update();
  EXPECT_TRUE(reading.HasFailed()) << words;
  EXPECT_NE(reading.Error().find(words), std::string::npos) << reading.Error();
  EXPECT_NE(reading.Error().find(path ? path : ""), std::string::npos) << reading.Error();
  EXPECT_EQ(reading->GetErrorCode(), code) << words;
  EXPECT_EQ(image->GetNumberOfPoints(), 0);
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(image->GetFieldData()->GetNumberOfArrays(), 0);
  for (const double value : { image->GetSpacing()[0], image->GetSpacing()[2] })
  {
    EXPECT_EQ(value, 1.0);
  }
}

void ExpectFailure(const std::string& content, const std::string& words, unsigned long code)
{
  const TemporaryFile file(content);
  MRCTestReading reading;
  ExpectFailure(reading, words, code, file.Path());
}

/// Largest resident memory of this process so far, in MiB.
long PeakMiB()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// The sanitizers keep freed memory, so the peak cannot be measured under them.
void ExpectPeakBelow(long mib)
{
#if !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(PeakMiB(), mib);
#else
  static_cast<void>(mib);
#endif
}

TEST(MRCErrors, NotAFile)
{
  MRCTestReading reading;
  ExpectFailure(
    reading, "no such file", vtkErrorCode::FileNotFoundError, "/there/is/no/such/map.mrc");
  ExpectFailure(reading, "this is a folder", vtkErrorCode::CannotOpenFileError, "/");
  ExpectFailure(reading, "not a regular file", vtkErrorCode::CannotOpenFileError, "/dev/null");
  ExpectFailure(reading, "set FileName", vtkErrorCode::NoFileNameError, nullptr);
}

TEST(MRCErrors, ForeignFormat)
{
  ExpectFailure("", "the file is empty", vtkErrorCode::PrematureEndOfFileError);
  ExpectFailure("12345", "5 bytes are too few", vtkErrorCode::PrematureEndOfFileError);
  ExpectFailure(
    Gzip("12345"), "5 bytes after decompression", vtkErrorCode::PrematureEndOfFileError);
  for (const std::string& content : { std::string(5000, 'g'), Gzip(std::string(5000, 'g')) })
  {
    ExpectFailure(content, "not an MRC, CCP4 or EMDB map", vtkErrorCode::UnrecognizedFileTypeError);
  }
}

TEST(MRCErrors, DamagedHeader)
{
  MRCTestFile mode({ 8, 8, 8 }, 2);
  mode.SetInt(4, 154285104);
  ExpectFailure(
    mode.Bytes(), "mode (word 4) is 154285104", vtkErrorCode::UnrecognizedFileTypeError);
  MRCTestFile grid({ 8, 8, 8 }, 2);
  grid.SetInt(1, -8);
  ExpectFailure(grid.Bytes(), "(words 1-3) is -8, 8, 8", vtkErrorCode::UnrecognizedFileTypeError);
}

TEST(MRCErrors, CompressedAsMRCZ)
{
  for (const int mode : { 1002, 2000, 5002, 6006 })
  {
    MRCTestFile map({ 8, 8, 8 }, 2);
    map.SetInt(4, mode);
    const TemporaryFile file(map.Bytes());
    MRCTestReading reading;
    EXPECT_EQ(reading->CanReadFile(file.Path()), 1); // so that its error is seen
    ExpectFailure(
      reading, "this is an MRCZ file", vtkErrorCode::UnrecognizedFileTypeError, file.Path());
    EXPECT_NE(reading.Error().find("compressor=None"), std::string::npos) << reading.Error();
  }
  ISTHMUS_NEEDS_SHARED_DATA("reports/y01e_mrcz_5002.mrcz");
  MRCTestReading reading;
  const std::string reported = (SharedDataFolder() / "reports/y01e_mrcz_5002.mrcz").string();
  ExpectFailure(
    reading, "this is an MRCZ file", vtkErrorCode::UnrecognizedFileTypeError, reported.c_str());
  EXPECT_NE(reading.Error().find("mode 5002"), std::string::npos) << reading.Error();
}

TEST(MRCErrors, TruncatedPlain)
{
  const std::string map = GoodMap();
  ExpectFailure(map.substr(0, map.size() - 1),
    "3072 bytes expected (header 1024, extended header 0, 8 x 8 x 8 voxels of mode 2), found 3071",
    vtkErrorCode::PrematureEndOfFileError);
  ExpectFailure(map.substr(0, 1024), "found 1024", vtkErrorCode::PrematureEndOfFileError);
  MRCTestFile extended({ 8, 8, 8 }, 2);
  extended.SetInt(24, 2000000000);
  ExpectFailure(
    extended.Bytes(), "extended header 2000000000", vtkErrorCode::PrematureEndOfFileError);
}

TEST(MRCErrors, TruncatedAndDamagedCompressed)
{
  MRCTestFile noise({ 50, 50, 50 }, 2);
  noise.AddVoxels([](int c, int r, int s, int) { return std::sin(c + 50.0 * r + 2500.0 * s); });
  for (const std::string& packed : { Gzip(noise.Bytes()), Bzip2(noise.Bytes()) })
  {
    ExpectFailure(packed.substr(0, packed.size() / 2), "after decompression",
      vtkErrorCode::PrematureEndOfFileError);
    // Damage is found in the data or, at the latest, by the checksum at the end.
    for (const std::size_t place : { packed.size() / 2, packed.size() - 6 })
    {
      std::string damaged = packed;
      damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
      ExpectFailure(damaged, "data are damaged before byte", vtkErrorCode::FileFormatError);
    }
  }
  const TemporaryFile file(Gzip(GoodMap().substr(0, 2000)));
  MRCTestReading lastSection(file.Path());
  lastSection->SetCropExtent(0, -1, 0, -1, 7, 7);
  ExpectFailure(lastSection, "3072 bytes expected after decompression, found 2000",
    vtkErrorCode::PrematureEndOfFileError, file.Path());
  ExpectFailure(Gzip(GoodMap().substr(0, 2000)),
    "3072 bytes expected after decompression, found 2000", vtkErrorCode::PrematureEndOfFileError);
}

TEST(MRCErrors, HeadersWithHugeCountsAllocateNothing)
{
  MRCTestFile huge({ 2000000000, 2000000000, 2000000000 }, 2);
  MRCTestFile large({ 1500, 1500, 1500 }, 2); // 13.5 GB
  const long before = PeakMiB();
  for (const std::string& head : { huge.Bytes(), large.Bytes() })
  {
    for (const std::string& packed : { head, Gzip(head), Bzip2(head) })
    {
      ExpectFailure(packed, "bytes expected", vtkErrorCode::PrematureEndOfFileError);
    }
  }
  // Zeros compress so well that only counting shows that 40 MB are not 13.5 GB.
  const std::string zeros = large.Bytes() + std::string(40000000, '\0');
  ExpectFailure(
    Bzip2(zeros), "after decompression, found 40001024", vtkErrorCode::PrematureEndOfFileError);
  ExpectPeakBelow(before + 200);
}

TEST(MRCErrors, RequestsBeyondTheMapAreErrors)
{
  const TemporaryFile file(GoodMap());
  MRCTestReading reading(file.Path());
  reading->SetVolumeIndex(1);
  ExpectFailure(reading, "no volume or image 1", vtkErrorCode::UserError, file.Path());
  reading->SetVolumeIndex(-1);
  reading->SetCropExtent(0, 3, 2, 8, 0, -1);
  ExpectFailure(
    reading, "nodes 2 to 8 along y, but the map has 0 to 7", vtkErrorCode::UserError, file.Path());
  reading->SetCropExtent(0, 3, 5, 2, 0, -1);
  ExpectFailure(reading, "nodes 5 to 2 along y", vtkErrorCode::UserError, file.Path());
  reading->SetCropExtent(0, -1, 0, -1, 0, -1);
  reading->SetSampleRate(1, 1, 0);
  ExpectFailure(reading, "SampleRate along z is 0", vtkErrorCode::UserError, file.Path());
}

TEST(MRCErrors, AReaderRecovers)
{
  const TemporaryFile good(GoodMap());
  const TemporaryFile bad("bad");
  MRCTestReading reading(good.Path());
  EXPECT_EQ(reading.Update()->GetNumberOfPoints(), 512);
  ExpectFailure(reading, "too few", vtkErrorCode::PrematureEndOfFileError, bad.Path());
  reading->SetFileName(good.Path());
  EXPECT_EQ(reading.Update()->GetNumberOfPoints(), 512);
  EXPECT_FALSE(reading.HasFailed());
  EXPECT_EQ(reading->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

/// Aborts an algorithm as soon as it reports progress.
class Abort : public vtkCommand
{
public:
  static Abort* New() { return new Abort; }
  void Execute(vtkObject* caller, unsigned long, void* fraction) override
  {
    if (*static_cast<double*>(fraction) > 0.0)
    {
      static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
    }
  }
};

TEST(MRCErrors, AbortLeavesAnEmptyOutput)
{
  MRCTestFile map({ 256, 256, 256 }, 1);
  map.AddVoxels([](int c, int, int, int) { return c; });
  for (const std::string& content : { map.Bytes(), Gzip(map.Bytes()) })
  {
    const TemporaryFile file(content);
    MRCTestReading reading(file.Path());
    reading->UpdateInformation();
    vtkNew<Abort> abort;
    reading->AddObserver(vtkCommand::ProgressEvent, abort);
    EXPECT_EQ(reading.Update()->GetNumberOfPoints(), 0);
    EXPECT_FALSE(reading.HasFailed()) << reading.Error();
  }
}

/// A file that returns fewer bytes than its size: it is being written, or its disk fails.
class ShortSource : public isthmus::ByteSource
{
public:
  std::size_t Read(std::uint64_t, void*, std::size_t size) override { return size / 2; }
  bool RandomAccess() const override { return true; }
  std::uint64_t MaximumBytes() const override { return 4096; }
  std::uint64_t CountUpTo(std::uint64_t limit, const isthmus::ProgressCallback&) override
  {
    return limit;
  }
  void SkipTo(std::uint64_t, const isthmus::ProgressCallback&) override {}
  void CheckEnd() override {}
  bool IsCut() const override { return false; }
  std::string Compression() const override { return "none"; }
  std::uint64_t FileSize() const override { return 4096; }
  const std::string& Path() const override { return this->Name; }

private:
  std::string Name = "short.mrc";
};

TEST(MRCErrors, AFileThatChangesIsNotCalledTruncated)
{
  ShortSource source;
  isthmus::MRCVoxelLayout layout;
  layout.Offset = 1024;
  layout.Counts = { 8, 8, 8 };
  std::vector<float> out(512);
  try
  {
    isthmus::ReadMRCVoxels(
      source, layout, { { 0, 0, 0 }, { 8, 8, 8 }, { 1, 1, 1 } }, out.data(), {});
    FAIL() << "nothing was said";
  }
  catch (const isthmus::ReaderError& error)
  {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("short.mrc: the file changed while it was read"), std::string::npos)
      << sentence;
    EXPECT_EQ(sentence.find("expected"), std::string::npos) << sentence;
  }
}

/// 34 GB according to the header, almost nothing on disk: only the crop is read and allocated.
TEST(MRCErrors, SmallCropOfAHugeSparseMap)
{
  MRCTestFile map({ 2048, 2048, 2048 }, 2);
  const TemporaryFile file(map.Bytes());
  ASSERT_EQ(::truncate(file.Path(), 1024 + 4LL * 2048 * 2048 * 2048), 0);
  const float value = 42.0f;
  std::fstream stream(file.Path(), std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(1024 + 4LL * ((1063LL * 2048 + 1062) * 2048 + 1061));
  stream.write(reinterpret_cast<const char*>(&value), 4);
  stream.close();

  const long before = PeakMiB();
  MRCTestReading reading(file.Path());
  reading->SetCropExtent(1000, 1063, 1000, 1063, 1000, 1063);
  vtkImageData* const image = reading.Update();
  ASSERT_FALSE(reading.HasFailed()) << reading.Error();
  EXPECT_EQ(image->GetNumberOfPoints(), 64 * 64 * 64);
  EXPECT_EQ(reading.At(61, 62, 63), 42.0);
  EXPECT_EQ(reading.At(61, 62, 62), 0.0);
  ExpectPeakBelow(before + 100);
}

}
