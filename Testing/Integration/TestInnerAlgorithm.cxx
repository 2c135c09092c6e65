// A failure of an inner algorithm is one error of the filter that was called.
#include "Core/AlgorithmGuard.h"
#include "Core/InnerAlgorithm.h"

#include "vtkDenoiseFromHalfMaps.h"
#include "vtkOffsetSurface.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ISTHMUS_LIMITS_MEMORY 0 // sanitizers reserve address space of their own
#else
#define ISTHMUS_LIMITS_MEMORY 1
#endif

namespace
{

/// Fails in one of several ways, or succeeds.
class Inner : public vtkPolyDataAlgorithm
{
public:
  static Inner* New();
  vtkTypeMacro(Inner, vtkPolyDataAlgorithm);
  enum Way
  {
    Success,
    Guard,
    Macro,
    Return,
    Warning
  };
  int Ending = Success;
  double Reached = 0.0;

protected:
  Inner() { this->SetNumberOfInputPorts(0); }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    if (this->Ending == Guard)
    {
      return isthmus::RunGuarded(
        this, output, [] { throw std::runtime_error("It fails within a guard."); });
    }
    if (this->Ending == Macro)
    {
      vtkErrorMacro("It fails as filters of VTK do.");
      return 1;
    }
    if (this->Ending == Warning)
    {
      vtkWarningMacro("It has doubts.");
    }
    isthmus::RunGuarded(this, output,
      [this]
      {
        for (double done = 0.0; done <= 1.0 && !this->GetAbortExecute(); done += 0.25)
        {
          this->Reached = done;
          this->UpdateProgress(done);
        }
      });
    return this->Ending == Return ? 0 : 1;
  }
};
vtkStandardNewMacro(Inner);

std::string RecordError(Inner* inner)
{
  try
  {
    isthmus::UpdateInner(inner);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

TEST(InnerAlgorithm, EveryKindOfFailureIsThrown)
{
  vtkNew<Inner> inner;
  EXPECT_EQ(RecordError(inner), "");
  const std::pair<int, const char*> ways[] = { { Inner::Guard, "It fails within a guard." },
    { Inner::Macro, "It fails as filters of VTK do." }, { Inner::Return, "Algorithm " } };
  for (const auto& [way, words] : ways)
  {
    inner->Ending = way;
    inner->Modified();
    EXPECT_EQ(RecordError(inner).substr(0, std::string(words).size()), words);
  }
  // The same again: the filter itself would not repeat its message.
  inner->Ending = Inner::Guard;
  inner->Modified();
  EXPECT_NE(RecordError(inner), "");
  inner->Modified();
  vtkObject::GlobalWarningDisplayOff();
  const std::string unseen = RecordError(inner);
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(unseen, "It fails within a guard.");
  inner->Ending = Inner::Success;
  inner->Modified();
  EXPECT_EQ(RecordError(inner), "");
}

TEST(InnerAlgorithm, WarningsProgressAndAbortArePassedOn)
{
  vtkNew<Inner> inner;
  inner->Ending = Inner::Warning;
  std::vector<double> reports;
  std::vector<std::string> warnings;
  const auto run = [&](double stopAt)
  {
    reports.clear();
    inner->Modified();
    isthmus::UpdateInner(
      inner,
      [&](double done)
      {
        reports.push_back(done);
        return done < stopAt;
      },
      [&](const std::string& warning) { warnings.push_back(warning); });
  };
  run(2.0);
  EXPECT_EQ(warnings, std::vector<std::string>{ "It has doubts." });
  EXPECT_GE(reports.size(), 5u);
  EXPECT_THROW(run(0.5), isthmus::Cancelled);
  EXPECT_EQ(inner->Reached, 0.5);
  run(2.0); // an abort does not outlast its execution
  EXPECT_EQ(inner->Reached, 1.0);
}

/// A ring: its surface has a choking loop.
vtkSmartPointer<vtkImageData> Map(int nodes, double noise)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(nodes, nodes, nodes);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double middle = 0.5 * nodes;
    const double away = std::hypot(p[0] - middle, p[1] - middle) - 0.6 * middle;
    const double square = away * away + (p[2] - middle) * (p[2] - middle);
    values->SetValue(i,
      static_cast<float>(std::exp(-square / (0.01 * nodes * nodes)) +
        noise * std::sin(static_cast<double>(i * 7919 % 104729))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

#if ISTHMUS_LIMITS_MEMORY

std::size_t AddressSpace()
{
  std::size_t pages = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r"))
  {
    const int read = std::fscanf(file, "%zu", &pages);
    std::fclose(file);
    pages = read == 1 ? pages : 0;
  }
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// The outcome of an execution in a child process with this much additional address space.
enum class End
{
  Whole,    ///< output, no error
  Reported, ///< no output, one error
  Signal,   ///< arrays of VTK that can't grow call abort() in Debian's build
  Other     ///< anything else: no output and no error, several errors ...
};

End RunWith(std::size_t bytes, vtkAlgorithm* filter)
{
  const pid_t child = fork();
  if (child == 0)
  {
    std::freopen("/dev/null", "w", stderr);
    const rlimit core{ 0, 0 };
    setrlimit(RLIMIT_CORE, &core);
    int errors = 0;
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&errors);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
    filter->AddObserver(vtkCommand::ErrorEvent, count);
    const rlimit limit{ AddressSpace() + bytes, RLIM_INFINITY };
    setrlimit(RLIMIT_AS, &limit);
    int outcome = 3;
    try
    {
      filter->Update();
      auto* const output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      const bool isWhole = output && output->GetNumberOfPoints() > 0;
      outcome = isWhole && errors == 0 ? 0 : (!isWhole && errors == 1 ? 1 : 3);
    }
    catch (...) // of the executive itself
    {
    }
    _exit(outcome);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status)   ? End::Signal
    : WEXITSTATUS(status) == 0 ? End::Whole
    : WEXITSTATUS(status) == 1 ? End::Reported
                               : End::Other;
}

/// With more and more memory, until it suffices: every failure but a signal is one error.
void ExpectErrors(vtkAlgorithm* filter, const char* name)
{
  std::array<int, 4> ends{};
  // Even with the first limit, memory suffices for a message.
  for (std::size_t mebibytes = 2; mebibytes < 400; mebibytes += mebibytes < 60 ? 3 : 10)
  {
    const End end = RunWith(mebibytes << 20, filter);
    ++ends[static_cast<std::size_t>(end)];
    EXPECT_NE(end, End::Other) << name << " with " << mebibytes << " MiB more";
    if (end == End::Whole)
    {
      break;
    }
  }
  std::printf("%s: %d whole, %d reported, %d ended by a signal\n", name, ends[0], ends[1], ends[2]);
  EXPECT_EQ(ends[0], 1) << name;
  EXPECT_GT(ends[1], 0) << name;
}

TEST(InnerAlgorithm, AllocationFailureIsOneErrorOfTheOuterFilter)
{
  vtkNew<vtkDenoiseFromHalfMaps> denoise;
  const auto one = Map(56, 0.1), other = Map(56, -0.1);
  denoise->SetInputData(one);
  denoise->SetOtherHalfData(other);
  ExpectErrors(denoise, "Denoise From Half Maps");
}

#endif

}
