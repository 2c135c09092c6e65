// Atom tables of CIF as programs write them: columns missing, crystals of small molecules, chemical
// components, several data blocks, atoms without coordinates.

#include "Atoms/ChemicalElement.h"
#include "MoleculeTexts.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

std::string FileText(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Macromolecule FromCIF(const std::string& text, std::int64_t model = 0)
{
  MoleculeOptions options;
  options.ModelIndex = model;
  return ParseMolecule(text, MoleculeFormat::MMCIF, options);
}

std::string Why(const std::string& text)
{
  return CatchMessage(text, MoleculeFormat::MMCIF);
}

/// "C2 O1 " of the elements of a molecule.
std::string Formula(const Macromolecule& molecule)
{
  std::map<std::string, int> counts;
  for (const Atom& atom : molecule.Atoms)
  {
    ++counts[ElementSymbol(atom.Element)];
  }
  std::string formula;
  for (const auto& [symbol, count] : counts)
  {
    formula += symbol + std::to_string(count) + " ";
  }
  return formula;
}

bool Mention(const std::vector<std::string>& sentences, const std::string& word)
{
  return std::any_of(sentences.begin(), sentences.end(),
    [&word](const std::string& sentence) { return sentence.find(word) != std::string::npos; });
}

double Distance(const Atom& a, const Atom& b)
{
  return std::hypot(
    a.Position[0] - b.Position[0], a.Position[1] - b.Position[1], a.Position[2] - b.Position[2]);
}

/// A calcium ion, glycine and a water, with the columns named in `columns`.
std::string Glycine(const std::vector<std::string>& columns)
{
  using Row = std::map<std::string, std::string>;
  const auto row = [](const char* group, const char* id, const char* symbol, const char* name,
                     const char* residue, const char* chain, const char* number, const char* label,
                     const char* x)
  {
    return Row{ { "group_PDB", group }, { "id", id }, { "type_symbol", symbol },
      { "label_atom_id", name }, { "auth_atom_id", name }, { "label_comp_id", residue },
      { "auth_comp_id", residue }, { "label_asym_id", chain }, { "auth_asym_id", chain },
      { "label_seq_id", label }, { "auth_seq_id", number }, { "label_alt_id", "." },
      { "Cartn_x", x }, { "Cartn_y", "0.5" }, { "Cartn_z", "-1.25" }, { "occupancy", "0.75" },
      { "B_iso_or_equiv", "12.5" }, { "pdbx_PDB_model_num", "1" } };
  };
  const std::vector<Row> rows{ row("ATOM", "1", "N", "N", "GLY", "A", "7", "1", "0.0"),
    row("ATOM", "2", "C", "CA", "GLY", "A", "7", "1", "1.5"),
    row("ATOM", "3", "C", "C", "GLY", "A", "7", "1", "3.0"),
    row("ATOM", "4", "O", "O", "GLY", "A", "7", "1", "4.2"),
    row("HETATM", "5", "CA", "CA", "CA", "B", "101", ".", "9.0"),
    row("HETATM", "6", "O", "O", "HOH", "C", "201", ".", "14.0") };
  std::string text = "data_gly\nloop_\n";
  for (const std::string& column : columns)
  {
    text += "_atom_site." + column + "\n";
  }
  for (const Row& values : rows)
  {
    for (const std::string& column : columns)
    {
      text += values.at(column) + " ";
    }
    text += "\n";
  }
  return text;
}

const std::vector<std::string> AllColumns{ "group_PDB", "id", "type_symbol", "label_atom_id",
  "auth_atom_id", "label_comp_id", "auth_comp_id", "label_asym_id", "auth_asym_id", "label_seq_id",
  "auth_seq_id", "label_alt_id", "Cartn_x", "Cartn_y", "Cartn_z", "occupancy", "B_iso_or_equiv",
  "pdbx_PDB_model_num" };

std::vector<std::string> Without(const std::vector<std::string>& names)
{
  std::vector<std::string> columns;
  for (const std::string& column : AllColumns)
  {
    if (std::find(names.begin(), names.end(), column) == names.end())
    {
      columns.push_back(column);
    }
  }
  return columns;
}

constexpr const char* RightFormula = "C2 Ca1 N1 O2 ";

}

TEST(CIFAtomTable, ReportedFilesHaveTheirAtoms)
{
  const auto folder = SharedDataFolder() / "reports";
  ISTHMUS_NEEDS_SHARED_DATA("reports");
  for (const char* name :
    { "m01_esmfold2_no_occupancy.cif", "m02_no_B_iso.cif", "m03b_phenix_no_label_asym.cif" })
  {
    const Macromolecule molecule = FromCIF(FileText(folder / name));
    ASSERT_EQ(molecule.Atoms.size(), 33u) << name;
    EXPECT_EQ(Formula(molecule), "C9 H17 N3 O4 ") << name; // trialanine, charged at both ends
    EXPECT_EQ(molecule.Atoms[0].Chain, "X") << name;
    EXPECT_EQ(molecule.Atoms[32].ResidueId, 3) << name;
    EXPECT_EQ(std::isnan(molecule.Atoms[0].Occupancy), name[1] == '0' && name[2] == '1') << name;
    EXPECT_EQ(std::isnan(molecule.Atoms[0].BFactor), name[2] == '2') << name;
  }
}

TEST(CIFAtomTable, EachColumnButCoordinatesAndOneNameMayBeMissing)
{
  ASSERT_EQ(Formula(FromCIF(Glycine(AllColumns))), RightFormula);
  for (const std::string& column : AllColumns)
  {
    if (column.substr(0, 5) == "Cartn")
    {
      EXPECT_NE(Why(Glycine(Without({ column }))).find("Cartn_x"), std::string::npos) << column;
      continue;
    }
    const Macromolecule molecule = FromCIF(Glycine(Without({ column })));
    EXPECT_EQ(Formula(molecule), RightFormula) << column;
    EXPECT_EQ(molecule.Atoms[4].Chain, "B") << column;
    EXPECT_EQ(molecule.Atoms[1].ResidueName, "GLY") << column;
    EXPECT_EQ(std::isnan(molecule.Atoms[0].Occupancy), column == "occupancy") << column;
    EXPECT_EQ(molecule.Atoms[1].ResidueId, column == "auth_seq_id" ? 1 : 7) << column;
  }
}

TEST(CIFAtomTable, LabelOrAuthNamesAloneAreEnough)
{
  const Macromolecule labels =
    FromCIF(Glycine(Without({ "auth_atom_id", "auth_comp_id", "auth_asym_id", "auth_seq_id" })));
  EXPECT_EQ(Formula(labels), RightFormula);
  EXPECT_EQ(labels.Atoms[0].ResidueId, 1);
  EXPECT_EQ(labels.Atoms[5].Chain, "C");
  const Macromolecule authors = FromCIF(Glycine(Without(
    { "label_atom_id", "label_comp_id", "label_asym_id", "label_seq_id", "label_alt_id" })));
  EXPECT_EQ(Formula(authors), RightFormula);
  EXPECT_EQ(authors.Atoms[5].ResidueId, 201);
  EXPECT_EQ(authors.Atoms[5].Chain, "C");
}

TEST(CIFAtomTable, CoordinatesAndANameAreEnough)
{
  const Macromolecule molecule =
    FromCIF(Glycine({ "label_atom_id", "Cartn_x", "Cartn_y", "Cartn_z" }));
  EXPECT_EQ(JoinNames(molecule), "N CA C O CA O ");
  EXPECT_EQ(molecule.Atoms[5].Position, (std::array<double, 3>{ 14.0, 0.5, -1.25 }));
  EXPECT_TRUE(Mention(molecule.Notes, "Atoms without a usable element in the file: 6;"));
  EXPECT_TRUE(Mention(molecule.Notes, "no occupancy and B_iso_or_equiv"));
  EXPECT_NE(Why(Glycine({ "id", "Cartn_x", "Cartn_y", "Cartn_z" })).find("label_atom_id"),
    std::string::npos);
}

TEST(CIFAtomTable, OneAtomWithoutLoopIsRead)
{
  const Macromolecule molecule =
    FromCIF("data_ion\n_atom_site.label_atom_id ZN\n_atom_site.label_comp_id ZN\n"
            "_atom_site.Cartn_x 1\n_atom_site.Cartn_y 2\n_atom_site.Cartn_z 3\n");
  ASSERT_EQ(molecule.Atoms.size(), 1u);
  EXPECT_EQ(molecule.Atoms[0].Element, 30);
}

TEST(CIFAtomTable, AtomsWithoutCoordinatesAreDroppedAndCounted)
{
  for (const char* missing : { "?", ".", "nan", "NaN", "-nan", "inf", "-Inf" })
  {
    std::string text = Glycine(AllColumns);
    for (const char* x : { "3.0", "9.0" })
    {
      const std::size_t at = text.find(std::string(" ") + x + " ");
      ASSERT_NE(at, std::string::npos);
      text.replace(at + 1, 3, missing);
    }
    const Macromolecule molecule = FromCIF(text);
    EXPECT_EQ(JoinNames(molecule), "N CA O O ") << missing;
    ASSERT_EQ(molecule.Warnings.size(), 1u) << missing;
    EXPECT_NE(molecule.Warnings[0].find("2 of 6 atoms have no coordinates"), std::string::npos);
    EXPECT_NE(molecule.Warnings[0].find("C of GLY 7 A, CA of CA 101 B"), std::string::npos)
      << molecule.Warnings[0];
  }
  std::string none = "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n"
                     "_atom_site.Cartn_y\n_atom_site.Cartn_z\nCA ? ? ?\nC 1 2 nan\n";
  EXPECT_NE(Why(none).find("none of its 2 atoms has coordinates"), std::string::npos) << Why(none);
}

TEST(CIFAtomTable, NumbersThatAreWordsAreStillRefused)
{
  std::string text = Glycine(AllColumns);
  text.replace(text.find(" 3.0 ") + 1, 3, "3.x");
  EXPECT_NE(Why(text).find("C of GLY 7 A"), std::string::npos) << Why(text);
}

// _geom_bond of the same file, computed by the refinement program, is independent of our
// conversion.
TEST(CIFAtomTable, CrystalOfTheOpenDatabaseHasTheBondsThatItLists)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/1544173.cif");
  const std::string text = FileText(SharedDataFolder() / "reports/1544173.cif");
  const Macromolecule molecule = FromCIF(text);
  EXPECT_EQ(Formula(molecule), "C20 H28 O2 ");
  std::map<std::string, const Atom*> byName;
  for (const Atom& atom : molecule.Atoms)
  {
    byName[atom.Name] = &atom;
  }
  std::istringstream lines(text.substr(text.find("_geom_bond_distance")));
  std::string line;
  std::getline(lines, line);
  int compared = 0;
  while (std::getline(lines, line))
  {
    std::istringstream words(line);
    std::string a, b, length;
    if (!(words >> a >> b >> length) || byName.count(a) == 0)
    {
      break;
    }
    EXPECT_NEAR(Distance(*byName.at(a), *byName.at(b)), std::stod(length), 0.006) << line;
    ++compared;
  }
  EXPECT_GT(compared, 40);
  EXPECT_TRUE(Mention(molecule.Notes, "asymmetric unit"));
  // U_iso 0.02054 of O1 is B = 8 pi^2 U.
  EXPECT_NEAR(byName.at("O1")->BFactor, 8.0 * M_PI * M_PI * 0.02054, 1e-3);
}

TEST(CIFAtomTable, TriclinicCellIsConverted)
{
  const std::string atoms = "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n"
                            "_atom_site_fract_z\nO1 0 0 0\nNa1 1 0 0\nCl1 0 1.0(2) 0\nCA1 0 0 1\n";
  const std::string cell = "_cell_length_a 5.0(1)\n_cell_length_b 6\n_cell_length_c 7\n";
  const std::string angles = "_cell_angle_alpha 80\n_cell_angle_beta 95\n_cell_angle_gamma 105\n";
  const Macromolecule molecule = FromCIF("data_t\n" + cell + angles + atoms);
  ASSERT_EQ(Formula(molecule), "C1 Cl1 Na1 O1 ");
  const auto cosine = [&](int i, int j)
  {
    double dot = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      dot += molecule.Atoms[static_cast<std::size_t>(i)].Position[k] *
        molecule.Atoms[static_cast<std::size_t>(j)].Position[k];
    }
    return dot;
  };
  EXPECT_NEAR(cosine(1, 1), 25.0, 1e-9);
  EXPECT_NEAR(cosine(2, 2), 36.0, 1e-9);
  EXPECT_NEAR(cosine(3, 3), 49.0, 1e-9);
  EXPECT_NEAR(cosine(2, 3), 42.0 * std::cos(80.0 * M_PI / 180.0), 1e-9);
  EXPECT_NEAR(cosine(1, 3), 35.0 * std::cos(95.0 * M_PI / 180.0), 1e-9);
  EXPECT_NEAR(cosine(1, 2), 30.0 * std::cos(105.0 * M_PI / 180.0), 1e-9);
  EXPECT_NE(Why("data_t\n" + atoms).find("_cell_length_a"), std::string::npos);
  EXPECT_NE(
    Why("data_t\n" + cell + "_cell_angle_alpha 150\n_cell_angle_beta 150\n" + atoms).find("angle"),
    std::string::npos);
}

TEST(CIFAtomTable, ChargesSymbolsAndDisorderOfCoreCIF)
{
  const std::string text =
    "data_salt\n_cell_length_a 10\n_cell_length_b 10\n_cell_length_c 10\nloop_\n_atom_type_symbol\n"
    "Ca2+\nO2-\nloop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n"
    "_atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\n_atom_site_disorder_group\n"
    "CA1 Ca2+ 0.1 0.1 0.1 1 .\nO1 O2- 0.3 0.1 0.1 0.6(1) 1\nO1 O2- 0.3 0.2 0.1 0.4 2\n"
    "O2 O2- 0.5 0.1 0.1 0.5 -1\nCA2 . 0.7 0.1 0.1 1 .\nC3 ? ? 0.1 0.1 1 .\n";
  const Macromolecule molecule = FromCIF(text);
  EXPECT_EQ(Formula(molecule), "Ca2 O2 ");
  EXPECT_EQ(molecule.Atoms[0].Charge, 2.0);
  EXPECT_EQ(molecule.Atoms[1].Charge, -2.0);
  EXPECT_NEAR(molecule.Atoms[1].Position[1], 1.0, 1e-12);  // the group with occupancy 0.6
  EXPECT_TRUE(Mention(molecule.Warnings, "1 of 6 atoms")); // C3
  MoleculeOptions all;
  all.AltLoc = "*";
  EXPECT_EQ(ParseMolecule(text, MoleculeFormat::MMCIF, all).Atoms.size(), 5u);
}

TEST(CIFAtomTable, LabelsOfCoreCIFBeginWithTheSymbol)
{
  const auto element = [](const std::string& label)
  {
    return Formula(
      FromCIF("data_x\n_cell_length_a 10\n_cell_length_b 10\n_cell_length_c 10\nloop_\n"
              "_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n" +
        label + " 0.1 0.1 0.1\n"));
  };
  for (const auto& [label, formula] :
    std::vector<std::pair<const char*, const char*>>{ { "Cl2", "Cl1 " }, { "CL2", "Cl1 " },
      { "BR1A", "Br1 " }, { "CU1", "Cu1 " }, { "ZN", "Zn1 " }, { "FE1", "Fe1 " }, { "SI3", "Si1 " },
      { "SE1", "Se1 " }, { "PT1", "Pt1 " }, { "Co1", "Co1 " }, { "C12A", "C1 " }, { "CA1", "C1 " },
      { "CO2", "C1 " }, { "CF3", "C1 " }, { "NA1", "N1 " }, { "HO5", "H1 " }, { "OW1", "O1 " },
      { "H1A", "H1 " }, { "D1", "H1 " } })
  {
    EXPECT_EQ(element(label), formula) << label;
  }
  EXPECT_TRUE(Mention(
    FromCIF(
      "data_x\n_cell_length_a 9\n_cell_length_b 9\n_cell_length_c 9\nloop_\n_atom_site_label\n"
      "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nC1 0 0 0\n")
      .Notes,
    "inferred from the labels"));
}

TEST(CIFAtomTable, ChemicalComponentHasItsBonds)
{
  const std::string head = "data_EOH\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n"
                           "_chem_comp_atom.type_symbol\n_chem_comp_atom.charge\n";
  const std::string bonds = "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n"
                            "_chem_comp_bond.atom_id_2\nEOH C1 C2\nEOH C1 O\n";
  const std::string both = head +
    "_chem_comp_atom.model_Cartn_x\n_chem_comp_atom.model_Cartn_y\n_chem_comp_atom.model_Cartn_z\n"
    "_chem_comp_atom.pdbx_model_Cartn_x_ideal\n_chem_comp_atom.pdbx_model_Cartn_y_ideal\n"
    "_chem_comp_atom.pdbx_model_Cartn_z_ideal\n";
  MoleculeOptions fileBonds;
  fileBonds.BondsByDistance = false;
  const Macromolecule ideal = ParseMolecule(both +
      "EOH C1 C 0 50 0 0 0 0 0\nEOH C2 C 0 51 0 0 1.5 0 0\n"
      "EOH O O -1 52 0 0 0 1.4 0\n" +
      bonds,
    MoleculeFormat::MMCIF, fileBonds);
  ASSERT_EQ(ideal.Atoms.size(), 3u);
  EXPECT_EQ(ideal.Bonds.size(), 2u);
  EXPECT_EQ(ideal.Atoms[1].Position[0], 1.5);
  EXPECT_EQ(ideal.Atoms[2].Charge, -1.0);
  EXPECT_EQ(ideal.Atoms[2].ResidueName, "EOH");
  EXPECT_TRUE(Mention(ideal.Notes, "ideal"));
  // CCD has components whose ideal coordinates could not be computed.
  const Macromolecule example = FromCIF(both +
    "EOH C1 C 0 50 0 0 ? ? ?\nEOH C2 C 0 51 0 0 ? ? ?\n"
    "EOH O O 0 52 0 0 0 1.4 0\n" +
    bonds);
  EXPECT_EQ(example.Atoms.size(), 3u);
  EXPECT_EQ(example.Atoms[1].Position[0], 51.0);
  // Monomer libraries: a list without atoms first, columns x, y, z.
  const std::string library =
    "data_comp_list\nloop_\n_chem_comp.id\n_chem_comp.name\nEOH ethanol\n" + head +
    "_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\n" +
    "EOH C1 C 0.000 1 0 0\nEOH O O 0 2.4 0 0\n" + bonds;
  EXPECT_EQ(JoinNames(FromCIF(library)), "C1 O ");
}

// Two components in one table have atoms of the same names.
TEST(CIFAtomTable, BondsStayWithinTheirComponent)
{
  MoleculeOptions fileBonds;
  fileBonds.BondsByDistance = false;
  const Macromolecule both = ParseMolecule(
    "data_comp\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n"
    "_chem_comp_atom.type_symbol\n_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\n"
    "EOH C1 C 0 0 0\nEOH C2 C 1.5 0 0\nEOH O O 0 1.4 0\n"
    "MOH C1 C 9 0 0\nMOH N N 9 9 0\nMOH O O 9 1.4 0\n"
    "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n"
    "EOH C1 C2\nEOH C1 O\nMOH C1 O\n",
    MoleculeFormat::MMCIF, fileBonds);
  ASSERT_EQ(both.Atoms.size(), 6u);
  std::set<std::pair<std::int64_t, std::int64_t>> bonds;
  for (const auto& bond : both.Bonds)
  {
    bonds.emplace(bond.First, bond.Second);
  }
  EXPECT_EQ(
    bonds, (std::set<std::pair<std::int64_t, std::int64_t>>{ { 0, 1 }, { 0, 2 }, { 3, 5 } }));
}

TEST(CIFAtomTable, AtomsOfALaterDataBlockAreRead)
{
  const std::string glycine = Glycine(AllColumns);
  const std::string first = FromCIF("data_global\n_journal_year 2016\n" + glycine).Warnings.empty()
    ? JoinNames(FromCIF("data_global\n_journal_year 2016\n" + glycine))
    : "warned";
  EXPECT_EQ(first, "N CA C O CA O ");
  const std::string other = "data_zinc\n_atom_site.label_atom_id ZN\n_atom_site.label_comp_id ZN\n"
                            "_atom_site.Cartn_x 1\n_atom_site.Cartn_y 2\n_atom_site.Cartn_z 3\n";
  const Macromolecule both = FromCIF(glycine + other);
  EXPECT_EQ(both.Atoms.size(), 6u);
  EXPECT_EQ(both.NumberOfModels, 2);
  EXPECT_TRUE(Mention(both.Warnings, "2 data blocks with atoms (gly, zinc)"));
  EXPECT_EQ(JoinNames(FromCIF(glycine + other, 1)), "ZN ");
  EXPECT_NE(Why("data_r1abcsf\nloop_\n_refln.index_h\n_refln.index_k\n1 2\n").find("reflections"),
    std::string::npos);
}

TEST(CIFAtomTable, ConfidenceOfModelCIFIsAnArray)
{
  const std::string metrics =
    "loop_\n_ma_qa_metric.id\n_ma_qa_metric.mode\n_ma_qa_metric.name\n1 global pTM\n2 local pLDDT\n"
    "loop_\n_ma_qa_metric_local.label_asym_id\n_ma_qa_metric_local.label_comp_id\n"
    "_ma_qa_metric_local.label_seq_id\n_ma_qa_metric_local.metric_id\n"
    "_ma_qa_metric_local.metric_value\n_ma_qa_metric_local.model_id\n"
    "_ma_qa_metric_local.ordinal_id\nA GLY 1 2 91.25 1 1\nA GLY 1 1 0.5 1 2\n";
  const Macromolecule molecule = FromCIF(Glycine(AllColumns) + metrics);
  ASSERT_EQ(molecule.Atoms.size(), 6u);
  EXPECT_EQ(molecule.Atoms[0].PLDDT, 91.25);
  EXPECT_EQ(molecule.Atoms[3].PLDDT, 91.25);
  EXPECT_TRUE(std::isnan(molecule.Atoms[4].PLDDT));
  EXPECT_EQ(molecule.Atoms[0].BFactor, 12.5);
}

TEST(CIFAtomTable, FractionalCoordinatesCountWhereCartesianOnesAreUnknown)
{
  const Macromolecule molecule =
    FromCIF("data_x\n_cell.length_a 10\n_cell.length_b 20\n_cell.length_c 30\nloop_\n"
            "_atom_site.label_atom_id\n_atom_site.type_symbol\n_atom_site.Cartn_x\n"
            "_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.fract_x\n_atom_site.fract_y\n"
            "_atom_site.fract_z\nC1 C ? ? ? 0.1 0.1 0.1\nO1 O ? ? ? 0.2 0.1 0.1\n");
  ASSERT_EQ(molecule.Atoms.size(), 2u);
  EXPECT_NEAR(molecule.Atoms[1].Position[0], 2.0, 1e-12);
  EXPECT_NEAR(molecule.Atoms[1].Position[2], 3.0, 1e-12);
}

TEST(CIFAtomTable, MalformedValuesDropNoAtoms)
{
  const std::vector<std::string> columns{ "label_atom_id", "auth_seq_id", "pdbx_PDB_ins_code",
    "pdbx_formal_charge", "label_alt_id", "Cartn_x", "Cartn_y", "Cartn_z" };
  std::string text = "data_x\nloop_\n";
  for (const std::string& column : columns)
  {
    text += "_atom_site." + column + "\n";
  }
  text += "N   one ?  2+  .  0 0 0\nCA  15A B  1-  .  2 0 0\nC '16' ?  x   .  4 0 0\n"
          "O   17C ?  1.0 AB 6 0 0\nCB  -3  AB +1  .  8 0 0\n";
  const Macromolecule molecule = FromCIF(text);
  ASSERT_EQ(JoinNames(molecule), "N CA C OA CB ");
  const int numbers[] = { 0, 15, 16, 17, -3 };
  const double charges[] = { 2, -1, Atom::Unknown, 1, 1 };
  const char insertions[] = { ' ', 'B', ' ', 'C', 'A' };
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(molecule.Atoms[i].ResidueId, numbers[i]) << i;
    EXPECT_EQ(molecule.Atoms[i].InsertionCode, insertions[i]) << i;
    EXPECT_TRUE(molecule.Atoms[i].Charge == charges[i] ||
      (std::isnan(molecule.Atoms[i].Charge) && std::isnan(charges[i])))
      << i << " " << molecule.Atoms[i].Charge;
  }
  EXPECT_TRUE(Mention(molecule.Notes, "1 value of auth_seq_id"));
  EXPECT_TRUE(Mention(molecule.Notes, "1 value of pdbx_formal_charge"));
}

TEST(CIFAtomTable, MalformedConnectionsDropNoAtoms)
{
  const std::string connections =
    "_struct_conn.id covale1\n_struct_conn.conn_type_id covale\n_struct_conn.ptnr1_label_comp_id "
    "GLY\n"
    "_struct_conn.ptnr2_label_comp_id GLY\n_struct_conn.ptnr1_label_atom_id N\n"
    "_struct_conn.ptnr2_label_atom_id C\n";
  const Macromolecule molecule = FromCIF(Glycine(AllColumns) + connections);
  EXPECT_EQ(molecule.Atoms.size(), 6u);
  EXPECT_TRUE(Mention(molecule.Warnings, "struct_conn"));
}
