// What the documents name exists: files and headings behind links, files and folders in code marks,
// functions in headers, tests, commands and options of the program in the README and the tutorial.
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/docs_test/documents.h"
#include "tests/run_program.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;

const fs::path root = COCOON_SOURCE_DIR;

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

// As GitHub makes it of a heading: lower case, hyphens for spaces, no other punctuation.
std::string slug_of(const std::string& heading) {
  std::string slug;
  for (const char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || c == '_' || c == '-' || letter >= 128) {
      slug += static_cast<char>(std::tolower(letter));
    }
    if (c == ' ') slug += '-';
  }
  return slug;
}

TEST(Documents, LinksLeadToHeadings) {
  std::map<fs::path, std::set<std::string>> anchors;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    std::set<std::string>& own = anchors[document.lexically_normal()];
    own = matches(text, "<a id=\"([^\"]+)\">");
    for (const std::string& heading : matches(text, "\n#+ ([^\n]+)")) own.insert(slug_of(heading));
  }
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    const std::regex pattern("\\]\\(([^)#:]*)#([^)]+)\\)");
    const std::string text = text_of(document);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      const std::string target = (*it)[1];
      const fs::path to =
          target.empty() ? document : (document.parent_path() / target).lexically_normal();
      EXPECT_TRUE(anchors[to].contains((*it)[2])) << document << " -> " << (*it)[0];
      ++links;
    }
  }
  EXPECT_GT(links, 60U);
}

TEST(Documents, EachPageIsLinkedFromAnother) {
  std::set<fs::path> linked;
  for (const fs::path& document : documents()) {
    for (const std::string& target : matches(text_of(document), "\\]\\(([^)#:]+\\.md)")) {
      const fs::path to = (document.parent_path() / target).lexically_normal();
      if (to != document.lexically_normal()) linked.insert(to);
    }
  }
  for (const fs::path& document : documents()) {
    if (document.parent_path() == root) continue;
    EXPECT_TRUE(linked.contains(document.lexically_normal())) << document;
  }
}

// A header or source without its comments.
std::string code_of(const fs::path& path) {
  return std::regex_replace(text_of(path), std::regex("//[^\n]*"), "");
}

// "`f`, `g` in `folder/file.h`".
TEST(Documents, NamesAreInTheHeadersThatAreNamedWithThem) {
  const std::regex pattern(
      "((?:`[A-Za-z_:]+`(?:,\\s+|\\s+and\\s+))*`[A-Za-z_:]+`)\\s+in\\s+`([a-z_/]+\\.h)`");
  std::size_t names = 0;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      const std::string header = code_of(root / std::string((*it)[2]));
      for (const std::string& name : matches((*it)[1], "`(?:[A-Za-z]+::)?([A-Za-z_]+)`")) {
        EXPECT_TRUE(has_word(header, name)) << document << ": " << name << " in " << (*it)[2];
        ++names;
      }
    }
  }
  EXPECT_GT(names, 150U);
}

// Names of tests by their suites.
std::map<std::string, std::set<std::string>> all_tests() {
  std::map<std::string, std::set<std::string>> tests;
  const std::regex pattern("\nTEST(?:_F|_P)?\\(([A-Za-z0-9]+),\\s*([A-Za-z0-9]+)\\)");
  for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      tests[(*it)[1]].insert((*it)[2]);
    }
  }
  return tests;
}

// "`Suite.Test`", "`Suite.*`"; in the table of situations of docs/update.md also "`Test`", of the
// suite before it.
TEST(Documents, NamedTestsExist) {
  const std::map<std::string, std::set<std::string>> tests = all_tests();
  const std::regex pattern("`(?:([A-Z][A-Za-z0-9]+)\\.)?(\\*|[A-Z][A-Za-z0-9]+)`");
  std::size_t named = 0;
  for (const fs::path& document : documents()) {
    std::istringstream text(text_of(document));
    bool is_situation = false;
    for (std::string line; std::getline(text, line);) {
      is_situation = line.starts_with("| situation |") || (is_situation && line.starts_with("|"));
      std::string suite;
      for (std::sregex_iterator it(line.begin(), line.end(), pattern), end; it != end; ++it) {
        if (!(*it)[1].matched && (!is_situation || suite.empty())) continue;
        if ((*it)[1].matched) suite = (*it)[1];
        const auto found = tests.find(suite);
        const bool exists =
            found != tests.end() && ((*it)[2] == "*" || found->second.contains((*it)[2]));
        EXPECT_TRUE(exists) << document << ": " << suite << "." << (*it)[2];
        ++named;
      }
    }
  }
  EXPECT_GT(named, 60U);
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

// By which an example may call the stage of a page: the function of that name in the header of that
// name at the top of a layer, or else what the page has in code marks.
std::set<std::string> names_of_stage(const std::string& stage, const std::string& page) {
  for (const char* layer : {"geom", "delaunay", "cocone", "update"}) {
    const fs::path header = root / layer / (stage + ".h");
    if (!fs::exists(header)) continue;
    if (std::regex_search(code_of(header), std::regex("\n[^ \n][^\n]* " + stage + "\\("))) {
      return {stage};
    }
  }
  return matches(page, "`([A-Za-z_]+)(?:::[a-z_]+)?(?:\\([^`]*\\))?`");
}

// Which are compiled and run: tests/CMakeLists.txt.
TEST(Documents, EachStageHasAnExampleThatCallsIt) {
  for (const auto& entry : fs::directory_iterator(root / "docs/stages")) {
    const std::string page = text_of(entry.path());
    std::string examples;
    for (const std::string& name : matches(page, "docs/examples/([a-z_]+\\.cpp)")) {
      examples += code_of(root / "docs/examples" / name);
    }
    bool is_called = false;
    for (const std::string& name : names_of_stage(entry.path().stem().string(), page)) {
      is_called = is_called || has_word(examples, "cocoon::" + name);
    }
    EXPECT_TRUE(is_called) << entry.path();
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
}  // namespace cocoon::test
