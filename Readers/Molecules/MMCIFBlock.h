/**
 * @file MMCIFBlock.h
 * @brief What of an mmCIF file is handed to gemmi, and how.
 */
#ifndef isthmus_MMCIFBlock_h
#define isthmus_MMCIFBlock_h

#include <gemmi/cifdoc.hpp>

namespace isthmus
{

/**
 * Leaves of a block what atoms, bonds and assemblies come from: gemmi reads all that it knows, and
 * a fault in what is not wanted would cost the atoms. Unknown occupancies and B factors become
 * PDBStream::BlankText, by which they are found again. O(values).
 *
 * @throws std::invalid_argument for whole numbers of more than nine digits, and of more than five
 * in the ranges of an assembly's operations: gemmi (0.5.7) adds digits up, and counts from the one
 * to the other, without a look at their size.
 */
void PrepareForGemmi(gemmi::cif::Block& block);

}

#endif
