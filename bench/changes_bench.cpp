// How often the update is right: random changes of random parts, scanned as scanners of several
// kinds would do it, with the truth known.
//
//   ./dev bench changes                   the table of bench/update_quality.md
//   --seeds N                             40 for each kind of scan
//   --first N                             the first seed, 1
//   --list yes                            a line for each case, too
//   --write DIR                           model, clouds, truth and result of each case as PLY files
//   --scan NUMBER                         one kind of scan only: its row, from 1 on
//   --least N                             exit code 1 if a smaller percentage of the well scanned
//                                         updates is right
//
// A result is right if it is a closed manifold with parts and handles of the truth, at most two
// spacings of the model from it both ways, and no vertex that stayed has moved. "scratch" is a
// reconstruction of the right samples of the model and all of the scan. "Well scanned" are updates
// where that is right, and every changed place has a sample within 1.5 spacings of the model.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "bench/changes/change_case.h"
#include "bench/options.h"
#include "cocone/reconstruct.h"
#include "io/mesh_file.h"
#include "io/point_file.h"
#include "ref/update_score.h"
#include "update/update_model.h"

namespace cocoon::bench {
namespace {

constexpr double reach = 2;          // of what is right, in spacings of the model
constexpr double largest_gap = 1.5;  // in a scan that is good: between changed places and samples

enum class Outcome { right, right_with_warning, wrong_with_warning, wrong, refused };

struct Judgement {
  Outcome outcome = Outcome::refused;
  bool scratch_is_right = false;
  double gap = 0;

  bool is_well_scanned() const { return scratch_is_right && gap <= largest_gap; }
};

// Updates by outcome.
struct Row {
  std::array<std::size_t, 5> all = {};
  std::array<std::size_t, 5> well_scanned = {};

  void add(const Judgement& judgement) {
    const auto outcome = static_cast<std::size_t>(judgement.outcome);
    ++all[outcome];
    if (judgement.is_well_scanned()) ++well_scanned[outcome];
  }
  void add(const Row& row) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k] += row.all[k];
      well_scanned[k] += row.well_scanned[k];
    }
  }
};

std::size_t sum(const std::array<std::size_t, 5>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

TriangleMesh from_scratch(const ChangeCase& example) {
  std::vector<Point> points = example.right;
  for (const std::vector<Point>& cloud : example.clouds) {
    points.insert(points.end(), cloud.begin(), cloud.end());
  }
  return reconstruct_tight(points).mesh;
}

void write_case(const std::filesystem::path& folder, const ChangeCase& example,
                const UpdateResult& result) {
  std::filesystem::create_directories(folder);
  write_mesh(folder / "model.ply", example.model);
  write_mesh(folder / "truth.ply", example.truth);
  if (!result.mesh.triangles.empty()) write_mesh(folder / "result.ply", result.mesh);
  for (std::size_t k = 0; k < example.clouds.size(); ++k) {
    write_points(folder / ("cloud" + std::to_string(k + 1) + ".ply"), example.clouds[k]);
  }
}

Outcome outcome_of(const UpdateResult& result, const ref::UpdateScore& score) {
  if (result.status != UpdateStatus::ok) return Outcome::refused;
  const bool is_right = score.right_topology() && score.moved == 0 && score.distance.max <= reach;
  if (result.warnings.empty()) return is_right ? Outcome::right : Outcome::wrong;
  return is_right ? Outcome::right_with_warning : Outcome::wrong_with_warning;
}

void print_case(const ChangeCase& example, const UpdateResult& result,
                const ref::UpdateScore& score, const Judgement& judgement) {
  constexpr const char* names[] = {"right", "right, warned", "wrong, warned", "WRONG", "refused"};
  const ScanSetting& s = example.setting;
  std::printf(
      "  %-13s scratch %d gap %4.1f  %s, %s; spacing %.2f margin %.1f ragged %.1f noise %.1f "
      "registration %.1f",
      names[static_cast<int>(judgement.outcome)], judgement.scratch_is_right ? 1 : 0, example.gap,
      example.part.c_str(), example.change.c_str(), s.spacing, s.margin, s.ragged, s.noise,
      s.registration);
  if (result.status == UpdateStatus::ok) {
    std::printf(
        "; parts %zu of %zu, genus %d of %d, Hausdorff %.1f, moved %zu, wrong %zu, gone %zu, both "
        "%zu\n",
        score.components, score.true_components, score.genus ? static_cast<int>(*score.genus) : -1,
        score.true_genus ? static_cast<int>(*score.true_genus) : -1, score.distance.max,
        score.moved, score.wrong, score.gone, score.wrong_and_gone);
  } else {
    std::printf("\n    %s\n", result.message.c_str());
  }
  for (const std::string& warning : result.warnings) std::printf("    %s\n", warning.c_str());
}

struct Printing {
  bool lists = false;
  std::filesystem::path folder;  // empty: nothing is written
};

Judgement judge(std::uint64_t seed, ScanKind kind, const Printing& printing) {
  const ChangeCase example = change_case(seed, kind);
  const UpdateResult result = update_model(example.model, example.clouds);
  const ref::UpdateScore score =
      ref::score_update(example.model, result, example.wrong, example.truth, {.samples = 20000});
  const Judgement judgement = {outcome_of(result, score),
                               is_right(from_scratch(example), example.truth, reach), example.gap};
  const std::string number =
      std::to_string(seed) + "-" + std::to_string(static_cast<int>(kind) + 1);
  if (printing.lists) {
    std::printf("%s", number.c_str());
    print_case(example, result, score, judgement);
  }
  if (!printing.folder.empty()) write_case(printing.folder / number, example, result);
  std::fflush(stdout);
  return judgement;
}

void print_row(const char* name, const Row& row) {
  std::printf("| %s |", name);
  for (const auto* counts : {&row.all, &row.well_scanned}) {
    std::printf(" %zu |", sum(*counts));
    for (const std::size_t count : *counts) std::printf(" %zu |", count);
  }
  std::printf("\n");
}

}  // namespace
}  // namespace cocoon::bench

int main(int argc, char** argv) {
  using namespace cocoon::bench;
  Options options(argc, argv);
  const std::size_t first = options.number("--first", 1);
  const std::size_t seeds = options.number("--seeds", 40);
  const std::size_t only = options.number("--scan", 0);
  const std::size_t least = options.number("--least", 0);
  const Printing printing = {options.text("--list", "no") == "yes", options.text("--write", "")};
  options.require_no_rest();
  if (only > std::size(scan_kinds)) options.fail("knows fewer kinds of scans");
  std::array<Row, std::size(scan_kinds)> rows;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (only != 0 && only != k + 1) continue;
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      rows[k].add(judge(seed, scan_kinds[k], printing));
    }
  }
  std::printf(
      "| scan | all | right | with a warning | wrong with a warning | wrong | refused | "
      "well scanned | right | with a warning | wrong with a warning | wrong | refused |\n"
      "| --- |%s\n",
      " ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
  Row total;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (only != 0 && only != k + 1) continue;
    print_row(name_of(scan_kinds[k]), rows[k]);
    total.add(rows[k]);
  }
  print_row("all", total);
  const std::size_t right = total.well_scanned[0] + total.well_scanned[1];
  return 100 * right >= least * sum(total.well_scanned) ? 0 : 1;
}
