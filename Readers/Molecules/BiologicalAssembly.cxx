#include "Molecules/BiologicalAssembly.h"

#include "Core/Geometry.h"
#include "Core/NumberText.h"

#include <algorithm>
#include <map>

#include <gemmi/assembly.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

/// Copies of the atoms of a molecule.
struct Copies
{
  std::vector<Atom> Atoms;
  std::vector<std::vector<std::size_t>> OfAtom; ///< of each atom, in the order of the operators
  std::vector<int> Operator;                    ///< of each copy
};

Copies CopyAtoms(const Macromolecule& molecule, const gemmi::Assembly& assembly,
  const std::function<std::string(std::size_t)>& subchain)
{
  Copies copies;
  copies.OfAtom.resize(molecule.Atoms.size());
  gemmi::ChainNameGenerator names(gemmi::HowToNameCopiedChain::Short);
  int number = 0;
  for (const gemmi::Assembly::Gen& generator : assembly.generators)
  {
    const bool isOfAll = !generator.chains.empty() && generator.chains[0] == "(all)";
    for (const gemmi::Assembly::Operator& copy : generator.operators)
    {
      std::map<std::string, std::string> nameOf; // of chains
      for (std::size_t i = 0; i < molecule.Atoms.size(); ++i)
      {
        const Atom& atom = molecule.Atoms[i];
        const bool isCopied = isOfAll || gemmi::in_vector(atom.Chain, generator.chains) ||
          (subchain && gemmi::in_vector(subchain(i), generator.subchains));
        if (!isCopied)
        {
          continue;
        }
        const auto [name, isNew] = nameOf.emplace(atom.Chain, "");
        if (isNew)
        {
          name->second = names.make_new_name(atom.Chain, 1);
        }
        const auto& x = atom.Position;
        const gemmi::Vec3 place = copy.transform.apply(gemmi::Vec3(x[0], x[1], x[2]));
        copies.OfAtom[i].push_back(copies.Atoms.size());
        copies.Operator.push_back(number);
        copies.Atoms.push_back(atom);
        copies.Atoms.back().Position = { place.x, place.y, place.z };
        copies.Atoms.back().Chain = name->second;
      }
      ++number;
    }
  }
  return copies;
}

/// @throws UnknownAssembly where the copies are farther apart than molecules are, by wrong
/// operators.
void RequireModestBox(
  const std::vector<Atom>& atoms, const gemmi::Assembly& assembly, const std::string& path)
{
  constexpr double largest = 1e10; // cubic angstrom
  gemmi::Box<gemmi::Position> box;
  for (const Atom& atom : atoms)
  {
    box.extend(gemmi::Position(atom.Position[0], atom.Position[1], atom.Position[2]));
  }
  const gemmi::Position size = box.get_size();
  if (std::max(size.x, 1.0) * std::max(size.y, 1.0) * std::max(size.z, 1.0) > largest)
  {
    throw UnknownAssembly(
      JoinText(path, ": assembly ", assembly.name, " is ", size.x, " x ", size.y, " x ", size.z,
        " angstrom large, which is too large to search. Correct its operators or leave Assembly "
        "empty."));
  }
}

/// Of each copy the one at whose place it is, itself if there is none. The others move to the mean.
std::vector<std::size_t> MergeCopies(Copies& copies)
{
  constexpr double same = 0.2;
  std::vector<std::size_t> single(copies.Atoms.size());
  for (const std::vector<std::size_t>& all : copies.OfAtom)
  {
    const auto x = [&copies](std::size_t i) { return copies.Atoms[i].Position[0]; };
    std::vector<std::size_t> sorted = all;
    std::sort(
      sorted.begin(), sorted.end(), [&x](std::size_t a, std::size_t b) { return x(a) < x(b); });
    std::map<std::size_t, std::vector<std::size_t>> near;
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      single[sorted[i]] = sorted[i];
      for (std::size_t j = i + 1; j < sorted.size() && x(sorted[j]) - x(sorted[i]) < same; ++j)
      {
        if (Distance(copies.Atoms[sorted[i]].Position, copies.Atoms[sorted[j]].Position) < same)
        {
          near[std::min(sorted[i], sorted[j])].push_back(std::max(sorted[i], sorted[j]));
        }
      }
    }
    for (const auto& [first, others] : near)
    {
      if (single[first] != first)
      {
        continue; // merged already
      }
      Point3 sum = copies.Atoms[first].Position;
      for (const std::size_t other : others)
      {
        single[other] = first;
        sum = sum + copies.Atoms[other].Position;
      }
      copies.Atoms[first].Position = 1.0 / static_cast<double>(others.size() + 1) * sum;
    }
  }
  return single;
}

}

const gemmi::Assembly& FindAssembly(
  const std::string& name, const std::vector<gemmi::Assembly>& known, const std::string& path)
{
  std::string list;
  for (const gemmi::Assembly& assembly : known)
  {
    if (assembly.name == name)
    {
      return assembly;
    }
    list += (list.empty() ? "" : ", ") + assembly.name;
  }
  throw UnknownAssembly(path + ": there is no assembly " + name + "; the file describes " +
    (list.empty() ? "none." : list + "."));
}

Macromolecule BuildAssembly(const Macromolecule& molecule, const gemmi::Assembly& assembly,
  const std::string& path, const std::function<std::string(std::size_t)>& subchain)
{
  Copies copies = CopyAtoms(molecule, assembly, subchain);
  RequireModestBox(copies.Atoms, assembly, path);
  const std::vector<std::size_t> single = MergeCopies(copies);
  Macromolecule result;
  std::vector<std::size_t> place(copies.Atoms.size());
  for (std::size_t i = 0; i < copies.Atoms.size(); ++i)
  {
    place[i] = single[i] == i ? result.Atoms.size() : place[single[i]];
    if (single[i] == i)
    {
      result.Atoms.push_back(std::move(copies.Atoms[i]));
    }
  }
  for (const Bond& bond : molecule.Bonds)
  {
    const auto& second = copies.OfAtom[static_cast<std::size_t>(bond.Second)];
    auto other = second.begin();
    for (const std::size_t one : copies.OfAtom[static_cast<std::size_t>(bond.First)])
    {
      while (other != second.end() && copies.Operator[*other] < copies.Operator[one])
      {
        ++other;
      }
      if (other != second.end() && copies.Operator[*other] == copies.Operator[one] &&
        place[one] != place[*other])
      {
        const auto a = static_cast<std::int64_t>(place[one]);
        const auto b = static_cast<std::int64_t>(place[*other]);
        result.Bonds.push_back({ std::min(a, b), std::max(a, b), true });
      }
    }
  }
  return result;
}

}
