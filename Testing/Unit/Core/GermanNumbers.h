/**
 * @file GermanNumbers.h
 * @brief The locale de_DE.UTF-8 for C and C++, as a host may set it.
 */
#ifndef isthmus_GermanNumbers_h
#define isthmus_GermanNumbers_h

#include "SharedData.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <locale>
#include <optional>
#include <string>

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#include <sanitizer/lsan_interface.h>
#define ISTHMUS_IGNORE_LEAKS __lsan::ScopedDisabler ignoreLeaks
#endif
#endif
#ifndef ISTHMUS_IGNORE_LEAKS
#define ISTHMUS_IGNORE_LEAKS
#endif

namespace isthmus::testing
{

/// Numbers are written "1.234,5" by the functions of C and the streams of C++ for the lifetime of
/// the object.
class GermanNumbers
{
public:
  GermanNumbers()
  {
    if (HasLocale())
    {
      ISTHMUS_IGNORE_LEAKS; // glibc's newlocale() does not free the parts of LOCPATH
      this->Before = std::locale::global(std::locale(Name)); // calls setlocale, too
    }
  }
  ~GermanNumbers()
  {
    if (this->Before)
    {
      std::locale::global(*this->Before);
      std::setlocale(LC_ALL, this->Before->name().c_str());
    }
  }
  GermanNumbers(const GermanNumbers&) = delete;
  GermanNumbers& operator=(const GermanNumbers&) = delete;

  bool AreSet() const
  {
    return this->Before && std::localeconv()->decimal_point == std::string(",");
  }

private:
  static constexpr const char* Name = "de_DE.UTF-8";

  /**
   * Compiles the locale of the system's sources (Debian's package locales), or one with a German
   * LC_NUMERIC only where there are none, into a temporary folder. Once: glibc remembers names of
   * locales that it has not found.
   */
  static bool HasLocale()
  {
    static const TemporaryFile source(
      "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n",
      "numbers");
    static const bool isThere = []
    {
      const std::string folder = std::filesystem::path(source.Path()).parent_path().string();
      const std::string target = folder + "/" + Name;
      const auto compile = [&](const std::string& input)
      {
        // The exit status is 1 for warnings as well.
        return std::system(
                 ("localedef --no-archive -c " + input + " '" + target + "' >/dev/null 2>&1")
                   .c_str()) >= 0 &&
          std::filesystem::exists(target + "/LC_NUMERIC");
      };
      if (!compile("-i de_DE -f UTF-8") && !compile("-i '" + std::string(source.Path()) + "'"))
      {
        return false;
      }
      ::setenv("LOCPATH", folder.c_str(), 1);
      const bool found = std::setlocale(LC_ALL, Name) != nullptr;
      std::setlocale(LC_ALL, "C");
      return found;
    }();
    return isThere;
  }

  std::optional<std::locale> Before;
};

}

/// First line of a test that sets the locale.
#define ISTHMUS_NEEDS_GERMAN(numbers)                                                              \
  if (!(numbers).AreSet())                                                                         \
  {                                                                                                \
    ASSERT_FALSE(isthmus::testing::SharedDataRequired()) << "localedef makes no German locale.";   \
    GTEST_SKIP() << "localedef makes no German locale.";                                           \
  }                                                                                                \
  static_assert(true, "a semicolon follows")

#endif
