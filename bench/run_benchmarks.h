// Running the registered benchmarks.
#pragma once

#include <benchmark/benchmark.h>
#include <string>
#include <vector>

namespace cocoon::bench {

// Runs them `repetitions` times in random order and reports medians, unless `arguments` (the name
// of the program, then flags of Google Benchmark) say otherwise. False: there was an unknown flag.
inline bool run_benchmarks(const std::vector<char*>& arguments, int repetitions) {
  // Defaults that the command line may change, so they come before it.
  std::vector<std::string> defaults{"--benchmark_repetitions=" + std::to_string(repetitions),
                                    "--benchmark_enable_random_interleaving=true",
                                    "--benchmark_report_aggregates_only=true"};
  std::vector<char*> all{arguments.front()};
  for (std::string& argument : defaults) all.push_back(argument.data());
  all.insert(all.end(), arguments.begin() + 1, arguments.end());
  int count = static_cast<int>(all.size());
  benchmark::Initialize(&count, all.data());
  if (benchmark::ReportUnrecognizedArguments(count, all.data())) return false;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return true;
}

}  // namespace cocoon::bench
