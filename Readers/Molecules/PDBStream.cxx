#include "PDBStream.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

namespace isthmus
{
namespace
{

/// Whether a line begins with `name` in capitals or not, as gemmi compares.
bool IsRecord(std::string_view line, std::string_view name)
{
  return line.size() >= name.size() &&
    std::equal(name.begin(), name.end(), line.begin(),
      [](char a, unsigned char b) { return a == std::toupper(b); });
}

}

PDBStream::PDBStream(
  std::string_view text, const std::string& path, bool cutAt72, const ProgressCallback& progress)
  : Lines(text, path, progress)
  , CutAt72(cutAt72)
{
}

char* PDBStream::gets(char* to, int size)
{
  constexpr std::size_t width = 80;
  std::string_view next;
  if (!this->Lines.Next(next))
  {
    return nullptr;
  }
  this->Line = next.substr(0, this->CutAt72 ? 72 : static_cast<std::size_t>(size - 2));
  // gemmi's strings end at a zero byte
  this->Line.erase(std::min(this->Line.find('\0'), this->Line.size()));
  if (IsRecord(this->Line, "ATOM") || IsRecord(this->Line, "HETA"))
  {
    this->CheckAtom();
  }
  else if (IsRecord(this->Line, "CONECT"))
  {
    this->ReadBonds();
  }
  else if (IsRecord(this->Line, "SSBO") || IsRecord(this->Line, "LINK"))
  {
    // gemmi 0.5.7 keeps these lines and reads past the end of short ones.
    this->Line.resize(std::max(this->Line.size(), width), ' ');
  }
  this->Line += '\n';
  std::memcpy(to, this->Line.c_str(), this->Line.size() + 1);
  return to;
}

void PDBStream::CheckAtom()
{
  for (const std::size_t from : { 30, 38, 46 })
  {
    double x = 0.0;
    if (!IsNumber(Columns(this->Line, from, 8), x) || !std::isfinite(x))
    {
      throw OtherColumns(this->Lines.Here() + "columns " + std::to_string(from + 1) + " to " +
        std::to_string(from + 8) +
        " hold no coordinate (a finite number). Is it a PDB file, and whole?");
    }
  }
  const bool noElement =
    Columns(this->Line, 76, 2).find_first_not_of("0123456789") == std::string_view::npos;
  const std::string_view charge = Columns(this->Line, 78, 2);
  if (noElement && !charge.empty() && charge.find_first_of("+-") == std::string_view::npos)
  {
    throw std::runtime_error(this->Lines.Here() + "columns 79-80 hold no charge.");
  }
  for (const std::size_t from : { 54, 60 })
  {
    if (Columns(this->Line, from, 6).empty())
    {
      this->Line.resize(std::max<std::size_t>(this->Line.size(), from + 6), ' ');
      this->Line.replace(from, 6, std::string("  ") + BlankText);
    }
  }
}

void PDBStream::ReadBonds()
{
  int from = 0;
  int to = 0;
  if (!IsNumber(Columns(this->Line, 6, 5), from))
  {
    return;
  }
  for (std::size_t at = 11; at < 31; at += 5)
  {
    if (IsNumber(Columns(this->Line, at, 5), to))
    {
      this->Bonds.push_back({ from, to });
    }
  }
}

}
