#include "io/encoding/number_text.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "io/encoding/text_lines.h"

namespace cocoon {
namespace {

double parsed(const std::string& text) {
  const char* at = text.data();
  double value = -12345;
  EXPECT_TRUE(parse_double(at, text.data() + text.size(), value)) << text;
  EXPECT_EQ(at, text.data() + text.size()) << text;
  return value;
}

TEST(NumberText, ReadsTheNearestDouble) {
  EXPECT_EQ(parsed("0.1"), 0.1);
  EXPECT_EQ(parsed("+.5"), 0.5);
  EXPECT_EQ(parsed("-1."), -1.0);
  EXPECT_EQ(parsed("1E+2"), 100.0);
  EXPECT_TRUE(std::signbit(parsed("-0")));
  EXPECT_EQ(parsed("9007199254740993"), 9007199254740992.0);  // a tie: to even
  EXPECT_EQ(parsed("2.4703282292062328e-324"), 5e-324);
  EXPECT_EQ(parsed("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

// Behind a number without a point it is a comment.
TEST(NumberText, SpecialNamesFollowAPoint) {
  EXPECT_TRUE(std::isinf(parsed("1.#INF")));
  const std::string text = "1#INF";
  const char* at = text.data();
  double value = 0;
  EXPECT_TRUE(parse_double(at, text.data() + text.size(), value));
  EXPECT_EQ(value, 1);
  EXPECT_EQ(at, text.data() + 1);
  EXPECT_EQ(without_comment("2 1#INF"), "2 1");
}

TEST(NumberText, TooLargeIsInfiniteAndTooSmallIsZero) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parsed("1e400"), infinity);
  EXPECT_EQ(parsed("-1e309"), -infinity);
  EXPECT_EQ(parsed("1" + std::string(400, '0')), infinity);
  EXPECT_EQ(parsed("0.01e400"), infinity);
  EXPECT_EQ(parsed("1e99999999999999999999"), infinity);
  EXPECT_EQ(parsed("1e-400"), 0.0);
  EXPECT_EQ(parsed("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parsed("100e-400"), 0.0);
  EXPECT_EQ(parsed("1e-99999999999999999999"), 0.0);
  EXPECT_TRUE(std::signbit(parsed("-1e-400")));
  EXPECT_EQ(parsed("0e999"), 0.0);
}

TEST(NumberText, ExponentsAtTheLimitOfIntegers) {
  EXPECT_EQ(parsed("1e9223372036854775807"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parsed("1e-9223372036854775807"), 0.0);
  EXPECT_EQ(parsed("0.001e9223372036854775807"), std::numeric_limits<double>::infinity());
}

// Else the rest would be taken for a comment, and the number for 1.
TEST(NumberText, KnowsHowOldLibrariesPrintWhatIsNotFinite) {
  for (const char* text : {"1.#QNAN", "-1.#IND", "1.#SNAN", "-1.#IND00", "1.#QNAN0"}) {
    EXPECT_TRUE(std::isnan(parsed(text))) << text;
  }
  EXPECT_EQ(parsed("1.#INF"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parsed("-1.#INF00"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(without_comment("1 2 1.#INF 4 # 5 # 6"), "1 2 1.#INF 4 ");
  EXPECT_EQ(without_comment("1 2 3.# about"), "1 2 3.");
  EXPECT_EQ(without_comment("#"), "");
  EXPECT_EQ(without_comment("none"), "none");
}

TEST(NumberText, RefusesWhatIsNoDecimalNumber) {
  for (const std::string text : {"", "+", "-", ".", "e5", "+-1", "x", "--1", "++1"}) {
    const char* at = text.data();
    double value = 7;
    EXPECT_FALSE(parse_double(at, text.data() + text.size(), value)) << text;
    EXPECT_EQ(at, text.data()) << text;
  }
  // A number with something behind it is no field.
  for (const char* text : {"0x10", "1.0D5", "1,5", "12abc"}) {
    double value = 0;
    EXPECT_FALSE(Fields(text).number(value)) << text;
  }
}

TEST(NumberText, WritesTheShortestTextThatReadsBack) {
  const auto text_of_number = [](double value) {
    std::string text;
    append_number(text, value);
    return text;
  };
  EXPECT_EQ(text_of_number(0.1), "0.1");
  EXPECT_EQ(text_of_number(-0.0), "-0");
  EXPECT_EQ(text_of_number(5e-324), "5e-324");
  EXPECT_EQ(text_of_number(4500000.000000123), "4500000.000000123");
  std::string single;
  append_number(single, 0.1F);
  EXPECT_EQ(single, "0.1");
}

TEST(TextLines, EndWithAnyMixOfLineEnds) {
  TextLines lines("a\nb\r\nc\rd\r\r\n\ne");
  std::string joined;
  for (std::string_view line; lines.next(line);) {
    joined += std::to_string(lines.number()) + "=" + std::string(line) + ";";
  }
  EXPECT_EQ(joined, "1=a;2=b;3=c;4=d;5=;6=;7=e;");
}

TEST(TextLines, LongFilesWithCarriageReturnsAloneTakeLinearTime) {
  std::string text;
  for (int i = 0; i < 2'000'000; ++i) text += "x\r";  // a search to the end per line: 4e12 bytes
  TextLines lines(text);
  for (std::string_view line; lines.next(line);) {
  }
  EXPECT_EQ(lines.number(), 2'000'000U);
}

}  // namespace
}  // namespace cocoon
