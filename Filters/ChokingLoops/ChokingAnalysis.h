/**
 * @file ChokingAnalysis.h
 * @brief What is known of a surface whose choking loops were looked for, part after part.
 */
#ifndef isthmus_ChokingAnalysis_h
#define isthmus_ChokingAnalysis_h

#include "ChokingLoops/AnalysisCost.h"
#include "ChokingLoops/ChokingSamples.h"
#include "ChokingLoops/FeatureMembrane.h"
#include "ChokingLoops/GeneratorCompletion.h"
#include "ChokingLoops/SurfaceMending.h"
#include "Core/Index.h"
#include "Core/Stopwatch.h"

#include <cmath>
#include <map>

namespace isthmus
{

/// Everything known about a surface. Built in order, since each part refers to those before.
struct ChokingAnalysis
{
  ChokingAnalysis(TriangleMesh samples, CellFiltration filtration, std::vector<double> errors,
    ChokingLoopTimes& times, const ProgressCallback& progress)
    : Samples(std::move(samples))
    , Filtration(std::move(filtration))
    , Pairs(Filtration, Between(progress, 0.0, 0.5))
    , Adjacency(Samples)
    , Homology(Adjacency)
    , Embedding(Adjacency, Filtration, Between(progress, 0.5, 0.55))
    , Context{ Filtration, Pairs, Homology, Embedding, Adjacency, std::move(errors) }
    , Regions(Context, Between(progress, 0.55, 0.6))
  {
    times.Pairing += this->Watch.Lap();
    this->Found.Diagram = ShapeFeatures(this->Context, this->Regions, Between(progress, 0.6, 0.9));
    this->Found.Membranes.resize(this->Found.Diagram.Features.size());
    for (const ShapeFeature& feature : this->Found.Diagram.Features)
    {
      this->Found.Centres.push_back(this->Centre(feature));
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

  /// Handles and tunnels that the samples did not settle, from tetrahedra that keep `surface`.
  void Complete(const SurfaceView& surface, const ProgressCallback& progress)
  {
    if (AllSettled(this->Found))
    {
      return;
    }
    try
    {
      CompleteGenerators(this->Context, surface, this->Found, progress);
      this->Remark = "Some handles or tunnels are narrower than the sampling error: they are "
                     "marked as not trusted, and their radius is an upper bound. Lower the sample "
                     "spacing to measure it.";
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      this->Remark = std::string("Some handles or tunnels are narrower than the sampling error, "
                                 "and could not be found on the surface itself: their number and "
                                 "side are not assured. ") +
        error.what();
    }
  }

  Point3 Centre(const ShapeFeature& feature) const
  {
    const auto t = this->Filtration.TrianglePoints(feature.Choke);
    const Point3& p = this->Filtration.Points[At(t[0])];
    const Point3& q = this->Filtration.Points[At(t[1])];
    const Point3& r = this->Filtration.Points[At(t[2])];
    return this->Context.PointError.empty() ? (1.0 / 3.0) * (p + q + r) : Circumcentre(p, q, r);
  }

  /// Voids this persistent, relative to the side's reference length, deserve refinement.
  static constexpr double WorthRefining = 0.05;

  /// Features that a finer sampling would settle.
  std::vector<Refinement> Blurred() const
  {
    std::vector<Refinement> wanted;
    for (std::size_t i = 0; i < this->Found.Membranes.size(); ++i)
    {
      const ShapeFeature& f = this->Found.Diagram.Features[i];
      const double reference = this->Found.Diagram.Reference[static_cast<std::size_t>(f.Side)];
      const bool generator =
        IsGenerator(f) && (!f.Trusted || this->Found.Membranes[i]->Loops.empty());
      const bool blurredVoid = f.Kind == FeatureKind::Noise && f.Dimension == 2 && !f.Trusted &&
        f.Persistence() > WorthRefining * reference;
      if (generator || blurredVoid)
      {
        const double gap = std::sqrt(std::max(0.0, f.Death * f.Death - f.Birth * f.Birth));
        wanted.push_back({ this->Found.Centres[i], 2.0 * f.Distance() + f.Error,
          std::min(0.9 * gap, 0.7 * std::sqrt(3.0) * f.Error) });
      }
    }
    return wanted;
  }

  Stopwatch Watch;
  TriangleMesh Samples;
  CellFiltration Filtration;
  FiltrationPairs Pairs;
  SurfaceAdjacency Adjacency;
  SurfaceHomology Homology;
  SurfaceInComplex Embedding;
  FeatureContext Context;
  SpaceRegions Regions;
  LocatedFeatures Found;
  std::map<std::size_t, std::optional<Membrane>> Tight; ///< of the features asked for
  ChokingLoopTimes Times;
  AnalysisCost Cost;
  SurfaceMending Mended;
  std::string Remark;
};

}

#endif
