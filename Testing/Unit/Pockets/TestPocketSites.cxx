// Sites of pockets: modes of known densities; the model's arithmetic; proteins turned, moved,
// shuffled.

#include "Core/Geometry.h"
#include "Pockets/PocketScore.h"
#include "Pockets/PocketSites.h"
#include "Pockets/SiteCopies.h"
#include "Pockets/SiteDescriptors.h"
#include "Pockets/SiteModel.h"
#include "SharedData.h"
#include "vtkMacromoleculeReader.h"
#include "vtkMolecularPockets.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

using namespace isthmus;

namespace
{

/// A row of the table: center and probability of each rank.
struct Row
{
  Point3 Center;
  double Probability;
};

std::vector<Row> DescribeRows(vtkPolyData* atoms)
{
  vtkNew<vtkMolecularPockets> filter;
  filter->SetInputData(atoms);
  filter->Update();
  std::vector<Row> rows;
  vtkTable* table = filter->GetPocketTable();
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const auto value = [&](const char* name) { return table->GetValueByName(i, name).ToDouble(); };
    rows.push_back(
      { { value("CenterX"), value("CenterY"), value("CenterZ") }, value("Probability") });
  }
  return rows;
}

/// The reader's atoms as points without bonds.
vtkSmartPointer<vtkPolyData> AtomsOfFile(const std::string& name)
{
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName((isthmus::testing::SharedDataFolder() / name).string().c_str());
  reader->Update();
  auto atoms = vtkSmartPointer<vtkPolyData>::New();
  atoms->SetPoints(reader->GetOutput()->GetPoints());
  atoms->GetPointData()->ShallowCopy(reader->GetOutput()->GetPointData());
  return atoms;
}

/// The atoms in another order, each place changed by `move`.
template <typename Move>
vtkSmartPointer<vtkPolyData> Rearrange(
  vtkPolyData* atoms, const std::vector<vtkIdType>& order, Move&& move)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  copy->GetPointData()->CopyAllocate(atoms->GetPointData());
  for (const vtkIdType i : order)
  {
    Point3 place;
    atoms->GetPoint(i, place.data());
    const vtkIdType id = points->InsertNextPoint(move(place).data());
    copy->GetPointData()->CopyData(atoms->GetPointData(), i, id);
  }
  copy->SetPoints(points);
  return copy;
}

Point3 Turn(const Point3& p)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Point3 q{ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
  return { q[0] - 20.0, c * q[1] - s * q[2] + 70.0, s * q[1] + c * q[2] - 45.0 };
}

}

TEST(PocketSites, TwoCloudsAreTwoSitesAtTheirMiddles)
{
  std::mt19937 random(3);
  std::normal_distribution<double> spread(0.0, 1.0);
  std::vector<Point3> places;
  std::vector<double> probabilities;
  const Point3 middles[] = { { 0, 0, 0 }, { 14, 3, 0 } };
  for (int i = 0; i < 4000; ++i)
  {
    const Point3 at{ spread(random), spread(random), spread(random) };
    places.push_back(middles[i % 2] + at);
    probabilities.push_back(i % 2 == 0 ? 0.2 : 0.6);
  }
  const std::vector<PocketSite> sites = FindSites(places, probabilities);
  ASSERT_EQ(sites.size(), 2u);
  // The more probable one is first; a mode of 2000 places of spread 1 is known to about 0.05.
  EXPECT_LT(Distance(sites[0].Center, middles[1]), 0.1);
  EXPECT_LT(Distance(sites[1].Center, middles[0]), 0.1);
  EXPECT_NEAR(sites[0].Density / sites[1].Density, 3.0, 0.1);
  EXPECT_EQ(sites[0].Places.size(), 2000u);
  EXPECT_EQ(sites[1].Places.size(), 2000u);
}

TEST(PocketSites, TheEndsOfALigandAreOneSite)
{
  // Two clouds 6 apart: noise would decide between two sites.
  std::mt19937 random(3);
  std::normal_distribution<double> spread(0.0, 1.0);
  std::vector<Point3> places;
  for (int i = 0; i < 2000; ++i)
  {
    places.push_back({ 6.0 * (i % 2) + spread(random), spread(random), spread(random) });
  }
  const std::vector<PocketSite> sites = FindSites(places, std::vector<double>(2000, 0.5));
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_LT(Distance(sites[0].Center, { 3.0, 0.0, 0.0 }), 0.3);
}

TEST(PocketSites, CrowdedPlacesCountLess)
{
  // Of each place of the first cloud there are four copies.
  std::mt19937 random(3);
  std::normal_distribution<double> spread(0.0, 2.0);
  std::vector<Point3> places;
  for (int i = 0; i < 100; ++i)
  {
    const Point3 at{ spread(random), spread(random), spread(random) };
    places.insert(places.end(), 4, at);
    places.push_back(at + Point3{ 30.0, 0.0, 0.0 });
  }
  const std::vector<PocketSite> sites = FindSites(places, std::vector<double>(500, 0.5));
  ASSERT_EQ(sites.size(), 2u);
  EXPECT_LT(Distance(sites[0].Center, { 0.0, 0.0, 0.0 }), 1.0);
  EXPECT_NEAR(sites[0].Density / sites[1].Density, 2.0, 0.1);
}

TEST(PocketSites, NoPlacesAndImpossibleOnes)
{
  EXPECT_TRUE(FindSites({}, {}).empty());
  const std::vector<PocketSite> sites = FindSites({ { 1, 2, 3 }, { 1, 2, 4 } }, { 0.0, 0.0 });
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(sites[0].Density, 0.0);
  EXPECT_EQ(sites[0].Places.size(), 2u);
}

TEST(PocketSites, TiedOnesAreOrderedByTheirResidues)
{
  std::vector<Pocket> sites(4);
  const double densities[] = { 3.0, 2.0 * (1.0 + 1e-12), 2.0, 1.0 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    sites[i].Density = densities[i];
    sites[i].Score = static_cast<double>(i);
    sites[i].Parent = static_cast<std::int64_t>(i) + 1;
    sites[i].Group = static_cast<std::int64_t>(i);
  }
  OrderTiedSites({ { { "D", 1, "", "ALA" } }, { { "B", 10, "", "ALA" } },
                   { { "A", 10, "", "ALA" } }, { { "A", 1, "", "ALA" } } },
    sites);
  const double order[] = { 0.0, 2.0, 1.0, 3.0 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(sites[i].Score, order[i]);
    EXPECT_EQ(sites[i].Parent, static_cast<std::int64_t>(i) + 1);
  }
}

TEST(PocketSites, CopiesHaveOneDensityAndFollowEachOtherByTheirChains)
{
  // Chains 1 and 0 are copies 50 apart, each with residues 0 to 9 along x and, around a site of its
  // own, 10 to 19; chain 2 has only the first number in common.
  std::vector<SiteAtom> atoms;
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 0.2);
  for (int chain = 0; chain < 3; ++chain)
  {
    for (int word = 0; word < 20; ++word)
    {
      SiteAtom atom;
      atom.Place = { 2.0 * word + noise(random), 50.0 * chain + noise(random), noise(random) };
      atom.Chain = chain;
      atom.Word = chain < 2 || word == 0 ? word : 100 + word;
      atom.Number = 20 * chain + word;
      atoms.push_back(atom);
    }
  }
  const auto at = [](double x, int chain, double density) {
    return PocketSite{ { x, 50.0 * chain, 1.0 }, density, {} };
  };
  const std::vector<CopiedSite> sites = GroupCopies(atoms,
    { at(5.0, 1, 9.0), at(30.0, 0, 8.0), at(5.0, 0, 6.0), at(5.0, 2, 5.0), at(13.0, 1, 4.0),
      at(31.0, 1, 3.0) });
  ASSERT_EQ(sites.size(), 6u);
  const double densities[] = { 7.5, 7.5, 5.5, 5.5, 5.0, 4.0 };
  const int chains[] = { 0, 1, 0, 1, 2, 1 };
  const std::int64_t groups[] = { 0, 0, 1, 1, 2, 3 };
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(sites[i].Site.Density, densities[i]) << i;
    EXPECT_EQ(sites[i].Chain, chains[i]) << i;
    EXPECT_EQ(sites[i].Group, groups[i]) << i;
  }
  EXPECT_EQ(GroupCopies({}, { at(5.0, 0, 1.0) }).front().Chain, -1);
}

TEST(PocketSites, CopiesBetweenTwoChainsKeepTheirOrder)
{
  // Words 0 to 9 line one side of the site, 10 to 19 the other: in the first site of chain 0 and of
  // chain 1, in the second the other way round. Which chain has more weight is noise.
  std::vector<SiteAtom> atoms;
  for (int word = 0; word < 20; ++word)
  {
    for (int site = 0; site < 2; ++site)
    {
      SiteAtom atom;
      atom.Place = { word < 10 ? -5.0 : 5.0, 0.5 * (word % 10), 50.0 * site };
      atom.Chain = word < 10 ? site : 1 - site;
      atom.Word = word;
      atom.Number = 20 * atom.Chain + word;
      atoms.push_back(atom);
    }
  }
  for (const double shift : { -0.3, 0.3 })
  {
    const std::vector<CopiedSite> sites =
      GroupCopies(atoms, { { { -shift, 2.0, 50.0 }, 9.0, {} }, { { shift, 2.0, 0.0 }, 8.0, {} } });
    ASSERT_EQ(sites.size(), 2u);
    EXPECT_EQ(sites[1].Group, 0);
    EXPECT_LT(sites[0].Site.Center[2], 1.0) << shift;
  }
}

TEST(SiteModel, ProbabilitiesAreLogisticAndRiseWithTheShare)
{
  const double* c = GetSiteModel().Calibration;
  const double odds = c[0] + c[1] * std::log(7.0) + c[2] * std::log(0.25);
  EXPECT_NEAR(SiteProbability(7.0, 0.25), std::exp(odds) / (1.0 + std::exp(odds)), 1e-14);
  EXPECT_GT(SiteProbability(7.0, 0.35), SiteProbability(7.0, 0.25));
  // Of one molecule, the denser site has the larger share.
  EXPECT_GT(SiteProbability(8.0, 0.8 * 0.25), SiteProbability(7.0, 0.7 * 0.25));
  EXPECT_GE(SiteProbability(0.0, 0.0), 0.0);
}

TEST(SiteModel, EveryTreeLeadsToALeaf)
{
  const SiteModelTable& model = GetSiteModel();
  ASSERT_GT(model.Trees, 50u);
  const std::size_t width = SiteDescriptorNames().size();
  for (std::size_t tree = 0; tree < model.Trees; ++tree)
  {
    // Each node and leaf is reached once.
    std::vector<int> open{ 0 };
    std::set<int> seen;
    while (!open.empty())
    {
      const int at = open.back();
      open.pop_back();
      ASSERT_TRUE(seen.insert(at).second);
      if (at >= 0)
      {
        const SiteModelNode& node = model.Nodes[model.FirstNodes[tree] + at];
        ASSERT_LT(node.Descriptor, width);
        open.push_back(node.Low);
        open.push_back(node.High);
      }
    }
    const auto leaves = std::count_if(seen.begin(), seen.end(), [](int at) { return at < 0; });
    EXPECT_EQ(2 * static_cast<std::size_t>(leaves), seen.size() + 1);
    EXPECT_EQ(*seen.begin(), -static_cast<int>(leaves));
  }
}

TEST(SiteDescriptors, AtomsByName)
{
  const auto kind = [](int element, const char* residue, const char* name) {
    return MakeSiteAtom({ 0, 0, 0 }, element, residue, name);
  };
  EXPECT_EQ(kind(6, "PHE", "CZ").Kind, SiteAtomKind::Aromatic);
  EXPECT_EQ(kind(7, "HIE", "NE2").Kind, SiteAtomKind::Imidazole);
  EXPECT_TRUE(kind(7, "HIE", "NE2").BindsMetals);
  EXPECT_EQ(kind(16, "CYS", "SG").Kind, SiteAtomKind::Sulfur);
  EXPECT_TRUE(kind(16, "CYX", "SG").BindsMetals);
  EXPECT_EQ(kind(6, "LEU", "CD1").Kind, SiteAtomKind::Aliphatic);
  EXPECT_EQ(kind(6, "ARG", "CZ").Kind, SiteAtomKind::Other);
  EXPECT_EQ(kind(8, "GLY", "O").Kind, SiteAtomKind::CarbonylOxygen);
  EXPECT_EQ(kind(6, "ALA", "CB").Residue, 20);
  EXPECT_EQ(kind(6, "ALA", "CA").Residue, 0);
  EXPECT_EQ(kind(6, "XYZ", "CA").Residue, -1);
  EXPECT_EQ(SiteResidueNames().size(), 40u);
}

TEST(PocketSites, DoNotDependOnRotationTranslationOrOrder)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/pdb1ake.pdb");
  for (const char* file : { "molecules/1hew.pdb", "molecules/pdb1ake.pdb" })
  {
    const auto atoms = AtomsOfFile(file);
    const std::vector<Row> rows = DescribeRows(atoms);
    ASSERT_GE(rows.size(), 3u);
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
      EXPECT_LE(rows[i].Probability, rows[i - 1].Probability);
    }
    std::vector<vtkIdType> order(static_cast<std::size_t>(atoms->GetNumberOfPoints()));
    std::iota(order.begin(), order.end(), vtkIdType{ 0 });
    const auto turned = DescribeRows(Rearrange(atoms, order, Turn));
    std::shuffle(order.begin(), order.end(), std::mt19937(5));
    const auto shuffled = DescribeRows(Rearrange(atoms, order, [](const Point3& p) { return p; }));
    ASSERT_EQ(turned.size(), rows.size());
    ASSERT_EQ(shuffled.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      EXPECT_EQ(shuffled[i].Center, rows[i].Center); // bit by bit
      EXPECT_EQ(shuffled[i].Probability, rows[i].Probability);
      EXPECT_LT(Distance(turned[i].Center, Turn(rows[i].Center)), 0.05);
    }
  }
}

TEST(PocketSites, FirstSiteStaysIfAtomsMove)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew.pdb");
  const auto atoms = AtomsOfFile("molecules/1hew.pdb");
  std::vector<vtkIdType> order(static_cast<std::size_t>(atoms->GetNumberOfPoints()));
  std::iota(order.begin(), order.end(), vtkIdType{ 0 });
  const Point3 first = DescribeRows(atoms).front().Center;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.2 / std::sqrt(3.0));
  int changes = 0;
  for (int run = 0; run < 20; ++run)
  {
    const auto moved = Rearrange(atoms, order,
      [&](const Point3& p)
      {
        const double x = noise(random), y = noise(random), z = noise(random);
        return p + Point3{ x, y, z };
      });
    changes += Distance(DescribeRows(moved).front().Center, first) > 4.0 ? 1 : 0;
  }
  EXPECT_LE(changes, 2);
}

TEST(PocketSites, OnASurfaceAndOff)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew.pdb");
  const auto atoms = AtomsOfFile("molecules/1hew.pdb");
  vtkNew<vtkMolecularPockets> filter;
  filter->SetInputData(atoms);
  filter->Update();
  vtkTable* table = filter->GetPocketTable();
  vtkPolyData* places = filter->GetSiteSurface();
  EXPECT_GT(places->GetNumberOfPoints(), 100);
  Point3 best;
  const char* axes[] = { "CenterX", "CenterY", "CenterZ" };
  for (std::size_t k = 0; k < 3; ++k)
  {
    best[k] = table->GetValueByName(0, axes[k]).ToDouble();
  }
  // A small ball at the best site, without polarized curvature, is likely; a large one around
  // everything is not.
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.0);
  ball->SetCenter(best.data());
  filter->SetSurfaceConnection(ball->GetOutputPort());
  filter->Update();
  const auto lowest = [&]()
  {
    vtkDataArray* values = filter->GetSiteSurface()->GetPointData()->GetArray("SiteProbability");
    return values ? values->GetRange()[0] : -1.0;
  };
  EXPECT_GT(lowest(), 0.1);
  EXPECT_EQ(filter->GetSiteSurface()->GetPointData()->GetArray("PocketId")->GetRange()[0], 1.0);
  ball->SetRadius(80.0);
  filter->Update();
  EXPECT_EQ(lowest(), 0.0);
  // Whole pockets have no probability.
  filter->SetFindSites(false);
  filter->SetUsePolarizedCurvature(false);
  filter->Update();
  EXPECT_TRUE(std::isnan(filter->GetPocketTable()->GetValueByName(0, "Probability").ToDouble()));
}
