// What the value of an option may be, beyond what CLI11 has for it.
#pragma once

#include <CLI/CLI.hpp>

namespace cocoon::app {

// Like CLI::Range, which lets "nan" pass.
CLI::Validator between(double low, double high);

// From 0 to below 2^64. CLI11 takes "", negative numbers and those that are too large for some
// whole number.
CLI::Validator whole_number();

// Takes them away. To CLI11 "010" is eight, as in C; scripts that count write it for ten.
CLI::Validator without_leading_zeros();

}  // namespace cocoon::app
