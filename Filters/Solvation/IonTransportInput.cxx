#include "Solvation/IonTransportInput.h"

#include "Core/PolyDataTriangles.h"
#include "Core/PrintableText.h"
#include "MolecularSurfaces/FlowField.h"
#include "Solvation/IonTransportOutput.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/GridImages.h"
#include "Surfaces/SurfaceCrossings.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <set>
#include <stdexcept>

namespace isthmus
{

void NameSpecies(const std::string& names, std::vector<TransportSpecies>& species)
{
  const char* const between = " ,;\t\n";
  const std::string text = Printable(names);
  std::size_t at = 0;
  std::size_t number = 0;
  std::set<std::string> taken;
  for (TransportSpecies& s : species)
  {
    at = text.find_first_not_of(between, at);
    const std::size_t end = text.find_first_of(between, at);
    s.Name = at == std::string::npos ? "Ion" + std::to_string(++number) : text.substr(at, end - at);
    number += at == std::string::npos ? 0 : 1;
    at = at == std::string::npos ? at : end;
    if (!taken.insert(s.Name).second)
    {
      throw std::invalid_argument(
        "Two species are called " + s.Name + ": give each a name of its own in SpeciesNames.");
    }
  }
}

std::vector<float> DistanceToClosed(
  const TransportDomain& domain, vtkPolyData* surface, const ProgressCallback& progress)
{
  if (surface->GetNumberOfPoints() == 0)
  {
    throw std::invalid_argument("The surface on input 1 is empty: give the molecule's closed "
                                "surface, or take the input away to have one made of the atoms.");
  }
  vtkNew<vtkImageData> image;
  SetImageGeometry(domain, image);
  const GridShape shape = ShapeOf(image);
  const auto inAxes = InGridAxes(surface, image);
  const PolyDataTriangles triangles(inAxes);
  const std::vector<unsigned char> inside = NodesInside(triangles.View(), shape);
  const std::vector<double> distance = DistanceToSurface(
    triangles.View(), shape, static_cast<double>(FlowGrid::Band) * domain.Spacing, progress);
  std::vector<float> to(distance.size());
  for (std::size_t node = 0; node < to.size(); ++node)
  {
    to[node] = static_cast<float>(inside[node] != 0 ? -distance[node] : distance[node]);
  }
  return to;
}

}
