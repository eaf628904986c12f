// Running the registered benchmarks.
#pragma once

#include <benchmark/benchmark.h>
#include <string>
#include <vector>

#include "bench/options.h"

namespace cocoon::bench {

// Runs them `repetitions` times in random order and reports medians, unless the flags of Google
// Benchmark that are left of the options say otherwise. False: there was an unknown one.
inline bool run_benchmarks(const Options& options, int repetitions) {
  // Defaults that the command line may change, so they come before it.
  std::vector<std::string> words{
      options.program(), "--benchmark_repetitions=" + std::to_string(repetitions),
      "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"};
  words.insert(words.end(), options.rest().begin(), options.rest().end());
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  int count = static_cast<int>(all.size());
  benchmark::Initialize(&count, all.data());
  if (benchmark::ReportUnrecognizedArguments(count, all.data())) return false;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return true;
}

}  // namespace cocoon::bench
