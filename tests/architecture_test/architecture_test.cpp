// The rules of the house that a machine can check: which folder may include which, who may use
// which library, what no source may contain. A failure names file and line.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct SourceFile {
  std::string layer;  // its folder: "geom"
  std::string name;   // from the root: "geom/point.h"
  std::vector<std::string> lines;

  bool is_header() const { return name.ends_with(".h"); }
};

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream stream(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The sources of the given folders, in order of their names.
std::vector<SourceFile> sources_of(const std::vector<std::string>& layers) {
  const fs::path root = COCOON_SOURCE_DIR;
  std::map<std::string, SourceFile> sources;
  for (const std::string& layer : layers) {
    if (!fs::exists(root / layer)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".h" && path.extension() != ".cpp") continue;
      const std::string name = fs::relative(path, root).generic_string();
      sources[name] = {layer, name, lines_of(path)};
    }
  }
  std::vector<SourceFile> result;
  for (auto& [name, source] : sources) result.push_back(std::move(source));
  return result;
}

const std::vector<std::string> product_layers = {"geom",   "delaunay", "cocone",
                                                 "update", "io",       "app"};
const std::vector<std::string> library_layers = {"geom", "delaunay", "cocone", "update", "io"};
const std::vector<std::string> all_layers = {"geom", "delaunay", "cocone", "update", "io",
                                             "app",  "ref",      "bench",  "docs",   "tests"};

std::string place(const SourceFile& source, std::size_t line) {
  return source.name + ":" + std::to_string(line + 1) + ": " + source.lines[line];
}

// Without what stands behind // (strings that contain // do not occur in the sources).
std::string code_of(const std::string& line) { return line.substr(0, line.find("//")); }

// Every line of code in `layers` that matches `pattern`, but for files in `except`.
std::string lines_matching(const std::vector<std::string>& layers, const std::string& pattern,
                           const std::set<std::string>& except = {}) {
  const std::regex regex(pattern);
  std::ostringstream found;
  for (const SourceFile& source : sources_of(layers)) {
    if (except.count(source.name) != 0) continue;
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      if (std::regex_search(code_of(source.lines[i]), regex)) found << place(source, i) << '\n';
    }
  }
  return found.str();
}

TEST(Architecture, FindsTheSources) {
  EXPECT_GE(sources_of(product_layers).size(), 20U);
  EXPECT_GE(sources_of({"tests"}).size(), 1U);
}

// What the repository holds at its root, as git lists it; nothing if these are not its files.
std::set<std::string> names_at_root() {
  const std::string root = COCOON_SOURCE_DIR;
  if (!fs::exists(root + "/.git")) return {};
  const std::string command = "git -c safe.directory='*' -C '" + root + "' ls-files";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::set<std::string> names;
  std::array<char, 4096> line{};
  while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) {
    const std::string path = line.data();
    names.insert(path.substr(0, path.find_first_of("/\n")));
  }
  pclose(pipe);
  return names;
}

TEST(Architecture, NothingUnplannedAtTheRoot) {
  const std::set<std::string> planned = {".ci",
                                         ".clang-format",
                                         ".clang-tidy",
                                         ".gitignore",
                                         "CHANGELOG.md",
                                         "CITATION.cff",
                                         "CMakeLists.txt",
                                         "CMakePresets.json",
                                         "CONTRIBUTING.md",
                                         "LICENSE",
                                         "README.md",
                                         "SECURITY.md",
                                         "app",
                                         "bench",
                                         "cmake",
                                         "cocone",
                                         "delaunay",
                                         "dev",
                                         "docs",
                                         "geom",
                                         "io",
                                         "ref",
                                         "tests",
                                         "update"};
  const std::set<std::string> names = names_at_root();
  if (names.empty()) GTEST_SKIP() << "not a git checkout";
  for (const std::string& name : names) EXPECT_TRUE(planned.contains(name)) << name;
}

TEST(Architecture, IncludesPointOneWay) {
  const std::map<std::string, std::set<std::string>> may_include = {
      {"geom", {"geom"}},
      {"delaunay", {"geom", "delaunay"}},
      {"cocone", {"geom", "delaunay", "cocone"}},
      {"update", {"geom", "delaunay", "cocone", "update"}},
      {"io", {"geom", "delaunay", "io"}},
      {"app", {"geom", "delaunay", "cocone", "update", "io", "app"}},
      {"ref", {"geom", "delaunay", "cocone", "update", "io", "ref"}},
      {"bench", {"geom", "delaunay", "cocone", "update", "io", "ref", "bench", "tests"}},
      {"docs", {"geom", "delaunay", "cocone", "update", "io", "docs"}},
      {"tests", {"geom", "delaunay", "cocone", "update", "io", "app", "ref", "tests"}},
  };
  const std::regex include("^ *# *include +\"([a-z_0-9]+)/");
  for (const SourceFile& source : sources_of(all_layers)) {
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(source.lines[i], match, include)) continue;
      EXPECT_TRUE(may_include.at(source.layer).count(match[1]) != 0) << place(source, i);
    }
  }
}

// A sub-folder of a layer ("cocone/facets"), and those of the same layer that it may include.
struct SubFolder {
  std::string name;
  std::set<std::string> may_include;
};

// The table of docs/design.md, row by row.
std::vector<SubFolder> table_of_sub_folders() {
  const std::regex row("^\\| `([a-z]+)/([a-z_]+)/` \\|[^|]*\\|([^|]*)\\|$");
  const std::regex folder("`([a-z_]+)`");
  std::vector<SubFolder> table;
  for (const std::string& line : lines_of(fs::path(COCOON_SOURCE_DIR) / "docs/design.md")) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    const std::string layer = match[1].str() + "/";
    const std::string arrows = match[3];
    SubFolder entry{layer + match[2].str(), {}};
    for (std::sregex_iterator it(arrows.begin(), arrows.end(), folder), end; it != end; ++it) {
      entry.may_include.insert(layer + (*it)[1].str());
    }
    table.push_back(entry);
  }
  return table;
}

// "cocone/facets" of "cocone/facets/half_star.h"; empty at the top of a layer.
std::string sub_folder_of(const std::string& name) {
  const std::size_t last = name.rfind('/');
  return name.find('/') == last ? "" : name.substr(0, last);
}

TEST(Architecture, IncludesBetweenSubFoldersAreThoseOfTheTable) {
  std::map<std::string, std::set<std::string>> may_include;
  for (const SubFolder& entry : table_of_sub_folders()) {
    for (const std::string& other : entry.may_include) {
      EXPECT_TRUE(may_include.contains(other)) << entry.name << " -> " << other << ", a row below";
    }
    may_include[entry.name] = entry.may_include;
  }
  std::map<std::string, std::set<std::string>> includes;
  const std::regex include("^ *# *include +\"([a-z_0-9/]+\\.h)\"");
  for (const SourceFile& source : sources_of(product_layers)) {
    const std::string from = sub_folder_of(source.name);
    if (from.empty()) continue;
    ASSERT_TRUE(may_include.contains(from)) << source.name << ": not in docs/design.md";
    includes[from];
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(source.lines[i], match, include)) continue;
      const std::string to = sub_folder_of(match[1]);
      if (to.empty() || to == from || !to.starts_with(source.layer + "/")) continue;
      EXPECT_TRUE(may_include.at(from).contains(to)) << place(source, i);
      includes[from].insert(to);
    }
  }
  EXPECT_EQ(includes, may_include);  // no row and no arrow that is not there
}

TEST(Architecture, TestsAreInTheFoldersOfWhatTheyTest) {
  std::map<std::string, std::string> folder_of_header;  // by layer and name: "cocone/half_star"
  for (const SourceFile& source : sources_of(product_layers)) {
    const fs::path path = source.name;
    const std::string concept_name = source.layer + "/" + path.stem().string();
    if (source.is_header()) folder_of_header[concept_name] = path.parent_path().generic_string();
  }
  for (const SourceFile& source : sources_of({"tests"})) {
    const fs::path path = source.name;
    const std::string stem = path.stem().string();
    if (!stem.ends_with("_test")) continue;
    const std::string folder = path.parent_path().lexically_relative("tests").generic_string();
    const std::string layer = folder.substr(0, folder.find('/'));
    const auto found = folder_of_header.find(layer + "/" + stem.substr(0, stem.size() - 5));
    if (found == folder_of_header.end()) continue;
    EXPECT_EQ(folder, found->second) << source.name;
  }
}

TEST(Architecture, OwnHeadersAreIncludedFromTheRoot) {
  EXPECT_EQ(lines_matching(product_layers, "# *include +\"[^/]*\""), "");
  EXPECT_EQ(lines_matching(product_layers, "# *include +\"\\.\\./"), "");
}

TEST(Architecture, CgalIsNoPartOfTheProduct) {
  EXPECT_EQ(lines_matching(product_layers, "CGAL"), "");
}

TEST(Architecture, LibrariesOfTheProgramStayInTheProgram) {
  EXPECT_EQ(lines_matching(library_layers, "# *include +<(fmt|nlohmann|CLI)/"), "");
  EXPECT_EQ(lines_matching(
                {"app"}, "# *include +<CLI/",
                {"app/command_line.cpp", "app/command_options.h", "app/arguments/option_values.h"}),
            "");
  EXPECT_EQ(lines_matching({"app"}, "# *include +<nlohmann/", {"app/json_report.cpp"}), "");
}

TEST(Architecture, LibraryNeitherPrintsNorEndsTheProgram) {
  EXPECT_EQ(lines_matching(library_layers,
                           "std::(cout|cerr|clog|printf|puts|exit|abort|terminate)\\b|"
                           "\\b(fprintf|printf) *\\("),
            "");
}

TEST(Architecture, OnlyWhatAllCompilersAndTheBrowserHave) {
  EXPECT_EQ(lines_matching(product_layers, "# *include +<(ranges|format|source_location)>"), "");
  EXPECT_EQ(lines_matching(product_layers, "std::(ranges|views)::"), "");
  EXPECT_EQ(lines_matching({"geom", "delaunay", "cocone", "update", "app"}, "std::(from|to)_chars"),
            "");
}

TEST(Architecture, NoHiddenRandomnessOrClock) {
  EXPECT_EQ(lines_matching(library_layers,
                           "std::random_device|\\bs?rand *\\(|std::time *\\(|_clock::now"),
            "");
}

TEST(Architecture, HeadersSayWhatTheyAre) {
  for (const SourceFile& source : sources_of(product_layers)) {
    if (!source.is_header()) continue;
    ASSERT_FALSE(source.lines.empty()) << source.name;
    EXPECT_TRUE(source.lines.front().starts_with("// ")) << source.name << ": no opening comment";
    bool guarded = false;
    bool in_namespace = false;
    for (const std::string& line : source.lines) {
      // Code for several instruction sets is included once for each.
      guarded = guarded || line == "#pragma once" ||
                (source.name.ends_with("-inl.h") && line.find("HWY_TARGET_TOGGLE") != line.npos);
      in_namespace = in_namespace || line.starts_with("namespace cocoon");
    }
    EXPECT_TRUE(guarded) << source.name << ": no #pragma once";
    EXPECT_TRUE(in_namespace) << source.name << ": not in namespace cocoon";
  }
}

TEST(Architecture, FilesAreOneConceptEach) {
  const std::regex vague("(^|[/_])(utils?|helpers?|misc|common|stuff)[_0-9]*\\.");
  for (const SourceFile& source : sources_of(all_layers)) {
    EXPECT_FALSE(std::regex_search(source.name, vague)) << source.name;
    EXPECT_LE(source.lines.size(), 500U) << source.name;
  }
}

// What begins at the start of a line, or two blanks in (a member of a class), maybe with a
// signature of several lines, and ends with nothing but a brace in the same column: types and
// constants end with a semicolon, namespaces with a comment.
TEST(Architecture, FunctionsFitOnAScreen) {
  const std::regex beside("^ *(#|//)");
  const std::regex between("^ *(namespace|extern|\\})");
  std::size_t functions = 0;
  for (const SourceFile& source : sources_of(product_layers)) {
    for (const std::size_t column : {std::size_t{0}, std::size_t{2}}) {
      constexpr std::size_t none = std::string::npos;
      std::size_t begin = none;
      for (std::size_t i = 0; i < source.lines.size(); ++i) {
        const std::string& line = source.lines[i];
        const std::size_t indent = line.find_first_not_of(' ');
        if (line.empty() || indent > column || std::regex_search(line, beside)) continue;
        if (line.substr(indent) == "}" && indent == column && begin != none) {
          EXPECT_LE(i - begin + 1, 60U) << place(source, begin);
          ++functions;
        }
        const bool ends = indent < column || line.back() == ';' || line.back() == '}';
        if (ends || std::regex_search(line, between)) {
          begin = none;
        } else if (begin == none) {
          begin = i;
        }
      }
    }
  }
  EXPECT_GT(functions, 1000U);
}

TEST(Architecture, NothingUnfinishedAndNothingOfOneMachine) {
  // Built from parts, so that this file does not contain what it forbids.
  const std::string unfinished = std::string("\\b(TO") + "DO|FIX" + "ME|X" + "XX)\\b";
  const std::string machine = std::string("/ro") + "ot/|/wo" + "rk/|/ho" + "me/";
  const std::regex forbidden(unfinished + "|" + machine);
  for (const SourceFile& source : sources_of(all_layers)) {
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      EXPECT_FALSE(std::regex_search(source.lines[i], forbidden)) << place(source, i);
    }
  }
}

// A source is cited by its paper or by a page of docs/, not by a text that readers do not have.
TEST(Architecture, NothingRefersToAnUnpublishedText) {
  // In two parts, so that this file does not contain what it forbids.
  const std::regex forbidden(std::string("\\b[Ss]pe") + "c(ification)?,? ([0-9]|section)");
  for (const SourceFile& source : sources_of(all_layers)) {
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      EXPECT_FALSE(std::regex_search(source.lines[i], forbidden)) << place(source, i);
    }
  }
}

}  // namespace
