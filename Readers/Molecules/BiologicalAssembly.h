/**
 * @file BiologicalAssembly.h
 * @brief Copies of chains as a file describes a biological assembly.
 */
#ifndef isthmus_BiologicalAssembly_h
#define isthmus_BiologicalAssembly_h

#include "Molecules/Macromolecule.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gemmi/model.hpp>

namespace isthmus
{

/// The file is valid, but does not describe the requested assembly.
class UnknownAssembly : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The assembly with a name. @throws UnknownAssembly if it is not one of `known`.
const gemmi::Assembly& FindAssembly(
  const std::string& name, const std::vector<gemmi::Assembly>& known, const std::string& path);

/**
 * Atoms and bonds of `molecule`, each chain once for each of its operators. Copies have names that
 * are free, and the bonds of their originals. Atoms on symmetry axes, whose copies are nearer than
 * 0.2 angstrom to each other, stay single, at the mean place. `subchain(atom)`: its label_asym_id,
 * by which mmCIF describes assemblies. O(n log n) for n atoms of the result.
 * @throws UnknownAssembly where the copies are too far apart.
 */
Macromolecule BuildAssembly(const Macromolecule& molecule, const gemmi::Assembly& assembly,
  const std::string& path, const std::function<std::string(std::size_t)>& subchain = {});

}

#endif
