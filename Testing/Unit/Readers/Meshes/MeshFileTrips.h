/**
 * @file MeshFileTrips.h
 * @brief Mesh files written and read again, or refused.
 */
#ifndef isthmus_MeshFileTrips_h
#define isthmus_MeshFileTrips_h

#include "Core/Progress.h"
#include "TemporaryFile.h"

#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace isthmus::testing
{

template <typename Reader>
auto OpenFile(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError)) << path;
  return reader;
}

/// Points and cells are the same, in the same order; coordinates bit for bit.
inline void ExpectSame(vtkPointSet* a, vtkPointSet* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    ASSERT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) << "point " << i;
  }
  vtkNew<vtkIdList> ids, others;
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(a->GetCellType(c), b->GetCellType(c)) << "cell " << c;
    a->GetCellPoints(c, ids);
    b->GetCellPoints(c, others);
    ASSERT_EQ(ids->GetNumberOfIds(), others->GetNumberOfIds()) << "cell " << c;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ASSERT_EQ(ids->GetId(i), others->GetId(i)) << "cell " << c;
    }
  }
}

template <typename Writer>
void Write(vtkPointSet* data, const std::string& path)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1) << path;
}

/// The error message for a file; empty if it was read.
template <typename Read>
std::string CatchMessage(Read&& read, const std::string& content, const std::string& name,
  const std::string& partner = {}, const std::string& partnerName = "x.node")
{
  const TemporaryFile file(content, name);
  if (!partner.empty())
  {
    std::ofstream(std::filesystem::path(file.Path()).parent_path() / partnerName) << partner;
  }
  try
  {
    read(file.Path(), ProgressCallback());
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

#define EXPECT_SAYS(sentence, part)                                                                \
  EXPECT_NE((sentence).find(part), std::string::npos) << (sentence)

/// Random tetrahedra with coordinates of all magnitudes, which text must preserve.
inline vtkSmartPointer<vtkUnstructuredGrid> RandomMesh(int type, int corners, int cells)
{
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-300, 300);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < corners * cells; ++i)
  {
    points->InsertNextPoint(std::ldexp(mantissa(random), exponent(random)),
      std::ldexp(mantissa(random), exponent(random)), i == 0 ? -0.0 : mantissa(random));
  }
  grid->SetPoints(points);
  std::vector<vtkIdType> ids(static_cast<std::size_t>(corners));
  for (int c = 0; c < cells; ++c)
  {
    for (int i = 0; i < corners; ++i)
    {
      ids[static_cast<std::size_t>(i)] = corners * c + (i * 3 + c) % corners;
    }
    grid->InsertNextCell(type, corners, ids.data());
  }
  return grid;
}

}

#endif
