#include "ChokingLoops/ChokingLoops.h"

#include "ChokingLoops/AdaptiveSamples.h"
#include "ChokingLoops/GreedyMembrane.h"
#include "ChokingLoops/LocalChoke.h"
#include "ChokingLoops/MeshFunctionError.h"
#include "ChokingLoops/SideClasses.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Contouring/MapSurface.h"
#include "Core/DisjointSets.h"
#include "Core/Index.h"
#include "Core/MemoryBudget.h"
#include "Core/ParallelFor.h"
#include "Core/Stopwatch.h"
#include "Persistence/DelaunayFiltration.h"
#include "Persistence/LowerStarFiltration.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Threads and their memory arenas, and the part of a complex that does not depend on its size.
constexpr double FixedBytes = 8e6;

/// Bytes per sample for the complex, its pairs and the surface: 1.3 KB on a million samples, more
/// if an abandoned finer sampling was in memory at the same time.
constexpr double BytesOfSample = 1700.0;

/// For each of a sample's three edges, one bit for each dual loop that crosses it.
constexpr double BytesOfWord = 24.0;

/// At the peak of an analysis.
double EstimateBytes(const SurfaceView& samples)
{
  DisjointSets<std::int64_t> sets(static_cast<std::int64_t>(samples.Points.size()));
  auto components = static_cast<std::int64_t>(samples.Points.size());
  for (const Triangle& t : samples.Triangles)
  {
    for (std::size_t k = 1; k < 3; ++k)
    {
      components -= sets.Find(t[0]) != sets.Find(t[k]) ? 1 : 0;
      sets.Join(t[0], t[k]);
    }
  }
  // Each triangle has three halves of an edge.
  const auto euler = static_cast<std::int64_t>(samples.Points.size()) -
    static_cast<std::int64_t>(samples.Triangles.size() / 2);
  const std::int64_t rank = std::max<std::int64_t>(0, 2 * components - euler);
  return FixedBytes +
    (BytesOfSample + BytesOfWord * static_cast<double>((rank + 63) / 64)) *
    static_cast<double>(samples.Points.size());
}

}

/// Everything known about a surface. Built in order, since each part refers to those before.
struct ChokingAnalysis
{
  ChokingAnalysis(SurfaceSamples samples, CellFiltration filtration,
    std::vector<CellError> cellErrors, std::vector<double> values, ChokingLoopTimes& times,
    const ProgressCallback& progress)
    : Samples(std::move(samples.Mesh))
    , Origin(std::move(samples.Origin))
    , Filtration(std::move(filtration))
    , Pairs(Filtration, Between(progress, 0.0, 0.5))
    , Adjacency(Samples)
    , Homology(Adjacency)
    , Embedding(Adjacency, Filtration, Between(progress, 0.5, 0.55))
    , Context{ Filtration, Pairs, Homology, Embedding, Adjacency, std::move(samples.Errors),
      std::move(cellErrors), std::move(values) }
    , Regions(Context, Between(progress, 0.55, 0.6))
  {
    this->Filtration.DropTriangleRanks();
    times.Pairing += this->Watch.Lap();
    this->Found.Diagram = FindFeatures(this->Context, this->Regions, Between(progress, 0.6, 0.9));
    this->Filtration.DropEdgeAndCellValues();
    this->Found.Membranes.resize(this->Found.Diagram.Features.size());
    for (const ShapeFeature& feature : this->Found.Diagram.Features)
    {
      this->Found.Centers.push_back(this->Center(feature));
      this->DeathCenters.push_back(this->DeathCenter(feature));
    }
    this->MakeGeneratorLoops(Between(progress, 0.9, 1.0));
    times.Features += this->Watch.Lap();
  }

  // All at once, since each must be independent of those before.
  void MakeGeneratorLoops(const ProgressCallback& progress)
  {
    HomologySpan span;
    const auto count = static_cast<double>(this->Found.Membranes.size());
    for (std::size_t i = 0; i < this->Found.Membranes.size(); ++i)
    {
      Report(progress, static_cast<double>(i) / count);
      if (IsGenerator(this->Found.Diagram.Features[i]))
      {
        this->Found.Membranes[i] =
          FeatureMembrane(this->Context, this->Regions, this->Found.Diagram.Features[i], &span);
      }
    }
  }

  /// Handles and tunnels that the samples did not determine.
  void Complete()
  {
    try
    {
      if (!CompleteGenerators(this->Context, this->Found))
      {
        return;
      }
      this->Remark = "Some handles or tunnels are narrower than the sampling error: they are "
                     "marked as not trusted, and their radius is an upper bound. Lower the sample "
                     "spacing to measure it.";
    }
    catch (const std::runtime_error& error)
    {
      this->Remark =
        std::string("Number and side of handles and tunnels are not guaranteed. ") + error.what();
    }
  }

  Point3 Center(const ShapeFeature& feature) const
  {
    const auto t = this->Filtration.TrianglePoints(feature.Choke);
    const Point3& p = this->Filtration.Points[At(t[0])];
    const Point3& q = this->Filtration.Points[At(t[1])];
    const Point3& r = this->Filtration.Points[At(t[2])];
    return this->Context.Errors.Point.empty() ? (1.0 / 3.0) * (p + q + r) : Circumcenter(p, q, r);
  }

  /// The place where the space behind a choke is filled.
  Point3 DeathCenter(const ShapeFeature& feature) const
  {
    const TetrahedronId filler =
      feature.Dimension == 2 ? this->Pairs.VoidFilled(feature.Choke) : TetrahedronId::None();
    if (!filler.Exists())
    {
      return {};
    }
    const auto& t = this->Filtration.Tetrahedra[filler];
    return Circumcenter(this->Filtration.Points[At(t[0])], this->Filtration.Points[At(t[1])],
      this->Filtration.Points[At(t[2])], this->Filtration.Points[At(t[3])]);
  }

  /// Voids this persistent, relative to the side's reference length, deserve refinement.
  static constexpr double WorthRefining = 0.05;

  bool IsUnresolved(std::size_t i) const
  {
    const ShapeFeature& f = this->Found.Diagram.Features[i];
    const std::optional<Membrane>& membrane = this->Found.Membranes[i];
    return IsGenerator(f)
      ? !f.Trusted || (membrane && membrane->Loops.empty())
      : f.Kind == FeatureKind::Noise && f.Dimension == 2 && !f.Trusted && this->IsPersistent(f);
  }

  bool IsPersistent(const ShapeFeature& f) const
  {
    return f.Persistence() >
      WorthRefining * this->Found.Diagram.Reference[static_cast<std::size_t>(f.Side)];
  }

  /// Where a finer sampling would resolve features.
  std::vector<Refinement> UnresolvedFeatures() const
  {
    std::vector<Refinement> wanted;
    for (std::size_t i = 0; i < this->Found.Membranes.size(); ++i)
    {
      if (this->IsUnresolved(i))
      {
        const ShapeFeature& f = this->Found.Diagram.Features[i];
        const double gap =
          std::sqrt(std::max(0.0, f.PairDeath * f.PairDeath - f.PairBirth * f.PairBirth));
        wanted.push_back({ this->Found.Centers[i], 2.0 * f.Radius() + f.Error,
          std::min(0.9 * gap, 0.7 * std::sqrt(3.0) * f.Error) });
      }
    }
    return wanted;
  }

  /// Features whose radius should be accurate: those that may be reported.
  bool Counts(const ShapeFeature& f) const
  {
    const double threshold =
      WorthRefining * this->Found.Diagram.Reference[static_cast<std::size_t>(f.Side)];
    return IsGenerator(f) ||
      (f.Kind == FeatureKind::Additional && f.Persistence() > 0.5 * threshold &&
        f.Persistence() + ComputeUncertainty(f) > threshold);
  }

  /// Measures the radii of features on the fine surface itself, where the samples are fine enough.
  void MeasureOn(const FineSurface& fine, double accuracy)
  {
    std::vector<ShapeFeature>& features = this->Found.Diagram.Features;
    ParallelFor(0, static_cast<std::int64_t>(features.size()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          ShapeFeature& f = features[i];
          const std::optional<LocalChoke> choke = f.Trusted && f.Choke.Exists() && this->Counts(f)
            ? FindLocalChoke(this->Context, fine, f.Choke, 0.1 * accuracy)
            : std::nullopt;
          // The class of the surface itself has a death as well, which may be the reference length.
          const auto death =
            f.Dimension == 2 && f.Trusted && (f.Kind == FeatureKind::Noise || this->Counts(f))
            ? FindLocalDeath(
                this->Context, fine, this->DeathCenters[i], f.PairDeath, 0.1 * accuracy)
            : std::nullopt;
          if (death)
          {
            f.PairDeath = f.Death = death->Radius;
          }
          if (choke)
          {
            f.Narrowed = f.Radius() - choke->Radius;
            (f.Dimension == 1 ? f.PairDeath : f.PairBirth) = choke->Radius;
            f.Error = std::sqrt(choke->Radius * choke->Radius - choke->Lower * choke->Lower);
            this->Found.Centers[i] = choke->Center;
          }
        }
      });
    std::array<double, 2> reference{ 0.0, 0.0 };
    for (const ShapeFeature& f : features)
    {
      double& side = reference[static_cast<std::size_t>(f.Side)];
      side = std::max(side, f.Trusted ? f.PairDeath : 0.0);
    }
    this->Found.Diagram.Reference = reference;
    for (ShapeFeature& f : features)
    {
      f.Death =
        std::max(f.Radius(), std::min(f.Death, reference[static_cast<std::size_t>(f.Side)]));
    }
  }

  /// Sorts features by their measured radii.
  void SortFeatures()
  {
    std::vector<std::size_t> order(this->Found.Diagram.Features.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) {
        return this->Found.Diagram.Features[a].Radius() < this->Found.Diagram.Features[b].Radius();
      });
    const auto sort = [&order](auto& values)
    {
      auto sorted = values;
      for (std::size_t i = 0; i < order.size(); ++i)
      {
        sorted[i] = std::move(values[order[i]]);
      }
      values = std::move(sorted);
    };
    sort(this->Found.Diagram.Features);
    sort(this->Found.Membranes);
    sort(this->Found.Centers);
  }

  /**
   * Where denser samples on a fine surface would resolve features, or determine their radii to
   * `accuracy` (a fraction). With edges of x radii, points of the surface reach into the choking
   * ball by up to x^2 / 6 radii, plus the deviation.
   */
  std::vector<Refinement> ImpreciseFeatures(double accuracy) const
  {
    std::vector<Refinement> wanted;
    for (std::size_t i = 0; i < this->Found.Membranes.size(); ++i)
    {
      const ShapeFeature& f = this->Found.Diagram.Features[i];
      const bool isUnresolved = this->IsUnresolved(i);
      if (isUnresolved || (this->Counts(f) && ComputeUncertainty(f) > accuracy * f.Radius()))
      {
        wanted.push_back(
          { this->Found.Centers[i], isUnresolved ? 2.0 * f.Radius() + f.Error : 1.3 * f.Radius(),
            2.5 * std::sqrt(accuracy) * f.Radius(), accuracy * f.Radius() });
      }
    }
    return wanted;
  }

  Stopwatch Watch;
  TriangleMesh Samples;
  std::vector<SimplexId> Origin; ///< of samples on a finer surface
  CellFiltration Filtration;
  FiltrationPairs Pairs;
  SurfaceAdjacency Adjacency;
  SurfaceHomology Homology;
  SurfaceInComplex Embedding;
  FeatureContext Context;
  SpaceRegions Regions;
  LocatedFeatures Found;
  /// The minimum cuts of the requested features, without and with chords.
  std::map<std::pair<std::size_t, bool>, std::optional<Membrane>> MinimumCuts;
  std::mutex Mutex; ///< for membranes that are computed on demand
  ChokingLoopTimes Times;
  RepairReport Repairs;
  std::vector<Point3> DeathCenters;  ///< of voids
  std::unique_ptr<FineSurface> Fine; ///< with more points than Samples; null: they are the same
  std::string Remark;
};

namespace
{

/// Rounds of refinement around features that the sampling does not resolve.
constexpr int Rounds = 3;

/// The same on a fine surface, whose thickness the first samples follow already.
constexpr int RoundsOnFine = 1;

/// Features that a uniformly finer sampling does not resolve are not resolved by a locally finer
/// one either. If a round resolves less than half of its places, the next would resolve fewer and
/// take as long again.
bool IsInVain(std::size_t before, std::size_t left)
{
  return 2 * left > before || (before > ManyPlaces && left <= ManyPlaces);
}

}

ChokingLoops::ChokingLoops(
  TriangleMesh surface, const ChokingLoopParameters& parameters, const ProgressCallback& progress)
{
  Check(parameters);
  ChokingLoopTimes times;
  Stopwatch watch;
  RepairReport repairs;
  surface = CheckedSurface(
    std::move(surface), parameters.AllowSelfIntersections, Between(progress, 0.0, 0.2), &repairs);
  times.Check = watch.Lap();
  const bool automatic = parameters.SampleSpacing <= 0.0;
  double spacing = parameters.SampleSpacing;
  const std::size_t own = surface.Points.size();
  SurfaceSamples samples;
  samples.Mesh = FirstSamples(surface, spacing, Between(progress, 0.2, 0.22));
  surface = {};
  std::unique_ptr<FineSurface> fine;
  if (automatic && own > MostUsualSamples)
  {
    fine = std::make_unique<FineSurface>(
      std::move(samples.Mesh), spacing, parameters.AllowSelfIntersections);
    samples = fine->Sample(Between(progress, 0.22, 0.25));
  }
  times.Sampling = watch.Lap();
  std::size_t before = 0; // places that the previous round left unresolved
  const MemoryBudget budget(parameters.MemoryLimit);
  budget.Require(EstimateBytes(samples.Mesh),
    "The analysis of " + std::to_string(samples.Mesh.Points.size()) + " samples",
    "raise SampleSpacing or simplify the surface");
  for (int round = 0;; ++round)
  {
    // Later rounds are rare: each takes half of the remaining progress.
    const double from = 1.0 - 0.75 * std::pow(0.5, round);
    const double to = 0.5 * (1.0 + from);
    const auto part = Between(progress, from, to);
    this->AnalyseSamples(std::move(samples), times, part);
    if (fine)
    {
      this->State->MeasureOn(*fine, 0.01 * parameters.Accuracy);
    }
    watch.Lap();
    const std::vector<Refinement> blurred = fine
      ? this->State->ImpreciseFeatures(0.01 * parameters.Accuracy)
      : this->State->UnresolvedFeatures();
    const bool isLast = round == (fine ? RoundsOnFine : Rounds) ||
      (!fine && round > 0 && IsInVain(before, blurred.size()));
    if (!automatic || isLast || blurred.empty() || (fine && !fine->Refine(blurred)))
    {
      break;
    }
    before = blurred.size();
    samples = {};
    if (fine)
    {
      samples = fine->Sample(Between(progress, to, to));
    }
    else
    {
      samples.Mesh = Refined(this->State->Samples, blurred, spacing * std::pow(0.6, round),
        spacing * std::pow(0.6, Rounds), Between(progress, to, to));
    }
    times.Sampling += watch.Lap();
    if (samples.Mesh.Points.empty() || !budget.Allows(EstimateBytes(samples.Mesh)))
    {
      break; // too expensive: unresolved features stay marked as not trusted
    }
  }
  this->State->Complete();
  times.Features += watch.Lap();
  if (fine)
  {
    this->State->SortFeatures();
    this->State->Fine = std::move(fine);
  }
  this->State->Times = times;
  this->State->Repairs = std::move(repairs);
  Report(progress, 1.0);
}

void ChokingLoops::AnalyseSamples(
  SurfaceSamples samples, ChokingLoopTimes& times, const ProgressCallback& progress)
{
  Stopwatch watch;
  this->State.reset(); // results of a coarser round
  if (samples.Errors.Point.empty())
  {
    samples.Errors.Point = SamplingErrors(samples.Mesh);
  }
  samples.Errors.Normal = PointNormals(samples.Mesh);
  CellFiltration filtration = DelaunayFiltration(samples.Mesh.Points, Between(progress, 0.0, 0.6),
    [&errors = samples.Errors](const SimplexId* corners, std::size_t count)
    { return errors.SquaredDistance(corners, count); });
  times.Filtration += watch.Lap();
  this->State = std::make_unique<ChokingAnalysis>(std::move(samples), std::move(filtration),
    std::vector<CellError>{}, std::vector<double>{}, times, Between(progress, 0.6, 1.0));
}

ChokingLoops::ChokingLoops(const SurfaceView& surface, const TetrahedralMesh& mesh,
  const std::vector<double>& values, const std::optional<std::vector<double>>& errors,
  const ProgressCallback& progress)
{
  ChokingLoopTimes times;
  Stopwatch watch;
  SurfaceSamples samples;
  samples.Mesh = CheckedSurface(CopyMesh(surface), true, Between(progress, 0.0, 0.1));
  times.Check = watch.Lap();
  CellFiltration filtration =
    LowerStarFiltration(mesh, values, samples.Mesh, Between(progress, 0.1, 0.5));
  times.Filtration = watch.Lap();
  std::vector<CellError> cellErrors =
    errors ? DistanceErrors(filtration, values, *errors) : RangeErrors(filtration, values);
  this->State = std::make_unique<ChokingAnalysis>(std::move(samples), std::move(filtration),
    std::move(cellErrors), values, times, Between(progress, 0.5, 1.0));
  this->State->Times = times;
  this->State->Remark = MeshRemark(this->State->Found.Diagram);
}

ChokingLoops::~ChokingLoops() = default;
ChokingLoops::ChokingLoops(ChokingLoops&&) noexcept = default;
ChokingLoops& ChokingLoops::operator=(ChokingLoops&&) noexcept = default;

const FeatureDiagram& ChokingLoops::Diagram() const
{
  return this->State->Found.Diagram;
}

const TriangleMesh& ChokingLoops::Samples() const
{
  return this->State->Samples;
}

const FineSurface* ChokingLoops::Fine() const
{
  return this->State->Fine.get();
}

SimplexId ChokingLoops::PointOfFine(SimplexId sample) const
{
  return this->State->Origin[At(sample)];
}

const SurfaceAdjacency& ChokingLoops::Adjacency() const
{
  return this->State->Adjacency;
}

const SurfaceHomology& ChokingLoops::Homology() const
{
  return this->State->Homology;
}

const ChokingLoopTimes& ChokingLoops::Times() const
{
  return this->State->Times;
}

const RepairReport& ChokingLoops::Repairs() const
{
  return this->State->Repairs;
}

double ChokingLoops::LargestError() const
{
  const auto& errors = this->State->Context.Errors.Point;
  double largest = errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end());
  for (const ShapeFeature& feature : this->Diagram().Features)
  {
    largest = std::max(largest, feature.FunctionError);
  }
  return largest;
}

std::vector<std::size_t> ChokingLoops::Select(const FeatureSelection& selection) const
{
  return SelectFeatures(this->Diagram(), selection);
}

const Membrane& ChokingLoops::GetMembrane(std::size_t feature)
{
  // Membranes of handles and tunnels exist already, so none is created while other threads read it.
  ChokingAnalysis& state = *this->State;
  std::optional<Membrane>& membrane = state.Found.Membranes[feature];
  {
    const std::lock_guard<std::mutex> lock(state.Mutex);
    if (membrane)
    {
      return *membrane;
    }
  }
  Membrane made =
    FeatureMembrane(state.Context, state.Regions, state.Found.Diagram.Features[feature]);
  const std::lock_guard<std::mutex> lock(state.Mutex);
  if (!membrane)
  {
    membrane = std::move(made);
  }
  return *membrane;
}

const Membrane& ChokingLoops::GetExistingMembrane(std::size_t feature) const
{
  const std::optional<Membrane>& made = this->State->Found.Membranes[feature];
  if (!made)
  {
    throw std::logic_error("the membrane of this feature has not been computed");
  }
  return *made;
}

const Membrane* ChokingLoops::GetMinimumCutMembrane(
  std::size_t feature, const ProgressCallback& progress, bool chords)
{
  ChokingAnalysis& state = *this->State;
  const std::pair key(feature, chords);
  std::unique_lock<std::mutex> lock(state.Mutex);
  auto known = state.MinimumCuts.find(key);
  if (known == state.MinimumCuts.end())
  {
    lock.unlock();
    std::optional<Membrane> membrane = MinimumCutMembrane(state.Context,
      state.Found.Diagram.Features[feature], state.Found.Centers[feature], progress, chords);
    if (membrane && !IsInterchangeable(state.Context, state.Found, feature, *membrane))
    {
      membrane.reset();
    }
    lock.lock();
    known = state.MinimumCuts.emplace(key, std::move(membrane)).first;
  }
  const std::optional<Membrane>& found = known->second;
  return found ? &*found : nullptr;
}

std::optional<Membrane> ChokingLoops::ComputeGreedyMembrane(std::size_t feature) const
{
  const ChokingAnalysis& state = *this->State;
  const ShapeFeature& f = state.Found.Diagram.Features[feature];
  std::optional<Membrane> membrane =
    f.Choke.Exists() ? GreedyMembrane(state.Context, f) : std::nullopt;
  if (membrane && !IsInterchangeable(state.Context, state.Found, feature, *membrane))
  {
    membrane.reset();
  }
  return membrane;
}

std::vector<Membrane> ChokingLoops::ComputeEncirclingMembranes(
  std::size_t feature, double longest, std::size_t most) const
{
  return EncirclingMembranes(this->State->Context, this->State->Found, feature, longest, most);
}

std::optional<Membrane> ChokingLoops::ComputeContactMembrane(
  std::size_t feature, double longest) const
{
  return ContactMembrane(this->State->Context, this->State->Found, feature, longest);
}

std::vector<SimplexId> ChokingLoops::GetContacts(std::size_t feature) const
{
  const TriangleId choke = this->State->Found.Diagram.Features[feature].Choke;
  if (!choke.Exists())
  {
    return {};
  }
  const auto corners = this->State->Filtration.TrianglePoints(choke);
  return { corners.begin(), corners.end() };
}

const std::string& ChokingLoops::Remark() const
{
  return this->State->Remark;
}

Point3 ChokingLoops::ChokePoint(std::size_t feature) const
{
  return this->State->Found.Centers[feature];
}

}
