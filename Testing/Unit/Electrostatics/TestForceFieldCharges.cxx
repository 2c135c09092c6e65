#include "vtkForceFieldCharges.h"

#include "Core/ChildProcess.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{

/// Water and two atoms of a glycine, as a PDB file gives them: without charges.
vtkSmartPointer<vtkPolyData> Glycine()
{
  auto atoms = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkStringArray> names, residues, chains;
  vtkNew<vtkIntArray> ids;
  const char* const called[] = { "N", "CA", "O" };
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(1.5 * i, 0.0, 0.0);
    names->InsertNextValue(called[i]);
    residues->InsertNextValue(i < 2 ? "GLY" : "HOH");
    chains->InsertNextValue("A");
    ids->InsertNextValue(i < 2 ? 1 : 2);
  }
  atoms->SetPoints(points);
  vtkAbstractArray* const arrays[] = { names, residues, chains, ids };
  const char* const arrayNames[] = { "AtomName", "ResidueName", "Chain", "ResidueId" };
  for (int a = 0; a < 4; ++a)
  {
    arrays[a]->SetName(arrayNames[a]);
    atoms->GetPointData()->AddArray(arrays[a]);
  }
  return atoms;
}

/// A substitute for pdb2pqr: each atom with charge 0.25 and radius 1.5. Meanwhile, PATH has its
/// folder and those of the shell's commands.
class Program
{
public:
  explicit Program(bool isThere)
    : Before(std::getenv("PATH"))
  {
    if (isThere)
    {
      const std::filesystem::path file = this->Folder.Path() / "pdb2pqr";
      std::ofstream(file) << "#!/bin/sh\nfor last in \"$@\"; do before=$file; file=$last; done\n"
                             "while read -r a b c d e f g h i j; do [ \"$a\" = END ] || "
                             "echo \"$a $b $c $d $e $f $g $h $i 0.25 1.5\"; done <\"$before\" "
                             ">\"$file\"\n";
      std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }
    setenv("PATH", this->Folder.Path().c_str(), 1);
  }
  ~Program() { setenv("PATH", this->Before.c_str(), 1); }
  Program(const Program&) = delete;
  void operator=(const Program&) = delete;

private:
  isthmus::TemporaryFolder Folder;
  std::string Before;
};

TEST(ForceFieldCharges, AtomsGetChargesAndRadii)
{
  const Program program(true);
  vtkNew<vtkForceFieldCharges> filter;
  filter->SetInputDataObject(Glycine());
  filter->Update();
  vtkPointSet* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 2); // not the water
  EXPECT_STREQ(output->GetClassName(), "vtkPolyData");
  for (vtkIdType i = 0; i < 2; ++i)
  {
    EXPECT_EQ(output->GetPoint(i)[0], 1.5 * static_cast<double>(i));
    EXPECT_EQ(output->GetPointData()->GetArray("Charge")->GetTuple1(i), 0.25);
    EXPECT_EQ(output->GetPointData()->GetArray("Radius")->GetTuple1(i), 1.5);
    EXPECT_EQ(output->GetPointData()->GetArray("InputAtom")->GetTuple1(i), static_cast<double>(i));
    vtkAbstractArray* residues = output->GetPointData()->GetAbstractArray("ResidueName");
    ASSERT_TRUE(residues);
    EXPECT_EQ(residues->GetVariantValue(i).ToString(), "GLY");
  }
}

TEST(ForceFieldCharges, ChargesOfTheFileStay)
{
  const Program none(false);
  const auto atoms = Glycine();
  vtkNew<vtkDoubleArray> charges;
  charges->SetName("Charge");
  for (const double charge : { 0.5, -0.5, 0.0 })
  {
    charges->InsertNextValue(charge);
  }
  atoms->GetPointData()->AddArray(charges);
  vtkNew<vtkForceFieldCharges> filter;
  filter->SetInputDataObject(atoms);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 3);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Charge")->GetTuple1(1), -0.5);
}

std::string Complaint(vtkPolyData* atoms)
{
  vtkNew<vtkForceFieldCharges> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputDataObject(atoms);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  return observer->GetErrorMessage();
}

TEST(ForceFieldCharges, WithoutTheProgramOrNamesThereIsOneMessage)
{
  const Program none(false);
  EXPECT_NE(Complaint(Glycine()).find("pdb2pqr"), std::string::npos) << Complaint(Glycine());
  const auto nowhere = Glycine();
  nowhere->GetPoints()->SetPoint(1, std::nan(""), 0.0, 0.0);
  EXPECT_NE(Complaint(nowhere).find("finite"), std::string::npos) << Complaint(nowhere);
  vtkNew<vtkPolyData> nameless;
  nameless->SetPoints(Glycine()->GetPoints());
  EXPECT_NE(Complaint(nameless).find("neither charges nor names"), std::string::npos)
    << Complaint(nameless);
}

}
