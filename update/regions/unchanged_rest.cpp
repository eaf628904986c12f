#include "update/regions/unchanged_rest.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "geom/arrays/sort_ids.h"
#include "geom/messages/require_size.h"
#include "update/model/require_ascending.h"
#include "update/model/sample_heights.h"
#include "update/stage_options.h"

namespace cocoon {

namespace {

using Piece = std::vector<VertexId>;

// Removed vertices with no sample near them, in pieces that hang together over edges of the model.
class UnscannedPieces {
 public:
  UnscannedPieces(const ModelIndex& model, std::span<const VertexId> removed)
      : model_(model), removed_(removed), is_taken_(removed.size(), 0) {}

  // Calls visit(piece) for those that hang on what stays. `is_scanned`: whether a sample is near a
  // vertex; `is_firm`: whether it is of a region that stays.
  template <class IsScanned, class IsFirm, class Visit>
  void visit_hanging(const IsScanned& is_scanned, const IsFirm& is_firm, const Visit& visit) {
    for (std::size_t k = 0; k < removed_.size(); ++k) {
      if (is_taken_[k] != 0 || !model_.is_used(removed_[k]) || is_scanned(removed_[k])) continue;
      Piece piece = piece_of(k, is_scanned);
      const auto hangs_on_firm = [&](VertexId v) { return hangs(v, is_firm); };
      if (std::any_of(piece.begin(), piece.end(), hangs_on_firm)) visit(std::move(piece));
    }
  }

 private:
  template <class Visit>
  void visit_neighbors(VertexId v, const Visit& visit) const {
    for (const TriangleId t : model_.triangles_at(v)) {
      for (const VertexId w : model_.mesh().triangles[t]) visit(w);
    }
  }
  template <class IsScanned>
  Piece piece_of(std::size_t first, const IsScanned& is_scanned) {
    Piece piece = {removed_[first]};
    is_taken_[first] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      visit_neighbors(piece[i], [&](VertexId w) {
        const std::size_t k = place_of(w);
        if (k == removed_.size() || is_taken_[k] != 0 || is_scanned(w)) return;
        is_taken_[k] = 1;
        piece.push_back(w);
      });
    }
    return piece;
  }
  // Over a vertex that stays: alone amid what was scanned, as at the mouth of a new pocket, it does
  // not count.
  template <class IsFirm>
  bool hangs(VertexId v, const IsFirm& is_firm) const {
    bool any = false;
    visit_neighbors(v, [&](VertexId w) {
      if (any || place_of(w) != removed_.size()) return;
      visit_neighbors(w, [&](VertexId x) { any = any || is_firm(x); });
    });
    return any;
  }

  // Among the removed ones; their number if it stays.
  std::size_t place_of(VertexId v) const {
    const auto place = std::lower_bound(removed_.begin(), removed_.end(), v);
    return place != removed_.end() && *place == v
               ? static_cast<std::size_t>(place - removed_.begin())
               : removed_.size();
  }

  const ModelIndex& model_;
  std::span<const VertexId> removed_;
  std::vector<std::uint8_t> is_taken_;
};

// What samples tell of pieces.
class Evidence {
 public:
  Evidence(const ModelIndex& model, std::span<const Scan> scans,
           std::span<const NearestPointTree> clouds, const UnchangedRestOptions& options)
      : model_(model), scans_(scans), clouds_(clouds), options_(options) {}

  bool is_near(VertexId v, double spacings) const {
    for (std::size_t c = 0; c < scans_.size(); ++c) {
      if (clouds_[c].any_near(model_.mesh().points[v], spacings * scans_[c].spacing)) return true;
    }
    return false;
  }
  bool is_beside_samples(const Piece& piece) const {
    return std::all_of(piece.begin(), piece.end(),
                       [&](VertexId v) { return is_near(v, options_.around); });
  }
  // Pieces beside samples of which one nearby is off the model. Complexity: of all at once.
  void erase_changed(std::vector<Piece>& pieces) const {
    std::vector<Point> places;
    for (const Piece& piece : pieces) {
      for (const VertexId v : piece) places.push_back(model_.mesh().points[v]);
    }
    for (std::size_t c = 0; c < scans_.size(); ++c) {
      const double reach = options_.around * scans_[c].spacing;
      const double bound = options_.height * scans_[c].spacing;
      SampleHeights heights(model_, scans_[c].samples, places, reach, bound, scans_[c].shift);
      const auto is_off = [&](PointId sample) { return heights.squared(sample) > bound * bound; };
      std::erase_if(pieces, [&](const Piece& piece) {
        return std::any_of(piece.begin(), piece.end(), [&](VertexId v) {
          return clouds_[c].any_near(model_.mesh().points[v], reach, is_off);
        });
      });
    }
  }

 private:
  const ModelIndex& model_;
  std::span<const Scan> scans_;
  std::span<const NearestPointTree> clouds_;
  const UnchangedRestOptions& options_;
};

}  // namespace

std::vector<VertexId> unchanged_rest(const ModelIndex& model, std::span<const VertexId> removed,
                                     const Regions& regions, const RegionChoice& choice,
                                     std::span<const RegionId> said_to_go,
                                     std::span<const Scan> scans,
                                     std::span<const NearestPointTree> clouds,
                                     const UnchangedRestOptions& options) {
  require_options("unchanged_rest", options);
  require_size("unchanged_rest", "trees of clouds", clouds.size(), scans.size());
  require_size("unchanged_rest", "groups of vertices", regions.group_of_vertex.size(),
               model.mesh().points.size());
  require_size("unchanged_rest", "flags of replaced regions", choice.replaced.size(),
               regions.regions.size());
  require_ascending("unchanged_rest", "removed vertices", removed, model.mesh().points.size());
  if (options.reach == 0) return {};
  const auto is_firm = [&](VertexId v) {
    const RegionId group = regions.group_of_vertex[v];
    return !group.is_none() && choice.replaced[group] == 0;
  };
  const auto is_said_to_go = [&](VertexId v) {
    bool is_said = false;
    model.for_each_triangle_at(v, [&](TriangleId t) {
      const RegionId r = regions.region_of_facet[t];
      is_said |= std::find(said_to_go.begin(), said_to_go.end(), r) != said_to_go.end();
    });
    return is_said;
  };
  const Evidence evidence(model, scans, clouds, options);
  std::vector<Piece> pieces;
  UnscannedPieces(model, removed)
      .visit_hanging([&](VertexId v) { return evidence.is_near(v, options.reach); }, is_firm,
                     [&](Piece piece) {
                       if (std::any_of(piece.begin(), piece.end(), is_said_to_go)) return;
                       if (evidence.is_beside_samples(piece)) pieces.push_back(std::move(piece));
                     });
  if (!pieces.empty()) evidence.erase_changed(pieces);
  std::vector<VertexId> rest;
  for (const Piece& piece : pieces) {
    rest.insert(rest.end(), piece.begin(), piece.end());
  }
  make_set(rest);
  return rest;
}

}  // namespace cocoon
