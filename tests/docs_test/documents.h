// What the tests of documents read.
#pragma once

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/run_program.h"

namespace cocoon::test {

inline const std::filesystem::path& project_root() {
  static const std::filesystem::path root = COCOON_SOURCE_DIR;
  return root;
}

inline std::vector<std::filesystem::path> documents() {
  namespace fs = std::filesystem;
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator(project_root())) result.push_back(entry.path());
  for (const char* folder : {"docs", "bench", "ref"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project_root() / folder)) {
      result.push_back(entry.path());
    }
  }
  std::erase_if(result, [](const fs::path& path) { return path.extension() != ".md"; });
  return result;
}

inline std::string text_of(const std::filesystem::path& path) { return content_of(path.string()); }

// All texts that the group of `pattern` matches.
inline std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    result.insert((*it)[1]);
  }
  return result;
}

inline bool has_word(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

}  // namespace cocoon::test
