// BinaryCIF: text files encoded here in each way of the specification give the same atoms.

#include "Molecules/BinaryCIF.h"
#include "PDBText.h"
#include "TemporaryFile.h"
#include "vtkMacromoleculeReader.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <charconv>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gemmi/cif.hpp>
#include <nlohmann/json.hpp>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

using Json = nlohmann::json;
using Integers = std::vector<std::int64_t>;

template <typename Number, typename From>
Json Bytes(const std::vector<From>& values)
{
  std::vector<std::uint8_t> bytes(values.size() * sizeof(Number));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto value = static_cast<Number>(values[i]);
    std::memcpy(&bytes[i * sizeof(Number)], &value, sizeof(Number));
  }
  return Json::binary(bytes);
}

Json ByteArray(int type)
{
  return { { "kind", "ByteArray" }, { "type", type } };
}

/// Whole numbers in each way; `encoding` begins with what has been done to them.
Json Plain(const Integers& values, Json encoding = Json::array())
{
  encoding.push_back(ByteArray(3));
  return { { "encoding", encoding }, { "data", Bytes<std::int32_t>(values) } };
}

Json Packed(const Integers& values, int bytes, bool isUnsigned, Json encoding = Json::array())
{
  const std::int64_t upper =
    isUnsigned ? (bytes == 1 ? 0xff : 0xffff) : (bytes == 1 ? 0x7f : 0x7fff);
  const std::int64_t lower = -upper - 1;
  Integers packed;
  for (std::int64_t value : values)
  {
    for (; value >= upper; value -= upper)
    {
      packed.push_back(upper);
    }
    for (; !isUnsigned && value <= lower; value -= lower)
    {
      packed.push_back(lower);
    }
    packed.push_back(value);
  }
  encoding.push_back({ { "kind", "IntegerPacking" }, { "byteCount", bytes },
    { "isUnsigned", isUnsigned }, { "srcSize", values.size() } });
  encoding.push_back(ByteArray(isUnsigned ? (bytes == 1 ? 4 : 5) : bytes));
  return { { "encoding", encoding },
    { "data",
      isUnsigned ? (bytes == 1 ? Bytes<std::uint8_t>(packed) : Bytes<std::uint16_t>(packed))
                 : (bytes == 1 ? Bytes<std::int8_t>(packed) : Bytes<std::int16_t>(packed)) } };
}

Integers RunLength(const Integers& values, Json& encoding)
{
  Integers runs;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (i > 0 && values[i] == values[i - 1])
    {
      ++runs.back();
      continue;
    }
    runs.push_back(values[i]);
    runs.push_back(1);
  }
  encoding.push_back({ { "kind", "RunLength" }, { "srcType", 3 }, { "srcSize", values.size() } });
  return runs;
}

Integers Delta(const Integers& values, Json& encoding)
{
  const std::int64_t origin = values.empty() ? 0 : values[0];
  Integers steps;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    steps.push_back(i == 0 ? 0 : values[i] - values[i - 1]);
  }
  encoding.push_back({ { "kind", "Delta" }, { "origin", origin }, { "srcType", 3 } });
  return steps;
}

/// Tests each encoding separately.
Json EncodeIntegers(const Integers& values, std::size_t way, Json encoding = Json::array())
{
  const bool isPositive =
    std::all_of(values.begin(), values.end(), [](std::int64_t v) { return v >= 0; });
  switch (way % 7)
  {
    case 0:
      return Plain(values, encoding);
    case 1:
    {
      const Integers runs = RunLength(values, encoding);
      return Plain(runs, encoding);
    }
    case 2:
    {
      const Integers steps = Delta(values, encoding);
      return Packed(steps, 1, false, encoding);
    }
    case 3:
    {
      const Integers steps = Delta(values, encoding);
      const Integers runs = RunLength(steps, encoding);
      return Packed(runs, 2, false, encoding);
    }
    case 4:
      return Packed(values, 2, isPositive, encoding);
    case 5:
      return Packed(values, 1, isPositive, encoding);
    default:
    {
      encoding.push_back(ByteArray(isPositive ? 6 : 3));
      return { { "encoding", encoding },
        { "data", isPositive ? Bytes<std::uint32_t>(values) : Bytes<std::int32_t>(values) } };
    }
  }
}

Json EncodeTexts(const std::vector<std::string>& texts, std::size_t way)
{
  std::map<std::string, std::int64_t> known;
  Integers offsets{ 0 };
  Integers places;
  std::string all;
  for (const std::string& text : texts)
  {
    const auto [found, isNew] = known.emplace(text, static_cast<std::int64_t>(known.size()));
    if (isNew)
    {
      all += text;
      offsets.push_back(static_cast<std::int64_t>(all.size()));
    }
    places.push_back(found->second);
  }
  const Json ofOffsets = EncodeIntegers(offsets, way + 2);
  const Json ofPlaces = EncodeIntegers(places, way);
  return { { "encoding",
             { { { "kind", "StringArray" }, { "dataEncoding", ofPlaces["encoding"] },
               { "stringData", all }, { "offsetEncoding", ofOffsets["encoding"] },
               { "offsets", ofOffsets["data"] } } } },
    { "data", ofPlaces["data"] } };
}

template <typename Number>
bool AreNumbers(const std::vector<std::string>& texts, std::vector<Number>& numbers)
{
  numbers.clear();
  for (const std::string& text : texts)
  {
    Number number = 0;
    const auto end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    if (text.empty() || result.ptr != end)
    {
      return false;
    }
    numbers.push_back(number);
  }
  return true;
}

Json EncodeReals(const std::vector<double>& values, std::size_t way)
{
  if (way % 3 == 0)
  {
    return { { "encoding", { ByteArray(33) } }, { "data", Bytes<double>(values) } };
  }
  if (way % 3 == 1)
  {
    return { { "encoding", { ByteArray(32) } }, { "data", Bytes<float>(values) } };
  }
  Integers fixed;
  for (const double value : values)
  {
    fixed.push_back(std::llround(value * 1000.0));
  }
  Json encoding = Json::array();
  encoding.push_back({ { "kind", "FixedPoint" }, { "factor", 1000 }, { "srcType", 33 } });
  return EncodeIntegers(fixed, way, encoding);
}

/// A file of text in BinaryCIF. `way` chooses among the encodings of each column.
Json Encode(const std::string& text, std::size_t way)
{
  gemmi::cif::Document document = gemmi::cif::read_memory(text.data(), text.size(), "test");
  Json file{ { "version", "0.3.0" }, { "encoder", "test" }, { "dataBlocks", Json::array() } };
  for (gemmi::cif::Block& block : document.blocks)
  {
    Json categories = Json::array();
    for (const std::string& name : block.get_mmcif_category_names())
    {
      gemmi::cif::Table table = block.find_mmcif_category(name);
      Json columns = Json::array();
      for (std::size_t c = 0; c < table.width(); ++c, ++way)
      {
        std::vector<std::string> texts;
        Integers mask;
        for (const auto row : table)
        {
          const std::string& raw = row[c];
          mask.push_back(raw == "." ? 1 : raw == "?" ? 2 : 0);
          texts.push_back(mask.back() > 0 ? "" : row.str(static_cast<int>(c)));
        }
        Integers integers;
        std::vector<double> reals;
        const Json data = AreNumbers(texts, integers) ? EncodeIntegers(integers, way)
          : AreNumbers(texts, reals)                  ? EncodeReals(reals, way)
                                                      : EncodeTexts(texts, way);
        const bool isMasked =
          std::any_of(mask.begin(), mask.end(), [](std::int64_t m) { return m > 0; });
        columns.push_back(
          { { "name",
              table.get_prefix().empty() ? std::string()
                                         : table.tags()[static_cast<int>(c)].substr(name.size()) },
            { "data", data }, { "mask", isMasked ? EncodeIntegers(mask, way + 1) : Json() } });
      }
      categories.push_back({ { "name", name.substr(0, name.size() - 1) },
        { "rowCount", table.length() }, { "columns", columns } });
    }
    file["dataBlocks"].push_back({ { "header", block.name }, { "categories", categories } });
  }
  return file;
}

std::string Pack(const Json& file)
{
  const std::vector<std::uint8_t> bytes = Json::to_msgpack(file);
  return std::string(bytes.begin(), bytes.end());
}

std::string ReadText(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void ExpectSame(const Macromolecule& found, const Macromolecule& wanted)
{
  ASSERT_EQ(found.Atoms.size(), wanted.Atoms.size());
  EXPECT_EQ(found.Bonds.size(), wanted.Bonds.size());
  EXPECT_EQ(found.NumberOfModels, wanted.NumberOfModels);
  EXPECT_EQ(found.Notes, wanted.Notes);
  EXPECT_EQ(found.Warnings, wanted.Warnings);
  for (std::size_t i = 0; i < wanted.Atoms.size(); ++i)
  {
    const Atom& a = found.Atoms[i];
    const Atom& b = wanted.Atoms[i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(a.Position[k], b.Position[k], 2e-5) << i; // single precision
    }
    EXPECT_EQ(Describe(a), Describe(b));
    EXPECT_EQ(a.Element, b.Element);
    EXPECT_EQ(a.AltLoc, b.AltLoc);
    EXPECT_EQ(a.IsHetero, b.IsHetero);
    EXPECT_EQ(a.Structure, b.Structure);
    EXPECT_EQ(std::isnan(a.BFactor), std::isnan(b.BFactor));
    EXPECT_NEAR(
      std::isnan(a.BFactor) ? 0.0 : a.BFactor, std::isnan(b.BFactor) ? 0.0 : b.BFactor, 1e-4);
    EXPECT_NEAR(std::isnan(a.Occupancy) ? 0.0 : a.Occupancy,
      std::isnan(b.Occupancy) ? 0.0 : b.Occupancy, 1e-6);
  }
}

/// An atom with a single column that is encoded by `column`, as x.
std::string OneAtom(const Json& x, std::size_t rows = 1)
{
  const auto column = [rows](const char* name, const std::string& value)
  {
    return Json{ { "name", name },
      { "data", EncodeTexts(std::vector<std::string>(rows, value), 0) }, { "mask", nullptr } };
  };
  const Json columns{ column("group_PDB", "ATOM"), column("id", "1"), column("type_symbol", "C"),
    column("label_atom_id", "CA"), column("label_comp_id", "ALA"), column("label_asym_id", "A"),
    column("label_seq_id", "1"), { { "name", "Cartn_x" }, { "data", x }, { "mask", nullptr } },
    column("Cartn_y", "2"), column("Cartn_z", "3") };
  return Pack({ { "encoder", "test" }, { "version", "0.3" },
    { "dataBlocks",
      { { { "header", "X" },
        { "categories",
          { { { "name", "_atom_site" }, { "rowCount", rows }, { "columns", columns } } } } } } } });
}

}

TEST(BinaryCIF, GivesTheAtomsOfTheTextInEachEncoding)
{
  for (const char* name : { "molecules/1FAS.cif", "reports/g07_assembly_gen.cif",
         "reports/m01_esmfold2_no_occupancy.cif", "reports/m03b_phenix_no_label_asym.cif" })
  {
    ISTHMUS_NEEDS_SHARED_DATA(name);
    const std::string text = ReadText(SharedDataFolder() / name);
    const Macromolecule wanted = ParseMolecule(text, MoleculeFormat::MMCIF);
    for (std::size_t way = 0; way < 21; way += name[0] == 'm' ? 10 : 1)
    {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(way));
      ExpectSame(ParseMolecule(Pack(Encode(text, way)), MoleculeFormat::MMCIF), wanted);
    }
  }
  MoleculeOptions third;
  third.Assembly = "3";
  const std::string text = ReadText(SharedDataFolder() / "reports/g07_assembly_gen.cif");
  EXPECT_EQ(ParseMolecule(Pack(Encode(text, 1)), MoleculeFormat::MMCIF, third).Atoms.size(), 492u);
}

TEST(BinaryCIF, ValuesOfTheSpecification)
{
  const auto xOf = [](const Json& column)
  { return ParseMolecule(OneAtom(column), MoleculeFormat::MMCIF).Atoms.at(0).Position[0]; };
  Json steps = Json::array();
  steps.push_back({ { "kind", "IntervalQuantization" }, { "min", -1.0 }, { "max", 4.0 },
    { "numSteps", 11 }, { "srcType", 32 } });
  EXPECT_DOUBLE_EQ(xOf(EncodeIntegers({ 3 }, 0, steps)), 0.5);
  EXPECT_DOUBLE_EQ(xOf(EncodeIntegers({ 10 }, 5, steps)), 4.0);
  // Numbers beyond what the packing holds, of both signs.
  for (const std::int64_t value : { 0L, 126L, 127L, 128L, 255L, 1000L, -128L, -129L, -700L })
  {
    EXPECT_EQ(xOf(Packed({ value }, 1, false)), static_cast<double>(value));
    EXPECT_EQ(xOf(Packed({ value }, 2, false)), static_cast<double>(value));
    EXPECT_EQ(value < 0 ? 0.0 : xOf(Packed({ value }, 1, true)),
      value < 0 ? 0.0 : static_cast<double>(value));
  }
  EXPECT_DOUBLE_EQ(xOf(EncodeReals({ 1.1 }, 1)), 1.1); // as 1.1, not 1.10000002384
}

TEST(BinaryCIF, TextsKeepTheirCharacters)
{
  gemmi::cif::Document document = ReadBinaryCIF(
    Pack({ { "encoder", "test" },
      { "dataBlocks",
        { { { "header", "X" },
          { "categories",
            { { { "name", "_entity" }, { "rowCount", 6 },
              { "columns",
                { { { "name", "id" },
                  { "data",
                    EncodeTexts({ "?", "a b", "it's \"so\"", "two\nlines", "", "data_x" }, 0) },
                  { "mask", nullptr } } } } } } } } } } }),
    [](const std::string&) { return true; });
  std::vector<std::string> texts;
  for (const std::string& raw : document.blocks.at(0).find_loop("_entity.id"))
  {
    texts.push_back(gemmi::cif::as_string(raw));
  }
  EXPECT_EQ(
    texts, (std::vector<std::string>{ "?", "a b", "it's \"so\"", "two\nlines", "", "data_x" }));
}

TEST(BinaryCIF, IsReadByItsNameOrContent)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1FAS.cif");
  const std::string text = ReadText(SharedDataFolder() / "molecules/1FAS.cif");
  const std::string packed = Pack(Encode(text, 2));
  const std::size_t atoms = ParseMolecule(text, MoleculeFormat::MMCIF).Atoms.size();
  for (const auto& [name, content] : { std::pair("a.bcif", packed), std::pair("a.BCIF", packed),
         std::pair("a.bcif.gz", Gzip(packed)), std::pair("a.cif", packed), std::pair("a", packed) })
  {
    const TemporaryFile file(content, name);
    EXPECT_EQ(ReadMacromolecule(file.Path(), MoleculeOptions()).Atoms.size(), atoms) << name;
    EXPECT_EQ(CountModels(file.Path(), MoleculeFormat::ByName), 1) << name;
    EXPECT_EQ(
      vtkMacromoleculeReader::CanReadFile(file.Path()), std::string(name).size() > 1 ? 1 : 0);
    vtkNew<vtkMacromoleculeReader> reader;
    reader->SetFileName(file.Path());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(atoms)) << name;
  }
  const TemporaryFile pdb(packed, "a.pdb");
  EXPECT_EQ(vtkMacromoleculeReader::CanReadFile(pdb.Path()), 0);
  EXPECT_NE(CatchMessage(packed, MoleculeFormat::PDB).find("Name it .bcif"), std::string::npos);
}

TEST(BinaryCIF, DamagedFilesAreRefusedWithTheirColumn)
{
  const auto why = [](const Json& column, std::size_t rows = 1)
  { return CatchMessage(OneAtom(column, rows), MoleculeFormat::MMCIF); };
  const auto expect = [](const std::string& said, const char* words)
  {
    EXPECT_NE(said.find("BinaryCIF"), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  const Json good = Plain({ 1 });
  EXPECT_EQ(why(good), "");
  expect(why(good, 2), "column _atom_site.Cartn_x: it has not as many values");
  Json column = good;
  column["encoding"] = Json::array();
  expect(why(column), "no encoding");
  column["encoding"] = { ByteArray(9) };
  expect(why(column), "no ByteArray of type 9");
  column["encoding"] = { { { "kind", "Zip" } }, ByteArray(3) };
  expect(why(column), "no encoding Zip");
  column["encoding"] = { { { "kind", "RunLength" }, { "srcSize", 1 } }, ByteArray(3) };
  expect(why(column), "runs are damaged");
  column = Plain({ 1, 2000000000 });
  column["encoding"].insert(
    column["encoding"].begin(), Json{ { "kind", "RunLength" }, { "srcSize", 2000000000 } });
  expect(why(column), "runs are damaged");
  column = Plain({ 1, 5 });
  column["encoding"].insert(
    column["encoding"].begin(), Json{ { "kind", "RunLength" }, { "srcSize", 2 } });
  expect(why(column), "longer than it says");
  column = Packed({ 1 }, 1, false);
  column["encoding"][0]["srcSize"] = 2;
  expect(why(column), "packed numbers");
  column = EncodeTexts({ "1" }, 0);
  column["data"] = Bytes<std::int32_t>(Integers{ 7 });
  expect(why(column), "a text that does not exist");
  column = EncodeTexts({ "1" }, 0);
  column["encoding"][0]["offsetEncoding"] = Json::array({ ByteArray(3) });
  column["encoding"][0]["offsets"] = Bytes<std::int32_t>(Integers{ 0, 99 });
  expect(why(column), "places of its texts are damaged");
  column = good;
  column["data"] = "text";
  expect(why(column), "not binary");
  const std::string whole = OneAtom(good);
  for (std::size_t size : { whole.size() - 1, whole.size() / 2, std::size_t{ 60 } })
  {
    expect(CatchMessage(whole.substr(0, size), MoleculeFormat::MMCIF), "damaged or truncated");
  }
}
