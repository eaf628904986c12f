// Table 1 of Woo & Dey 2005: the four columns of the local update, for all of the paper's models
// that there are, three times: the paper's seconds (Pentium IV, 1.6 GHz), those of the same steps
// written plainly with CGAL (ref/cgal_update.h), and ours; the latter two in this run, on one
// thread each; ours on all threads, too.
//
//   paper_bench [--repetitions R] [--points N] [--cloud-points N] [MODEL ...]
//
// R (3) repetitions of all, each time another one first; medians of processor time, with all
// threads of time by the clock. A column frees what its step worked with, on both sides (some
// thousandths of it), and not the surface. "whole" is the sum of the columns, for ours with what is
// between them.
//
// Compared after that: our update must succeed, with all threads give the same surface, and replace
// as many points as CGAL's, but for those at the border (1 % of the model); both surfaces must be
// closed, and have 98 % of their triangles in common. Else exit code 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "bench/common_triangles.h"
#include "bench/options.h"
#include "bench/stage_times.h"
#include "bench/stopwatch.h"
#include "bench/tidy_heap.h"
#include "cocone/reconstruct.h"
#include "geom/arrays/median.h"
#include "geom/execution.h"
#include "geom/mesh_check.h"
#include "io/sample_models.h"
#include "ref/cgal_update.h"
#include "update/update_model.h"

namespace cocoon {
namespace {

constexpr std::array<const char*, 4> columns = {"boundary_detection", "overlapping_facets",
                                                "segmentation_and_selection", "reconstruction"};
// Those of the table, then the whole.
using Columns = std::array<double, 5>;

Columns with_sum(const std::array<double, 4>& seconds) {
  Columns result = {};
  for (std::size_t c = 0; c < 4; ++c) {
    result[c] = seconds[c];
    result[4] += seconds[c];
  }
  return result;
}

struct Ours {
  Columns seconds = {};
  double cloud_delaunay = 0;
  double model_delaunay = 0;
  UpdateResult result;
};

Ours run_ours(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds,
              int threads) {
  const auto time = threads == 1 ? &bench::Elapsed::processor : &bench::Elapsed::wall;
  bench::StageTimes clock(time);
  Ours ours;
  const bench::Stopwatch whole;
  ours.result = update_model(model, clouds, {}, {.threads = threads, .progress = &clock});
  ours.seconds[4] = whole.elapsed().*time;
  for (std::size_t c = 0; c < 4; ++c) ours.seconds[c] = clock.seconds(columns[c]);
  ours.cloud_delaunay = clock.seconds("boundary_detection/delaunay");
  ours.model_delaunay = clock.seconds("reconstruction/delaunay");
  return ours;
}

// By model, as the file has them.
std::map<std::string, Columns> papers_table() {
  std::ifstream file(COCOON_TABLE1);
  std::map<std::string, Columns> table;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("model,", 0) == 0) continue;
    std::istringstream cells(line);
    std::string name;
    std::getline(cells, name, ',');
    std::array<double, 4> papers;
    for (double& seconds : papers) {
      std::string cell;
      std::getline(cells, cell, ',');
      seconds = std::stod(cell);
    }
    table[name] = with_sum(papers);
  }
  return table;
}

Columns medians(const std::vector<Columns>& runs) {
  Columns result;
  for (std::size_t c = 0; c < result.size(); ++c) {
    std::vector<double> values;
    values.reserve(runs.size());
    for (const Columns& run : runs) values.push_back(run[c]);
    result[c] = median(values);
  }
  return result;
}

void print_row(const char* model, const char* who, const Columns& values, const char* format) {
  std::printf("%-12s %-18s", model, who);
  for (const double value : values) std::printf(format, value);
  std::printf("\n");
}

Columns divided(const Columns& a, const Columns& b) {
  Columns result;
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = a[c] / b[c];
  return result;
}

// What a column costs beyond the triangulation of its own data, as a share of that triangulation:
// of the clouds for the first three columns, of the updated points for the last, of both for all.
Columns beyond_delaunay(const Ours& ours) {
  const double clouds = ours.cloud_delaunay;
  const double updated = ours.model_delaunay;
  return {(ours.seconds[0] - clouds) / clouds, ours.seconds[1] / clouds, ours.seconds[2] / clouds,
          (ours.seconds[3] - updated) / updated,
          (ours.seconds[4] - clouds - updated) / (clouds + updated)};
}

struct Arguments {
  std::size_t repetitions = 3;
  SampleOptions sample;
  std::vector<std::string> models;
};

// Prints what both did; whether it is the same work, as the head of this file says.
bool agree(const Ours& ours, const TriangleMesh& threaded, const ref::CgalUpdate& cgal,
           std::size_t points) {
  const TriangleMesh& mesh = ours.result.mesh;
  std::size_t rim = 0;
  for (const CloudReport& cloud : ours.result.clouds) rim += cloud.boundary_points;
  const std::size_t replaced = ours.result.replacement.vertices.replaced;
  const std::size_t common = bench::common_triangles(mesh, cgal.mesh);
  std::printf(
      "%-12s %zu points; ours / CGAL: %zu / %zu rim points, %zu / %zu replaced, %zu / %zu "
      "triangles, %zu in common\n",
      "", points, rim, cgal.rim_points, replaced, cgal.replaced.size(), mesh.triangles.size(),
      cgal.mesh.triangles.size(), common);
  const double difference =
      std::abs(static_cast<double>(replaced) - static_cast<double>(cgal.replaced.size()));
  const auto require = [](bool holds, const char* what) {
    if (!holds) std::fprintf(stderr, "paper_bench: %s\n", what);
    return holds;
  };
  bool good = require(ours.result.status == UpdateStatus::ok, "our update was refused");
  good = require(mesh_check(mesh).balanced, "our surface is not closed") && good;
  good = require(mesh_check(cgal.mesh).balanced, "CGAL's surface is not closed") && good;
  good = require(mesh == threaded, "ours with all threads is another surface") && good;
  good = require(difference <= 0.01 * static_cast<double>(points), "other points are replaced") &&
         good;
  return require(static_cast<double>(common) >= 0.98 * static_cast<double>(mesh.triangles.size()),
                 "other triangles") &&
         good;
}

// Whether both programs agree.
bool run_model(const std::string& name, const Arguments& arguments,
               const std::map<std::string, Columns>& paper) {
  const SampleModel sample = sample_model(name, arguments.sample);
  const TriangleMesh model = reconstruct_tight(sample.initial).mesh;
  std::vector<Columns> our_runs;
  std::vector<Columns> threaded_runs;
  std::vector<Columns> cgal_runs;
  std::vector<Columns> shares;
  Ours ours;
  Ours threaded;
  ref::CgalUpdate cgal;
  const std::array<std::function<void()>, 3> programs = {
      [&] {
        threaded = run_ours(model, sample.clouds, 0);
        threaded_runs.push_back(threaded.seconds);
      },
      [&] {
        ours = run_ours(model, sample.clouds, 1);
        our_runs.push_back(ours.seconds);
        shares.push_back(beyond_delaunay(ours));
      },
      [&] {
        cgal = ref::cgal_update(model, sample.clouds);
        cgal_runs.push_back(with_sum(cgal.seconds));
      }};
  for (std::size_t run = 0; run < 3 * arguments.repetitions; ++run) {
    bench::tidy_heap();
    programs[(run + run / 3) % 3]();
  }
  const Columns our_seconds = medians(our_runs);
  const Columns cgal_seconds = medians(cgal_runs);
  const bool papers_size = !arguments.sample.points && !arguments.sample.cloud_points;
  if (const auto found = paper.find(name); found != paper.end() && papers_size) {
    print_row(name.c_str(), "paper", found->second, "%12.2f");
    print_row("", "  / ours", divided(found->second, our_seconds), "%11.0fx");
  }
  print_row(name.c_str(), "CGAL", cgal_seconds, "%12.4f");
  print_row(name.c_str(), "ours", our_seconds, "%12.4f");
  print_row("", "  CGAL / ours", divided(cgal_seconds, our_seconds), "%11.1fx");
  print_row("", "  over Delaunay", medians(shares), "%12.2f");
  const Columns threaded_seconds = medians(threaded_runs);
  print_row("", "ours, all threads", threaded_seconds, "%12.4f");
  print_row("", "  CGAL / ours", divided(cgal_seconds, threaded_seconds), "%11.1fx");
  return agree(ours, threaded.result.mesh, cgal, sample.initial.size());
}

Arguments parse(int argc, char** argv) {
  bench::Options options(argc, argv);
  Arguments arguments;
  arguments.repetitions = std::max<std::size_t>(1, options.number("--repetitions", 3));
  const auto count = [&](const char* name) {
    const std::string text = options.text(name, "");
    return text.empty() ? std::nullopt : std::optional(options.as_number(text));
  };
  arguments.sample.points = count("--points");
  arguments.sample.cloud_points = count("--cloud-points");
  const std::vector<std::string> names = sample_model_names();
  arguments.models = options.rest().empty() ? names : options.rest();
  for (const std::string& name : arguments.models) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      options.fail("no model '" + name + "'");
    }
  }
  return arguments;
}

}  // namespace
}  // namespace cocoon

int main(int argc, char** argv) {
  using namespace cocoon;
  const Arguments arguments = parse(argc, argv);
  const auto paper = papers_table();
  std::printf(
      "Seconds of processor time, one thread, medians of %zu. \"over Delaunay\": what is not\n"
      "the triangulation of the column's own data, as a share of that triangulation. \"all\n"
      "threads\": %d, seconds by the clock; CGAL's are those of processor time there, too.\n\n",
      arguments.repetitions, thread_count({.threads = 0}));
  std::printf("%-12s %-18s%12s%12s%12s%12s%12s\n", "model", "", "boundary", "overlapping",
              "segment,", "reconstruct", "whole");
  std::printf("%-12s %-18s%12s%12s%12s\n", "", "", "detection", "facets", "select");
  bool good = true;
  for (const std::string& name : arguments.models) good = run_model(name, arguments, paper) && good;
  if (!good) std::printf("the two updates do not agree\n");
  return good ? 0 : 1;
}
