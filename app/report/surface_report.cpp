#include "app/report/surface_report.h"

#include <bit>
#include <cstdint>
#include <fmt/format.h>

#include "geom/messages/counted.h"
#include "geom/random/mixed_bits.h"

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
  std::uint64_t hash = 0;
  const auto add = [&hash](std::uint64_t word) {
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U;
    hash = (std::rotl(hash, 29) ^ word) * odd;
  };
  for (const Point& p : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) add(std::bit_cast<std::uint64_t>(p[axis]));
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId vertex : triangle) add(vertex.value);
  }
  return fmt::format("{:016x}", mixed_bits(hash));
}

}  // namespace cocoon::app
