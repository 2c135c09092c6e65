// Boxes of nodes by hand: growing, clipping, counting, and covering a box in world coordinates.

#include "Core/ImageExtent.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <limits>

using namespace isthmus;

namespace
{

const Extent Whole{ -3, 12, 0, 9, 5, 20 };
const Extent Nothing{ 0, 5, 3, 2, 0, 5 };

}

TEST(ImageExtent, AFlatOneIsNotEmpty)
{
  EXPECT_FALSE(IsEmpty({ 2, 2, 3, 3, 4, 4 }));
  EXPECT_EQ(NodeCount({ 2, 2, 3, 3, 4, 4 }), 1);
  EXPECT_TRUE(IsEmpty({ 2, 1, 3, 3, 4, 4 }));
  EXPECT_TRUE(IsEmpty(Nothing));
  EXPECT_TRUE(IsEmpty({ 0, 5, 0, 5, 1, 0 }));
  EXPECT_EQ(NodeCount(Nothing), 0);
  EXPECT_EQ(NodeCount(Whole), 16 * 10 * 16);
  constexpr int most = std::numeric_limits<int>::max();
  EXPECT_EQ(NodeCount({ 0, most - 1, 0, most - 1, 0, 0 }), std::int64_t{ most } * most);
}

TEST(ImageExtent, GrowsWithinTheWholeExtent)
{
  EXPECT_EQ(GrowExtent({ 0, 1, 4, 5, 10, 11 }, { 1, 2, 3 }, Whole), (Extent{ -1, 2, 2, 7, 7, 14 }));
  EXPECT_EQ(GrowExtent({ 0, 1, 4, 5, 10, 11 }, { 3, 4, 5 }, Whole), (Extent{ -3, 4, 0, 9, 5, 16 }));
  constexpr int most = std::numeric_limits<int>::max();
  EXPECT_EQ(GrowExtent({ 0, 1, 4, 5, 10, 11 }, { most, most, most }, Whole), Whole);
  EXPECT_EQ(GrowExtent(Nothing, { 1, 1, 1 }, Whole), Nothing);
}

TEST(ImageExtent, IntersectionsAndContainment)
{
  const Extent a{ 0, 5, 0, 5, 6, 9 };
  EXPECT_EQ(Intersection(a, { 3, 8, -2, 0, 6, 7 }), (Extent{ 3, 5, 0, 0, 6, 7 }));
  EXPECT_TRUE(IsEmpty(Intersection(a, { 6, 8, 0, 5, 6, 9 })));
  EXPECT_TRUE(Contains(Whole, a));
  EXPECT_TRUE(Contains(a, a));
  EXPECT_FALSE(Contains(a, Whole));
  for (std::size_t end = 0; end < 6; ++end)
  {
    Extent more = a;
    more[end] += end % 2 ? 1 : -1;
    EXPECT_FALSE(Contains(a, more));
    EXPECT_TRUE(Contains(more, a));
    EXPECT_EQ(LayersBetween(a, more), 1);
  }
  EXPECT_TRUE(Contains(a, Nothing));
  EXPECT_EQ(LayersBetween(a, Whole), 11);
  EXPECT_EQ(LayersBetween(Whole, a), 0);
}

TEST(ImageExtent, CoverBoundsHasTheCellsThatABoxTouches)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(-3, 12, 0, 9, 5, 20);
  image->SetOrigin(10.0, 20.0, 30.0);
  image->SetSpacing(0.5, 1.0, 2.0);
  const double box[6] = { 10.1, 10.9, 22.0, 23.5, 44.5, 45.0 };
  EXPECT_EQ(CoverBounds(image, box, { 0, 0, 0 }, Whole), (Extent{ 0, 2, 2, 4, 7, 8 }));
  EXPECT_EQ(CoverBounds(image, box, { 1, 0, 3 }, Whole), (Extent{ -1, 3, 2, 4, 5, 11 }));
  const double all[6] = { -1e300, 1e300, -1e300, 1e300, -1e300, 1e300 };
  EXPECT_EQ(CoverBounds(image, all, { 0, 0, 0 }, Whole), Whole);
  // Turned by a quarter around z: x of the world is the second axis of the image.
  image->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  const double turned[6] = { 12.5, 13.0, 18.75, 19.25, 44.5, 45.0 };
  EXPECT_EQ(CoverBounds(image, turned, { 0, 0, 0 }, Whole), (Extent{ 1, 3, 2, 3, 7, 8 }));
}
