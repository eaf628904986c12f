#include "app/surface_report.h"

#include <bit>
#include <cstdint>
#include <fmt/format.h>

#include "geom/counted.h"

namespace cocoon::app {

void add_surface(JsonReport& report, const TriangleMesh& mesh, const MeshReport& certificate) {
  report.set("surface/vertices", certificate.vertices);
  report.set("surface/triangles", certificate.triangles);
  report.set("surface/watertight", certificate.watertight);
  report.set("surface/edge_manifold", certificate.edge_manifold);
  report.set("surface/vertex_manifold", certificate.vertex_manifold);
  report.set("surface/oriented", certificate.oriented);
  report.set("surface/components", certificate.components);
  report.set("surface/euler", certificate.euler);
  if (certificate.genus) report.set("surface/genus", *certificate.genus);
  report.set("surface/open_edges", certificate.open_edges);
  report.set("surface/overfull_edges", certificate.overfull_edges);
  report.set("surface/pinched_vertices", certificate.pinched_vertices);
  report.set("surface/hash", mesh_hash(mesh));
}

std::string surface_summary(const MeshReport& certificate) {
  std::string text =
      fmt::format("{} vertices, {} triangles: ", certificate.used_vertices, certificate.triangles);
  text += certificate.watertight ? "closed" : counted(certificate.open_edges, "open edge");
  if (certificate.edge_manifold && certificate.vertex_manifold) {
    text += ", manifold";
  } else {
    text += fmt::format(", not manifold ({} with more than two triangles, {} pinched)",
                        counted(certificate.overfull_edges, "edge"), certificate.pinched_vertices);
  }
  text += certificate.oriented ? ", oriented" : ", not oriented";
  text += ", " + counted(certificate.components, "component");
  if (certificate.genus) text += fmt::format(", genus {}", *certificate.genus);
  return text;
}

std::string mesh_hash(const TriangleMesh& mesh) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto add = [&hash](std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) {
      hash ^= word >> shift & 0xFFU;
      hash *= 0x100000001B3U;
    }
  };
  for (const Point& p : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) add(std::bit_cast<std::uint64_t>(p[axis]));
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId vertex : triangle) add(vertex.value);
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace cocoon::app
