#include "CellComplex/CellType.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

using LocalEdge = std::pair<int, int>;

std::string Text(const LocalEdge& edge)
{
  return "(" + std::to_string(edge.first) + ", " + std::to_string(edge.second) + ")";
}

/// Calls `visit(from, to)` for each side of a face.
template <typename Visit>
void ForEachSide(const std::vector<int>& face, Visit&& visit)
{
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    visit(face[i], face[(i + 1) % face.size()]);
  }
}

bool RunsAlong(const std::vector<int>& face, int from, int to)
{
  bool found = false;
  ForEachSide(face, [&](int a, int b) { found = found || (a == from && b == to); });
  return found;
}

}

FaceList OrientFaces(FaceList faces)
{
  std::map<LocalEdge, std::vector<std::size_t>> facesOfEdge;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    ForEachSide(faces[f], [&](int a, int b) { facesOfEdge[std::minmax(a, b)].push_back(f); });
  }
  std::vector<bool> reached(faces.size(), false);
  std::vector<std::size_t> queue;
  if (!faces.empty())
  {
    queue.push_back(0);
    reached[0] = true;
  }
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    ForEachSide(faces[queue[next]],
      [&](int a, int b)
      {
        for (const std::size_t other : facesOfEdge[std::minmax(a, b)])
        {
          if (!reached[other])
          {
            if (RunsAlong(faces[other], a, b))
            {
              std::reverse(faces[other].begin(), faces[other].end());
            }
            reached[other] = true;
            queue.push_back(other);
          }
        }
      });
  }
  return faces;
}

CellType::CellType(std::string name, int numberOfVertices, FaceList faces)
  : TypeName(std::move(name))
  , VertexCount(numberOfVertices)
  , FaceVertices(std::move(faces))
{
  this->NumberDarts();
  this->GatherVertexDarts();
  this->CheckSphere();
}

CellType::LocalDarts CellType::NumberEdges() const
{
  if (this->VertexCount < 4)
  {
    this->Reject("has fewer than four vertices");
  }
  LocalDarts dartOf;
  for (const std::vector<int>& face : this->FaceVertices)
  {
    if (face.size() < 3 || std::set<int>(face.begin(), face.end()).size() != face.size())
    {
      this->Reject("has a face with fewer than three vertices or with a repeated vertex");
    }
    ForEachSide(face,
      [&](int a, int b)
      {
        if (std::min(a, b) < 0 || std::max(a, b) >= this->VertexCount)
        {
          this->Reject("has a face with the edge " + Text({ a, b }) + ", whose vertices are not " +
            "all among its " + std::to_string(this->VertexCount));
        }
        dartOf[std::minmax(a, b)] = 0;
      });
  }
  // Local numbers of darts have 16 bits.
  if (2 * dartOf.size() + 1 > 65535)
  {
    this->Reject("has more than 32,767 edges");
  }
  unsigned number = 0;
  for (auto& edge : dartOf)
  {
    edge.second = 2 * number++ + 1;
  }
  return dartOf;
}

void CellType::NumberDarts()
{
  const LocalDarts dartOf = this->NumberEdges();
  this->Darts.resize(2 * dartOf.size() + 1);
  this->FaceOffsets.push_back(0);
  std::vector<bool> used(this->Darts.size(), false);
  for (std::size_t f = 0; f < this->FaceVertices.size(); ++f)
  {
    const std::size_t first = this->FaceDarts.size();
    ForEachSide(this->FaceVertices[f],
      [&](int a, int b)
      {
        const unsigned dart = dartOf.at(std::minmax(a, b)) + (a > b ? 1u : 0u);
        if (used[dart])
        {
          this->Reject(
            "has two faces that run along its edge " + Text({ a, b }) + " in the same direction");
        }
        used[dart] = true;
        this->Darts[dart].Start = static_cast<Local>(a);
        this->Darts[dart].Face = static_cast<Local>(f);
        this->Darts[dart].Position = static_cast<Local>(this->FaceDarts.size() - first);
        this->FaceDarts.push_back(static_cast<Local>(dart));
      });
    this->FaceOffsets.push_back(static_cast<Local>(this->FaceDarts.size()));
    this->LinkFace(first);
  }
  for (const auto& edge : dartOf)
  {
    if (!used[edge.second] || !used[Beta2(edge.second)])
    {
      this->Reject("is open at its edge " + Text(edge.first));
    }
  }
}

void CellType::LinkFace(std::size_t first)
{
  const std::size_t last = this->FaceDarts.size() - 1;
  for (std::size_t i = first; i <= last; ++i)
  {
    this->Darts[this->FaceDarts[i]].Next = this->FaceDarts[i == last ? first : i + 1];
    this->Darts[this->FaceDarts[i]].Previous = this->FaceDarts[i == first ? last : i - 1];
  }
}

void CellType::GatherVertexDarts()
{
  const auto vertices = static_cast<std::size_t>(this->VertexCount);
  this->VertexOffsets.assign(vertices + 1, 0);
  for (std::size_t d = 1; d < this->Darts.size(); ++d)
  {
    ++this->VertexOffsets[this->Darts[d].Start];
  }
  // First the ends of each vertex's darts; filling backwards, last dart first, turns them into
  // beginnings.
  std::partial_sum(
    this->VertexOffsets.begin(), this->VertexOffsets.end(), this->VertexOffsets.begin());
  this->VertexDarts.resize(this->Darts.size() - 1);
  for (std::size_t d = this->Darts.size(); --d > 0;)
  {
    this->VertexDarts[--this->VertexOffsets[this->Darts[d].Start]] = static_cast<Local>(d);
  }
}

void CellType::CheckSphere() const
{
  for (int v = 0; v < this->VertexCount; ++v)
  {
    const unsigned degree = this->VertexDegree(static_cast<unsigned>(v));
    if (degree == 0)
    {
      this->Reject("has the vertex " + std::to_string(v) + " in none of its faces");
    }
    const unsigned first = this->VertexDart(static_cast<unsigned>(v), 0);
    unsigned fan = 0;
    unsigned dart = first;
    do
    {
      dart = this->Darts[Beta2(dart)].Next;
      ++fan;
    } while (dart != first);
    if (fan != degree)
    {
      this->Reject("touches itself at its vertex " + std::to_string(v));
    }
  }
  const int euler = this->VertexCount - this->NumberOfEdges() + this->NumberOfFaces();
  if (euler != 2 || this->DartsReachedFromFirst() != this->NumberOfDarts())
  {
    this->Reject("is not a sphere: its Euler number (vertices - edges + faces) is " +
      std::to_string(euler) + ", or its faces are in several pieces");
  }
}

int CellType::DartsReachedFromFirst() const
{
  std::vector<unsigned> queue{ 1 };
  std::vector<bool> reached(this->Darts.size(), false);
  reached[1] = true;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    for (const unsigned dart : { unsigned(this->Darts[queue[next]].Next), Beta2(queue[next]) })
    {
      if (!reached[dart])
      {
        reached[dart] = true;
        queue.push_back(dart);
      }
    }
  }
  return static_cast<int>(queue.size());
}

void CellType::Reject(const std::string& reason) const
{
  throw std::invalid_argument("The cell type '" + this->TypeName + "' " + reason +
    ". List its faces counter-clockwise seen from outside, with each edge in two faces.");
}

std::size_t CellType::MemoryBytes() const
{
  std::size_t bytes = sizeof(CellType) + this->TypeName.capacity() +
    this->Darts.capacity() * sizeof(Dart) +
    (this->FaceOffsets.capacity() + this->FaceDarts.capacity() + this->VertexOffsets.capacity() +
      this->VertexDarts.capacity()) *
      sizeof(Local);
  for (const std::vector<int>& face : this->FaceVertices)
  {
    bytes += sizeof(std::vector<int>) + face.capacity() * sizeof(int);
  }
  return bytes;
}

CellType CellType::MakeMirrorImage() const
{
  FaceList faces = this->FaceVertices;
  for (std::vector<int>& face : faces)
  {
    std::reverse(face.begin(), face.end());
  }
  return CellType("mirrored " + this->TypeName, this->VertexCount, std::move(faces));
}

const CellType& CellType::Tetrahedron()
{
  static const CellType type(
    "tetrahedron", 4, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  return type;
}

const CellType& CellType::Pyramid()
{
  static const CellType type(
    "pyramid", 5, { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } });
  return type;
}

const CellType& CellType::Prism()
{
  static const CellType type(
    "prism", 6, { { 0, 2, 1 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 }, { 3, 4, 5 } });
  return type;
}

const CellType& CellType::Hexahedron()
{
  static const CellType type("hexahedron", 8,
    { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
      { 3, 0, 4, 7 } });
  return type;
}

}
