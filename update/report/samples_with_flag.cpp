#include "update/report/samples_with_flag.h"

#include <cstddef>

namespace cocoon {

std::vector<std::vector<Point>> samples_with_flag(const Replacement& replacement,
                                                  std::span<const JoinedCloud> joined,
                                                  std::span<const std::vector<Point>> clouds,
                                                  IdVector<PointId, std::uint8_t> flags) {
  std::vector<std::vector<Point>> samples(joined.size());
  for (std::size_t c = 0; c < joined.size(); ++c) {
    for (const std::size_t member : joined[c].members) {
      const IdVector<PointId, PointId>& position = replacement.point_of_cloud_point[member];
      for (const PointId k : position.ids()) {
        std::uint8_t& wanted = flags[position[k]];
        if (wanted != 0) samples[c].push_back(clouds[member][k.index()]);
        wanted = 0;
      }
    }
  }
  return samples;
}

}  // namespace cocoon
