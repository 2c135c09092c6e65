#include "Imaging/DomainDecomposition.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include <algorithm>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr int haloTag = 20240;

/// Calls body(offset of a row of `box` in an array of extent `local`, row length).
template <typename Body>
void ForRows(const Extent& local, const Extent& box, Body&& body)
{
  const std::int64_t nx = local[1] - local[0] + 1, ny = local[3] - local[2] + 1;
  for (std::int64_t k = box[4]; k <= box[5]; ++k)
  {
    for (std::int64_t j = box[2]; j <= box[3]; ++j)
    {
      body(box[0] - local[0] + nx * (j - local[2] + ny * (k - local[4])), box[1] - box[0] + 1);
    }
  }
}

/// Cuts from `mine` its overlap with `other`, if that is a slab across all of it; otherwise false.
bool CutSlab(Extent& mine, const Extent& other)
{
  const Extent shared = Intersection(mine, other);
  if (NodeCount(shared) == 0)
  {
    return true;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t low = 2 * axis, high = low + 1;
    Extent slab = mine;
    slab[low] = shared[low];
    slab[high] = shared[high];
    if (slab == shared && (shared[low] == mine[low] || shared[high] == mine[high]))
    {
      shared[low] == mine[low] ? mine[low] = shared[high] + 1 : mine[high] = shared[low] - 1;
      return true;
    }
  }
  return false;
}

}

DomainDecomposition::DomainDecomposition(
  vtkMultiProcessController* controller, const Extent& whole, const Extent& own, int halo)
  : Controller(controller)
  , Whole(whole)
  , Halo(halo)
  , Extents(1, own)
  , LocalExtent(own)
  , OwnedExtent(own)
{
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  if (ranks > 1)
  {
    this->Extents.resize(static_cast<std::size_t>(ranks));
    this->Rank = static_cast<std::size_t>(controller->GetLocalProcessId());
    controller->AllGather(own.data(), this->Extents.front().data(), 6);
    this->LocalExtent = GrowExtent(own, { halo, halo, halo }, whole);
    this->FindOwned();
  }
}

Extent DomainDecomposition::Shared(std::size_t owner, std::size_t user) const
{
  const Extent& part = this->Extents[user];
  const Extent grown = GrowExtent(part, { this->Halo, this->Halo, this->Halo }, this->Whole);
  return grown == part ? Extent{ 0, -1, 0, -1, 0, -1 } : Intersection(this->Extents[owner], grown);
}

void DomainDecomposition::FindOwned()
{
  // Every rank computes what all ranks own, so that all find the same errors.
  std::int64_t covered = 0;
  for (std::size_t rank = 0; rank < this->Extents.size(); ++rank)
  {
    Extent owned = this->Extents[rank];
    // A crosswise overlap with one rank may be part of a slab that another one cuts away.
    for (std::size_t round = 0; round < 3; ++round)
    {
      std::for_each(this->Extents.begin(), this->Extents.begin() + std::ptrdiff_t(rank),
        [&owned](const Extent& lower) { CutSlab(owned, lower); });
    }
    covered += NodeCount(owned);
    if (rank == this->Rank)
    {
      this->OwnedExtent = owned;
    }
  }
  if (covered != NodeCount(this->Whole))
  {
    throw std::runtime_error(
      "The parts of the image on the ranks do not cover the whole image, which this filter needs: "
      "apply it before filters that crop the image.");
  }
}

template <typename T>
void DomainDecomposition::ExchangeHalo(T* values) const
{
  if (!this->Distributed())
  {
    return;
  }
  std::vector<T> buffer;
  auto send = [&](std::size_t other)
  {
    const Extent box = this->Shared(this->Rank, other);
    buffer.clear();
    ForRows(this->LocalExtent, box,
      [&](std::int64_t row, std::int64_t length)
      { buffer.insert(buffer.end(), values + row, values + row + length); });
    if (!buffer.empty())
    {
      this->Controller->Send(
        buffer.data(), static_cast<vtkIdType>(buffer.size()), static_cast<int>(other), haloTag);
    }
  };
  auto receive = [&](std::size_t other)
  {
    const Extent box = this->Shared(other, this->Rank);
    buffer.resize(static_cast<std::size_t>(NodeCount(box)));
    if (!buffer.empty())
    {
      this->Controller->Receive(
        buffer.data(), static_cast<vtkIdType>(buffer.size()), static_cast<int>(other), haloTag);
    }
    auto from = buffer.cbegin();
    ForRows(this->LocalExtent, box,
      [&](std::int64_t row, std::int64_t length)
      {
        std::copy_n(from, length, values + row);
        from += length;
      });
  };
  // Pairs of ranks meet in the same order everywhere, so that there is no deadlock.
  for (std::size_t other = 0; other < this->Extents.size(); ++other)
  {
    if (other < this->Rank)
    {
      receive(other);
      send(other);
    }
    else if (other > this->Rank)
    {
      send(other);
      receive(other);
    }
  }
}

void DomainDecomposition::Sum(double* values, int count) const
{
  if (this->Distributed())
  {
    std::vector<double> sums(values, values + count);
    this->Controller->AllReduce(sums.data(), values, count, vtkCommunicator::SUM_OP);
  }
}

template void DomainDecomposition::ExchangeHalo(float*) const;
template void DomainDecomposition::ExchangeHalo(double*) const;

}
