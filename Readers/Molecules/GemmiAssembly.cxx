#include "Molecules/GemmiAssembly.h"

#include <gemmi/assembly.hpp>

namespace isthmus
{

void TakeAssembly(gemmi::Structure& structure, const std::string& name, const std::string& path)
{
  std::string known;
  for (const gemmi::Assembly& assembly : structure.assemblies)
  {
    known += (known.empty() ? "" : ", ") + assembly.name;
  }
  if (!structure.find_assembly(name))
  {
    throw NoSuchAssembly(path + ": there is no assembly " + name + "; the file describes " +
      (known.empty() ? "none." : known + "."));
  }
  gemmi::transform_to_assembly(structure, name, gemmi::HowToNameCopiedChain::Short, nullptr);
}

}
