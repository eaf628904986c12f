#include "app/option_values.h"

#include <cctype>
#include <cstdint>
#include <fmt/format.h>
#include <string>

#include "io/number_text.h"

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

}  // namespace cocoon::app
