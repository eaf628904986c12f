// The JSON report of a run: one object whose sections each command fills in as far as it has them.
// Sections appear in the order in which they are first set. Only json_report.cpp knows the JSON
// library.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cocoon::app {

class JsonReport {
 public:
  JsonReport();
  ~JsonReport();
  JsonReport(JsonReport&&) noexcept;
  JsonReport& operator=(JsonReport&&) noexcept;
  JsonReport(const JsonReport&) = delete;
  JsonReport& operator=(const JsonReport&) = delete;

  // As it is now: to go back to.
  JsonReport copy() const;

  // Sets the value at `path`, names separated by '/'; objects on the way are made as needed. A
  // double that is not finite is written as null.
  void set(std::string_view path, bool value);
  void set(std::string_view path, std::size_t value);
  void set(std::string_view path, std::ptrdiff_t value);
  void set(std::string_view path, int value);
  void set(std::string_view path, double value);
  void set(std::string_view path, const char* value);
  void set(std::string_view path, const std::string& value);
  void set(std::string_view path, const std::vector<std::size_t>& values);
  void set(std::string_view path, const std::vector<double>& values);
  void set(std::string_view path, const std::vector<std::string>& values);
  void set(std::string_view path, const JsonReport& object);
  // Adds to the count at `path`, which is 0 if there is none.
  void add(std::string_view path, std::size_t count);
  // Makes an empty array at `path`, and adds an element to the array there.
  void set_empty_array(std::string_view path);
  void append(std::string_view path, const JsonReport& object);
  void append(std::string_view path, const std::string& value);
  void append(std::string_view path, double value);

  // The text, indented by two spaces, with a newline at its end.
  std::string text() const;
  // The text on one line, for a script element of a page: it contains no '<'. "</script>" would end
  // the element, "<!--<script>" keep the next end from doing so.
  std::string script_text() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace cocoon::app
