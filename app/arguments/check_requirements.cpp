#include "app/arguments/check_requirements.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "app/command_line.h"
#include "geom/messages/counted.h"
#include "geom/messages/place_name.h"

namespace cocoon::app {

namespace {

struct Requirement {
  const char* word;
  bool (*holds)(const Certificate&);
  std::string (*failure)(const Certificate&);
  // A vertex where it fails, if that is at a place.
  VertexId (*where)(const Certificate&, const TriangleMesh&) = nullptr;
};

// Counts that make a mesh fail, in words, and no others: an edge with four triangles does not leave
// it open.
std::string edges_failure(const Certificate& c) {
  if (c.report.edges == 0) return "no triangle has three different corners";
  return fmt::format("{}, {} with an odd number of triangles",
                     counted(c.report.open_edges, "open edge"),
                     counted(c.report.odd_edges - c.report.open_edges, "other"));
}

// Open edges are unbalanced, too, and none of the reasons.
std::string oriented_failure(const Certificate& c) {
  if (c.report.orientation_conflicts == 0) {
    return "edges with more than two triangles are not run through equally often both ways";
  }
  return counted(c.report.orientation_conflicts, "edge with two triangles in the same direction",
                 "edges with two triangles in the same direction");
}

std::string overfull_failure(const Certificate& c) {
  return counted(c.report.overfull_edges, "edge with more than two triangles",
                 "edges with more than two triangles");
}

std::string pinched_failure(const Certificate& c) {
  return counted(c.report.pinched_vertices, "pinched vertex", "pinched vertices");
}

std::string manifold_failure(const Certificate& c) {
  return overfull_failure(c) + ", " + pinched_failure(c);
}

std::string bad_triangles_failure(const Certificate& c) {
  return fmt::format(
      "triangles: {} with a repeated vertex, {} without area, {} repeated, {} with fewer corners",
      c.report.repeated_vertex_triangles + c.repeated_vertex_faces, c.report.zero_area_triangles,
      c.report.duplicate_triangles, c.short_faces);
}

std::size_t crossing_pairs(const Certificate& c) {
  return c.self_intersections ? c.self_intersections->count : 0;
}

VertexId first_of(const std::vector<VertexPair>& edges) {
  return edges.empty() ? VertexId() : edges.front()[0];
}

// Or an edge of three triangles, or five; not if there are edges of four, too, since it is not
// known which the examples are.
VertexId at_odd_edge(const Certificate& c, const TriangleMesh&) {
  if (c.report.open_edges > 0) return first_of(c.report.examples.open_edges);
  return c.report.overfull_edges == c.report.odd_edges ? first_of(c.report.examples.overfull_edges)
                                                       : VertexId();
}

VertexId at_overfull_edge(const Certificate& c, const TriangleMesh&) {
  return first_of(c.report.examples.overfull_edges);
}

VertexId at_pinched_vertex(const Certificate& c, const TriangleMesh&) {
  const std::vector<VertexId>& pinched = c.report.examples.pinched_vertices;
  return pinched.empty() ? VertexId() : pinched.front();
}

VertexId at_contact(const Certificate& c, const TriangleMesh& mesh) {
  return c.report.edge_manifold ? at_pinched_vertex(c, mesh) : at_overfull_edge(c, mesh);
}

VertexId at_conflict(const Certificate& c, const TriangleMesh&) {
  return first_of(c.report.examples.orientation_conflicts);
}

VertexId at_bad_triangle(const Certificate& c, const TriangleMesh& mesh) {
  const MeshExamples& e = c.report.examples;
  for (const auto* bad :
       {&e.repeated_vertex_triangles, &e.zero_area_triangles, &e.duplicate_triangles}) {
    if (!bad->empty()) return mesh.triangles[bad->front()][0];
  }
  return {};
}

VertexId at_crossing(const Certificate& c, const TriangleMesh& mesh) {
  if (crossing_pairs(c) == 0) return {};
  return mesh.triangles[c.self_intersections->pairs.front()[0]][0];
}

const Requirement requirements[] = {
    {"closed", [](const Certificate& c) { return c.report.watertight; }, edges_failure,
     at_odd_edge},
    {"watertight", [](const Certificate& c) { return c.report.watertight; }, edges_failure,
     at_odd_edge},
    {"manifold",
     [](const Certificate& c) { return c.report.edge_manifold && c.report.vertex_manifold; },
     manifold_failure, at_contact},
    {"edge-manifold", [](const Certificate& c) { return c.report.edge_manifold; }, overfull_failure,
     at_overfull_edge},
    {"vertex-manifold", [](const Certificate& c) { return c.report.vertex_manifold; },
     pinched_failure, at_pinched_vertex},
    {"oriented", [](const Certificate& c) { return c.report.oriented; }, oriented_failure,
     at_conflict},
    {"orientable", [](const Certificate& c) { return c.report.orientable; },
     [](const Certificate&) { return std::string("a component is one-sided"); }},
    {"connected", [](const Certificate& c) { return c.report.components == 1; },
     [](const Certificate& c) { return counted(c.report.components, "component"); }},
    {"no-bad-triangles",
     [](const Certificate& c) {
       return c.report.repeated_vertex_triangles + c.repeated_vertex_faces + c.short_faces +
                  c.report.zero_area_triangles + c.report.duplicate_triangles ==
              0;
     },
     bad_triangles_failure, at_bad_triangle},
    {"no-unused-vertices", [](const Certificate& c) { return c.report.unused_vertices == 0; },
     [](const Certificate& c) {
       return counted(c.report.unused_vertices, "vertex without a triangle",
                      "vertices without a triangle");
     }},
    {"no-self-intersections", [](const Certificate& c) { return crossing_pairs(c) == 0; },
     [](const Certificate& c) {
       return counted(crossing_pairs(c), "pair of triangles crosses", "pairs of triangles cross");
     },
     at_crossing},
};

const Requirement* find_requirement(const std::string& word) {
  const auto* const found =
      std::find_if(std::begin(requirements), std::end(requirements),
                   [&](const Requirement& requirement) { return requirement.word == word; });
  return found == std::end(requirements) ? nullptr : found;
}

}  // namespace

std::string requirement_words() {
  std::string words;
  for (const Requirement& requirement : requirements) {
    words += (words.empty() ? "" : ", ") + std::string(requirement.word);
  }
  return words;
}

void require_known_words(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (find_requirement(word) == nullptr) {
      throw UsageError(fmt::format("--require: '{}' is none of {}", word, requirement_words()));
    }
  }
}

bool needs_self_intersections(const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), "no-self-intersections") != words.end();
}

std::vector<std::string> failed_requirements(const std::vector<std::string>& words,
                                             const Certificate& certificate,
                                             const TriangleMesh& mesh) {
  std::vector<std::string> failures;
  for (const std::string& word : words) {
    const Requirement* const requirement = find_requirement(word);
    if (requirement == nullptr || requirement->holds(certificate)) continue;
    const bool negative = word.rfind("no-", 0) == 0;
    const VertexId at =
        requirement->where == nullptr ? VertexId() : requirement->where(certificate, mesh);
    const std::string place = at.is_none() ? "" : ", as near " + place_name(mesh.points[at]);
    failures.push_back(fmt::format("{} {} ({}{})", negative ? "fails" : "not", word,
                                   requirement->failure(certificate), place));
  }
  return failures;
}

}  // namespace cocoon::app
