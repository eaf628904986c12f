// The certificate of a surface, as reports and summaries show it.
#pragma once

#include <string>

#include "app/json_report.h"
#include "geom/mesh_check.h"
#include "geom/triangle_mesh.h"

namespace cocoon::app {

// The section "surface" of the JSON report.
void add_surface(JsonReport& report, const TriangleMesh& mesh, const MeshReport& certificate);

// "1022 vertices, 2040 triangles: closed, manifold, oriented, 1 component, genus 0"
std::string surface_summary(const MeshReport& certificate);

// 16 hexadecimal digits that depend on every bit of the mesh, to compare results across machines,
// thread counts and versions (over coordinates and triangles, word by word; not cryptographic).
std::string mesh_hash(const TriangleMesh& mesh);

}  // namespace cocoon::app
