// Which vertices of the model go: those of what is replaced.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/ids.h"
#include "geom/point.h"
#include "update/choose_regions.h"
#include "update/cloud_rim.h"
#include "update/model/model_index.h"
#include "update/regions/scanned_vertices.h"
#include "update/segment_model.h"

namespace cocoon {

struct ReplaceOptions {
  // Kept model vertices closer to a cloud point than this share of the cloud's rim spacing are
  // dropped, too: where cloud and model overlap, the cloud wins. 0 = off, as in the paper.
  double thinning_distance = 0;
  ScannedOptions scanned;  // vertices at the very rim
  // Border vertices beside a partial loop go whatever side of it they are on if all regions around
  // their neighbors go.
  bool enclosed_go = true;
};

// Vertices of which more is known than regions and rims tell; each list ascending.
struct SaidVertices {
  std::span<const VertexId> go = {};    // those that would stay: scanned_again()
  std::span<const VertexId> stay = {};  // those that would go: unchanged_rest()
};

struct ReplacedVertices {
  std::vector<VertexId> removed;  // replaced, thinned out, or not used by a triangle; ascending

  std::size_t kept = 0;               // of all vertices of the model
  std::size_t replaced = 0;           // of all
  std::size_t border_kept = 0;        // of those without a group: they lie outside the rim
  std::size_t border_replaced = 0;    // of those without a group: they lie under the cloud
  std::size_t enclosed_replaced = 0;  // of border_replaced, by ReplaceOptions::enclosed_go
  std::size_t scanned_replaced = 0;   // replaced only because a sample is close to them
  std::size_t unscanned_kept = 0;     // kept only because no sample is close to them
  std::size_t overlooked = 0;         // replaced only because of SaidVertices::go
  std::size_t unchanged = 0;          // kept only because of SaidVertices::stay
  std::size_t thinned = 0;            // dropped by ReplaceOptions::thinning_distance
  std::size_t unused_vertices = 0;    // of the model: in no triangle
};

// The vertices of replaced groups. A vertex without a group goes if all regions around it go, and
// stays if all stay and no border is there: regions that were parted have no rim between them. Any
// other is replaced iff it lies on the cloud's side of the rim edge nearest to it; the rims are
// those that formed the border. So is a border vertex all of whose neighboring regions are kept
// although it lies under the cloud: then the cloud covers it without covering a facet. But what is
// left of a partial loop may lead into the midst of what goes, as at the mouth of a hole, with that
// on both sides: there vertices on the other side go, too. Of the vertices at the very rim those go
// that have been scanned anew (scanned_vertices.h); where no region goes there is nothing to
// replace, and none before the rim does.
// rims[c] belongs to clouds[c]. `said`: vertices that go or stay whatever the regions say.
// Errors: InputError for parts of another model, by their sizes, and for options out of range.
// Complexity: O(g log n) for the g vertices that are not in the midst of what stays, and n samples;
// with thinning O(n) for n vertices, and a search for each. Deterministic.
// Source: Woo & Dey 2005, section 3.4 ("the vertices in the region"; border vertices are open).
ReplacedVertices replaced_vertices(const ModelIndex& model, const Regions& regions,
                                   const RegionChoice& choice, std::span<const CloudRim> rims,
                                   std::span<const std::vector<Point>> clouds,
                                   const ReplaceOptions& options = {},
                                   const SaidVertices& said = {});

}  // namespace cocoon
