#include "app/arguments/option_values.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "app/command_line.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

// What a validator makes of a text: the text after it, or what it says is wrong.
std::string after(const CLI::Validator& validator, std::string text) {
  const std::string wrong = validator(text);
  return wrong.empty() ? text : wrong;
}

TEST(OptionValues, RangesRefuseWhatIsNoNumber) {
  EXPECT_EQ(after(between(0, 1), "0"), "0");
  EXPECT_EQ(after(between(0, 1), "1"), "1");
  for (const char* text : {"nan", "1.1", "-0.1", "inf", "", "x"}) {
    EXPECT_EQ(after(between(0, 1), text), std::string(text) + " is not in [0, 1]");
  }
}

TEST(OptionValues, WholeNumbersHaveNoSignAndFit) {
  EXPECT_EQ(after(whole_number(), "18446744073709551615"), "18446744073709551615");
  for (const char* text : {"", "-1", "+1", "1.5", " 1", "18446744073709551616"}) {
    EXPECT_EQ(after(whole_number(), text),
              "'" + std::string(text) + "' is no whole number from 0 to below 2^64");
  }
}

TEST(OptionValues, LeadingZerosGo) {
  EXPECT_EQ(after(without_leading_zeros(), "010"), "10");
  EXPECT_EQ(after(without_leading_zeros(), "000"), "000");
  EXPECT_EQ(after(without_leading_zeros(), "0.5"), "0.5");
}

TEST(OptionValues, BlanksBesideWordsGo) {
  EXPECT_EQ(after(without_blanks(), " manifold\t"), "manifold");
  EXPECT_EQ(after(without_blanks(), "no way"), "no way");
  EXPECT_EQ(after(without_blanks(), " "), " ");
}

TEST(OptionValues, EmptyOnesAreRefused) {
  CLI::App app;
  std::string map;
  app.add_option("--map", map);
  const char* const arguments[] = {"program", "--map", ""};
  app.parse(3, arguments);
  EXPECT_THROW(require_no_empty_values(app), UsageError);
}

TEST(OptionValues, WhatACommandDoesNotHaveIsNamed) {
  EXPECT_EQ(unexpected_told("cocoon check ", {"a.ply", "--no=3", "-x"}),
            "cocoon check has no option --no");
  EXPECT_EQ(unexpected_told("cocoon check ", {"--config", "f"}),
            "cocoon check has no option --config; options are given on the command line alone");
  EXPECT_EQ(unexpected_told("cocoon check ", {"b.ply", "-"}),
            "cocoon check has no place for b.ply -");
}

TEST(OptionValues, OptionsGoBeforeTheMark) {
  EXPECT_EQ(unexpected_told("cocoon check ", {"--", "--quiet"}),
            "cocoon check takes what is behind -- for names of files; give --quiet before it");
  EXPECT_EQ(unexpected_told("cocoon check ", {"-x", "--", "--quiet"}),
            "cocoon check has no option -x");
  EXPECT_EQ(unexpected_told("cocoon check ", {"--", "b.ply"}),
            "cocoon check has no place for b.ply");
}

TEST(OptionValues, AFileThatLooksLikeAnOptionIsNamed) {
  const TemporaryFolder folder;
  folder.write("-dash.ply", "");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.file(""));
  EXPECT_EQ(unexpected_told("cocoon check ", {"-dash.ply"}),
            "cocoon check has no option -dash.ply; the file of that name is ./-dash.ply");
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace cocoon::app
