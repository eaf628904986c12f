#include "app/arguments/option_values.h"

#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <system_error>

#include "app/command_line.h"
#include "io/encoding/number_text.h"

namespace cocoon::app {

CLI::Validator between(double low, double high) {
  const std::string range = fmt::format("in [{}, {}]", low, high);
  return {[=](const std::string& text) {
            double value = 0;
            const bool read = CLI::detail::lexical_cast(text, value);
            return read && value >= low && value <= high ? std::string()
                                                         : fmt::format("{} is not {}", text, range);
          },
          range};
}

CLI::Validator whole_number() {
  return {[](const std::string& text) {
            std::uint64_t value = 0;
            const char* at = text.data();
            const char* end = at + text.size();
            const bool has_sign = text.starts_with('-') || text.starts_with('+');
            return !has_sign && parse_integer(at, end, value) && at == end
                       ? std::string()
                       : fmt::format("'{}' is no whole number from 0 to below 2^64", text);
          },
          "0 to below 2^64"};
}

CLI::Validator without_leading_zeros() {
  return {[](std::string& text) {
            const std::size_t first = text.find_first_not_of('0');
            const bool is_digit = first != std::string::npos &&
                                  std::isdigit(static_cast<unsigned char>(text[first])) != 0;
            if (is_digit) text.erase(0, first);
            return std::string();
          },
          ""};
}

CLI::Validator without_blanks() {
  return {[](std::string& text) {
            constexpr const char* blanks = " \t";
            const std::size_t first = text.find_first_not_of(blanks);
            if (first == std::string::npos) return std::string();
            text = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
            return std::string();
          },
          ""};
}

CLI::Validator folder_name() {
  return {[](const std::string& text) {
            if (text != "-") return std::string();
            return std::string(
                "-: several files are written, to a folder; name one (./- if that is its name)");
          },
          ""};
}

void require_no_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (!value.empty()) continue;
      throw UsageError(option->get_name() + ": the value is empty; give one");
    }
  }
}

// What follows an option may be its value, so the option alone is named.
std::string unexpected_told(const std::string& command, std::vector<std::string> extras) {
  bool is_behind_mark = false;
  for (const std::string& extra : extras) {
    if (extra == "--") is_behind_mark = true;
    if (extra == "--" || extra.size() < 2 || extra.front() != '-') continue;
    const std::string name = extra.substr(0, extra.find('='));
    if (is_behind_mark) {
      return fmt::format("{}takes what is behind -- for names of files; give {} before it", command,
                         name);
    }
    std::string hint = name == "--config" ? "; options are given on the command line alone" : "";
    std::error_code ignored;
    if (std::filesystem::exists(extra, ignored)) hint = "; the file of that name is ./" + extra;
    return fmt::format("{}has no option {}{}", command, name, hint);
  }
  std::erase(extras, "--");
  return fmt::format("{}has no place for {}", command, fmt::join(extras, " "));
}

}  // namespace cocoon::app
