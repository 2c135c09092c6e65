// Deprecated names of C++ do what the names that replaced them do.

#include "vtkIsosurfaceStuffing.h"
#include "vtkMapHandles.h"
#include "vtkMolecularFlowSurface.h"
#include "vtkPoissonBoltzmann.h"
#include "vtkSurfaceMeasures.h"
#include "vtkSurfaceRemesh.h"
#include "vtkSurfaceToGrid.h"
#include "vtkTetCutaway.h"
#include "vtkTetrahedralMesher.h"
#include <vtkNew.h>

#include <gtest/gtest.h>

#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wdeprecated-declarations" // they are what is tested
#endif

namespace
{

template <typename Filter>
void ExpectIsoValueIsLevel()
{
  vtkNew<Filter> filter;
  filter->SetIsoValue(0.25);
  EXPECT_EQ(filter->GetLevel(), 0.25);
  filter->SetLevel(0.75);
  EXPECT_EQ(filter->GetIsoValue(), 0.75);
}

}

TEST(Deprecation, IsoValueIsLevel)
{
  ExpectIsoValueIsLevel<vtkMolecularFlowSurface>();
  ExpectIsoValueIsLevel<vtkPoissonBoltzmann>();
  ExpectIsoValueIsLevel<vtkSurfaceMeasures>();
  ExpectIsoValueIsLevel<vtkSurfaceToGrid>();
}

TEST(Deprecation, SuperlevelIsInsideIsHigher)
{
  vtkNew<vtkMapHandles> filter;
  filter->SuperlevelOff();
  EXPECT_FALSE(filter->GetInsideIsHigher());
  filter->SuperlevelOn();
  EXPECT_TRUE(filter->GetInsideIsHigher());
  filter->SetSuperlevel(false);
  EXPECT_FALSE(filter->GetSuperlevel());
}

TEST(Deprecation, EnumeratorsKeepTheirValues)
{
  EXPECT_EQ(vtkIsosurfaceStuffing::INSIDE, vtkIsosurfaceStuffing::Inside);
  EXPECT_EQ(vtkIsosurfaceStuffing::OUTSIDE, 1);
  EXPECT_EQ(vtkIsosurfaceStuffing::BOTH, 2);
  EXPECT_EQ(vtkTetrahedralMesher::INSIDE, 0);
  EXPECT_EQ(vtkTetrahedralMesher::OUTSIDE, 1);
  EXPECT_EQ(vtkTetrahedralMesher::BOTH, 2);
  EXPECT_EQ(vtkTetrahedralMesher::TETGEN, 0);
  EXPECT_EQ(vtkTetrahedralMesher::CGAL, 1);
  EXPECT_EQ(vtkTetrahedralMesher::AUTOMATIC, 2);
  EXPECT_EQ(vtkSurfaceRemesh::RELATIVE_EDGE_LENGTH, 0);
  EXPECT_EQ(vtkSurfaceRemesh::EDGE_LENGTH, 1);
  EXPECT_EQ(vtkSurfaceRemesh::NUMBER_OF_TRIANGLES, 2);
  EXPECT_EQ(vtkTetCutaway::SEED_POINT, 0);
  EXPECT_EQ(vtkTetCutaway::SEED_FACE, 1);
  EXPECT_EQ(vtkTetCutaway::STOP_BY_NUMBER, 0);
  EXPECT_EQ(vtkTetCutaway::STOP_BY_DISTANCE, 1);
  EXPECT_EQ(vtkTetCutaway::STOP_BY_PLANE, 2);
}
