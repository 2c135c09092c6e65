// Lysozyme (1HEW) on grids of 65^3 to 257^3 over the same cube: CPU and wall time, iterations,
// bytes per node; thirty-two of them, 62,720 atoms, on 193^3; the same charges, radii and grid by
// APBS (two solutions: solvated and reference) and the ratios. On a busy machine, only CPU time is
// meaningful. Needs ISTHMUS_DATA_DIR or the default data, and `apbs`.

#include "Atoms/MolecularDensity.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/PoissonBoltzmann.h"
#include "PeakMemory.h"
#include "SharedData.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace
{

using namespace isthmus;

constexpr double Side = 66.0; // angstrom, around lysozyme with 10 and more of solvent

double CpuSeconds(int who)
{
  rusage use{};
  getrusage(who, &use);
  return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
    1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

/// ATOM lines of a PQR file: the last five columns are x, y, z, charge, radius.
std::vector<ChargedAtom> ReadPQR(const std::filesystem::path& path)
{
  std::vector<ChargedAtom> atoms;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("ATOM", 0) != 0 && line.rfind("HETATM", 0) != 0)
    {
      continue;
    }
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;)
    {
      all.push_back(word);
    }
    double v[5];
    for (std::size_t i = 0; i < 5; ++i)
    {
      v[i] = std::stod(all[all.size() - 5 + i]);
    }
    atoms.push_back({ { v[0], v[1], v[2] }, v[3], v[4] });
  }
  return atoms;
}

std::filesystem::path Lysozyme()
{
  return isthmus::testing::SharedDataFolder() / "molecules/1hew/1hew.pqr";
}

Point3 BoundsCenter(const std::vector<ChargedAtom>& atoms)
{
  Point3 low{ 1e9, 1e9, 1e9 }, high{ -1e9, -1e9, -1e9 };
  for (const ChargedAtom& atom : atoms)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], atom.Position[a]);
      high[a] = std::max(high[a], atom.Position[a]);
    }
  }
  return { 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]) };
}

struct Run
{
  double Energy = 0.0, Cpu = 0.0, Bytes = 0.0; ///< kcal/mol, seconds, growth of the whole process
};

std::map<std::int64_t, Run> Ours;

/// Solves for atoms (in the frame of the grid) on n^3 nodes of h, with a Gaussian surface.
Run Solve(benchmark::State& state, const std::vector<ChargedAtom>& atoms, std::int64_t n, double h,
  BoundaryCondition condition)
{
  isthmus::testing::ResetPeakMemory();
  const double memory = isthmus::testing::PeakMemory();
  const double start = CpuSeconds(RUSAGE_SELF);
  std::vector<Ball> balls;
  for (const ChargedAtom& atom : atoms)
  {
    balls.push_back({ atom.Position, atom.Radius });
  }
  std::vector<float> density(static_cast<std::size_t>(n * n * n));
  GaussianSum(balls, 2.0, { 0.0, 0.0, 0.0 }, { density.data(), { n, n, n }, { h, h, h } });
  LevelFunction level;
  level.Floats = { density.data(), { n, n, n }, { h, h, h } };
  level.Level = 1.0;
  level.Logarithm = true;
  PoissonBoltzmannParameters parameters;
  parameters.BoundaryCondition = condition;
  parameters.Padding = 0.0;
  const IonAtmosphere ions({}, parameters.Temperature);
  const auto solution =
    SolvePoissonBoltzmann(level, BoxAround(level, 0.0), atoms, parameters, ions);
  const PoissonBoltzmannReport& report = solution->GetReport();
  Run run;
  run.Energy = report.SolvationEnergy * units::ThermalKilocalorie(parameters.Temperature);
  run.Cpu = CpuSeconds(RUSAGE_SELF) - start;
  run.Bytes = isthmus::testing::PeakMemory() - memory;
  const auto nodes = static_cast<double>(n * n * n);
  state.counters["kcal"] = run.Energy;
  state.counters["cpu_s"] = run.Cpu;
  state.counters["us_per_node"] = 1e6 * run.Cpu / nodes;
  state.counters["iterations"] = report.Iterations;
  state.counters["bytes_per_node"] = run.Bytes / nodes;
  state.counters["fallbacks"] = static_cast<double>(report.LinearFits + report.GhostFits);
  return run;
}

/// Lysozyme, its box's middle at `place`.
void AddLysozyme(const Point3& place, std::vector<ChargedAtom>& atoms)
{
  const std::vector<ChargedAtom> one = ReadPQR(Lysozyme());
  const Point3 center = BoundsCenter(one);
  for (ChargedAtom atom : one)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      atom.Position[a] += place[a] - center[a];
    }
    atoms.push_back(atom);
  }
}

/// Lysozyme on n^3 nodes.
void Lysozyme(benchmark::State& state)
{
  const std::int64_t n = state.range(0);
  std::vector<ChargedAtom> atoms;
  AddLysozyme({ 0.5 * Side, 0.5 * Side, 0.5 * Side }, atoms);
  for (auto _ : state)
  {
    Ours[n] = Solve(state, atoms, n, Side / static_cast<double>(n - 1),
      static_cast<BoundaryCondition>(state.range(1)));
  }
}

/// 4 x 4 x 2 of them, 44 angstrom apart: 62,720 atoms on 193^3 nodes of an angstrom.
void ManyAtoms(benchmark::State& state)
{
  std::vector<ChargedAtom> atoms;
  for (int copy = 0; copy < 32; ++copy)
  {
    AddLysozyme(
      { 30.0 + 44.0 * (copy % 4), 30.0 + 44.0 * (copy / 4 % 4), 74.0 + 44.0 * (copy / 16) }, atoms);
  }
  for (auto _ : state)
  {
    Solve(state, atoms, 193, 1.0, BoundaryCondition::SelfConsistent);
  }
}

/// APBS on the same nodes: CPU of the child, its memory, its energy.
void Apbs(benchmark::State& state)
{
  const std::int64_t n = state.range(0);
  const auto folder = std::filesystem::temp_directory_path() / "isthmus-apbs";
  std::filesystem::create_directories(folder);
  const Point3 center = BoundsCenter(ReadPQR(Lysozyme()));
  const double h = Side / static_cast<double>(n - 1);
  std::ofstream input(folder / "in");
  input << "read mol pqr " << Lysozyme().string() << " end\n";
  for (const char* kind : { "solv", "ref" })
  {
    input << "elec name " << kind << " mg-manual dime " << n << " " << n << " " << n << " grid "
          << h << " " << h << " " << h << " gcent " << center[0] << " " << center[1] << " "
          << center[2] << " mol 1 lpbe bcfl mdh pdie 2.0 sdie " << (kind[0] == 's' ? 80.0 : 2.0)
          << " chgm spl0 srfm mol srad 1.4 swin 0.3 sdens 10.0 temp 298.15 calcenergy total"
             " calcforce no end\n";
  }
  input << "print elecEnergy solv - ref end\nquit\n";
  input.close();
  const std::string command = "cd '" + folder.string() + "' && apbs in > out 2>&1";
  for (auto _ : state)
  {
    const double start = CpuSeconds(RUSAGE_CHILDREN);
    if (std::system(command.c_str()) != 0)
    {
      state.SkipWithError("apbs did not run");
      return;
    }
    const double cpu = CpuSeconds(RUSAGE_CHILDREN) - start;
    rusage use{};
    getrusage(RUSAGE_CHILDREN, &use);
    std::ifstream output(folder / "out");
    for (std::string line; std::getline(output, line);)
    {
      const auto at = line.find("Global net ELEC energy =");
      if (at != std::string::npos)
      {
        state.counters["kcal"] = std::stod(line.substr(line.find('=') + 1)) / 4.184;
      }
    }
    state.counters["cpu_s"] = cpu;
    state.counters["bytes_per_node"] =
      1024.0 * static_cast<double>(use.ru_maxrss) / static_cast<double>(n * n * n);
    if (Ours.count(n))
    {
      state.counters["ours/apbs_cpu"] = Ours[n].Cpu / cpu;
    }
  }
}

}

BENCHMARK(Lysozyme)
  ->ArgsProduct({ { 65, 97, 129, 193, 257 }, { 2, 3 } })
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
BENCHMARK(ManyAtoms)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(Apbs)->Arg(65)->Arg(97)->Arg(129)->Arg(193)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_MAIN();
