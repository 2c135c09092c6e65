// A failed filter reports one message, once, without VTK's description of its request, and
// downstream outputs are emptied as well.

#include "Core/AlgorithmGuard.h"
#include "Core/ChildProcess.h"
#include "vtkMRCMapReader.h"
#include "vtkSurfaceToGrid.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkElevationFilter.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// Fails with Sentence, in RequestInformation as well as in RequestData; without it, copies its
/// input.
class Failing : public vtkPolyDataAlgorithm
{
public:
  static Failing* New();
  vtkTypeMacro(Failing, vtkPolyDataAlgorithm);
  std::string Message;

protected:
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    return isthmus::RunGuarded(this, vtkPolyData::GetData(output), [this] { this->Fail(); });
  }

  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override
  {
    auto* result = vtkPolyData::GetData(output);
    result->ShallowCopy(vtkPolyData::GetData(input[0]));
    return isthmus::RunGuarded(this, output, [this] { this->Fail(); });
  }

private:
  void Fail() const
  {
    if (!this->Message.empty())
    {
      throw std::runtime_error(this->Message);
    }
  }
};

vtkStandardNewMacro(Failing);

/// Fills both outputs, then fails with Sentence, or is aborted if there is no Sentence.
class FailingTwice : public vtkPolyDataAlgorithm
{
public:
  static FailingTwice* New();
  vtkTypeMacro(FailingTwice, vtkPolyDataAlgorithm);
  std::string Message;
  bool Sound = false;

protected:
  FailingTwice() { this->SetNumberOfOutputPorts(2); }

  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* outputs) override
  {
    return isthmus::RunGuarded(this, outputs,
      [&]
      {
        for (int port = 0; port < 2; ++port)
        {
          vtkPolyData::GetData(outputs, port)->ShallowCopy(vtkPolyData::GetData(input[0]));
        }
        if (!this->Sound)
        {
          if (this->Message.empty())
          {
            throw isthmus::Cancelled();
          }
          throw std::runtime_error(this->Message);
        }
      });
  }
};

vtkStandardNewMacro(FailingTwice);

/// The messages of an algorithm and its executive, one entry each.
class Ear
{
public:
  explicit Ear(vtkAlgorithm* algorithm)
  {
    for (vtkObject* who : std::initializer_list<vtkObject*>{ algorithm, algorithm->GetExecutive() })
    {
      vtkNew<vtkCallbackCommand> listener;
      listener->SetClientData(&this->Messages);
      listener->SetCallback(
        [](vtkObject*, unsigned long, void* said, void* words) {
          static_cast<std::vector<std::string>*>(said)->emplace_back(
            static_cast<const char*>(words));
        });
      who->AddObserver(vtkCommand::ErrorEvent, listener);
    }
  }

  std::vector<std::string> Messages;
};

}

TEST(AlgorithmGuard, EachMessageIsReportedOnce)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<Failing> failing;
  const Ear ear(failing);
  failing->SetInputConnection(sphere->GetOutputPort());
  failing->Message = "The sky is down: lift it.";
  failing->UpdateInformation();
  ASSERT_EQ(ear.Messages.size(), 1U);
  EXPECT_NE(ear.Messages[0].find(failing->Message), std::string::npos);
  failing->Update(); // fails again, for the data
  failing->Update();
  EXPECT_EQ(ear.Messages.size(), 1U);
  EXPECT_EQ(failing->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(AlgorithmGuard, IsReportedAgainAfterAnyChange)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<Failing> failing;
  const Ear ear(failing);
  failing->SetInputConnection(sphere->GetOutputPort());
  failing->Message = "The sky is down: lift it.";
  failing->Update();
  failing->Modified();
  failing->Update();
  EXPECT_EQ(ear.Messages.size(), 2U) << "the filter was changed";
  sphere->SetRadius(3.0);
  failing->Update();
  EXPECT_EQ(ear.Messages.size(), 3U) << "its input was";
  failing->Message = "The sea is up.";
  failing->Modified();
  failing->Update();
  ASSERT_EQ(ear.Messages.size(), 4U);
  EXPECT_NE(ear.Messages[3].find("The sea is up."), std::string::npos);
}

TEST(AlgorithmGuard, DownstreamOutputsAreEmptiedAndComeBack)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<Failing> failing;
  const Ear ear(failing);
  failing->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkElevationFilter> after;
  after->SetInputConnection(failing->GetOutputPort());
  after->Update();
  const vtkIdType points = after->GetOutput()->GetNumberOfPoints();
  EXPECT_GT(points, 0);
  failing->Message = "The sky is down: lift it.";
  failing->Modified();
  after->Update();
  EXPECT_EQ(after->GetOutput()->GetNumberOfPoints(), 0);
  failing->Message.clear();
  failing->Modified();
  after->Update();
  EXPECT_EQ(after->GetOutput()->GetNumberOfPoints(), points);
  EXPECT_EQ(ear.Messages.size(), 1U);
}

TEST(AlgorithmGuard, AllOutputsAreEmptyAfterAnErrorAndAfterAnAbort)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<FailingTwice> failing;
  const Ear ear(failing);
  failing->SetInputConnection(sphere->GetOutputPort());
  const auto pointsOf = [&](int port)
  { return vtkPolyData::SafeDownCast(failing->GetOutputDataObject(port))->GetNumberOfPoints(); };
  failing->Sound = true;
  failing->Update();
  EXPECT_GT(pointsOf(0), 0);
  EXPECT_GT(pointsOf(1), 0);
  for (const char* sentence : { "The sky is down: lift it.", "" })
  {
    failing->Sound = false;
    failing->Message = sentence;
    failing->Modified();
    failing->Update();
    EXPECT_EQ(pointsOf(0), 0) << sentence;
    EXPECT_EQ(pointsOf(1), 0) << sentence;
  }
  EXPECT_EQ(ear.Messages.size(), 1U); // an abort is no error
}

TEST(AlgorithmGuard, AnUpdateInRequestInformationReportsOnce)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkSurfaceToGrid> grid;
  const Ear ear(grid);
  grid->SetInputConnection(sphere->GetOutputPort());
  grid->SetSpacing(-1.0);
  grid->Update();
  grid->Update();
  EXPECT_EQ(ear.Messages.size(), 1U) << (ear.Messages.size() > 1 ? ear.Messages[1] : "");
  EXPECT_EQ(grid->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(AlgorithmGuard, AnAbortUpstreamIsNoticedAndReset)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkSurfaceToGrid> grid;
  grid->SetInputConnection(sphere->GetOutputPort());
  grid->SetSpacing(0.05);
  vtkNew<vtkElevationFilter> after;
  after->SetInputConnection(grid->GetOutputPort());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(sphere);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* source, void*)
    {
      if (static_cast<vtkAlgorithm*>(caller)->GetProgress() > 0.0)
      {
        static_cast<vtkAlgorithm*>(source)->SetAbortExecuteAndUpdateTime();
      }
    });
  const unsigned long tag = grid->AddObserver(vtkCommand::ProgressEvent, stop);
  const Ear ear(grid);
  after->Update();
  EXPECT_EQ(grid->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(after->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  grid->RemoveObserver(tag);
  sphere->AbortExecuteOff();
  sphere->Modified();
  after->Update();
  EXPECT_GT(after->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_TRUE(ear.Messages.empty()) << ear.Messages[0];
}

TEST(AlgorithmGuard, ATruncatedFileIsReportedOnceWithItsCode)
{
  const isthmus::TemporaryFolder folder;
  const auto path = folder.Path() / "isthmus_cut_short.map";
  std::ofstream(path, std::ios::binary) << std::string(1023, 'x');
  vtkNew<vtkMRCMapReader> reader;
  const Ear ear(reader);
  reader->SetFileName(path.string().c_str());
  for (int i = 0; i < 3; ++i)
  {
    reader->UpdateInformation();
    reader->Update();
    EXPECT_NE(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  }
  EXPECT_EQ(ear.Messages.size(), 1U) << (ear.Messages.size() > 1 ? ear.Messages[1] : "");
}
