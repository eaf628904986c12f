#include "cocone/edge_components.h"

namespace cocoon {
namespace {

constexpr std::uint32_t unseen = 0xFFFFFFFFU;

// All that is connected with the first triangle becomes a component with this number.
EdgeComponent flood(const TriangleMesh& mesh, const LinkedSides& sides, TriangleId first,
                    std::uint32_t number, EdgeComponents& result) {
  EdgeComponent component;
  result.component_of[first] = number;
  std::vector<TriangleId> stack{first};
  while (!stack.empty()) {
    const TriangleId t = stack.back();
    stack.pop_back();
    ++component.triangles;
    component.turned += result.turned[t];
    for (SideId side = 3 * t.value; side < 3 * t.value + 3; ++side) {
      if (!sides.is_two_sided(side)) continue;
      const SideId other = sides.links[side];
      const TriangleId next(triangle_of_side(other));
      const bool disagree = ends_of_side(mesh, side)[0] == ends_of_side(mesh, other)[0];
      const auto turned = static_cast<std::uint8_t>(result.turned[t] ^ (disagree ? 1U : 0U));
      if (result.component_of[next] == unseen) {
        result.component_of[next] = number;
        result.turned[next] = turned;
        stack.push_back(next);
      } else if (result.turned[next] != turned) {
        component.is_contradictory = true;
      }
    }
  }
  return component;
}

}  // namespace

EdgeComponents edge_components(const TriangleMesh& mesh, const LinkedSides& sides) {
  EdgeComponents result;
  result.component_of = IdVector<TriangleId, std::uint32_t>(mesh.triangles.size(), unseen);
  result.turned = IdVector<TriangleId, std::uint8_t>(mesh.triangles.size(), 0);
  for (const TriangleId t : mesh.triangles.ids()) {
    if (result.component_of[t] != unseen) continue;
    const auto number = static_cast<std::uint32_t>(result.components.size());
    result.components.push_back(flood(mesh, sides, t, number, result));
  }
  return result;
}

}  // namespace cocoon
