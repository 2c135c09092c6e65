/**
 * @file MoleculeCartoon.h
 * @brief Ribbons and arrows along chains, and balls and sticks, as polygons.
 *
 * The curve of a chain is the cubic Hermite spline through CA of amino acids (of strands, through
 * the averages (1, 2, 1)/4 along the chain, which flattens them) and through C4' of nucleotides,
 * with the tangents of Catmull and Rom. The section is a superellipse |x/a|^e + |y/b|^e = 1: a
 * circle of coil, an ellipse (e = 2) of a helix, nearly a rectangle (e = 6) of a strand, blended
 * halfway between residues. Its long axis lies in the peptide planes, as M. Carson and C. E. Bugg,
 * J. Mol. Graphics 4 (1986) 121, take it: for A from CA to the next CA and B from CA to O, (A x B)
 * x A, turned where it opposes the one before. Without O, it is the binormal of the curve.
 */
#ifndef isthmus_MoleculeCartoon_h
#define isthmus_MoleculeCartoon_h

#include "Atoms/PolymerResidues.h"
#include "Atoms/SecondaryStructure.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Lengths in angstrom.
struct CartoonShape
{
  double RibbonWidth = 2.4;         ///< of helices and strands
  double RibbonThickness = 0.5;     ///< of helices and strands, and the diameter of coil
  double StickRadius = 0.2;         ///< of bonds
  double BallScale = 0.25;          ///< radius of balls over the van der Waals radius
  std::int64_t Sides = 12;          ///< of a section, from 3 to 64
  std::int64_t StepsPerResidue = 6; ///< along the chain, even
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSFILTERSATOMS_EXPORT void Check(const CartoonShape& shape);

/// Polygons with one normal for each point.
struct CartoonMesh
{
  std::vector<Point3> Points;
  std::vector<Point3> Normals;
  std::vector<std::int64_t> Offsets{ 0 }; ///< of each polygon's corners
  std::vector<std::int64_t> Corners;
  std::vector<std::int64_t> Items; ///< of each polygon: its residue in a cartoon, else its atom

  std::size_t NumberOfPolygons() const { return this->Items.size(); }
};

/**
 * Draws the chains: each piece of linked residues separately, so that gaps stay open; a closed
 * chain (the last residue linked to the first) as a closed curve; a single residue as a ball; bases
 * as sticks from the curve. Items are the numbers of residues.
 *
 * O(residues).
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSATOMS_EXPORT void DrawCartoon(const std::vector<NamedAtom>& atoms,
  const std::vector<PolymerResidue>& residues, const std::vector<SecondaryStructure>& structure,
  const CartoonShape& shape, CartoonMesh& mesh, const ProgressCallback& progress = {});

/// An atom as a ball, by its index in a list of atoms.
struct DrawnBall
{
  std::int64_t Atom;
  double Radius;
};

/**
 * Draws balls, and bonds as two half sticks, each with the Item of its atom. Ends of bonds are
 * indices of `atoms`.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSATOMS_EXPORT void DrawBallsAndSticks(const std::vector<NamedAtom>& atoms,
  const std::vector<DrawnBall>& balls, const std::vector<std::array<std::int64_t, 2>>& bonds,
  const CartoonShape& shape, CartoonMesh& mesh, const ProgressCallback& progress = {});

}

#endif
