/**
 * @file SharedData.h
 * @brief The location of the real maps and proteins, which are not part of the repository.
 */
#ifndef isthmus_SharedData_h
#define isthmus_SharedData_h

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isthmus::testing
{

/// Folder of the shared data: ISTHMUS_DATA_DIR, else the folder configured with CMake.
inline std::filesystem::path SharedDataFolder()
{
  const char* chosen = std::getenv("ISTHMUS_DATA_DIR");
  return chosen && *chosen ? chosen : ISTHMUS_DEFAULT_DATA_DIR;
}

/// True where a missing file is a failure (CI), false where the test may be skipped.
inline bool SharedDataRequired()
{
  const char* required = std::getenv("ISTHMUS_REQUIRE_DATA");
  return required && std::string(required) == "1";
}

}

/// First line of a test that reads `relative` (for example "maps/emd_5043.map") of the shared data.
#define ISTHMUS_NEEDS_SHARED_DATA(relative)                                                        \
  if (!std::filesystem::exists(isthmus::testing::SharedDataFolder() / (relative)))                 \
  {                                                                                                \
    if (isthmus::testing::SharedDataRequired())                                                    \
    {                                                                                              \
      FAIL() << "ISTHMUS_REQUIRE_DATA=1 but there is no "                                          \
             << isthmus::testing::SharedDataFolder() / (relative);                                 \
    }                                                                                              \
    GTEST_SKIP() << "needs " << (relative) << " of the shared data: set ISTHMUS_DATA_DIR";         \
  }                                                                                                \
  static_assert(true, "a semicolon follows")

#endif
