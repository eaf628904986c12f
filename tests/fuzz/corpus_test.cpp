// The inputs that the fuzzer found worth keeping, and those that once broke something, run as
// ordinary tests.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "io/file_bytes.h"
#include "tests/fuzz/fuzz_target.h"

namespace cocoon::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(COCOON_TEST_DATA) / "fuzz";

class Corpus : public testing::TestWithParam<FuzzTarget> {};

TEST_P(Corpus, KeepsItsPromises) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(corpus / GetParam().name)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  EXPECT_GE(files.size(), 2U);
  GetParam().run({});
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename().string());
    const FileBytes file = read_file(path);
    const std::vector<std::uint8_t> bytes(file.view().begin(), file.view().end());
    EXPECT_NO_THROW(GetParam().run(bytes));
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(fuzz_targets()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(FuzzTargets, EveryFolderOfTheCorpusHasOne) {
  std::set<std::string> names;
  for (const FuzzTarget& target : fuzz_targets()) names.insert(target.name);
  for (const auto& entry : fs::directory_iterator(corpus)) {
    if (entry.is_directory()) {
      EXPECT_EQ(names.count(entry.path().filename().string()), 1U) << entry.path();
    }
  }
}

}  // namespace
}  // namespace cocoon::fuzz
