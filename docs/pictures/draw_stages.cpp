// Draws the pictures of docs/cocone.md: the stages run on two scans, and a plane cuts what they
// find.
//   draw_stages FOLDER           writes the pictures to FOLDER
//   draw_stages --check FOLDER   exit code 1 if those in FOLDER are others
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cocone/boundary_samples.h"
#include "cocone/candidate_triangles.h"
#include "cocone/clean_up_cells.h"
#include "cocone/cocones.h"
#include "cocone/extract_manifold.h"
#include "cocone/mark_cells.h"
#include "cocone/peel_cells.h"
#include "cocone/poles.h"
#include "cocone/prune_sharp_edges.h"
#include "delaunay/delaunay.h"
#include "delaunay/vertex_stars.h"
#include "delaunay/voronoi_dual.h"
#include "docs/pictures/plane_section.h"
#include "docs/pictures/scans.h"
#include "docs/pictures/svg_canvas.h"
#include "io/atomic_file.h"

namespace cocoon::pictures {
namespace {

const std::string outside = "#d9e8f6";
const std::string inside = "#fbe2bd";
const std::string unknown = "#dcdcdc";
const std::string surface_color = "#1f4e8c";
const std::string alert = "#c0392b";
const std::string pale_alert = "#f6d5d0";
const std::string changed = "#8cc08a";
const std::string behind = "#e08a2c";
const std::string cocone_color = "#f6c78b";
const std::string voronoi = "#7d9cc0";
const std::string grid = "#b8b8b8";
const std::string ink = "#222";

// What the stages make of a scan, each from those before it.
struct Stages {
  explicit Stages(const std::vector<Point>& scan) : cells(delaunay(scan).triangulation) {}

  Triangulation cells;
  VertexStars stars = vertex_stars(cells);
  Dual dual = voronoi_dual(cells);
  Poles poles = compute_poles(cells, dual);
  Cocones cocones = intersect_cocones(cells, dual, poles);
  BoundarySamples boundary = boundary_samples(cells, dual, poles, cocones);
  FacetSet candidates = candidate_triangles(cells, cocones, boundary.boundary);
  PrunedCandidates pruned = prune_sharp_edges(cells, candidates);
  FacetSet unpruned = pruned.left.set;
  ManifoldSurface surface = extract_manifold(cells, std::move(pruned.left), pruned.umbrella);
  CellMarks marked = mark_cells(cells, surface.triangles, boundary.boundary);
  CellMarks peeled = peel_cells(cells, surface.triangles.set, marked);
  CellMarks cleaned = clean_up();

 private:
  CellMarks clean_up() const {
    CellMarks marks = peeled;
    clean_up_cells(cells, poles, marks);
    return marks;
  }
};

constexpr double far = 8;  // beyond all frames
constexpr Frame whole{{0.22, -0.02}, 165, 640, 390};
constexpr Frame edge{{0.42, 0.08}, 580, 640, 400};

Planar flat(const Point& p) { return {p.x, p.y}; }

// Those that the section shows.
std::vector<VertexId> samples_in_plane(const Stages& s) {
  std::vector<VertexId> found;
  for (const VertexId v : s.cells.vertices()) {
    if (s.cells.point(v).z == 0) found.push_back(v);
  }
  return found;
}

VertexId sample_nearest(const Stages& s, Planar place) {
  VertexId nearest;
  double least = 0;
  for (const VertexId v : samples_in_plane(s)) {
    const Planar way = flat(s.cells.point(v)) - place;
    if (!nearest.is_none() && dot(way, way) >= least) continue;
    nearest = v;
    least = dot(way, way);
  }
  return nearest;
}

void draw_samples(SvgCanvas& canvas, const Stages& s, double radius = 2.2) {
  for (const VertexId v : samples_in_plane(s)) {
    canvas.dot(flat(s.cells.point(v)), radius, {.fill = ink});
  }
}

// Those for which is_marked(sample) in another color, and larger.
void draw_two_kinds(SvgCanvas& canvas, const Stages& s,
                    const std::function<bool(VertexId)>& is_marked) {
  for (const VertexId v : samples_in_plane(s)) {
    const bool marked = is_marked(v);
    canvas.dot(flat(s.cells.point(v)), marked ? 3.4 : 2.2, {.fill = marked ? alert : ink});
  }
}

void draw_voronoi_cell(SvgCanvas& canvas, const Stages& s, VertexId v, const std::string& fill,
                       double width) {
  canvas.polygon(section_of_voronoi_cell(s.cells, s.stars, v, far),
                 {.fill = fill, .stroke = voronoi, .width = width});
}

// Fills all cells by the color that color_of(cell) names.
void draw_cells(SvgCanvas& canvas, const Stages& s,
                const std::function<std::string(CellId)>& color_of) {
  for (const CellId c : s.cells.finite_cells()) {
    const std::vector<Planar> polygon = section_of_cell(s.cells, c);
    if (polygon.empty()) continue;
    canvas.polygon(polygon, {.fill = color_of(c), .stroke = grid, .width = 0.4});
  }
}

void draw_facet(SvgCanvas& canvas, const Stages& s, FacetId f, const Style& style) {
  const auto stretch = section_of_facet(s.cells, f);
  if (stretch) canvas.line(stretch->first, stretch->second, style);
}

void draw_facets(SvgCanvas& canvas, const Stages& s, const FacetSet& facets, const Style& style) {
  facets.for_each(s.cells, [&](FacetId f) { draw_facet(canvas, s, f, style); });
}

double area(std::span<const Planar> polygon) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Planar a = polygon[k - 1] - polygon[0];
    const Planar b = polygon[k] - polygon[0];
    sum += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return sum;
}

// Of the cells whose centers are near the middle of the body that with the largest section.
CellId largest_inside(const Stages& s) {
  CellId largest;
  double most = 0;
  for (const CellId c : s.cells.finite_cells()) {
    const double found = norm(s.dual.centers[c]) > 0.3 ? 0 : area(section_of_cell(s.cells, c));
    if (found <= most) continue;
    most = found;
    largest = c;
  }
  return largest;
}

std::string draw_triangulation(const Stages& s) {
  SvgCanvas canvas(whole);
  draw_cells(canvas, s, [](CellId) { return "white"; });
  const CellId largest = largest_inside(s);
  const Point& center = s.dual.centers[largest];
  const double squared_radius = squared_distance(center, s.cells.point(s.cells.vertex(largest, 0)));
  canvas.polygon(section_of_cell(s.cells, largest), {.fill = inside, .stroke = grid});
  canvas.circle(flat(center), std::sqrt(squared_radius - center.z * center.z),
                {.stroke = alert, .width = 1.5, .dashed = true});
  canvas.polygon(outline_of_body(), {.stroke = surface_color, .width = 1.2, .dashed = true});
  draw_samples(canvas, s);
  return canvas.finish({{ink, "samples in the plane"},
                        {surface_color, "the body (nobody knows it)"},
                        {inside, "a cell"},
                        {alert, "its ball: no sample inside"}});
}

std::string draw_poles(const Stages& s) {
  SvgCanvas canvas(whole);
  const VertexId chosen = sample_nearest(s, {-0.55, 0.95});
  for (const VertexId v : samples_in_plane(s)) {
    draw_voronoi_cell(canvas, s, v, v == chosen ? outside : "none", 0.7);
  }
  for (const VertexId v : samples_in_plane(s)) {
    const Planar p = flat(s.cells.point(v));
    const Planar normal = 0.07 * flat(s.poles.normals[v]);
    canvas.line(p - normal, p + normal, {.stroke = alert, .width = 1.6});
  }
  const Point& p = s.cells.point(chosen);
  const Vec3& normal = s.poles.normals[chosen];
  const Planar lower = flat(p - s.poles.heights[chosen] * normal);
  canvas.arrow(flat(p), flat(p + 0.42 * normal), alert);
  canvas.line(flat(p), lower, {.stroke = alert, .width = 1.2, .dashed = true});
  canvas.text(flat(p + 0.42 * normal) + Planar{0.04, 0}, "n_p, to p+", alert);
  canvas.text(lower + Planar{0.04, -0.03}, "h_p, to p-", alert);
  draw_samples(canvas, s);
  return canvas.finish({{"white", "Voronoi cells, cut by the plane"},
                        {outside, "that of p"},
                        {alert, "normals n_p, seen from above the plane"}});
}

std::string draw_cocones(const Stages& s) {
  const VertexId chosen = sample_nearest(s, {-0.55, 0.95});
  const Point& p = s.cells.point(chosen);
  SvgCanvas canvas({flat(p), 900, 640, 360});
  for (const VertexId v : samples_in_plane(s)) {
    draw_voronoi_cell(canvas, s, v, v == chosen ? outside : "none", 0.8);
  }
  // In the plane the directions m + t tangent with |t| >= slope make the cocone.
  const Vec3& normal = s.poles.normals[chosen];
  const double in_plane = std::hypot(normal.x, normal.y);
  const Planar m{normal.x / in_plane, normal.y / in_plane};
  const double cosine = s.cocones.cosine / in_plane;
  const double slope = cosine / std::sqrt(1 - cosine * cosine);
  const std::vector<Planar> cell = section_of_voronoi_cell(s.cells, s.stars, chosen, far);
  for (const Planar tangent : {Planar{-m.y, m.x}, Planar{m.y, -m.x}}) {
    const Planar upper = m - slope * tangent;
    const Planar lower = -1.0 * m - slope * tangent;
    const std::vector<Planar> half = clipped(cell, upper, dot(upper, flat(p)));
    canvas.polygon(clipped(half, lower, dot(lower, flat(p))), {.fill = cocone_color});
  }
  draw_facets(canvas, s, s.candidates, {.stroke = surface_color, .width = 2});
  canvas.arrow(flat(p), flat(p) + 0.15 * m, alert);
  canvas.text(flat(p) + 0.15 * m + Planar{0.008, -0.005}, "n_p", alert);
  draw_samples(canvas, s, 4);
  canvas.text(flat(p) + Planar{0.012, -0.022}, "p");
  return canvas.finish({{outside, "Voronoi cell of p"},
                        {cocone_color, "cocone of p"},
                        {surface_color, "triangles whose dual edges meet cocones"}});
}

std::string draw_boundary_samples(const Stages& s) {
  SvgCanvas canvas(whole);
  for (const bool boundary : {false, true}) {
    for (const VertexId v : samples_in_plane(s)) {
      if ((s.boundary.boundary[v] != 0) != boundary) continue;
      draw_voronoi_cell(canvas, s, v, boundary ? pale_alert : "none", 0.7);
    }
  }
  draw_two_kinds(canvas, s, [&](VertexId v) { return s.boundary.boundary[v] != 0; });
  return canvas.finish({{ink, "interior samples"},
                        {alert, "boundary samples"},
                        {pale_alert, "their Voronoi cells"}});
}

std::string draw_candidates(const Stages& s) {
  SvgCanvas canvas(whole);
  draw_cells(canvas, s, [](CellId) { return "white"; });
  draw_facets(canvas, s, s.candidates, {.stroke = surface_color, .width = 2});
  draw_samples(canvas, s);
  return canvas.finish(
      {{surface_color, "candidate triangles"}, {"white", "other cells and facets"}});
}

// Of `all` facets those that are in `kept`, too, and the others.
void draw_choice(SvgCanvas& canvas, const Stages& s, const FacetSet& all, const FacetSet& kept,
                 const std::string& color_of_others) {
  draw_cells(canvas, s, [](CellId) { return "white"; });
  for (const bool is_kept : {false, true}) {
    all.for_each(s.cells, [&](FacetId f) {
      if (kept.contains(f) != is_kept) return;
      draw_facet(canvas, s, f, {.stroke = is_kept ? surface_color : color_of_others, .width = 2.4});
    });
  }
  draw_samples(canvas, s);
}

std::string draw_pruning(const Stages& s) {
  SvgCanvas canvas(edge);
  draw_choice(canvas, s, s.candidates, s.unpruned, alert);
  return canvas.finish(
      {{surface_color, "candidates at a sharp, noisy edge"}, {alert, "those that are pruned"}});
}

std::string draw_extraction(const Stages& s) {
  SvgCanvas canvas(edge);
  draw_choice(canvas, s, s.unpruned, s.surface.triangles.set, behind);
  return canvas.finish({{surface_color, "the outermost sheet: the Cocone surface"},
                        {behind, "candidates behind it"}});
}

std::string draw_marks(const Stages& s) {
  SvgCanvas canvas(whole);
  draw_cells(canvas, s, [&](CellId c) {
    if (s.marked.labels[c] == CellLabel::unmarked) return unknown;
    return s.marked.labels[c] == CellLabel::out ? outside : inside;
  });
  draw_facets(canvas, s, s.surface.triangles.set, {.stroke = surface_color, .width = 2});
  draw_two_kinds(canvas, s, [&](VertexId v) { return s.marked.good[v] == 0; });
  return canvas.finish({{outside, "marked outside"},
                        {inside, "marked inside"},
                        {unknown, "not marked"},
                        {ink, "good samples"},
                        {alert, "poor ones"}});
}

// The boundary of the body; what of it is no triangle of the Cocone surface in another color.
void draw_closed_surface(SvgCanvas& canvas, const Stages& s, const CellMarks& marks) {
  for (const CellId c : s.cells.finite_cells()) {
    if (marks.reached[c] != 0) continue;
    for (int i = 0; i < 4; ++i) {
      if (marks.reached[s.cells.neighbor(c, i)] == 0) continue;
      const FacetId f = facet_id(c, i);
      const bool known = s.surface.triangles.set.contains(f);
      draw_facet(canvas, s, f, {.stroke = known ? surface_color : alert, .width = 2.2});
    }
  }
}

std::string draw_peel(const Stages& s) {
  SvgCanvas canvas(whole);
  draw_cells(canvas, s, [&](CellId c) { return s.peeled.reached[c] != 0 ? outside : inside; });
  draw_closed_surface(canvas, s, s.peeled);
  draw_samples(canvas, s);
  return canvas.finish({{outside, "removed from outside"},
                        {inside, "the body that is left"},
                        {surface_color, "Cocone surface"},
                        {alert, "triangles that close it"}});
}

std::string draw_clean_up(const Stages& s) {
  SvgCanvas canvas(whole);
  draw_cells(canvas, s, [&](CellId c) {
    const bool out = s.cleaned.reached[c] != 0;
    if (out != (s.peeled.reached[c] != 0)) return changed;
    return out ? outside : inside;
  });
  draw_closed_surface(canvas, s, s.cleaned);
  draw_samples(canvas, s);
  return canvas.finish({{changed, "cells that changed sides"},
                        {surface_color, "Cocone surface"},
                        {alert, "other triangles of the result"}});
}

std::map<std::string, std::string> draw_all() {
  const Stages body(scan_of_body());
  const Stages bar(scan_of_edge());
  return {{"triangulation.svg", draw_triangulation(body)},
          {"poles.svg", draw_poles(body)},
          {"cocones.svg", draw_cocones(body)},
          {"boundary_samples.svg", draw_boundary_samples(body)},
          {"candidate_triangles.svg", draw_candidates(body)},
          {"pruning.svg", draw_pruning(bar)},
          {"extraction.svg", draw_extraction(bar)},
          {"marks.svg", draw_marks(body)},
          {"peel.svg", draw_peel(body)},
          {"clean_up.svg", draw_clean_up(body)}};
}

bool is_current(const std::string& file, const std::string& content) {
  std::ifstream stream(file, std::ios::binary);
  const std::string found{std::istreambuf_iterator<char>(stream), {}};
  if (found == content) return true;
  std::fprintf(stderr, "draw_stages: %s is not what the stages give; run ./dev pictures\n",
               file.c_str());
  return false;
}

int run(bool check, const std::string& folder) {
  bool all_current = true;
  for (const auto& [name, content] : draw_all()) {
    const std::string file = std::filesystem::path(folder) / name;
    if (check) {
      all_current = is_current(file, content) && all_current;
    } else {
      write_file(file, content);
    }
  }
  return all_current ? 0 : 1;
}

}  // namespace
}  // namespace cocoon::pictures

int main(int argc, char** argv) {
  const bool check = argc == 3 && std::string(argv[1]) == "--check";
  if (argc != 2 && !check) {
    std::fprintf(stderr, "usage: draw_stages [--check] FOLDER\n");
    return 2;
  }
  try {
    return cocoon::pictures::run(check, argv[argc - 1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_stages: %s\n", error.what());
    return 2;
  }
}
