#include "Pockets/PoreProfile.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Pockets/EmptySpace.h"
#include "Pockets/PoreChannels.h"
#include "Pockets/PoreRadius.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Planes across a pore, and the points of the path in them, where known.
struct Course
{
  std::vector<Plane> Planes;
  std::vector<Point3> Path;
  double Least = -HUGE_VAL; ///< the path is at least that wide
  double Enough = 0.0;      ///< radius beyond which it need not be known
  double End = 0.0;         ///< radius beyond which the pore ends
};

/// Running means with a Gaussian of the given width, which gets narrower towards the ends so that
/// the ends do not move.
std::vector<Point3> Smooth(const std::vector<Point3>& points, double width)
{
  const auto n = static_cast<std::int64_t>(points.size());
  std::vector<Point3> smooth(points.size());
  for (std::int64_t i = 0; i < n; ++i)
  {
    const std::int64_t reach = std::min({ static_cast<std::int64_t>(3.0 * width), i, n - 1 - i });
    const double sigma = std::max(1e-3, static_cast<double>(reach) / 3.0);
    Point3 sum{ 0.0, 0.0, 0.0 };
    double weights = 0.0;
    for (std::int64_t k = -reach; k <= reach; ++k)
    {
      const double x = static_cast<double>(k) / sigma;
      const double weight = std::exp(-0.5 * x * x);
      sum = sum + weight * points[static_cast<std::size_t>(i + k)];
      weights += weight;
    }
    smooth[static_cast<std::size_t>(i)] = (1.0 / weights) * sum;
  }
  return smooth;
}

/// `path` at equal distances. Throws std::invalid_argument if that needs too many planes.
std::vector<Point3> Resample(const std::vector<Point3>& path, double spacing)
{
  constexpr double mostPlanes = 1e5;
  double whole = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    whole += Length(path[i + 1] - path[i]);
  }
  if (!(whole / spacing <= mostPlanes))
  {
    throw std::invalid_argument("A pore here is " + FormatNumber(whole) +
      " angstrom long, which needs more than 100000 planes at this Spacing: raise Spacing, or "
      "check the unit of the atoms' coordinates.");
  }
  std::vector<Point3> points{ path.front() };
  double rest = spacing;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Point3 step = path[i + 1] - path[i];
    const double length = Length(step);
    double at = rest;
    for (; at <= length; at += spacing)
    {
      points.push_back(path[i] + (at / length) * step);
    }
    rest = at - length;
  }
  return points;
}

/// The same, in both directions from the `start`-th point, so that one plane passes exactly through
/// the narrowest place.
std::vector<Point3> ResampleFrom(const std::vector<Point3>& path, std::size_t start, double spacing)
{
  const auto at = path.begin() + static_cast<std::ptrdiff_t>(start);
  std::vector<Point3> points =
    Resample({ std::make_reverse_iterator(at + 1), path.rend() }, spacing);
  std::reverse(points.begin(), points.end());
  const std::vector<Point3> rest = Resample({ at, path.end() }, spacing);
  points.insert(points.end(), rest.begin() + 1, rest.end());
  return points;
}

/// Planes across `points`, smoothed by a Gaussian of that width (in points).
Course CourseAlong(const std::vector<Point3>& points, double width)
{
  const std::vector<Point3> smooth = Smooth(points, width);
  Course course;
  for (std::size_t i = 0; i < smooth.size(); ++i)
  {
    const Point3 d =
      smooth[std::min(i + 1, smooth.size() - 1)] - smooth[i > 0 ? i - 1 : std::size_t{ 0 }];
    const double length = Length(d);
    if (length > 0.0)
    {
      course.Planes.push_back({ smooth[i], (1.0 / length) * d });
      course.Path.push_back(points[i]);
    }
  }
  return course;
}

/// The projection of `p` onto `plane`.
Point3 Project(const Plane& plane, const Point3& p)
{
  return p - Dot(p - plane.Origin, plane.Normal) * plane.Normal;
}

/// The balls in the planes after (`step` 1) or before (-1) plane `from`, whose ball is known, up to
/// the end of the pore.
std::vector<PlaneBall> MarchAlong(const AtomField& atoms, const Course& course, std::size_t from,
  std::int64_t step, PlaneBall ball, const ProgressCallback& progress)
{
  std::vector<PlaneBall> balls;
  const auto n = static_cast<std::int64_t>(course.Planes.size());
  for (auto i = static_cast<std::int64_t>(from) + step;
       i >= 0 && i < n && ball.Radius <= course.End; i += step)
  {
    Report(progress,
      static_cast<double>(std::abs(i - static_cast<std::int64_t>(from))) / static_cast<double>(n));
    const Plane& plane = course.Planes[static_cast<std::size_t>(i)];
    std::vector<Point3> starts{ Project(plane, ball.Center) };
    if (!course.Path.empty())
    {
      starts.push_back(Project(plane, course.Path[static_cast<std::size_t>(i)]));
    }
    ball = LargestBallInPlane(atoms, plane, starts, ball.Radius, course.Enough);
    if (ball.Radius < course.Least)
    {
      // The path is wider than this everywhere, so this is a dead end beside it.
      const PlaneBall other =
        LargestBallInPlane(atoms, plane, { starts.back() }, course.Least, course.Enough);
      ball = other.Radius > ball.Radius ? other : ball;
    }
    balls.push_back(ball);
  }
  return balls;
}

/// Weights of atoms as seen by a water probe.
constexpr double Probe = 1.4;

void CheckPoint(const char* name, const Point3& p)
{
  if (!std::isfinite(p[0] + p[1] + p[2]))
  {
    throw std::invalid_argument(std::string(name) + " has a coordinate that is not finite.");
  }
}

RegularFiltration EnlargeBalls(
  const std::vector<Ball>& atoms, const PoreOptions& options, const ProgressCallback& progress)
{
  std::vector<Point3> centers;
  std::vector<double> radii;
  for (const Ball& atom : atoms)
  {
    centers.push_back(atom.Center);
    radii.push_back(atom.Radius + Probe);
  }
  return MakeRegularFiltration(std::move(centers), std::move(radii), progress, options.Predicted);
}

/// Samples from which the radius rises by `depth` on both sides before it falls below.
std::vector<std::size_t> Bottlenecks(const std::vector<PoreSample>& samples)
{
  constexpr double depth = 0.1; // angstrom
  std::vector<std::size_t> found;
  const auto rises = [&](std::size_t i, std::int64_t step)
  {
    for (auto k = static_cast<std::int64_t>(i) + step;
         k >= 0 && k < static_cast<std::int64_t>(samples.size()); k += step)
    {
      const double radius = samples[static_cast<std::size_t>(k)].Radius;
      const bool first = step < 0; // of equal ones
      if (radius < samples[i].Radius || (first && radius == samples[i].Radius))
      {
        return false;
      }
      if (radius > samples[i].Radius + depth)
      {
        return true;
      }
    }
    return false;
  };
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (rises(i, 1) && rises(i, -1))
    {
      found.push_back(i);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [&](std::size_t a, std::size_t b) { return samples[a].Radius < samples[b].Radius; });
  return found;
}

/// Beyond what was found at sixteenths of the way, and where climbs in planes end.
double WithMargin(double error)
{
  constexpr double caution = 1.2, climbing = 1e-4; // angstrom
  return caution * error + climbing;
}

/// What is between two planes: the clearance along the line between the centers of their balls. The
/// largest ball in a plane there has at least that radius; in a straight pore it has that.
struct BetweenPlanes
{
  double Deviation = 0.0; ///< of the clearance from the line between the radii
  double Least = HUGE_VAL;
};

BetweenPlanes LookBetweenPlanes(
  const AtomField& atoms, const PoreSample& first, const PoreSample& last)
{
  constexpr int parts = 16;
  BetweenPlanes between{ 0.0, std::min(first.Radius, last.Radius) };
  for (int i = 1; i < parts; ++i)
  {
    const double share = static_cast<double>(i) / parts;
    const double line = first.Radius + share * (last.Radius - first.Radius);
    const double clearance =
      atoms.At(first.Center + share * (last.Center - first.Center), line).Radius;
    between.Deviation = std::max(between.Deviation, std::abs(clearance - line));
    between.Least = std::min(between.Least, clearance);
  }
  return between;
}

void EstimateRadiusErrors(
  const AtomField& atoms, std::vector<PoreSample>& samples, const ProgressCallback& progress)
{
  for (PoreSample& sample : samples)
  {
    sample.Least = sample.Radius;
  }
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
  {
    Report(progress, static_cast<double>(i) / static_cast<double>(samples.size()));
    const BetweenPlanes between = LookBetweenPlanes(atoms, samples[i], samples[i + 1]);
    for (const std::size_t k : { i, i + 1 })
    {
      samples[k].RadiusError = std::max(samples[k].RadiusError, WithMargin(between.Deviation));
      samples[k].Least = std::min(samples[k].Least, between.Least);
    }
  }
}

Pore PoreThrough(const AtomField& atoms, const Course& course, std::size_t from,
  const Point3& start, const ProgressCallback& progress)
{
  Pore pore;
  const Point3 in = Project(course.Planes[from], start);
  const PlaneBall first = LargestBallInPlane(
    atoms, course.Planes[from], { in }, std::max(1.0, atoms.At(in).Radius), course.Enough);
  std::vector<PlaneBall> balls =
    MarchAlong(atoms, course, from, -1, first, Between(progress, 0.0, 0.45));
  std::reverse(balls.begin(), balls.end());
  balls.push_back(first);
  const auto after = MarchAlong(atoms, course, from, 1, first, Between(progress, 0.45, 0.9));
  balls.insert(balls.end(), after.begin(), after.end());
  // Wide channels are followed beyond their mouths, since no radius criterion ends them.
  if (course.End > course.Enough)
  {
    // Everything beyond the last narrow places on both sides is outside.
    const auto isNarrow = [&](const PlaneBall& ball) { return ball.Radius < course.Enough; };
    balls.erase(std::find_if(balls.rbegin(), balls.rend(), isNarrow).base(), balls.end());
    balls.erase(balls.begin(), std::find_if(balls.begin(), balls.end(), isNarrow));
  }
  if (balls.empty())
  {
    return pore;
  }
  double length = 0.0;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    length += i > 0 ? Length(balls[i].Center - balls[i - 1].Center) : 0.0;
    pore.Samples.push_back({ balls[i].Center, balls[i].Radius, 0.0, 0.0, length,
      atoms.At(balls[i].Center, balls[i].Radius).Atom });
  }
  EstimateRadiusErrors(atoms, pore.Samples, Between(progress, 0.9, 1.0));
  pore.Bottlenecks = Bottlenecks(pore.Samples);
  pore.Span = Length(pore.Samples.back().Center - pore.Samples.front().Center);
  return pore;
}

Pore MeasurePore(const AtomField& atoms, const Channel& channel, const PoreOptions& options,
  const ProgressCallback& progress)
{
  // A path bends around each atom; averaging over three times the atom size gives the course of the
  // pore.
  constexpr double smoothing = 3.0; // angstrom
  // A wide channel is computed up to three times its radius, and from four times EndRadius on its
  // planes are spaced in proportion to its width.
  const double width =
    channel.IsWide ? std::max(1.0, 0.25 * channel.Radius / options.EndRadius) : 1.0;
  const double spacing = options.Spacing * (channel.IsWide ? 4.0 * width : 1.0);
  Course course =
    CourseAlong(ResampleFrom(channel.Path, channel.From, spacing), width * smoothing / spacing);
  course.Least = channel.Radius;
  course.Enough = channel.IsWide ? 3.0 * channel.Radius : options.EndRadius;
  course.End = channel.IsWide ? HUGE_VAL : options.EndRadius;
  const auto& planes = course.Planes;
  if (planes.empty())
  {
    throw std::runtime_error("The two ends of the pore are the same: choose points farther apart.");
  }
  const Point3& narrow = channel.Path[channel.Narrowest];
  // From the narrowest place outwards: there the largest ball in the pore is unique.
  std::size_t from = 0;
  for (std::size_t i = 1; i < planes.size(); ++i)
  {
    from = Length(planes[i].Origin - narrow) < Length(planes[from].Origin - narrow) ? i : from;
  }
  return PoreThrough(atoms, course, from, narrow, progress);
}

/// Wide channels one after another, since each takes long and reports its progress; the others in
/// parallel.
std::vector<Pore> MeasurePores(const AtomField& atoms, const std::vector<Channel>& channels,
  const PoreOptions& options, const ProgressCallback& progress)
{
  std::vector<Pore> pores(channels.size());
  ParallelFor(
    0, static_cast<std::int64_t>(channels.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        if (!channels[i].IsWide)
        {
          pores[i] = MeasurePore(atoms, channels[i], options, {});
        }
      }
    },
    Between(progress, 0.0, 0.5));
  const auto count = static_cast<double>(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    const auto before = static_cast<double>(i);
    const ProgressCallback own =
      Between(progress, 0.5 + 0.5 * before / count, 0.5 + 0.5 * (before + 1.0) / count);
    if (channels[i].IsWide)
    {
      pores[i] = MeasurePore(atoms, channels[i], options, own);
    }
  }
  return pores;
}

}

double Pore::DipBelow(const PoreSample& sample)
{
  return WithMargin(sample.Radius - sample.Least);
}

double Pore::DipBelowNarrowest() const
{
  double narrowest = HUGE_VAL, least = HUGE_VAL;
  for (const PoreSample& sample : this->Samples)
  {
    narrowest = std::min(narrowest, sample.Radius);
    least = std::min(least, sample.Least);
  }
  return WithMargin(std::max(0.0, narrowest - least));
}

void Check(const PoreOptions& options)
{
  constexpr double longest = 1e4;
  RequireAbove("EndRadius", options.EndRadius, 0.0, longest, "It is in angstrom.");
  RequireRange("Spacing", options.Spacing, 0.001, longest, "It is in angstrom.");
  RequireAbove("MinimumRadius", options.MinimumRadius, 0.0, longest, "It is in angstrom.");
  RequireRange("MinimumSpan", options.MinimumSpan, 0.0, 1e6, "It is in angstrom.");
  RequireRange("MaximumPores", options.MaximumPores, 0, 1e6);
  RequireAbove("MaximumOffset", options.MaximumOffset, 0.0, longest, "It is in angstrom.");
}

std::vector<Pore> FindPores(
  const std::vector<Ball>& atoms, const PoreOptions& options, const ProgressCallback& progress)
{
  Check(options);
  RegularFiltration f = EnlargeBalls(atoms, options, Between(progress, 0.0, 0.3));
  std::vector<Pore> pores;
  if (f.Complex.Tetrahedra.empty())
  {
    return pores;
  }
  const CellAccessibility access =
    FindAccess(f, FacesOfCells(f.Complex), Probe, Between(progress, 0.3, 0.35));
  const auto channels = FindChannels(f, access, Probe, options, Between(progress, 0.35, 0.7));
  std::vector<Pore> found =
    MeasurePores(AtomField(atoms), channels, options, Between(progress, 0.7, 1.0));
  for (Pore& pore : found)
  {
    if (!pore.Samples.empty() && pore.Span >= options.MinimumSpan)
    {
      pores.push_back(std::move(pore));
    }
  }
  Report(progress, 1.0);
  return pores;
}

Pore PoreBetween(const std::vector<Ball>& atoms, const Point3& first, const Point3& last,
  const PoreOptions& options, const ProgressCallback& progress)
{
  Check(options);
  CheckPoint("Point1", first);
  CheckPoint("Point2", last);
  if (Length(first - last) <= options.Spacing)
  {
    throw std::invalid_argument("Point1 and Point2 are the same, or closer than Spacing: set them "
                                "to the two ends of the pore.");
  }
  const RegularFiltration f = EnlargeBalls(atoms, options, Between(progress, 0.0, 0.4));
  if (f.Complex.Tetrahedra.empty())
  {
    throw std::runtime_error("There are fewer than four atoms, or all lie in one plane, so there "
                             "is no pore between them.");
  }
  const auto faces = FacesOfCells(f.Complex);
  const CellAccessibility access = FindAccess(f, faces, Probe, Between(progress, 0.4, 0.5));
  Channel channel =
    PathBetween(f, faces, access, first, last, options, Between(progress, 0.5, 0.6));
  channel.Path.front() = first;
  channel.Path.back() = last;
  const AtomField field(atoms);
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < channel.Path.size(); ++i)
  {
    const double room = field.At(channel.Path[i]).Radius;
    channel.Narrowest = room > 0.0 && room < least ? i : channel.Narrowest;
    least = room > 0.0 ? std::min(least, room) : least;
  }
  return MeasurePore(field, channel, options, Between(progress, 0.6, 1.0));
}

Pore PoreAlong(const std::vector<Ball>& atoms, const Point3& point, const Point3& direction,
  const PoreOptions& options, const ProgressCallback& progress)
{
  Check(options);
  CheckPoint("Point", point);
  CheckPoint("Direction", direction);
  const double length = Length(direction);
  if (!(length > 0.0))
  {
    throw std::invalid_argument("Direction has length 0: set it to the direction along the pore.");
  }
  if (atoms.empty())
  {
    throw std::runtime_error("There are no atoms, so there is no pore.");
  }
  const Point3 along = (1.0 / length) * direction;
  double low = 0.0;
  double high = 0.0;
  for (const Ball& atom : atoms)
  {
    low = std::min(low, Dot(atom.Center - point, along));
    high = std::max(high, Dot(atom.Center - point, along));
  }
  const auto before = static_cast<std::int64_t>((options.EndRadius - low) / options.Spacing);
  const auto after = static_cast<std::int64_t>((options.EndRadius + high) / options.Spacing);
  if (before + after > 10000000)
  {
    throw std::invalid_argument("Spacing is " + FormatNumber(options.Spacing) +
      ", too small for atoms this far apart: choose a larger Spacing.");
  }
  Course course;
  course.Enough = options.EndRadius;
  course.End = options.EndRadius;
  for (std::int64_t i = -before; i <= after; ++i)
  {
    course.Planes.push_back({ point + (static_cast<double>(i) * options.Spacing) * along, along });
  }
  return PoreThrough(AtomField(atoms), course, static_cast<std::size_t>(before), point, progress);
}

namespace
{

/// Clearances in a crystal, from the atoms around one cell.
class PeriodicField
{
public:
  PeriodicField(const PeriodicSpace& space, const PeriodicCell& cell)
    : Space(space)
    , Cell(cell)
    , Balls(MakeBalls(space))
    , Field(Balls)
  {
  }

  double Clearance(const Point3& place) const
  {
    return this->Field.At(place + this->Cell.Vector(this->IntoCell(place))).Radius;
  }

  /// Atoms whose surface is within `reach` of `place`.
  void AddNear(const Point3& place, double reach, std::set<AtomImage>& images) const
  {
    const CellShift into = this->IntoCell(place);
    for (const std::int64_t i : this->Field.Touching(place + this->Cell.Vector(into), reach))
    {
      const AtomImage& image = this->Space.Images[static_cast<std::size_t>(i)];
      images.insert({ image.Atom, Add(image.Shift, Negative(into)) });
    }
  }

private:
  static std::vector<Ball> MakeBalls(const PeriodicSpace& space)
  {
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < space.Images.size(); ++i)
    {
      balls.push_back({ space.Filtration.Complex.Points[i], space.Filtration.Radii[i] - Probe });
    }
    return balls;
  }

  CellShift IntoCell(const Point3& place) const
  {
    const Point3 f = this->Cell.Fractions(place);
    return { -static_cast<int>(std::floor(f[0])), -static_cast<int>(std::floor(f[1])),
      -static_cast<int>(std::floor(f[2])) };
  }

  const PeriodicSpace& Space;
  const PeriodicCell& Cell;
  std::vector<Ball> Balls;
  AtomField Field;
};

/// Points no more than `spacing` apart, including those of the path.
std::vector<Point3> Refine(const std::vector<Point3>& path, double spacing)
{
  std::vector<Point3> points{ path.front() };
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Point3 step = path[i + 1] - path[i];
    const double parts = std::ceil(std::max(1.0, Length(step) / spacing));
    for (double k = 1.0; k <= parts; ++k)
    {
      points.push_back(k == parts ? path[i + 1] : path[i] + (k / parts) * step);
    }
  }
  return points;
}

/// A closed way, of which the first and the last point are copies, from its widest point on.
Pore MeasureClosedWay(const std::vector<Point3>& points, const PeriodicField& field)
{
  std::vector<double> radii;
  radii.reserve(points.size());
  for (const Point3& point : points)
  {
    radii.push_back(field.Clearance(point));
  }
  const std::size_t count = points.size() - 1;
  const auto begin =
    static_cast<std::size_t>(std::max_element(radii.begin(), radii.end() - 1) - radii.begin());
  const Point3 whole = points.back() - points.front();
  Pore pore;
  double length = 0.0;
  for (std::size_t i = 0; i <= count; ++i)
  {
    const std::size_t at = (begin + i) % count;
    const Point3 center = begin + i < count ? points[at] : points[at] + whole;
    length += i > 0 ? Length(center - pore.Samples.back().Center) : 0.0;
    pore.Samples.push_back({ center, radii[at], 0.0, 0.0, length, -1 });
  }
  pore.Span = Length(whole);
  return pore;
}

}

PeriodicPores FindPeriodicPores(const std::vector<Ball>& atoms, const PeriodicCell& cell,
  const PoreOptions& options, const ProgressCallback& progress)
{
  Check(options);
  const PeriodicSpace space =
    MakePeriodicSpace(atoms, cell, Probe, 0.0, options.Predicted, Between(progress, 0.0, 0.6));
  const PeriodicField field(space, space.Cell);
  PeriodicPores found;
  const TetrahedronId widest = space.Widest();
  found.LargestRadius = space.Access.CellClearance[widest];
  found.LargestCenter = space.Filtration.Centers[widest];
  std::set<AtomImage> images;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto share = static_cast<double>(axis) / 3.0;
    const std::vector<Point3> path =
      PathAlongCell(space, axis, Between(progress, 0.6 + 0.3 * share, 0.7 + 0.3 * share));
    if (path.empty())
    {
      continue;
    }
    found.Pores.push_back(MeasureClosedWay(Refine(path, options.Spacing), field));
    found.Pores.back().Direction = "abc"[axis];
    for (const PoreSample& sample : found.Pores.back().Samples)
    {
      constexpr double lining = 1.0; // angstrom, more than that of PoreOutput.cxx
      field.AddNear(sample.Center, sample.Radius + 2.0 * options.Spacing + lining, images);
    }
  }
  for (const AtomImage& image : images)
  {
    const auto home = At(space.NumberOfImage.at({ image.Atom, NoCellShift }));
    found.Images.push_back({ space.Filtration.Complex.Points[home] + space.Cell.Vector(image.Shift),
      atoms[image.Atom].Radius });
    found.Atoms.push_back(image.Atom);
  }
  const AtomField around(found.Images);
  for (Pore& pore : found.Pores)
  {
    for (PoreSample& sample : pore.Samples)
    {
      sample.NearestAtom = around.At(sample.Center, sample.Radius).Atom;
    }
    EstimateRadiusErrors(around, pore.Samples, {});
    pore.Bottlenecks = Bottlenecks(pore.Samples);
  }
  Report(progress, 1.0);
  return found;
}

}
