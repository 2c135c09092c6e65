// A million atoms from PQR: the whole reader with and without bonds by distance, beside a plain
// loop of fread and strtod that stores only the five numbers of each line. A million atoms
// from PDB and from mmCIF beside gemmi's own readers.

#include "vtkMacromoleculeReader.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <gemmi/cif.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr int Atoms = 1000000;

/// A protein-like density of atoms: a lattice 2.15 angstrom wide with jitter.
class Files
{
public:
  Files()
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.6, 0.6);
    std::ofstream pqr(this->PQR);
    std::ofstream pdb(this->PDB);
    std::ofstream cif(this->CIF);
    // The columns of the PDB's files; 100 chains, since gemmi searches a chain for each residue.
    cif << "data_million\nloop_\n";
    for (const char* column : { "group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id",
           "label_comp_id", "label_asym_id", "label_entity_id", "label_seq_id", "pdbx_PDB_ins_code",
           "Cartn_x", "Cartn_y", "Cartn_z", "occupancy", "B_iso_or_equiv", "pdbx_formal_charge",
           "auth_seq_id", "auth_comp_id", "auth_asym_id", "auth_atom_id", "pdbx_PDB_model_num" })
    {
      cif << "_atom_site." << column << "\n";
    }
    std::array<char, 160> line;
    for (int i = 0; i < Atoms; ++i)
    {
      const double x = 2.15 * (i % 100) + jitter(random);
      const double y = 2.15 * (i / 100 % 100) + jitter(random);
      const double z = 2.15 * (i / 10000) + jitter(random);
      const char* name = std::array{ "N", "CA", "C", "O", "CB" }[static_cast<std::size_t>(i % 5)];
      std::snprintf(line.data(), line.size(),
        "ATOM  %5d  %-3s ALA A%4d    %8.3f%8.3f%8.3f %7.4f %6.4f\n", i % 100000, name,
        i / 5 % 10000, x, y, z, 0.1 * (i % 7) - 0.3, 1.5 + 0.1 * (i % 4));
      pqr << line.data();
      std::snprintf(line.data(), line.size(),
        "ATOM  %5d  %-3s ALA A%4d    %8.3f%8.3f%8.3f  1.00 20.00           %c  \n", i % 100000,
        name, i / 5 % 10000, x, y, z, name[0]);
      pdb << line.data();
      std::snprintf(line.data(), line.size(),
        "ATOM %d %c %s . ALA A%d 1 %d ? %.3f %.3f %.3f 1.00 20.00 ? %d ALA A%d %s 1\n", i + 1,
        name[0], name, i / 10000, i / 5 % 2000 + 1, x, y, z, i / 5 % 2000 + 1, i / 10000, name);
      cif << line.data();
    }
  }
  ~Files()
  {
    std::filesystem::remove(this->PQR);
    std::filesystem::remove(this->PDB);
    std::filesystem::remove(this->CIF);
  }
  std::string PQR = (std::filesystem::temp_directory_path() / "isthmus_million.pqr").string();
  std::string PDB = (std::filesystem::temp_directory_path() / "isthmus_million.pdb").string();
  std::string CIF = (std::filesystem::temp_directory_path() / "isthmus_million.cif").string();
};

const Files& TheFiles()
{
  static const Files files;
  return files;
}

/// Seconds of one reading of each file, kept for the ratios that the peers print.
std::map<std::string, double> Ours;

template <typename Work>
double MeasureSeconds(Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void ReadOnce(benchmark::State& state, const std::string& file, bool bonds)
{
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetBondsByDistance(bonds);
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPoints() != Atoms)
  {
    state.SkipWithError("wrong number of atoms");
  }
  state.counters["bonds"] = static_cast<double>(reader->GetOutput()->GetNumberOfLines());
}

void Read(benchmark::State& state, const std::string& file, bool bonds)
{
  for (auto _ : state)
  {
    Ours[file] = MeasureSeconds([&] { ReadOnce(state, file, bonds); });
  }
}

/// The minimum time to read the numbers in plain C.
void FreadStrtodOnce(benchmark::State& state)
{
  std::FILE* file = std::fopen(TheFiles().PQR.c_str(), "rb");
  std::string text(std::filesystem::file_size(TheFiles().PQR), '\0');
  const std::size_t got = std::fread(&text[0], 1, text.size(), file);
  std::fclose(file);
  std::vector<double> numbers;
  const char* at = text.data();
  for (; at + 55 < text.data() + got; at = std::strchr(at, '\n') + 1)
  {
    for (const int column : { 30, 38, 46 })
    {
      std::array<char, 9> field{};
      std::copy_n(at + column, 8, field.begin());
      numbers.push_back(std::strtod(field.data(), nullptr));
    }
    char* end = nullptr;
    numbers.push_back(std::strtod(at + 54, &end));
    numbers.push_back(std::strtod(end, nullptr));
  }
  if (numbers.size() != std::size_t{ 5 } * Atoms)
  {
    state.SkipWithError("wrong number of numbers");
  }
  benchmark::DoNotOptimize(numbers.data());
}

void FreadStrtod(benchmark::State& state)
{
  for (auto _ : state)
  {
    state.counters["reader/this"] =
      Ours[TheFiles().PQR] / MeasureSeconds([&] { FreadStrtodOnce(state); });
  }
}

void GemmiPDB(benchmark::State& state)
{
  for (auto _ : state)
  {
    const double seconds =
      MeasureSeconds([] { benchmark::DoNotOptimize(gemmi::read_pdb_file(TheFiles().PDB)); });
    state.counters["reader/this"] = Ours[TheFiles().PDB] / seconds;
  }
}

void GemmiMMCIF(benchmark::State& state)
{
  for (auto _ : state)
  {
    const double seconds = MeasureSeconds([]
      { benchmark::DoNotOptimize(gemmi::make_structure(gemmi::cif::read_file(TheFiles().CIF))); });
    state.counters["reader/this"] = Ours[TheFiles().CIF] / seconds;
  }
}

}

BENCHMARK_CAPTURE(Read, PQRWithoutDistances, TheFiles().PQR, false)
  ->Unit(benchmark::kSecond)
  ->UseRealTime();
// The complete result: atoms, arrays, bonds, both outputs.
BENCHMARK_CAPTURE(Read, PQR, TheFiles().PQR, true)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK(FreadStrtod)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(Read, PDBWithoutDistances, TheFiles().PDB, false)
  ->Unit(benchmark::kSecond)
  ->UseRealTime();
BENCHMARK(GemmiPDB)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(Read, MMCIFWithoutDistances, TheFiles().CIF, false)
  ->Unit(benchmark::kSecond)
  ->UseRealTime();
BENCHMARK(GemmiMMCIF)->Unit(benchmark::kSecond)->UseRealTime();

BENCHMARK_MAIN();
