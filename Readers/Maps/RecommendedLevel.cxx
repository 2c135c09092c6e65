#include "Maps/RecommendedLevel.h"

#include "Core/NumberText.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <regex>
#include <string_view>
#include <system_error>

namespace isthmus
{
namespace
{

constexpr std::uintmax_t LargestHeader = std::uintmax_t{ 16 } << 20; // they have about 20 KiB

std::string WithoutComments(const std::string& xml)
{
  std::string text;
  std::size_t from = 0;
  for (std::size_t open; (open = xml.find("<!--", from)) != std::string::npos;)
  {
    text.append(xml, from, open - from);
    const std::size_t close = xml.find("-->", open + 4);
    if (close == std::string::npos)
    {
      return text;
    }
    from = close + 3;
  }
  return text.append(xml, from, std::string::npos);
}

struct Element
{
  std::string Attributes;
  std::string Content;
  std::size_t End = std::string::npos; ///< after it in the text
};

/// Where "</name" begins, from `from` on: not that of a longer name.
std::size_t FindClosingTag(const std::string& text, const std::string& close, std::size_t from)
{
  std::size_t at = text.find(close, from);
  while (at != std::string::npos)
  {
    const std::size_t behind = at + close.size();
    if (behind < text.size() &&
      (text[behind] == '>' || std::isspace(static_cast<unsigned char>(text[behind]))))
    {
      return at;
    }
    at = text.find(close, behind);
  }
  return at;
}

/// The first element `name` of `text` from `from` on; its End is npos where there is none.
Element FindElement(const std::string& text, const std::string& name, std::size_t from)
{
  Element element;
  const std::string open = '<' + name, close = "</" + name;
  std::size_t at = text.find(open, from);
  while (at != std::string::npos)
  {
    const std::size_t behind = at + open.size();
    const std::size_t bracket = text.find('>', behind);
    if (bracket == std::string::npos)
    {
      return element;
    }
    if (text[bracket - 1] == '/' && bracket == text.find_first_of("<>", behind))
    {
      at = text.find(open, bracket); // <contour_list/> has no content
      continue;
    }
    // Not <contour_list> for <contour>.
    if (bracket == behind || std::isspace(static_cast<unsigned char>(text[behind])))
    {
      const std::size_t end = FindClosingTag(text, close, bracket);
      if (end != std::string::npos)
      {
        element.Attributes = text.substr(behind, bracket - behind);
        element.Content = text.substr(bracket + 1, end - bracket - 1);
        element.End = end + close.size();
      }
      return element;
    }
    at = text.find(open, behind);
  }
  return element;
}

std::optional<double> Number(const std::string& text)
{
  std::string_view rest = text;
  double value = 0.0;
  if (!ExtractNumber(rest, value) || !ExtractWord(rest).empty() || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Whether the header names the file `name` for the map of `content`.
bool NamesFile(const std::string& content, const EntryMap& map)
{
  const EntryMap named = ParseEntryMap(FindElement(content, "file", 0).Content);
  return named.Entry == map.Entry && named.Element == map.Element && named.Number == map.Number;
}

/// The level in the description of one map.
std::optional<double> ContourLevel(const std::string& text)
{
  std::optional<double> level;
  for (Element contour = FindElement(text, "contour", 0); contour.End != std::string::npos;
       contour = FindElement(text, "contour", contour.End))
  {
    const std::optional<double> here = Number(FindElement(contour.Content, "level", 0).Content);
    const bool primary = contour.Attributes.find("primary=\"true\"") != std::string::npos ||
      contour.Attributes.find("primary='true'") != std::string::npos;
    if (here && (!level || primary))
    {
      level = here;
    }
    if (here && primary)
    {
      break;
    }
  }
  return level ? level : Number(FindElement(text, "contourLevel", 0).Content);
}

std::optional<double> ReadLevelFromFile(const std::filesystem::path& path, const EntryMap& map)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) ||
    std::filesystem::file_size(path, error) > LargestHeader)
  {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  return HeaderLevel(
    std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()), map);
}

}

EntryMap ParseEntryMap(const std::string& name)
{
  static const std::regex form("emd[-_](\\d+)(?:_(half_map|additional)_(\\d{1,3}))?"
                               "(?:\\.(?:map|mrc|ccp4))?(?:\\.(?:gz|bz2))?");
  std::smatch parts;
  const std::string lower = LowerCase(name);
  if (!std::regex_match(lower, parts, form))
  {
    return {};
  }
  const std::string kind = parts[2];
  return { parts[1],
    kind == "additional" ? "additional_map"
      : kind.empty()     ? "map"
                         : kind,
    kind.empty() ? 0 : static_cast<int>(Number(parts[3]).value_or(0.0)) };
}

std::optional<double> HeaderLevel(const std::string& xml, const EntryMap& map)
{
  const std::string text = WithoutComments(xml);
  // Half maps and additional maps are described in the order of their numbers; a file name in the
  // description, which old headers lack, is the better evidence.
  std::string content;
  int number = 0;
  for (Element found = FindElement(text, map.Element, 0); found.End != std::string::npos;
       found = FindElement(text, map.Element, found.End))
  {
    ++number;
    const bool hasFile = FindElement(found.Content, "file", 0).End != std::string::npos;
    if (map.Number == 0 || (hasFile ? NamesFile(found.Content, map) : number == map.Number))
    {
      content = found.Content;
      break;
    }
  }
  return ContourLevel(content);
}

std::optional<double> RecommendedLevel(const std::string& fileName)
{
  const std::filesystem::path path(fileName);
  const EntryMap map = ParseEntryMap(path.filename().string());
  if (map.Entry.empty())
  {
    return std::nullopt;
  }
  const std::filesystem::path beside = path.parent_path();
  for (const auto& folder : { beside, beside / ".." / "header" })
  {
    for (const char* start : { "emd-", "emd_", "EMD-", "EMD_" })
    {
      if (const auto level = ReadLevelFromFile(folder / (start + map.Entry + ".xml"), map))
      {
        return level;
      }
    }
  }
  return std::nullopt;
}

}
