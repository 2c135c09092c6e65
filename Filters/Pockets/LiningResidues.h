/**
 * @file LiningResidues.h
 * @brief The residues that line a pocket or a pore, as rows of a table and as atoms to display.
 */
#ifndef isthmus_LiningResidues_h
#define isthmus_LiningResidues_h

#include "Atoms/MoleculeAtoms.h"
#include "Pockets/Pocket.h"

#include <vtkNew.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkIntArray;
class vtkPointSet;
class vtkPolyData;
class vtkStringArray;
class vtkTable;

namespace isthmus
{

/// Residue, number and chain, as "ASP 52 A".
std::string MakeResidueLabel(const NamedAtom& atom);

/// A residue with those of its atoms that line a feature. Without residue names, each atom counts
/// as a residue.
struct LiningResidue
{
  std::vector<vtkIdType> Points; ///< of the input
  double Area = 0.0;             ///< area of their surface that faces the feature
};

/// The residues in the order of the file.
std::vector<LiningResidue> FindLiningResidues(
  const std::vector<LiningAtom>& lining, const MoleculeAtoms& atoms);

/// Their names, those with the largest area first: "TRP 62 A; ASP 52 A"; empty if the atoms have no
/// names.
std::string JoinNames(std::vector<LiningResidue> residues, const MoleculeAtoms& atoms);

/// A warning where a fifth or more of the residues at `place` ("the first site") of a predicted
/// model have a low confidence, pLDDT below 70; empty: fewer, or no confidence.
std::string DescribeConfidence(
  const std::vector<LiningResidue>& residues, const MoleculeAtoms& atoms, const std::string& place);

/// Columns: the feature's number, Chain, ResidueId, InsertionCode, ResidueName, Atoms (names
/// between blanks), AtomIds (points of the input), NumberOfAtoms, Area.
class LiningTable
{
public:
  explicit LiningTable(std::string featureName)
    : FeatureName(std::move(featureName))
  {
  }
  void Add(int feature, const std::vector<LiningResidue>& residues, const MoleculeAtoms& atoms);
  void Fill(vtkTable* output) const;

private:
  struct Row
  {
    int Feature;
    NamedAtom First;
    std::string Names, Ids;
    std::size_t Count;
    double Area;
  };
  std::string FeatureName;
  std::vector<Row> Rows;
};

/// Whole residues as points with the input's arrays, and the input's bonds among them. The array
/// `ResidueLabel` has the residue's name at one of its atoms ("ASP 52 A") and is empty at the
/// others.
class ResidueAtoms
{
public:
  ResidueAtoms(const MoleculeAtoms& atoms, vtkPointSet* input, const char* featureName);
  ~ResidueAtoms();
  void Add(int feature, const std::vector<LiningResidue>& residues);
  void Fill(vtkPolyData* output);

private:
  using Key = std::array<std::string, 4>;
  static Key MakeKey(const NamedAtom& atom);

  const MoleculeAtoms& Atoms;
  vtkPointSet* Input;
  std::map<Key, std::vector<vtkIdType>> OfResidue;
  std::vector<vtkIdType> Points;
  vtkNew<vtkIntArray> Feature;
  vtkNew<vtkStringArray> Label;
  std::vector<std::size_t> FirstOfFeature;
};

}

#endif
