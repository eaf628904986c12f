// Handles of an updated model that the parts in whose place its clouds are do not explain.
#pragma once

#include <cstddef>
#include <span>

namespace cocoon {

struct HandleOptions {
  // A handle of the samples' own surface is no mistake if the way around it is longer than this
  // many spacings of the coarsest cloud: webs and tunnels at torn places are narrower.
  double wide = 6;
};

// What a cloud put into the model.
struct SewnPatch {
  std::size_t rims = 0;   // loops of its rim on the model
  std::size_t parts = 0;  // replaced groups under it
};

// A sphere with holes that is sewn into the model in the place of m parts of it, disks or other
// spheres with holes, lowers the Euler number by 2 (m - 1): it adds m - 1 handles, or joins what
// was apart. A drilled hole, in the place of a disk at each mouth, is one handle more; a tube in
// the place of a tube is none. So what an update adds beyond that are handles of the scans
// themselves, or wrong ones; or a part is there whose rim was not found, as where a scan is torn at
// a sharp edge. Parts are those of each patch and mouths with no group inside
// (`empty_loops`, of all clouds: RegionChoice::undecided_loops), but of no cloud, nor of all, more
// than there are loops: a border that touches itself encloses slivers of the model. `before` and
// `after`: Euler numbers of the models, `after` without loose parts, each of them taken for a
// sphere. Complexity: O(patches). Source: ours.
std::size_t unexplained_handles(std::span<const SewnPatch> patches, std::size_t empty_loops,
                                std::ptrdiff_t before, std::ptrdiff_t after);

}  // namespace cocoon
