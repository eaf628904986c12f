// How well the update does on the procedural models of the paper's examples, where the truth is
// known: all models, over many seeds, with ideal scans, with registration errors and with noise.
//
//   ./dev bench update_scores             the table of bench/update_quality.md
//   --seeds N                             20 of each model
//   --model NAME                          one model only
//   --percent N                           of the paper's numbers of points
//
// Exit code 1 if an update was refused, or a vertex that stayed has moved.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/options.h"
#include "cocone/reconstruct.h"
#include "geom/mesh_measure.h"
#include "io/sample_models.h"
#include "ref/scan_errors.h"
#include "ref/update_score.h"

namespace cocoon {
namespace {

struct Condition {
  const char* name;
  double registration;  // in spacings of the cloud
  double noise;
};
constexpr Condition conditions[] = {
    {"ideal", 0, 0}, {"registration 0.5", 0.5, 0}, {"noise 0.1", 0, 0.1}};

// The worst of many scores.
struct Worst {
  std::size_t runs = 0;
  std::size_t failures = 0;
  std::size_t wrong_topology = 0;
  std::size_t moved = 0;
  std::size_t fewest_gone = ~std::size_t{0};
  std::size_t most_gone = 0;
  double precision = 1;
  double recall = 1;
  double mean = 0;
  double rms = 0;
  double hausdorff = 0;
  double smallest_margin = 180;

  void add(const UpdateResult& result, const ref::UpdateScore& score) {
    ++runs;
    if (result.status != UpdateStatus::ok) {
      ++failures;
      return;
    }
    wrong_topology += score.right_topology() ? 0 : 1;
    moved += score.moved;
    fewest_gone = std::min(fewest_gone, score.gone);
    most_gone = std::max(most_gone, score.gone);
    precision = std::min(precision, score.precision());
    recall = std::min(recall, score.recall());
    mean = std::max(mean, score.distance.mean / score.spacing);
    rms = std::max(rms, score.distance.rms / score.spacing);
    hausdorff = std::max(hausdorff, score.distance.max / score.spacing);
    for (const CloudReport& cloud : result.clouds) {
      smallest_margin = std::min(smallest_margin, cloud.margin_deg);
    }
  }
};

double cloud_spacing(const std::vector<Point>& cloud) {
  const CloudSurface surface = cloud_surface(cloud);
  return mesh_measure(surface.mesh).edge_lengths.median;
}

void run(const SampleModel& sample, const TriangleMesh& model, std::uint64_t seed,
         const Condition& condition, Worst& worst) {
  std::vector<std::vector<Point>> clouds = sample.clouds;
  std::uint64_t cloud_seed = 1000 * seed;
  for (std::vector<Point>& cloud : clouds) {
    const double spacing = cloud_spacing(cloud);
    ref::add_scan_errors(cloud, {.noise = condition.noise * spacing,
                                 .registration = condition.registration * spacing,
                                 .seed = ++cloud_seed});
  }
  const UpdateResult result = update_model(model, clouds);
  const ref::UpdateScore score = ref::score_update(model, result, sample, {.samples = 50000});
  if (result.status != UpdateStatus::ok) {
    std::printf("  seed %d: %s\n", static_cast<int>(seed), result.message.c_str());
  } else if (score.precision() < 0.995 || score.recall() < 0.995 || !score.right_topology() ||
             score.distance.max > 2 * score.spacing) {
    std::printf("  seed %d: wrong %zu, gone %zu, both %zu, genus %d, closed %d, Hausdorff %.2f\n",
                static_cast<int>(seed), score.wrong, score.gone, score.wrong_and_gone,
                score.genus ? static_cast<int>(*score.genus) : -1, score.closed_manifold ? 1 : 0,
                score.distance.max / score.spacing);
  }
  worst.add(result, score);
}

// Whether all updates were done, and moved nothing.
bool score_model(const std::string& name, std::uint64_t seeds, double size) {
  std::array<Worst, std::size(conditions)> worst;
  SampleOptions options;
  if (size != 1) {
    const SampleModel full = sample_model(name);
    std::size_t cloud_points = 0;
    for (const auto& cloud : full.clouds) cloud_points += cloud.size();
    options.points = static_cast<std::size_t>(size * static_cast<double>(full.initial.size()));
    options.cloud_points = static_cast<std::size_t>(size * static_cast<double>(cloud_points));
  }
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    options.seed = seed;
    const SampleModel sample = sample_model(name, options);
    const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
    for (std::size_t c = 0; c < std::size(conditions); ++c) {
      run(sample, model, seed, conditions[c], worst[c]);
    }
  }
  for (std::size_t c = 0; c < std::size(conditions); ++c) {
    const Worst& w = worst[c];
    std::printf(
        "| %s | %s | %zu | %zu-%zu | %.4f | %.4f | %zu | %.3f | %.3f | %.2f | %.0f | %zu |\n",
        name.c_str(), conditions[c].name, w.runs - w.failures, w.fewest_gone, w.most_gone,
        w.precision, w.recall, w.wrong_topology, w.mean, w.rms, w.hausdorff, w.smallest_margin,
        w.moved);
  }
  std::fflush(stdout);
  return std::all_of(worst.begin(), worst.end(),
                     [](const Worst& w) { return w.failures == 0 && w.moved == 0; });
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) {
  cocoon::bench::Options options(argc, argv);
  const std::size_t seeds = options.number("--seeds", 20);
  const std::string only = options.text("--model", "");
  const double size = 0.01 * static_cast<double>(options.number("--percent", 100));
  options.require_no_rest();
  const std::vector<std::string> names = cocoon::sample_model_names();
  if (!only.empty() && std::find(names.begin(), names.end(), only) == names.end()) {
    options.fail("does not know the model '" + only + "'");
  }
  std::printf(
      "The worst of %d seeds; distances in spacings of the initial model.\n"
      "| model | scan | done | removed | precision | recall | wrong topology | mean | RMS | "
      "Hausdorff | margin, degrees | moved vertices |\n"
      "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
      static_cast<int>(seeds));
  bool good = true;
  for (const std::string& name : names) {
    if (only.empty() || only == name) good = cocoon::score_model(name, seeds, size) && good;
  }
  return good ? 0 : 1;
}
