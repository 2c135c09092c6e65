#include "Cases.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace isthmus::digests
{

void RequireProgram(const std::string& program)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    if (std::filesystem::exists(std::filesystem::path(folder) / program))
    {
      return;
    }
  }
  throw MissingProgram(program + " is not installed");
}

}
