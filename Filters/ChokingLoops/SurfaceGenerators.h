/**
 * @file SurfaceGenerators.h
 * @brief When does each class of loops on a surface become fillable?
 */
#ifndef isthmus_SurfaceGenerators_h
#define isthmus_SurfaceGenerators_h

#include "ChokingLoops/SurfaceHomology.h"
#include "ChokingLoops/SurfaceInComplex.h"
#include "Persistence/FiltrationPairs.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// A class of H1(M) that dies in the complex.
struct SurfaceGenerator
{
  TriangleId Filler;            ///< the triangle that fills it
  std::vector<std::size_t> Sum; ///< the basis loops of SurfaceHomology whose sum it is
};

/**
 * The persistent kernel of H1(M) -> H1(K_d), with Z/2 coefficients: as many fillers as classes of M
 * die in the complex, each at the value where the kernel grows.
 *
 * When the complex fills space, that is all 2g classes: where inside and outside are apart from
 * each other (above the sampling error), g of them die inside and g outside ("half lives, half
 * dies"), and what a filler closes is a class of its side plus, perhaps, one that died before on
 * the other. Ascending by value. Time: 2g reductions of cycles and an elimination of 2g columns.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<SurfaceGenerator> SurfaceGenerators(
  const SurfaceHomology& homology, const SurfaceInComplex& surface, const CellFiltration& f,
  const FiltrationPairs& pairs, const ProgressCallback& progress = {});

}

#endif
