#include "ChokingLoops/LoopFeature.h"

#include "ChokingLoops/ChokeFit.h"
#include "ChokingLoops/LoopDrawing.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Loops this much longer than the shortest girth are worth another look.
constexpr double Roomy = 1.5;

/// Of ShortestGirth(): what discretisation may take off a loop.
constexpr double Slack = 0.98;

double Longest(const LoopFeature& feature)
{
  return feature.Lengths.empty()
    ? 0.0
    : *std::max_element(feature.Lengths.begin(), feature.Lengths.end());
}

std::vector<Point3> PointsOf(
  const ChokingLoops& loops, const LoopFeature& feature, const std::vector<SimplexId>& loop)
{
  std::vector<Point3> points;
  points.reserve(loop.size());
  for (const SimplexId p : loop)
  {
    points.push_back(feature.Point(p, loops.Samples()));
  }
  return points;
}

}

bool Belongs(const ChokingLoops& loops, std::size_t index, const LoopFeature& feature,
  const LoopTolerances& tolerances)
{
  const ShapeFeature& f = loops.Diagram().Features[index];
  std::vector<Point3> points;
  for (const auto& loop : feature.Loops)
  {
    const std::vector<Point3> polygon = PointsOf(loops, feature, loop);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return !feature.Collapsed && Longest(feature) >= Slack * ShortestGirth(f) &&
    IsSurrounded(loops.ChokePoint(index), tolerances.Nearness * f.Distance(), points);
}

namespace
{

/// What a loop that nothing holds is worth: as much longer it may be than one held.
constexpr double Freedom = 1.05;

/// Encircling loops looked for are so long at most, in circumferences of the ball; and of how many.
constexpr double LongestRound = 3.0;
constexpr std::size_t MostRound = 6;

/// Paths along edges are so much longer than geodesics.
constexpr double AlongEdges = 1.15;

std::vector<SimplexId> ContactsOn(const Membrane& membrane, const std::vector<SimplexId>& contacts)
{
  std::vector<SimplexId> on;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(on),
    [&membrane](SimplexId p)
    {
      return std::any_of(membrane.Loops.begin(), membrane.Loops.end(),
        [p](const auto& loop) { return std::find(loop.begin(), loop.end(), p) != loop.end(); });
    });
  return on;
}

/// Of loops tried one after another, the tightest of those that fit best.
class TightestFit
{
public:
  TightestFit(
    ChokingLoops& loops, std::size_t feature, int rounds, const LoopTolerances& tolerances)
    : Loops(loops)
    , Index(feature)
    , Rounds(rounds)
    , Tolerances(tolerances)
    , Girth(ShortestGirth(loops.Diagram().Features[feature]))
    , Contacts(loops.ContactsOf(feature))
  {
  }

  /// Drawn as tight as M holds them.
  void TryFree(const Membrane& membrane, bool isEncircling, const ProgressCallback& progress = {});

  /// Held at some of the points where the ball touches M, all of them first.
  void TryHeld(const Membrane& membrane, bool isEncircling);

  bool Belongs() const { return this->BestGrade >= Grade::Jagged; }
  bool IsLongEnough() const { return this->BestGrade >= Grade::Hairpin; }
  bool Fits() const { return this->BestGrade == Grade::Fits; }
  double Length() const { return Longest(this->Best); }
  double ShortestLength() const { return this->Girth; }
  LoopFeature Take() { return std::move(this->Best); }

private:
  enum class Grade
  {
    None,
    Collapsed,
    Short,   ///< there is no room for the ball in it
    Hairpin, ///< belongs to the choke point, but goes to and fro
    Strays,  ///< tight, but elsewhere
    Jagged,  ///< belongs, but is held where it turns sharply
    Fits
  };

  Grade GradeOf(const LoopFeature& candidate) const;
  double CostOf(const LoopFeature& candidate, Grade grade) const;
  void Try(LoopFeature candidate, bool isEncircling);

  ChokingLoops& Loops;
  std::size_t Index;
  int Rounds;
  LoopTolerances Tolerances;
  double Girth;
  std::vector<SimplexId> Contacts;
  LoopFeature Best;
  Grade BestGrade = Grade::None;
  double BestCost = 0.0;
};

TightestFit::Grade TightestFit::GradeOf(const LoopFeature& candidate) const
{
  if (!isthmus::Belongs(this->Loops, this->Index, candidate, this->Tolerances))
  {
    const bool isShort = Longest(candidate) < Slack * this->Girth;
    return candidate.Collapsed    ? Grade::Collapsed
      : isShort || candidate.Held ? Grade::Short
                                  : Grade::Strays;
  }
  return candidate.SharpestBend >= this->Tolerances.SharpestLoop ? Grade::Hairpin
    : candidate.SharpestBend >= this->Tolerances.SharpestHeld    ? Grade::Jagged
                                                                 : Grade::Fits;
}

double TightestFit::CostOf(const LoopFeature& candidate, Grade grade) const
{
  switch (grade)
  {
    case Grade::Fits:
      return (candidate.Held ? Freedom : 1.0) * Longest(candidate);
    case Grade::Strays:
      return Longest(candidate);
    case Grade::Jagged:
    case Grade::Hairpin:
      return candidate.SharpestBend;
    default:
      return std::max(0.0, this->Girth - Longest(candidate));
  }
}

void TightestFit::Try(LoopFeature candidate, bool isEncircling)
{
  const Grade grade = this->GradeOf(candidate);
  const double cost = this->CostOf(candidate, grade);
  if (grade > this->BestGrade || (grade == this->BestGrade && cost < this->BestCost))
  {
    candidate.Encircling = isEncircling;
    this->Best = std::move(candidate);
    this->BestGrade = grade;
    this->BestCost = cost;
  }
}

void TightestFit::TryFree(
  const Membrane& membrane, bool isEncircling, const ProgressCallback& progress)
{
  const SurfaceAdjacency& surface = this->Loops.Adjacency();
  LoopFeature candidate =
    Drawn(surface, membrane, TightLoops(surface, membrane, this->Rounds, {}, progress));
  for (const auto& loop : candidate.Loops)
  {
    if (isEncircling && !candidate.Converged)
    {
      candidate.SharpestBend = std::max(candidate.SharpestBend,
        SharpestTurn(PointsOf(this->Loops, candidate, loop), 1e-6 * Longest(candidate)));
    }
  }
  this->Try(std::move(candidate), isEncircling);
}

void TightestFit::TryHeld(const Membrane& membrane, bool isEncircling)
{
  const SurfaceAdjacency& surface = this->Loops.Adjacency();
  const double radius = this->Loops.Diagram().Features[this->Index].Distance();
  const std::vector<SimplexId> touched = ContactsOn(membrane, this->Contacts);
  for (unsigned choice = (1U << touched.size()) - 1U; choice > 0; --choice)
  {
    std::vector<SimplexId> pins;
    for (std::size_t k = 0; k < touched.size(); ++k)
    {
      if (choice >> k & 1U)
      {
        pins.push_back(touched[k]);
      }
    }
    const std::vector<SurfaceCurve> tight = TightLoops(surface, membrane, this->Rounds, pins);
    LoopFeature held = Drawn(surface, membrane, tight);
    held.Held = true;
    const bool isCut = held.SharpestBend > SharpestKept;
    this->Try(std::move(held), isEncircling);
    for (std::size_t i = 0; isCut && i < this->Tolerances.CornerCuts.size(); ++i)
    {
      held = Drawn(surface, membrane, tight, this->Tolerances.CornerCuts[i] * radius);
      held.Held = true;
      this->Try(std::move(held), isEncircling);
    }
  }
}

}

LoopFeature MakeLoopFeature(ChokingLoops& loops, std::size_t index, int rounds,
  const ProgressCallback& progress, const LoopTolerances& tolerances)
{
  const ShapeFeature& f = loops.Diagram().Features[index];
  const Membrane& pushed = loops.MembraneOf(index);
  TightestFit fit(loops, index, rounds, tolerances);
  fit.TryFree(pushed, false, Between(progress, 0.0, 0.4));
  if (rounds == 0 || !f.Trusted || !f.Choke.Exists() ||
    (fit.Belongs() && fit.Length() < Roomy * fit.ShortestLength()))
  {
    return fit.Take();
  }
  const Membrane* tight = loops.TightMembraneOf(index, Between(progress, 0.4, 0.6));
  if (tight)
  {
    fit.TryFree(*tight, false, Between(progress, 0.6, 0.7));
  }
  if (fit.Belongs())
  {
    return fit.Take();
  }
  for (const Membrane* membrane : { tight, &pushed })
  {
    if (membrane && !fit.Fits())
    {
      fit.TryHeld(*membrane, false);
    }
  }
  Report(progress, 0.8);
  const double longest = std::min(
    fit.Fits() ? Freedom * fit.Length() : HUGE_VAL, LongestRound * 2.0 * Pi * f.Distance());
  for (const Membrane& round : loops.EncirclingMembranesOf(index, AlongEdges * longest, MostRound))
  {
    fit.TryFree(round, true);
    if (!fit.Fits())
    {
      fit.TryHeld(round, true);
    }
  }
  const auto last = fit.IsLongEnough() ? std::nullopt : loops.ContactMembraneOf(index, longest);
  if (last)
  {
    fit.TryHeld(*last, true);
  }
  return fit.Take();
}

}
