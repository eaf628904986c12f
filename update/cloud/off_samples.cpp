#include "update/cloud/off_samples.h"

#include "geom/messages/require_size.h"
#include "update/model/sample_heights.h"

namespace cocoon {

std::vector<OffSample> outward_samples_off_model(const ModelIndex& model, Points samples,
                                                 std::span<const Outward> outward,
                                                 double distance) {
  if (!outward.empty()) {
    require_size("outward_samples_off_model", "normals of the samples", outward.size(),
                 samples.size());
  }
  std::vector<OffSample> off;
  for (const PointId p : ids_off_model(model, samples, distance)) {
    off.push_back({samples[p.index()], outward.empty() ? Outward{} : outward[p.index()]});
  }
  return off;
}

}  // namespace cocoon
