#include "Maps/RecommendedLevel.h"

#include "Core/NumberText.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
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
  std::size_t End = std::string::npos; ///< behind it in the text
};

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
    // Not <contour_list> for <contour>.
    if (bracket == behind || std::isspace(static_cast<unsigned char>(text[behind])))
    {
      const std::size_t end = text.find(close, bracket);
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
  if (!TakeNumber(rest, value) || !TakeWord(rest).empty() || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

/// NNNN of a file name that begins with emd_NNNN, or nothing.
std::string EntryOf(const std::string& name)
{
  std::string start = name.substr(0, 4);
  std::transform(start.begin(), start.end(), start.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (start != "emd_" && start != "emd-")
  {
    return {};
  }
  const std::size_t end = name.find_first_not_of("0123456789", 4);
  return name.substr(4, end == std::string::npos ? end : end - 4);
}

std::optional<double> LevelOfFile(const std::filesystem::path& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) ||
    std::filesystem::file_size(path, error) > LargestHeader)
  {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  return LevelOfHeader(
    std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
}

}

std::optional<double> LevelOfHeader(const std::string& xml)
{
  const std::string text = WithoutComments(xml);
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

std::optional<double> RecommendedLevel(const std::string& fileName)
{
  const std::filesystem::path path(fileName);
  const std::string entry = EntryOf(path.filename().string());
  if (entry.empty())
  {
    return std::nullopt;
  }
  const std::filesystem::path beside = path.parent_path();
  for (const auto& folder : { beside, beside / ".." / "header" })
  {
    for (const char* start : { "emd-", "emd_", "EMD-", "EMD_" })
    {
      if (const auto level = LevelOfFile(folder / (start + entry + ".xml")))
      {
        return level;
      }
    }
  }
  return std::nullopt;
}

}
