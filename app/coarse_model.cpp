#include "app/coarse_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "geom/errors.h"
#include "geom/mesh/triangles_by_area.h"
#include "geom/search/closest_facet.h"
#include "geom/search/neighbor_distance.h"
#include "update/checks/lost_triangles.h"
#include "update/checks/model_places.h"
#include "update/report/cloud_report.h"

namespace cocoon::app {

namespace {

std::vector<Scan> scans_before(const std::vector<std::vector<Point>>& clouds,
                               const CoarseModelOptions& coarse) {
  std::vector<Scan> scans;
  for (const std::vector<Point>& cloud : clouds) {
    scans.push_back(
        {cloud, coarse.neighbor_share * median_neighbor_distance(cloud, coarse.neighbor)});
  }
  return scans;
}

// In two digits, as it is told: --densify with this number gives the same.
double spacing_to_try(const UpdateInput& input, const CoarseModelOptions& coarse) {
  const double area = TrianglesByArea(input.model).area();
  const double spacing = std::max(largest_spacing(scans_before(input.clouds, coarse)),
                                  std::sqrt(area / coarse.most_samples));
  return std::strtod(fmt::format("{:.2g}", spacing).c_str(), nullptr);
}

// Whether triangles that are too large for the scans and the change (large_side) are at least this
// share of the model's area.
bool has_large_triangles(const UpdateInput& input, double share, const CoarseModelOptions& coarse) {
  const double limit = large_side(scans_before(input.clouds, coarse));
  double area = 0;
  double large = 0;
  for (const TriangleId t : input.model.triangles.ids()) {
    const double own = area_of(input.model, t);
    area += own;
    if (longest_edge(input.model, t) > limit) large += own;
  }
  return large > 0 && large >= share * area;
}

// Whether it is worth a trial to make the model dense.
bool is_coarse(const UpdateInput& input, const UpdateOutcome& outcome,
               const CoarseModelOptions& coarse) {
  if (outcome.update.result.status == UpdateStatus::ok) {
    const LostSurface& lost = outcome.lost;
    return (lost.warns && lost.is_coarse) || lost.large_share > coarse.lost.min_coarse_share;
  }
  return has_large_triangles(input, coarse.min_large_share_if_refused, coarse);
}

// The same made dense and updated.
struct DenseUpdate {
  UpdateInput input;
  UpdateOutcome outcome;
};

// Of each place whether its surface goes with the change of the dense model.
std::vector<std::uint8_t> are_replaced(const std::vector<ModelPlace>& places, double reach,
                                       const DenseUpdate& dense) {
  const ClosestFacetTree tree(dense.input.model);
  const auto& point_of_vertex = dense.outcome.update.result.replacement.point_of_vertex;
  std::vector<std::uint8_t> replaced;
  std::uint32_t slot = 0;
  for (const ModelPlace& place : places) {
    const ClosestFacet facet = tree.closest(place.at, slot);
    const Triangle& corners = dense.input.model.triangles[facet.triangle];
    const bool goes = std::any_of(corners.begin(), corners.end(),
                                  [&](VertexId v) { return point_of_vertex[v].is_none(); });
    replaced.push_back(goes && facet.squared_distance <= reach * reach ? 1 : 0);
  }
  return replaced;
}

// Areas of the model where nothing was scanned, by which of the two updates passes there; and what
// they have made up.
struct KeptAreas {
  double all = 0;
  double only_dense = 0;  // the one of the dense model
  double only_first = 0;  // where it is no part of what the change of the dense model replaced
  double neither = 0;     // likewise
  double made_up_by_dense = 0;
  double made_up_by_first = 0;
};

KeptAreas kept_areas(const UpdateInput& input, const UpdateOutcome& outcome,
                     const DenseUpdate& dense) {
  const UpdateResult& result = outcome.update.result;
  const UpdateResult& of_dense = dense.outcome.update.result;
  const UnscannedPlaces unscanned(scans_of(input.clouds, of_dense.clouds));
  const std::vector<ModelPlace> places = unscanned.of(input.model);
  const std::vector<std::uint8_t> off_dense = unscanned.are_off(places, of_dense.mesh);
  const std::vector<std::uint8_t> off_first = result.status == UpdateStatus::ok
                                                  ? unscanned.are_off(places, result.mesh)
                                                  : std::vector<std::uint8_t>(places.size(), 1);
  const std::vector<std::uint8_t> replaced = are_replaced(places, unscanned.reach(), dense);
  KeptAreas areas;
  areas.made_up_by_dense = unscanned.area_off(unscanned.of(of_dense.mesh), input.model);
  if (result.status == UpdateStatus::ok) {
    areas.made_up_by_first = unscanned.area_off(unscanned.of(result.mesh), input.model);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double area = places[k].area;
    areas.all += area;
    if (off_dense[k] == 0) {
      areas.only_dense += off_first[k] != 0 ? area : 0;
    } else if (replaced[k] == 0) {
      (off_first[k] != 0 ? areas.neither : areas.only_first) += area;
    }
  }
  return areas;
}

// Whether by the update of the dense model, which is ok, less is lost and made up.
bool is_better(const KeptAreas& areas, bool first_is_ok, const CoarseModelOptions& coarse) {
  if (!first_is_ok) {
    return areas.neither + areas.made_up_by_dense <= coarse.lost.min_area_share * areas.all;
  }
  const double better = areas.only_dense + areas.made_up_by_first;
  const double worse = areas.only_first + areas.made_up_by_dense;
  return areas.all > 0 && better > coarse.lost.min_coarse_share * areas.all &&
         worse <= coarse.max_given_up * better;
}

// What the first would have lost and made up, or why it is no use, for the report and the user.
void tell(Job& job, const UpdateInput& input, const UpdateResult& first, const KeptAreas& areas,
          double spacing) {
  std::string what = fmt::format("it cannot be updated so ({})", name_of(first.status));
  if (first.status == UpdateStatus::ok) {
    const double lost = areas.only_dense / areas.all;
    const double made_up = areas.made_up_by_first / areas.all;
    job.report().set("update/coarse_model/lost_area_share", lost);
    job.report().set("update/coarse_model/made_up_area_share", made_up);
    what = fmt::format("of its surface {:.3g} % would be lost and {:.3g} % made up", 100 * lost,
                       100 * made_up);
  }
  job.warn(fmt::format(
      "{} has large triangles, and {}: it was made dense first (as by --densify {}; --keep-coarse "
      "takes its vertices alone)",
      input.model_name, what, spacing));
}

// Why it is not taken; empty: it is, and the job was told so. Fills in what of it can be.
std::string try_dense(Job& job, const UpdateInput& input, const UpdateOutcome& outcome,
                      const UpdateOptions& options, double spacing,
                      const CoarseModelOptions& coarse, DenseUpdate& dense) {
  const std::string made_dense = fmt::format("made dense (--densify {}) it ", spacing);
  try {
    dense.input = with_dense_model(job, input, spacing, options.reconstruct);
    dense.outcome = updated(job, dense.input, options);
  } catch (const InputError& error) {
    return made_dense + fmt::format("is of no use ({})", error.what());
  }
  const UpdateResult& result = dense.outcome.update.result;
  if (result.status != UpdateStatus::ok) {
    return made_dense + fmt::format("cannot be updated ({})", name_of(result.status));
  }
  const KeptAreas areas =
      timed(job.execution(), "check", [&] { return kept_areas(input, outcome, dense); });
  const UpdateResult& first = outcome.update.result;
  if (!is_better(areas, first.status == UpdateStatus::ok, coarse)) {
    return made_dense + "keeps no more";
  }
  tell(job, input, first, areas, spacing);
  return {};
}

// Input and outcome become those of the dense model, if that keeps more of the surface.
void make_dense(Job& job, UpdateInput& input, UpdateOutcome& outcome, const UpdateOptions& options,
                const CoarseModelOptions& coarse) {
  const double spacing = spacing_to_try(input, coarse);
  if (!(spacing > 0)) return;
  DenseUpdate dense;
  const bool is_taken = job.try_out([&] {
    outcome.lost.tried = try_dense(job, input, outcome, options, spacing, coarse, dense);
    return outcome.lost.tried.empty();
  });
  JsonReport& report = job.report();
  report.set("update/coarse_model/status", std::string(name_of(outcome.update.result.status)));
  report.set("update/coarse_model/spacing", spacing);
  report.set("update/coarse_model/made_dense", is_taken);
  if (!is_taken) return;
  input = std::move(dense.input);
  outcome = std::move(dense.outcome);
}

}  // namespace

UpdateOutcome updated_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                                   const CoarseModelOptions& coarse) {
  if (!options.overrides.is_empty()) {
    const std::string tried = make_dense_enough(job, input, options, coarse);
    UpdateOutcome said = updated(job, input, options);
    said.lost.tried = tried;
    return said;
  }
  UpdateOutcome outcome = updated(job, input, options);
  if (input.is_mesh_of_file && is_coarse(input, outcome, coarse)) {
    make_dense(job, input, outcome, options, coarse);
  }
  return outcome;
}

std::string make_dense_enough(Job& job, UpdateInput& input, const UpdateOptions& options,
                              const CoarseModelOptions& coarse) {
  if (!input.is_mesh_of_file || !has_large_triangles(input, coarse.min_large_share, coarse)) {
    return {};
  }
  UpdateOptions unsaid = options;
  unsaid.overrides = {};
  UpdateOutcome outcome;
  try {
    outcome = updated(job, input, unsaid);
  } catch (const InputError&) {
    return {};  // the update to come has the same to say
  }
  if (is_coarse(input, outcome, coarse)) make_dense(job, input, outcome, unsaid, coarse);
  return outcome.lost.tried;
}

}  // namespace cocoon::app
