#include "Imaging/DiffusionEvaluation.h"

#include "Core/ParallelFor.h"
#include "Imaging/DiffusionPipeline.h"

#include <memory>
#include <mutex>

namespace isthmus
{
namespace
{

/// Hands out pipelines, so that each thread has one and their memory is touched for the first time
/// once and not for every tile.
template <typename T>
class PipelinePool
{
public:
  using Pipeline = std::unique_ptr<DiffusionPipeline<T>>;

  Pipeline Take(const DiffusionOperator<T>& diffusion, int stages, std::int64_t tileRows)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Idle.empty())
      {
        Pipeline pipeline = std::move(this->Idle.back());
        this->Idle.pop_back();
        return pipeline;
      }
    }
    return std::make_unique<DiffusionPipeline<T>>(diffusion, stages, tileRows);
  }

  void Return(Pipeline pipeline)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle.push_back(std::move(pipeline));
  }

private:
  std::mutex Mutex;
  std::vector<Pipeline> Idle;
};

std::int64_t Parts(std::int64_t whole, std::int64_t part)
{
  return (whole + part - 1) / part;
}

}

template <typename T>
int StagesOfAPass(const DiffusionOperator<T>& diffusion)
{
  // What each stage adds at the sides of a tile grows with its reach: from order 1 on, that costs
  // what memory gains.
  return diffusion.Order() == 0 ? 4 : 1;
}

template <typename T>
void Evaluate(const DiffusionOperator<T>& diffusion, const DiffusionPass<T>& pass,
  const ProgressCallback& progress)
{
  if (diffusion.Size() == 0)
  {
    return;
  }
  const std::int64_t rows = diffusion.Dimensions[1];
  const std::int64_t planes = diffusion.Dimensions[2];
  const int stages = pass.Stages();
  const std::int64_t chunkPlanes = 64 * stages; // so that what is done twice stays a small part
  const std::int64_t fitting = DiffusionPipeline<T>::TileRowsThatFit(diffusion, stages);
  const std::int64_t tileRows = Parts(rows, Parts(rows, fitting)); // tiles of nearly equal height
  const std::int64_t tiles = Parts(rows, tileRows);
  const std::int64_t chunks = Parts(planes, chunkPlanes);
  PipelinePool<T> pool;
  ParallelFor(
    0, tiles * chunks, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      auto pipeline = pool.Take(diffusion, stages, tileRows);
      for (std::int64_t item = first; item < last; ++item)
      {
        const std::int64_t row = item % tiles * tileRows;
        const std::int64_t plane = item / tiles * chunkPlanes;
        pipeline->Run(pass, { row, std::min(rows, row + tileRows) },
          { plane, std::min(planes, plane + chunkPlanes) });
      }
      pool.Return(std::move(pipeline));
    },
    progress);
}

template int StagesOfAPass(const DiffusionOperator<float>&);
template int StagesOfAPass(const DiffusionOperator<double>&);
template void Evaluate(
  const DiffusionOperator<float>&, const DiffusionPass<float>&, const ProgressCallback&);
template void Evaluate(
  const DiffusionOperator<double>&, const DiffusionPass<double>&, const ProgressCallback&);

}
