// libFuzzer target: the bytes as a molecule in one of the formats (the first byte says which, the
// second which atoms are selected). The result must have finite positions and bonds between
// existing atoms.
//
// Seeds come from LLVMFuzzerCustomMutator, which occasionally starts from a valid file.

#include "FuzzInput.h"
#include "Molecules/MacromoleculeReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

namespace
{

const std::string Samples[] = { std::string("\x01\x00", 2) + R"(HEADER    HYDROLASE
MODEL        1
ATOM      1  N  ALYS A   1       3.398   9.981  10.408  0.60 20.00           N1+
ATOM      2  CA BLYS A   1A      2.459  10.365   9.364  0.40 20.00           C
ANISOU    2  CA BLYS A   1A      123    123    123      1      2      3       C
ATOM      3  SG  CYS B  12       2.459  11.365   9.364  1.00 20.00           S
TER       4      CYS B  12
HETATM A0000 FE  HEM C1000       3.459  10.365   9.364                      FE
ENDMDL
SSBOND   1 CYS B   12    CYS B   12                          1555   1555  2.00
LINK         SG  CYS B  12                FE   HEM C1000     1555   1555  2.30
CONECT    1    2    3
END
)",
  std::string("\x02\x01", 2) + R"(data_1ABC
loop_
_atom_site.group_PDB
_atom_site.id
_atom_site.type_symbol
_atom_site.label_atom_id
_atom_site.label_alt_id
_atom_site.label_comp_id
_atom_site.label_asym_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
_atom_site.occupancy
_atom_site.B_iso_or_equiv
_atom_site.auth_seq_id
_atom_site.pdbx_PDB_model_num
ATOM 1 N N . LYS A 3.398 9.981 10.408 1.00 ? 1 1
ATOM 2 C 'CA' A LYS A 2.459 10.365 9.364 ? 20.0 1 1
HETATM 3 O O . HOH B 1 2 3e0 1 1 -5 2
#
loop_
_struct_conn.id
_struct_conn.conn_type_id
_struct_conn.ptnr1_auth_asym_id
_struct_conn.ptnr1_auth_seq_id
_struct_conn.ptnr1_label_comp_id
_struct_conn.ptnr1_label_atom_id
_struct_conn.ptnr2_auth_asym_id
_struct_conn.ptnr2_auth_seq_id
_struct_conn.ptnr2_label_comp_id
_struct_conn.ptnr2_label_atom_id
c covale A 1 LYS N A 1 LYS CA
)",
  std::string("\x03\x02", 2) + R"(REMARK   1 PQR
ATOM      1  N   LYS     1       3.398   9.981  10.408  0.0966 1.8240
ATOM     36  HB2 ASP A   3    2004.9053004.355-899.274 -0.0212 1.4870
ATOM      3  CA  LYS A 1003A   2.459  10.365   9.364 -0.0015 1.9080 C
HETATM100000 ZN  ZN  B1004       1.459  10.365   9.364  2.0000 0.0000
ENDMDL
ATOM 1 C A 1 0.0 0.0 0.0 0.1 1.87
)",
  std::string("\x04\x00", 2) +
    "3\nwater\nO 0 0 0\nH 0.96 0 0 1 2 3\n1 -.24 0.93 0\n\n1\nc\nFe1 0 0 1e3\n" };

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  isthmus::testing::OneThreadAndSilence();
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(
  uint8_t* data, size_t size, size_t most, unsigned int seed)
{
  if (size < 8 || seed % 64 == 0)
  {
    const std::string& sound = Samples[seed / 64 % 4];
    size = std::min(most, sound.size());
    std::memcpy(data, sound.data(), size);
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  if (size < 2)
  {
    return 0;
  }
  const char* const altLocs[] = { "", "*", "A", "B" };
  isthmus::MoleculeOptions options;
  options.Format =
    static_cast<isthmus::MoleculeFormat>(data[0] % (isthmus::NumberOfMoleculeFormats + 1));
  options.AltLoc = altLocs[data[1] % 4];
  options.ModelIndex = data[1] / 4 % 2;
  options.ReadHetero = data[1] / 8 % 2 == 0;
  options.Chains = data[1] / 16 % 2 == 0 ? "" : "A";
  isthmus::Macromolecule molecule;
  try
  {
    molecule = isthmus::ParseMacromolecule(
      { reinterpret_cast<const char*>(data) + 2, size - 2 }, "fuzz", options);
  }
  catch (const std::runtime_error&)
  {
    return 0; // refused with a sentence
  }
  for (const isthmus::Atom& atom : molecule.Atoms)
  {
    for (const double x : atom.Position)
    {
      if (!std::isfinite(x))
      {
        std::abort();
      }
    }
  }
  for (const isthmus::Bond& bond : molecule.Bonds)
  {
    if (bond.First < 0 || bond.First >= bond.Second ||
      bond.Second >= static_cast<std::int64_t>(molecule.Atoms.size()))
    {
      std::abort();
    }
  }
  return 0;
}
