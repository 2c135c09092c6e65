// Assemblies of mmCIF files: products of groups of operators, and tables that are incomplete.

#include "Molecules/CIFAssemblies.h"
#include "PDBText.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

Macromolecule ReadReportedAssembly(const std::string& file, const std::string& name)
{
  MoleculeOptions options;
  options.Assembly = name;
  return ReadMacromolecule((SharedDataFolder() / "reports" / file).string(), options);
}

/// One atom at (1, 0, 0), T moves it by 10 along x, R turns it by 90 degrees about z, H-1 is the
/// identity. `tables`: those of the assembly.
std::string OneAtom(const std::string& tables)
{
  std::string text = "data_X\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
                     "_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                     "_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n"
                     "_atom_site.Cartn_y\n_atom_site.Cartn_z\nATOM 1 C CA GLY A 1 1 0 0\n#\nloop_\n"
                     "_pdbx_struct_oper_list.id\n";
  for (const char* row : { "1", "2", "3" })
  {
    for (const char* column : { "1", "2", "3" })
    {
      text += std::string("_pdbx_struct_oper_list.matrix[") + row + "][" + column + "]\n";
    }
    text += std::string("_pdbx_struct_oper_list.vector[") + row + "]\n";
  }
  text += "T 1 0 0 10 0 1 0 0 0 0 1 0\nR 0 -1 0 0 1 0 0 0 0 0 1 0\nH-1 1 0 0 0 0 1 0 0 0 0 1 0\n"
          "BAD 1 0 0 ? 0 1 0 0 0 0 1 0\n#\n";
  return text + tables;
}

std::string Generator(const std::string& expression, const std::string& name = "1")
{
  return "_pdbx_struct_assembly_gen.assembly_id " + name +
    "\n_pdbx_struct_assembly_gen.oper_expression '" + expression +
    "'\n_pdbx_struct_assembly_gen.asym_id_list A\n";
}

std::vector<std::array<double, 3>> Places(const std::string& text)
{
  MoleculeOptions options;
  options.Assembly = "1";
  std::vector<std::array<double, 3>> places;
  for (const Atom& atom : ParseMolecule(text, MoleculeFormat::MMCIF, options).Atoms)
  {
    places.push_back(atom.Position);
  }
  return places;
}

std::string WhyNot(const std::string& expression, const std::string& name = "1")
{
  MoleculeOptions options;
  options.Assembly = "1";
  return CatchMessage(OneAtom(Generator(expression, name)), MoleculeFormat::MMCIF, options);
}

void ExpectPlaces(const std::string& text, const std::vector<std::array<double, 3>>& wanted)
{
  const auto places = Places(text);
  ASSERT_EQ(places.size(), wanted.size()) << text.substr(text.find("_pdbx_struct_assembly"));
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(places[i][axis], wanted[i][axis], 1e-9) << i << " " << axis;
    }
  }
}

using Products = std::vector<std::vector<std::string>>;

}

TEST(Assemblies, ReportedFiles)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/g07_assembly_gen.cif");
  const std::size_t atoms = ReadReportedAssembly("g07_assembly_gen.cif", "").Atoms.size();
  EXPECT_EQ(atoms, 82u);
  for (const auto& [name, wanted] :
    { std::pair("1", 123u), std::pair("2", 82u), std::pair("3", 492u) })
  {
    EXPECT_EQ(ReadReportedAssembly("g07_assembly_gen.cif", name).Atoms.size(), wanted) << name;
  }
  EXPECT_EQ(ReadReportedAssembly("g07d_no_method_details.cif", "1").Atoms.size(), 123u);
}

// The dictionary of mmCIF: "applied from right to left".
TEST(Assemblies, ProductsAreAppliedFromRightToLeft)
{
  ExpectPlaces(OneAtom(Generator("(R)(T)")), { { 0, 11, 0 } });
  ExpectPlaces(OneAtom(Generator("(T)(R)")), { { 10, 1, 0 } });
  ExpectPlaces(OneAtom(Generator("(R)(T)(R)")), { { -1, 10, 0 } });
  ExpectPlaces(OneAtom(Generator("(H-1, R) (H-1,T)")),
    { { 1, 0, 0 }, { 11, 0, 0 }, { 0, 1, 0 }, { 0, 11, 0 } });
  ExpectPlaces(OneAtom(Generator("H-1,T")), { { 1, 0, 0 }, { 11, 0, 0 } });
}

TEST(Assemblies, ExpressionsOfTheDictionary)
{
  EXPECT_EQ(ParseOperatorExpression("1", {}), (Products{ { "1" } }));
  EXPECT_EQ(ParseOperatorExpression("1,3-5", {}), (Products{ { "1" }, { "3" }, { "4" }, { "5" } }));
  EXPECT_EQ(ParseOperatorExpression("(1,2)(3,4)", {}),
    (Products{ { "1", "3" }, { "1", "4" }, { "2", "3" }, { "2", "4" } }));
  EXPECT_EQ(ParseOperatorExpression("(1-60)(X0)(P)", {}).size(), 60u);
  EXPECT_EQ(ParseOperatorExpression("X-1", { "X-1" }), (Products{ { "X-1" } }));
  for (const char* faulty : { "", "(1", "1)", "(1)2", "((1)(2))", "(1)(2,)", "3-1", "a-b", "()" })
  {
    EXPECT_THROW(ParseOperatorExpression(faulty, {}), std::invalid_argument) << faulty;
  }
}

// Predictors and converters write no pdbx_struct_assembly, or one with other columns or details.
TEST(Assemblies, TheTableOfAssembliesMayBeMissingOrIncomplete)
{
  const std::string id = "_pdbx_struct_assembly.id 1\n";
  for (const std::string& table : { std::string(), id,
         id + "_pdbx_struct_assembly.details ?\n_pdbx_struct_assembly.method_details ?\n",
         id +
           "_pdbx_struct_assembly.details 'helical assembly'\n"
           "_pdbx_struct_assembly.method_details ?\n_pdbx_struct_assembly.oligomeric_details ?\n"
           "_pdbx_struct_assembly.oligomeric_count ?\n" })
  {
    ExpectPlaces(OneAtom(table + Generator("T")), { { 11, 0, 0 } });
  }
}

TEST(Assemblies, FaultsAreNamedWhenTheAssemblyIsWanted)
{
  EXPECT_NE(WhyNot("(1-2000000000)").find("more than 100,000"), std::string::npos);
  EXPECT_NE(WhyNot("(1-999)(1-999)").find("more than 100,000"), std::string::npos);
  EXPECT_NE(WhyNot("(R)(Q)").find("needs operator Q"), std::string::npos) << WhyNot("(R)(Q)");
  EXPECT_NE(WhyNot("BAD").find("operator BAD"), std::string::npos) << WhyNot("BAD");
  EXPECT_NE(WhyNot("(R").find("oper_expression (R"), std::string::npos) << WhyNot("(R");
  EXPECT_EQ(WhyNot("R", "PAU"), "test: there is no assembly 1; the file describes PAU.");
  // Nothing of it matters without an assembly.
  EXPECT_EQ(CatchMessage(OneAtom(Generator("(1-2000000000)")), MoleculeFormat::MMCIF), "");
}
