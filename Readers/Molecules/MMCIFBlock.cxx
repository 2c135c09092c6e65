#include "Molecules/MMCIFBlock.h"

#include "Molecules/PDBStream.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <gemmi/atox.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

/// Categories of an mmCIF file that atoms, bonds and assemblies come from.
const std::array<std::string, 12> CategoriesRead{ "_atom_site.", "_atom_site_anisotrop.",
  "_atom_sites.", "_cell.", "_symmetry.", "_entity.", "_entity_poly.", "_struct_asym.",
  "_struct_conn.", "_pdbx_struct_assembly.", "_pdbx_struct_assembly_gen.",
  "_pdbx_struct_oper_list." };

void DropOthers(gemmi::cif::Block& block)
{
  const auto isOther = [](const gemmi::cif::Item& item)
  {
    using gemmi::cif::ItemType;
    const bool isLoop = item.type == ItemType::Loop && !item.loop.tags.empty();
    if (!isLoop && item.type != ItemType::Pair)
    {
      return true;
    }
    const std::string tag = gemmi::to_lower(isLoop ? item.loop.tags.front() : item.pair[0]);
    return std::none_of(CategoriesRead.begin(), CategoriesRead.end(),
      [&tag](const std::string& category) { return gemmi::starts_with(tag, category); });
  };
  block.items.erase(
    std::remove_if(block.items.begin(), block.items.end(), isOther), block.items.end());
}

void DemandShortNumbers(gemmi::cif::Block& block, const std::string& tag, std::size_t most)
{
  for (const std::string& value : block.find_values(tag))
  {
    std::size_t digits = 0;
    for (const char c : value)
    {
      digits = gemmi::is_digit(c) ? digits + 1 : 0;
      if (digits > most)
      {
        throw std::invalid_argument(
          tag + " has a number of more than " + std::to_string(most) + " digits");
      }
    }
  }
}

/// Gives unknown values of a column a number by which they are found again.
void MarkBlanks(gemmi::cif::Block& block, const char* tag)
{
  for (std::string& value : block.find_values(tag))
  {
    if (gemmi::cif::is_null(value))
    {
      value = PDBStream::BlankText;
    }
  }
}

}

void PrepareForGemmi(gemmi::cif::Block& block)
{
  DropOthers(block);
  for (const char* tag : { "_atom_site.id", "_atom_site.auth_seq_id", "_atom_site.label_seq_id",
         "_atom_site.pdbx_formal_charge", "_struct_conn.ptnr1_auth_seq_id",
         "_struct_conn.ptnr2_auth_seq_id", "_struct_conn.ptnr1_label_seq_id",
         "_struct_conn.ptnr2_label_seq_id", "_pdbx_struct_assembly.oligomeric_count" })
  {
    DemandShortNumbers(block, tag, 9);
  }
  DemandShortNumbers(block, "_pdbx_struct_assembly_gen.oper_expression", 5);
  MarkBlanks(block, "_atom_site.occupancy");
  MarkBlanks(block, "_atom_site.B_iso_or_equiv");
}

}
