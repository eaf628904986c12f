// What the documents name exists: files behind links, files and folders in code marks, commands and
// options of the program in the README and the tutorial.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/run_program.h"

namespace {

namespace fs = std::filesystem;
using cocoon::test::content_of;
using cocoon::test::run_program;

const fs::path root = COCOON_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator(root)) result.push_back(entry.path());
  for (const char* folder : {"docs", "bench", "ref"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      result.push_back(entry.path());
    }
  }
  std::erase_if(result, [](const fs::path& path) { return path.extension() != ".md"; });
  return result;
}

// All texts that the group of `pattern` matches.
std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    result.insert((*it)[1]);
  }
  return result;
}

TEST(Documents, AreThere) {
  EXPECT_GE(documents().size(), 8U);
  for (const char* name : {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff",
                           "LICENSE", "docs/tutorial.md", "docs/reading_guide.md", "docs/design.md",
                           "docs/formats.md", "docs/bibliography.md"}) {
    EXPECT_TRUE(fs::exists(root / name)) << name;
  }
}

TEST(Documents, LinksLeadToFiles) {
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    for (std::string target : matches(content_of(document.string()), "\\]\\(([^)#]+)[^)]*\\)")) {
      if (target.find("://") != std::string::npos) continue;
      EXPECT_TRUE(fs::exists(document.parent_path() / target)) << document << " -> " << target;
      ++links;
    }
  }
  EXPECT_GT(links, 100U);
}

TEST(Documents, NamedSourcesExist) {
  const std::string layers = "(?:geom|delaunay|cocone|update|io|app|ref|tests|bench|docs|cmake)";
  const std::string file = "[a-zA-Z0-9_/-]+\\.(?:h|cpp|md|csv|txt|html|xyz|off|ply|cmake)";
  const std::string pattern = "`(" + layers + "/(?:" + file + "|(?:[a-z0-9_-]+/)*))`";
  std::size_t sources = 0;
  for (const fs::path& document : documents()) {
    for (const std::string& name : matches(content_of(document.string()), pattern)) {
      EXPECT_TRUE(fs::exists(root / name)) << document << " names " << name;
      ++sources;
    }
  }
  EXPECT_GT(sources, 300U);
}

// Which are compiled and run: tests/CMakeLists.txt.
TEST(Documents, EachStageHasAnExample) {
  for (const auto& entry : fs::directory_iterator(root / "docs/stages")) {
    const std::string page = content_of(entry.path().string());
    EXPECT_FALSE(matches(page, "docs/examples/([a-z_]+\\.cpp)").empty()) << entry.path();
  }
}

// Names of authors as texts cite them: "Doi & Koide", "Cline et al.", "Cook 1986".
std::set<std::string> authors_in(const std::string& text, bool with_years) {
  const std::string name = "([A-Z][^ ,.;:()*|]*[a-z])";  // not a venue, as SoCG
  std::set<std::string> names = matches(text, name + " (?:&|et al)");
  names.merge(matches(text, " & " + name));
  if (with_years) names.merge(matches(text, name + ",? (?:19|20)[0-9]{2}\\b"));
  return names;
}

// The comments of a source from each "Source" to the end of the comment, one line each.
std::string sources_named_in(const fs::path& path) {
  std::ifstream stream(path);
  std::string sources;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t begin = line.find("//");
    const std::size_t source = line.find("Source", begin);
    if (begin == line.npos || line.find_first_not_of(' ') != begin) {
      if (inside) sources += '\n';
      inside = false;
    } else if (inside) {
      sources += line.substr(begin + 2);
    } else if (source != line.npos) {
      inside = true;
      sources += line.substr(source);
    }
  }
  return sources;
}

TEST(Documents, BibliographyHasAllAuthors) {
  const std::string bibliography = content_of((root / "docs/bibliography.md").string());
  for (const char* folder : {"geom", "delaunay", "cocone", "update", "io", "app", "ref", "bench"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".h") continue;
      for (const std::string& author : authors_in(sources_named_in(entry.path()), true)) {
        EXPECT_NE(bibliography.find(author), std::string::npos) << entry.path() << ": " << author;
      }
    }
  }
  for (const fs::path& document : documents()) {
    for (const std::string& author : authors_in(content_of(document.string()), false)) {
      EXPECT_NE(bibliography.find(author), std::string::npos) << document << ": " << author;
    }
  }
}

TEST(Documents, CommandsAndOptionsAreThoseOfTheProgram) {
  std::size_t options = 0;
  for (const char* document : {"README.md", "docs/tutorial.md"}) {
    const std::regex continued("\\\\\n *");
    const std::string text =
        std::regex_replace(content_of((root / document).string()), continued, "");
    const std::set<std::string> commands = matches(text, "\n    cocoon ([a-z]+)");
    EXPECT_GE(commands.size(), 6U) << document;
    for (const std::string& command : commands) {
      const std::set<std::string> known =
          matches(run_program({command, "--help"}).out, "(--[a-z][a-z-]*)");
      EXPECT_FALSE(known.empty()) << command;
      const std::regex uses("\n    cocoon " + command + "([^#\n]*)");
      for (std::sregex_iterator it(text.begin(), text.end(), uses), end; it != end; ++it) {
        for (const std::string& option : matches((*it)[1], "(--[a-z-]+)")) {
          EXPECT_TRUE(known.contains(option)) << document << ": " << command << " " << option;
          ++options;
        }
      }
    }
  }
  EXPECT_GT(options, 20U);
}

}  // namespace
