#include "Tetrahedra/CGALComplex.h"

#include <CGAL/Mesh_3/Slivers_exuder.h>
#include <CGAL/lloyd_optimize_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <cmath>

namespace isthmus::cgal
{
namespace
{

/// The criterion of CGAL's exuder, its only callback, which also checks for cancellation.
class ReportingCriterion : public CGAL::Mesh_3::Min_dihedral_angle_criterion<Triangulation>
{
  using Base = CGAL::Mesh_3::Min_dihedral_angle_criterion<Triangulation>;

public:
  ReportingCriterion(double bound, const Triangulation& triangulation, double usual,
    const ProgressCallback& progress, std::uint64_t& count)
    : Base(bound, triangulation)
    , Usual(usual)
    , Progress(&progress)
    , Calls(&count)
  {
  }

  using Base::operator();
  double operator()(const Tetrahedron_3& t) const override
  {
    if (++*this->Calls % 1024 == 0)
    {
      Report(*this->Progress, 1.0 - std::exp(-static_cast<double>(*this->Calls) / this->Usual));
    }
    return Base::operator()(t);
  }

private:
  double Usual; ///< calls after which about two thirds of the progress bar are full
  const ProgressCallback* Progress;
  std::uint64_t* Calls;
};

void Exude(Complex& complex, const ProgressCallback& progress)
{
  constexpr double slivers = 8.0; // degrees
  std::uint64_t count = 0;
  const double usual = 100.0 * static_cast<double>(complex.number_of_cells_in_complex() + 1);
  const ReportingCriterion criterion(slivers, complex.triangulation(), usual, progress, count);
  CGAL::Mesh_3::Slivers_exuder<Complex, ReportingCriterion> exuder(complex, criterion);
  exuder.set_time_limit(0.0);
  exuder();
}

}

void Optimize(const DomainWithBox& domain, const CGALCriteria& c, Complex& complex,
  const ProgressCallback& progress)
{
  namespace params = CGAL::parameters;
  if (c.LloydIterations > 0)
  {
    CGAL::lloyd_optimize_mesh_3(complex, domain, params::time_limit = c.OptimisationTimeLimit,
      params::max_iteration_number = static_cast<std::size_t>(c.LloydIterations));
  }
  if (c.ODTIterations > 0)
  {
    CGAL::odt_optimize_mesh_3(complex, domain, params::time_limit = c.OptimisationTimeLimit,
      params::max_iteration_number = static_cast<std::size_t>(c.ODTIterations));
  }
  if (c.PerturbTimeLimit > 0.0)
  {
    CGAL::perturb_mesh_3(
      complex, domain, params::time_limit = c.PerturbTimeLimit, params::sliver_bound = 15.0);
  }
  if (c.Exude)
  {
    Exude(complex, progress);
  }
}

}
