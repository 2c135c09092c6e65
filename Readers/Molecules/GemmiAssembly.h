/**
 * @file GemmiAssembly.h
 * @brief The biological assembly of a structure whose file holds a part of it.
 */
#ifndef isthmus_GemmiAssembly_h
#define isthmus_GemmiAssembly_h

#include <stdexcept>
#include <string>

namespace gemmi
{
struct Structure;
}

namespace isthmus
{

/// The file is fine, but does not describe the assembly that was asked for.
class NoSuchAssembly : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * Replaces the models of `structure` by assembly `name` as the file describes it (REMARK 350 of
 * PDB, pdbx_struct_assembly_gen of mmCIF): each chain once for each of its operators, copies under
 * names that are free. Atoms on symmetry axes stay single. @throws NoSuchAssembly.
 */
void TakeAssembly(gemmi::Structure& structure, const std::string& name, const std::string& path);

}

#endif
