// The Poisson-Nernst-Planck equations for a round pore in radius and height, by a direct solver:
// the reference for three dimensions. Only the formula for the flux is taken from the library.
#ifndef AxisymmetricPore_h
#define AxisymmetricPore_h

#include "Electrostatics/ElectrostaticUnits.h"
#include "Solvation/PoissonNernstPlanck.h"
#include "Solvation/TransportGrid.h"
#include "TransportLine.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <vector>

namespace isthmus::testing
{

/// Rings of cells with centers (i + 1/2) h from the axis and k h - HalfLength along it.
class AxisymmetricPore
{
public:
  /// A ring of `charge` e around the axis, `ring` angstrom from it, in the middle of the membrane.
  AxisymmetricPore(const TransportDomain& domain, const IonTransportParameters& parameters,
    double ring, double charge, double h)
    : P(parameters)
    , H(h)
    , Rings(static_cast<int>(std::lround(domain.Radius / h)))
    , Layers(2 * static_cast<int>(std::lround(domain.HalfLength / h)) + 1)
    , Half(domain.HalfLength)
    , Phi(Eigen::VectorXd::Zero(this->Rings * this->Layers))
    , Fixed(this->Phi)
  {
    const double coulomb = 4.0 * Pi * units::CoulombLength(this->P.Temperature);
    this->Fixed[this->At(static_cast<int>(ring / h), this->Layers / 2)] = 0.5 * coulomb * charge;
    this->Fixed[this->At(static_cast<int>(ring / h) - 1, this->Layers / 2)] =
      0.5 * coulomb * charge;
    this->Drop = 1e-3 * this->P.Voltage * units::ElementaryCharge /
      (units::BoltzmannConstant * this->P.Temperature);
    this->V.assign(this->P.Species.size(), this->Phi);
    for (int iteration = 0; iteration < 40; ++iteration)
    {
      for (std::size_t k = 0; k < this->V.size(); ++k)
      {
        this->SolveIons(k);
      }
      const Eigen::VectorXd before = this->Phi;
      for (int step = 0; step < 30 && this->NewtonStep() > 1e-6; ++step)
      {
      }
      if ((this->Phi - before).cwiseAbs().maxCoeff() < 1e-5)
      {
        break;
      }
    }
  }

  /// pA, through the middle of the pore.
  double Current(std::size_t k) const
  {
    double total = 0.0;
    const int middle = this->Layers / 2;
    for (int i = 0; i < this->Rings; ++i)
    {
      if (this->Wet(i, middle) && this->Wet(i, middle + 1))
      {
        total += this->Area(i) / this->H * this->P.Species[k].Diffusion *
          this->Conductance(k, this->At(i, middle), this->At(i, middle + 1)) *
          (this->V[k][this->At(i, middle)] - this->V[k][this->At(i, middle + 1)]);
      }
    }
    return this->P.Species[k].Valence * FaradayUnit() * total;
  }

private:
  int At(int ring, int layer) const { return ring + this->Rings * layer; }
  double Along(int layer) const { return this->H * layer - this->Half; }
  double Area(int ring) const { return Pi * this->H * this->H * (2 * ring + 1); }
  bool Held(int layer) const { return layer == 0 || layer == this->Layers - 1; }
  bool Wet(int ring, int layer) const
  {
    return std::abs(this->Along(layer)) > 0.5 * this->P.MembraneThickness ||
      this->H * (ring + 0.5) < this->P.LumenRadius;
  }
  double Conductance(std::size_t k, int p, int q) const
  {
    const double half = -0.5 * this->P.Species[k].Valence;
    return SlotboomConductance(std::exp(half * this->Phi[p]), std::exp(half * this->Phi[q]));
  }

  /// Calls each(p, q, area / distance) for neighbours p and q.
  template <typename Each>
  void ForEachFace(Each&& each) const
  {
    for (int k = 0; k < this->Layers; ++k)
    {
      for (int i = 0; i < this->Rings; ++i)
      {
        if (k + 1 < this->Layers)
        {
          each(i, k, i, k + 1, this->Area(i) / this->H);
        }
        if (i + 1 < this->Rings && !this->Held(k))
        {
          each(i, k, i + 1, k, 2.0 * Pi * this->H * (i + 1));
        }
      }
    }
  }

  /// Solves sum g (u_p - u_q) + d_p u_p = s_p with u given in the baths.
  Eigen::VectorXd Solve(const std::vector<Eigen::Triplet<double>>& faces,
    const Eigen::VectorXd& diagonal, Eigen::VectorXd right, double below, double above) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    const int n = this->Rings * this->Layers;
    const auto held = [this](int p) { return this->Held(p / this->Rings); };
    const auto given = [&](int p) { return p < this->Rings ? below : above; };
    for (const auto& face : faces)
    {
      for (const auto& [p, q] :
        { std::pair(face.row(), face.col()), std::pair(face.col(), face.row()) })
      {
        if (held(p))
        {
          continue;
        }
        entries.emplace_back(p, p, face.value());
        if (held(q))
        {
          right[p] += face.value() * given(q);
        }
        else
        {
          entries.emplace_back(p, q, -face.value());
        }
      }
    }
    for (int p = 0; p < n; ++p)
    {
      entries.emplace_back(p, p, held(p) ? 1.0 : diagonal[p]);
      right[p] = held(p) ? given(p) : right[p];
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    return factor.solve(right);
  }

  void SolveIons(std::size_t k)
  {
    std::vector<Eigen::Triplet<double>> faces;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(this->Phi.size());
    this->ForEachFace(
      [&](int i, int layer, int j, int next, double over)
      {
        if (this->Wet(i, layer) && this->Wet(j, next))
        {
          const int p = this->At(i, layer), q = this->At(j, next);
          faces.emplace_back(p, q, over * this->Conductance(k, p, q));
        }
      });
    for (int p = 0; p < this->Phi.size(); ++p)
    {
      diagonal[p] = this->Wet(p % this->Rings, p / this->Rings) ? 0.0 : 1.0;
    }
    const TransportSpecies& s = this->P.Species[k];
    this->V[k] = this->Solve(faces, diagonal, Eigen::VectorXd::Zero(this->Phi.size()),
      s.Below * std::exp(s.Valence * this->Drop), s.Above);
  }

  double NewtonStep()
  {
    std::vector<Eigen::Triplet<double>> faces;
    this->ForEachFace(
      [&](int i, int layer, int j, int next, double over)
      {
        const bool a = this->Wet(i, layer), b = this->Wet(j, next);
        const double in = this->P.SoluteDielectric, out = this->P.SolventDielectric;
        const double eps = a != b ? 2.0 * in * out / (in + out) : a ? out : in;
        faces.emplace_back(this->At(i, layer), this->At(j, next), over * eps);
      });
    const double scale =
      4.0 * Pi * units::CoulombLength(this->P.Temperature) * units::IonsPerCubicAngstrom * this->H;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(this->Phi.size());
    Eigen::VectorXd right = this->Fixed;
    for (int p = 0; p < this->Phi.size(); ++p)
    {
      for (std::size_t k = 0; k < this->V.size() && this->Wet(p % this->Rings, p / this->Rings);
           ++k)
      {
        const double z = this->P.Species[k].Valence;
        const double ions =
          scale * this->Area(p % this->Rings) * this->V[k][p] * std::exp(-z * this->Phi[p]);
        diagonal[p] += z * z * ions;
        right[p] += z * ions + z * z * ions * this->Phi[p];
      }
    }
    const Eigen::VectorXd next = this->Solve(faces, diagonal, right, this->Drop, 0.0);
    const double change = (next - this->Phi).cwiseAbs().maxCoeff();
    this->Phi += (next - this->Phi) * std::min(1.0, 3.0 / change);
    return change;
  }

  const IonTransportParameters P;
  const double H;
  const int Rings, Layers;
  const double Half;
  double Drop = 0.0;
  Eigen::VectorXd Phi, Fixed;
  std::vector<Eigen::VectorXd> V;
};

}

#endif
