// Kirkwood's spheres K1 (Born's ion, 1/80) and K2 (three charges off the center, 2/80) on 65^3
// nodes of 0.5 angstrom and the same box at 1 and 0.25: errors of the energy and of the potential
// outside against the series, by this solver with the border it makes itself, and by APBS (srfm mol
// and smol, bcfl mdh; two solutions) with the same charges, radii and grid in the same run; and the
// ratios. Needs `apbs`.

#include "../Unit/Electrostatics/SphereProblem.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

constexpr double Half = 16.0; // angstrom

std::map<std::pair<int, int>, SphereErrors> Ours; ///< by sphere and 4 h

void Isthmus(benchmark::State& state)
{
  const int number = static_cast<int>(state.range(0));
  const double h = 0.25 * static_cast<double>(state.range(1));
  for (auto _ : state)
  {
    SphereProblem problem(Kirkwood(number), Half, h);
    problem.Parameters.BoundaryCondition = BoundaryCondition::SelfConsistent;
    problem.Parameters.Tolerance = 1e-6;
    const auto solution = problem.Solve();
    const SphereErrors errors = RecordErrors(problem, *solution);
    Ours[{ number, static_cast<int>(state.range(1)) }] = errors;
    state.counters["energy"] = errors.Energy;
    state.counters["outside_kT"] = errors.Outside;
    state.counters["iterations"] = solution->GetReport().Iterations;
  }
}

/// The numbers of an OpenDX file, z running fastest.
std::vector<double> ReadDX(const std::filesystem::path& path)
{
  std::vector<double> values;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    const char first = line.empty() ? '#' : line.front();
    if (first == '-' || (first >= '0' && first <= '9'))
    {
      std::istringstream words(line);
      for (double v; words >> v;)
      {
        values.push_back(v);
      }
    }
  }
  return values;
}

void WriteInput(const std::filesystem::path& folder, const KirkwoodSphere& s, std::int64_t n,
  double h, const std::string& surface)
{
  std::ofstream molecule(folder / "sphere.pqr");
  molecule << "ATOM 1 C BAL 1 " << s.Center[0] << " " << s.Center[1] << " " << s.Center[2]
           << " 0.0 " << s.Radius << "\n";
  int serial = 2;
  for (const ChargedAtom& q : s.Charges)
  {
    molecule << "ATOM " << serial++ << " Q BAL 1 " << q.Position[0] << " " << q.Position[1] << " "
             << q.Position[2] << " " << q.Charge << " 0.0\n";
  }
  std::ofstream input(folder / "in");
  input << "read mol pqr sphere.pqr end\n";
  for (const bool solvated : { true, false })
  {
    input << "elec name " << (solvated ? "solv" : "ref") << " mg-manual dime " << n << " " << n
          << " " << n << " grid " << h << " " << h << " " << h
          << " gcent 0 0 0 mol 1 lpbe bcfl mdh pdie " << s.Solute << " sdie "
          << (solvated ? s.Solvent : s.Solute) << " chgm spl0 srfm " << surface
          << " srad 1.4 swin 0.3 sdens 40.0 temp 298.15 calcenergy total calcforce no"
          << (solvated ? " write pot dx pot" : "") << " end\n";
  }
  input << "print elecEnergy solv - ref end\nquit\n";
}

/// Largest error outside of the sphere; APBS' DX files have z running fastest.
double OutsideError(const KirkwoodSphere& s, const std::vector<double>& u, std::int64_t n, double h)
{
  double worst = 0.0;
  for (std::int64_t node = 0; node < n * n * n; ++node)
  {
    const Point3 x{ h * static_cast<double>(node / (n * n)) - Half,
      h * static_cast<double>(node / n % n) - Half, h * static_cast<double>(node % n) - Half };
    if (s.Distance(x) >= s.Radius)
    {
      worst = std::max(worst, std::abs(u[static_cast<std::size_t>(node)] - s.Outside(x)));
    }
  }
  return worst;
}

void Apbs(benchmark::State& state)
{
  const int number = static_cast<int>(state.range(0));
  const double h = 0.25 * static_cast<double>(state.range(1));
  const auto n = static_cast<std::int64_t>(std::llround(2.0 * Half / h)) + 1;
  const KirkwoodSphere sphere = Kirkwood(number);
  const auto folder = std::filesystem::temp_directory_path() / "isthmus-apbs-spheres";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  WriteInput(folder, sphere, n, h, state.range(2) ? "smol" : "mol");
  const std::string command = "cd '" + folder.string() + "' && apbs in > out 2>&1";
  for (auto _ : state)
  {
    if (std::system(command.c_str()) != 0)
    {
      state.SkipWithError("apbs did not run");
      return;
    }
  }
  double energy = 0.0;
  std::ifstream output(folder / "out");
  for (std::string line; std::getline(output, line);)
  {
    if (line.find("Global net ELEC energy =") != std::string::npos)
    {
      energy = std::stod(line.substr(line.find('=') + 1)) / units::ThermalKilojoule(298.15);
    }
  }
  std::filesystem::path written = folder / "pot.dx";
  written = std::filesystem::exists(written) ? written : folder / "pot-PE0.dx";
  const std::vector<double> u = ReadDX(written);
  if (static_cast<std::int64_t>(u.size()) != n * n * n)
  {
    state.SkipWithError("apbs wrote no potential");
    return;
  }
  const double error = std::abs(energy / sphere.Energy() - 1.0);
  const double outside = OutsideError(sphere, u, n, h);
  state.counters["energy"] = error;
  state.counters["outside_kT"] = outside;
  const SphereErrors& ours = Ours[{ number, static_cast<int>(state.range(1)) }];
  state.counters["ours/apbs_energy"] = ours.Energy / error;
  state.counters["ours/apbs_outside"] = ours.Outside / outside;
}

}

BENCHMARK(Isthmus)->ArgsProduct({ { 1, 2 }, { 4, 2, 1 } })->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(Apbs)
  ->ArgsProduct({ { 1, 2 }, { 4, 2, 1 }, { 0, 1 } })
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
BENCHMARK_MAIN();
