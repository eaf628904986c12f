// Quality of reconstructions of known surfaces, ours beside CGAL's: one table of shapes, one of
// noise and outliers.
//
//   quality_bench [--points N] [--only WORD] [--pictures FILE]
//
// --only: models whose name contains WORD. --pictures: a page that shows the true surfaces and all
// results, in one HTML file. Distances are in units of the mean spacing of the
// samples.
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "bench/options.h"
#include "bench/picture_sheet.h"
#include "bench/quality_measures.h"
#include "bench/quality_models.h"
#include "bench/rivals/cgal_surfaces.h"
#include "bench/stopwatch.h"
#include "bench/thumbnail.h"
#include "bench/tidy_heap.h"
#include "cocone/reconstruct.h"
#include "cocone/robust_cocone.h"
#include "geom/box.h"
#include "io/mesh_file.h"

namespace cocoon::bench {
namespace {

constexpr int picture_size = 200;

struct Method {
  const char* name;
  std::function<TriangleMesh(Points)> run;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> all{
      {"ours, paper", [](Points p) { return reconstruct_tight(p, {.mode = Mode::paper}).mesh; }},
      {"ours", [](Points p) { return reconstruct_tight(p).mesh; }},
      {"ours, cavities",
       [](Points p) { return reconstruct_tight(p, {.keep_cavities = true}).mesh; }},
      {"ours, noise robust", [](Points p) { return reconstruct_robust(p).surface.mesh; }},
      {"CGAL advancing front", [](Points p) { return rivals::cgal_advancing_front(p).mesh; }},
      {"CGAL scale space", [](Points p) { return rivals::cgal_scale_space(p).mesh; }}};
  return all;
}

void print_header() {
  std::printf("%-34s %6s  %-21s %-6s %-8s %5s %5s %6s %6s %7s %6s %6s %6s\n", "model", "points",
              "method", "closed", "manifold", "parts", "genus", "mean", "rms", "max", "normal",
              "unused", "s");
}

std::string caption_of(const Quality& q) {
  if (q.triangles == 0) return "empty";
  char text[96];
  std::snprintf(text, sizeof text, "%s; parts %+td, genus %+td; largest distance %.2f",
                q.closed ? "closed" : "open", q.extra_components, q.extra_genus, q.max);
  return text;
}

// Pictures are made if there is a sheet for them.
void begin_row(PictureSheet* pictures, const QualityModel& model, const Box& frame) {
  if (pictures == nullptr) return;
  pictures->begin_row(model.name);
  pictures->add("true surface", thumbnail_bmp(model.truth, frame, picture_size),
                std::to_string(model.points.size()) + " points", true);
}

void add_picture(PictureSheet* pictures, const char* method, const TriangleMesh& mesh,
                 const Quality& q, const Box& frame) {
  if (pictures == nullptr) return;
  pictures->add(method, thumbnail_bmp(mesh, frame, picture_size), caption_of(q),
                q.closed && q.extra_components == 0 && q.extra_genus == 0);
}

void measure(const QualityModel& model, PictureSheet* pictures) {
  const Box frame = box_of(model.truth.points.span());
  begin_row(pictures, model, frame);
  for (const Method& method : methods()) {
    tidy_heap();
    const Stopwatch stopwatch;
    const TriangleMesh mesh = method.run(model.points);
    const double seconds = stopwatch.elapsed().processor;
    const Quality q = quality_of(mesh, model);
    std::printf("%-34s %6zu  %-21s %-6s %-8s %+5td %+5td %6.3f %6.3f %7.3f %6.1f %6zu %6.2f\n",
                model.name.c_str(), model.points.size(), method.name,
                q.triangles == 0 ? "empty"
                : q.closed       ? "yes"
                                 : "no",
                q.manifold ? "yes" : "no", q.extra_components, q.extra_genus, q.mean, q.rms, q.max,
                q.normal_deg, q.unused, seconds);
    std::fflush(stdout);
    add_picture(pictures, method.name, mesh, q, frame);
  }
}

struct Arguments {
  std::size_t points;
  std::string only;      // empty: all
  std::string pictures;  // empty: none
};

std::string percent(double fraction) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * fraction);
  return text;
}

// What noise is added to: the first two of the shapes, and real models.
std::vector<QualityModel> noise_models(std::vector<QualityModel> models, std::size_t count) {
  models.resize(2);
  for (const char* name : {"elephant", "anchor_dense"}) {
    const std::string file = std::string(COCOON_TEST_DATA) + "/models/" + name + ".off";
    models.push_back(sampled(name, read_mesh(file), 2 * count, 21));
  }
  return models;
}

void run(const Arguments& arguments) {
  const auto wanted = [&](const QualityModel& model) {
    return model.name.find(arguments.only) != std::string::npos;
  };
  PictureSheet sheet("Reconstructions of known surfaces");
  PictureSheet* const pictures = arguments.pictures.empty() ? nullptr : &sheet;
  std::puts("\nShapes");
  print_header();
  const std::vector<QualityModel> shapes = quality_models(arguments.points);
  for (const QualityModel& model : shapes) {
    if (wanted(model)) measure(model, pictures);
  }
  std::puts("\nNoise (deviation in units of the spacing) and outliers");
  print_header();
  for (const QualityModel& model : noise_models(shapes, arguments.points)) {
    for (const double noise : {0.0, 0.05, 0.1, 0.2, 0.5}) {
      QualityModel noisy = disturbed(model, noise, 0, 31);
      noisy.name += ", noise " + percent(noise);
      if (wanted(noisy)) measure(noisy, pictures);
    }
    QualityModel stray = disturbed(model, 0, 0.01, 32);
    stray.name += ", 1 % outliers";
    if (wanted(stray)) measure(stray, pictures);
  }
  if (pictures != nullptr) pictures->write(arguments.pictures);
}

}  // namespace
}  // namespace cocoon::bench

int main(int argc, char** argv) {
  cocoon::bench::Options options(argc, argv);
  const cocoon::bench::Arguments arguments{
      options.number("--points", 5000), options.text("--only", ""), options.text("--pictures", "")};
  options.require_no_rest();
  try {
    cocoon::bench::run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "quality_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
