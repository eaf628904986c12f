// What the documents name exists: files behind links, files and folders in code marks, commands and
// options of the program in the README and the tutorial, options of stages with their defaults.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
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
    for (const std::string& target :
         matches(content_of(document.string()), "\\]\\(([^)#]+)[^)]*\\)")) {
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

// The values with which members of structs begin, by name: of one name in several structs all.
std::multimap<std::string, double> defaults_in_headers() {
  std::multimap<std::string, double> values;
  for (const char* folder : {"geom", "cocone", "update"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        const std::size_t equals = line.find(" = ");
        if (equals == line.npos || line.find(';', equals) == line.npos) continue;
        const std::size_t name = line.find_last_of(' ', equals - 1) + 1;
        const std::string value = line.substr(equals + 3);
        values.emplace(line.substr(name, equals - name),
                       value.starts_with("true") ? 1 : std::strtod(value.c_str(), nullptr));
      }
    }
  }
  return values;
}

// From each "Options" of a page to the next point of a list, bold word or empty line.
std::string paragraphs_on_options(const std::string& page) {
  std::istringstream stream(page);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == line.npos || line[first] == '*' || line[first] == '|') inside = false;
    const std::size_t begin = line.find("Options");
    if (begin == line.npos && !inside) continue;
    std::string rest = inside ? line : line.substr(begin);
    const std::size_t end = rest.find("**", rest.starts_with("Options.**") ? 10 : 0);
    inside = end == rest.npos;
    text += rest.substr(0, end) + '\n';
  }
  return text;
}

TEST(Documents, DefaultsOfOptionsAreThoseOfTheHeaders) {
  const std::multimap<std::string, double> defaults = defaults_in_headers();
  const std::regex option("`(?:[a-z_.]+[.])?([a-z_]+)` (true|[0-9]+(?:[.][0-9]+)?(?:e-[0-9]+)?)");
  std::size_t options = 0;
  for (const fs::path& document : documents()) {
    const std::string text = paragraphs_on_options(content_of(document.string()));
    for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it) {
      const std::string value = (*it)[2];
      const double number = value == "true" ? 1 : std::strtod(value.c_str(), nullptr);
      bool found = false;
      const auto [first, last] = defaults.equal_range((*it)[1]);
      for (auto entry = first; entry != last; ++entry) found |= entry->second == number;
      EXPECT_TRUE(found) << document << ": " << (*it)[0];
      ++options;
    }
  }
  EXPECT_GT(options, 100U);
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
