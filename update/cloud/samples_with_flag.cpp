#include "update/cloud/samples_with_flag.h"

#include <cstddef>
#include <utility>

#include "geom/messages/require_size.h"

namespace cocoon {

std::vector<std::vector<Point>> samples_with_flag(const Replacement& replacement,
                                                  std::span<const JoinedCloud> joined,
                                                  std::span<const std::vector<Point>> clouds,
                                                  IdVector<PointId, std::uint8_t> flags) {
  require_size("samples_with_flag", "flags", flags.size(), replacement.points.size());
  require_size("samples_with_flag", "clouds", clouds.size(),
               replacement.point_of_cloud_point.size());
  std::vector<std::vector<Point>> samples(joined.size());
  for (std::size_t c = 0; c < joined.size(); ++c) {
    for (const std::size_t member : joined[c].members) {
      const IdVector<PointId, PointId>& position = replacement.point_of_cloud_point[member];
      for (const PointId k : position.ids()) {
        if (position[k].is_none()) continue;
        std::uint8_t& wanted = flags[position[k]];
        if (wanted != 0) samples[c].push_back(clouds[member][k.index()]);
        wanted = 0;
      }
    }
  }
  return samples;
}

std::vector<std::vector<Point>> unused_samples(const Replacement& replacement,
                                               const ReconstructResult& reconstruction,
                                               std::span<const JoinedCloud> joined,
                                               std::span<const std::vector<Point>> clouds) {
  if (reconstruction.unused_points == 0) return std::vector<std::vector<Point>>(joined.size());
  IdVector<PointId, std::uint8_t> unused(replacement.points.size(), 1);
  for (const PointId p : reconstruction.point_of_vertex) unused[p] = 0;
  return samples_with_flag(replacement, joined, clouds, std::move(unused));
}

}  // namespace cocoon
