/**
 * @file CIFAssemblies.h
 * @brief Biological assemblies that mmCIF files describe, with products of groups of operators.
 */
#ifndef isthmus_CIFAssemblies_h
#define isthmus_CIFAssemblies_h

#include <string>
#include <vector>

#include <gemmi/cifdoc.hpp>
#include <gemmi/model.hpp>

namespace isthmus
{

/**
 * The operators of an oper_expression, each as the names of the operators whose product it is: "1",
 * "1,3", "(1-60)", "(1,2)(3,4)" (1 3, 1 4, 2 3, 2 4), "(X0)(1-60)". As the dictionary of mmCIF
 * says, a product is applied from right to left: the last name first. A name with a hyphen that is
 * among `known` is a name, otherwise a range of whole numbers.
 * @throws std::invalid_argument for anything else, and for more than 100,000 products.
 */
std::vector<std::vector<std::string>> ParseOperatorExpression(
  const std::string& expression, const std::vector<std::string>& known);

/// Names of the assemblies that pdbx_struct_assembly_gen generates, each once; pdbx_struct_assembly
/// may be missing.
std::vector<std::string> CIFAssemblyNames(gemmi::cif::Block& block);

/// One of them. gemmi (0.5) ignores all but the first group of a product, and assemblies whose row
/// of pdbx_struct_assembly is missing or incomplete. @throws std::invalid_argument.
gemmi::Assembly ReadCIFAssembly(gemmi::cif::Block& block, const std::string& name);

}

#endif
