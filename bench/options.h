// The options of a benchmark program: "--name value", in any order.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace cocoon::bench {

// The parts of "a,b,c".
inline std::vector<std::string> comma_list(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

// Options are taken out one by one; what is not understood ends the program with exit code 2.
class Options {
 public:
  Options(int argc, char** argv) : program_(argv[0]), words_(argv + 1, argv + argc) {}

  std::string text(const char* name, std::string otherwise) {
    const auto found = std::find(words_.begin(), words_.end(), name);
    if (found == words_.end()) return otherwise;
    if (found + 1 == words_.end()) fail(std::string(name) + " needs a value");
    std::string value = *(found + 1);
    words_.erase(found, found + 2);
    return value;
  }
  std::size_t number(const char* name, std::size_t otherwise) {
    return as_number(text(name, std::to_string(otherwise)));
  }
  std::vector<std::string> list(const char* name, const std::string& otherwise) {
    return comma_list(text(name, otherwise));
  }

  // What is left: arguments without a name, or the flags of Google Benchmark.
  const std::vector<std::string>& rest() const { return words_; }
  // For a program that has no other arguments.
  void require_no_rest() const {
    if (!words_.empty()) fail("does not know '" + words_.front() + "'");
  }
  const std::string& program() const { return program_; }

  std::size_t as_number(const std::string& text) const {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      fail("'" + text + "' is no whole number");
    }
    return value;
  }
  [[noreturn]] void fail(const std::string& message) const {
    std::fprintf(stderr, "%s: %s; its options are at the head of its source\n", program_.c_str(),
                 message.c_str());
    std::exit(2);
  }

 private:
  std::string program_;
  std::vector<std::string> words_;
};

}  // namespace cocoon::bench
