#include "Molecules/PDBStream.h"

#include <algorithm>
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
      [](char a, char b) { return a == b || (a == (b & ~0x20) && b >= 'a'); });
}

/// Blanks, a minus or none, digits, a point and digits: what nearly all coordinates look like.
bool IsPlainNumber(const char* at, const char* end)
{
  const auto digits = [&at, end]()
  {
    const char* const first = at;
    while (at < end && *at >= '0' && *at <= '9')
    {
      ++at;
    }
    return at > first;
  };
  while (at < end && *at == ' ')
  {
    ++at;
  }
  at += at < end && *at == '-' ? 1 : 0;
  if (!digits() || at == end || *at != '.')
  {
    return false;
  }
  ++at;
  return digits() && at == end;
}

/// An atom's line with all its columns, in which nothing is to be mended or refused.
bool IsPlainAtom(std::string_view line)
{
  constexpr std::size_t width = 80;
  const char* const c = line.data();
  return line.size() >= width && IsPlainNumber(c + 30, c + 38) && IsPlainNumber(c + 38, c + 46) &&
    IsPlainNumber(c + 46, c + 54) && c[59] > ' ' && c[65] > ' ' && c[78] == ' ' && c[79] == ' ';
}

}

bool PDBStream::IsAtom(std::string_view line)
{
  return IsRecord(line, "ATOM") || IsRecord(line, "HETA");
}

PDBStream::PDBStream(
  std::string_view text, const std::string& path, Extent extent, const ProgressCallback& progress)
  : Lines(text, path, progress)
  , Kind(extent)
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
  next = next.substr(
    0, this->Kind == Extent::WholeWithout73To80 ? 72 : static_cast<std::size_t>(size - 2));
  // gemmi's strings end at a zero byte
  next = next.substr(0, next.find('\0'));
  const bool isAtom = IsAtom(next);
  if (isAtom && IsPlainAtom(next))
  {
    char* const end = std::copy(next.begin(), next.end(), to);
    end[0] = '\n';
    end[1] = '\0';
    return to;
  }
  this->CheckPiece(next);
  this->Line = next;
  if (isAtom)
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
  else if (IsRecord(this->Line, "DBRE"))
  {
    // Of no use here, and gemmi adds up ten digits, beyond what an int holds.
    this->Line.clear();
  }
  this->Line += '\n';
  std::memcpy(to, this->Line.c_str(), this->Line.size() + 1);
  return to;
}

void PDBStream::CheckPiece(std::string_view line) const
{
  const bool isLast = this->Kind == Extent::LastPiece;
  if (!isLast && this->Kind != Extent::Piece)
  {
    return;
  }
  for (const char* record : { "MODE", "ENDM", "SSBO", "LINK", "CISP" })
  {
    if (IsRecord(line, record))
    {
      this->Lines.Fail(std::string(record) + ": the file is to be read whole.");
    }
  }
  if (!isLast && IsRecord(line, "END"))
  {
    this->Lines.Fail("END before the last piece.");
  }
}

void PDBStream::CheckAtom()
{
  for (const std::size_t from : { 30, 38, 46 })
  {
    double x = 0.0;
    if (!IsNumber(Columns(this->Line, from, 8), x) || !std::isfinite(x))
    {
      throw NonstandardColumnsError(this->Lines.Here() + "columns " + std::to_string(from + 1) +
        " to " + std::to_string(from + 8) +
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
