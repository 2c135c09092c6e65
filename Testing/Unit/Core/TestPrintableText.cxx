// Which bytes are text: ASCII, UTF-8 to the ends of its ranges, and bytes that resemble it.

#include "Core/PrintableText.h"

#include <gtest/gtest.h>

#include <string>

using namespace isthmus;

TEST(PrintableText, ValidTextIsUnchanged)
{
  for (const char* text : { "", "Level 1.5\nand more ~", "\xc2\x80\xdf\xbf", "\xe0\xa0\x80",
         "\xed\x9f\xbf\xee\x80\x80\xef\xbf\xbf", "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf" })
  {
    EXPECT_EQ(Printable(text), text);
  }
}

TEST(PrintableText, InvalidBytesBecomeQuestionMarks)
{
  EXPECT_EQ(Printable("a\tb\rc\x7f"), "a?b?c?");
  EXPECT_EQ(Printable(std::string("a\0b", 3)), "a?b");
  EXPECT_EQ(Printable("\x1f \x1e"), "? ?");
  EXPECT_EQ(Printable("\x80x\xbf"), "?x?");
  EXPECT_EQ(Printable("\xc0\x80\xc1\xbf"), "????");                     // two bytes for one
  EXPECT_EQ(Printable("\xe0\x9f\xbf"), "???");                          // three for two
  EXPECT_EQ(Printable("\xed\xa0\x80"), "???");                          // half of a pair
  EXPECT_EQ(Printable("\xf0\x8f\xbf\xbf"), "????");                     // four for three
  EXPECT_EQ(Printable("\xf4\x90\x80\x80\xf5\x80\x80\x80"), "????????"); // beyond U+10FFFF
  EXPECT_EQ(Printable("\xc3\xa9\xc3"), "\xc3\xa9?");                    // cut off
  EXPECT_EQ(Printable("\xe2\x82z"), "??z");
  EXPECT_EQ(Printable("\xf0\x9f\x98"), "???");
}
