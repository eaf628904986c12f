// Running the registered benchmarks, with an exit code that tells of wrong results.
#pragma once

#include <benchmark/benchmark.h>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/options.h"

namespace cocoon::bench {

// Whether a run had a wrong result.
inline bool has_failed = false;

// Google Benchmark alone says so in its table, if at all, and ends the program with exit code 0.
inline void fail(benchmark::State& state, const std::string& message) {
  has_failed = true;
  std::fprintf(stderr, "%s\n", message.c_str());
  state.SkipWithError(message.c_str());
}

// Runs them `repetitions` times in random order and reports medians, unless the flags of Google
// Benchmark that are left of the options say otherwise. Returns the exit code of the program: 0; 1
// if one of them has failed; 2 if a flag is unknown, or the filter leaves none.
inline int run_benchmarks(const Options& options, int repetitions) {
  // Defaults that the command line may change, so they come before it.
  std::vector<std::string> words{
      options.program(), "--benchmark_repetitions=" + std::to_string(repetitions),
      "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"};
  words.insert(words.end(), options.rest().begin(), options.rest().end());
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  int count = static_cast<int>(all.size());
  benchmark::Initialize(&count, all.data());
  if (benchmark::ReportUnrecognizedArguments(count, all.data())) return 2;
  const std::size_t run = benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return has_failed ? 1 : run == 0 ? 2 : 0;
}

}  // namespace cocoon::bench
