// What the value of an option may be, beyond what CLI11 has for it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cocoon::app {

// Like CLI::Range, which lets "nan" pass.
CLI::Validator between(double low, double high);

// Adds an option whose value is one of some words, each of which stands for a value.
template <class Value, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target,
                        const std::string& meaning,
                        const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<std::string> words;
  words.reserve(choices.size());
  for (const auto& [word, value] : choices) words.push_back(word);
  const auto choose = [&target, choices](const std::string& chosen) {
    for (const auto& [word, value] : choices) {
      if (word == chosen) target = value;
    }
  };
  return app.add_option_function<std::string>(name, choose, meaning)->check(CLI::IsMember(words));
}

// From 0 to below 2^64. CLI11 takes "", negative numbers and those that are too large for some
// whole number.
CLI::Validator whole_number();

// Takes them away. To CLI11 "010" is eight, as in C; scripts that count write it for ten.
CLI::Validator without_leading_zeros();

// Before and behind a word of a list, as people write one: "closed, manifold".
CLI::Validator without_blanks();

// Not "-", which is standard output elsewhere: several files go to a folder.
CLI::Validator folder_name();

// Throws UsageError for an empty value, as a shell makes it of a variable that is not set: taken
// for an option that is not given, an output would be missing in the end.
void require_no_empty_values(const CLI::App& command);

// What is wrong with arguments that the command ("cocoon check ") does not have, in one line;
// "--" may be among them. Precondition: there is another one. Looks whether there is a file of that
// name.
std::string unexpected_told(const std::string& command, std::vector<std::string> extras);

}  // namespace cocoon::app
