// The words of `cocoon check --require`: what may be asked of a mesh, each answered by the
// certificate of geom/mesh_check.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geom/mesh_check.h"
#include "geom/self_intersection.h"
#include "geom/triangle_mesh.h"

namespace cocoon::app {

// What the words are asked about.
struct Certificate {
  MeshReport report;
  // Of the file, which the reader has left out: naming a vertex twice; with fewer than three
  // corners.
  std::size_t repeated_vertex_faces = 0;
  std::size_t short_faces = 0;
  std::optional<SelfIntersections> self_intersections;  // none: not looked for
};

// All words, separated by commas.
std::string requirement_words();

// Throws UsageError for a word that is not one of them.
void require_known_words(const std::vector<std::string>& words);

// Whether a requirement needs the search for self-intersections.
bool needs_self_intersections(const std::vector<std::string>& words);

// One part sentence for each requirement that does not hold, with the count that says why, and
// where on the mesh if that is at a place: "not closed (12 open edges, ..., as near (1, 2, 3))".
// Empty: all hold.
std::vector<std::string> failed_requirements(const std::vector<std::string>& words,
                                             const Certificate& certificate,
                                             const TriangleMesh& mesh);

}  // namespace cocoon::app
