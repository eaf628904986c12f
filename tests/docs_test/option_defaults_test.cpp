// Options of stages that the documents name have the defaults of the headers, each looked up in the
// struct that the page means.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/docs_test/documents.h"

namespace cocoon::test {
namespace {

namespace fs = std::filesystem;

struct Member {
  std::string type;
  double value = 0;  // with which it begins, if that is a number; true is 1
};
using Struct = std::map<std::string, Member>;

// All structs of options, by name, and which of them each header has.
struct Headers {
  std::map<std::string, Struct> structs;
  std::map<std::string, std::vector<std::string>> in_header;
};

void read_header(const fs::path& path, Headers& headers) {
  const std::regex begins("struct ([A-Za-z]+) \\{");
  const std::regex member("  ([A-Za-z0-9_:<>]+) ([a-z_0-9]+)(?: = ([^;]*))?;.*");
  std::ifstream stream(path);
  std::string inside;
  for (std::string line; std::getline(stream, line);) {
    std::smatch found;
    if (std::regex_match(line, found, begins)) {
      inside = found[1];
      headers.structs[inside];
      headers.in_header[fs::relative(path, project_root()).string()].push_back(inside);
    } else if (line.starts_with("}")) {
      inside.clear();
    } else if (!inside.empty() && std::regex_match(line, found, member)) {
      const std::string value = found[3];
      headers.structs[inside][found[2]] = {
          found[1], value == "true" ? 1 : std::strtod(value.c_str(), nullptr)};
    }
  }
}

Headers read_headers() {
  Headers headers;
  for (const char* folder : {"geom", "cocone", "update"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project_root() / folder)) {
      if (entry.path().extension() == ".h") read_header(entry.path(), headers);
    }
  }
  return headers;
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

class Lookup {
 public:
  // A page of a stage means the structs of the headers that it names; those of the update,
  // which name all, only UpdateOptions, and what they say before a colon.
  Lookup(const Headers& headers, const fs::path& document) : headers_(headers) {
    if (document.filename() != "update.md" && document.filename() != "departures.md") {
      for (const std::string& header : matches(text_of(document), "`([a-z_/]+\\.h)`")) {
        const auto found = headers.in_header.find(header);
        if (found == headers.in_header.end()) continue;
        page_.insert(page_.end(), found->second.begin(), found->second.end());
      }
    }
  }

  // "`cut.ends`: `scanned` 2, ...", "(`StrayOptions`): ...".
  void set_context(const std::string& path) {
    if (headers_.structs.contains(path)) {
      context_ = path;
    } else if (const std::optional<Member> found = member("UpdateOptions", path)) {
      context_ = found->type;
    }
  }
  void forget_context() { context_.clear(); }

  std::vector<Member> find(const std::string& path) const {
    std::vector<std::string> bases = page_;
    if (!context_.empty()) bases = {context_};
    if (path.find('.') != path.npos) bases.emplace_back("UpdateOptions");
    std::vector<Member> result;
    for (const std::string& base : bases) {
      if (const std::optional<Member> found = member(base, path)) result.push_back(*found);
    }
    return result;
  }

 private:
  std::optional<Member> member(const std::string& base, const std::string& path) const {
    std::istringstream names(path);
    Member found{base};
    for (std::string name; std::getline(names, name, '.');) {
      const auto in = headers_.structs.find(found.type);
      if (in == headers_.structs.end()) return {};
      const auto next = in->second.find(name);
      if (next == in->second.end()) return {};
      found = next->second;
    }
    return found;
  }

  const Headers& headers_;
  std::vector<std::string> page_;
  std::string context_;
};

TEST(Documents, DefaultsOfOptionsAreThoseOfTheHeaders) {
  const Headers headers = read_headers();
  const std::regex token(
      "(Options\\b)(?!`)|`([A-Za-z_.]+)`\\)?:|\\(`([A-Za-z]+Options)`\\)|"
      "`([a-z_.]+)` (true|[0-9]+(?:[.][0-9]+)?(?:e-[0-9]+)?)");
  std::size_t options = 0;
  for (const fs::path& document : documents()) {
    Lookup lookup(headers, document);
    const std::string text = paragraphs_on_options(text_of(document));
    for (std::sregex_iterator it(text.begin(), text.end(), token), end; it != end; ++it) {
      const std::smatch& found = *it;
      if (found[1].matched) lookup.forget_context();
      if (found[2].matched) lookup.set_context(found[2]);
      if (found[3].matched) lookup.set_context(found[3]);
      if (!found[4].matched) continue;
      const std::string value = found[5];
      const double number = value == "true" ? 1 : std::strtod(value.c_str(), nullptr);
      bool is_default = false;
      for (const Member& member : lookup.find(found[4])) is_default |= member.value == number;
      EXPECT_TRUE(is_default) << document << ": " << found[0];
      ++options;
    }
  }
  EXPECT_GT(options, 100U);
}

}  // namespace
}  // namespace cocoon::test
