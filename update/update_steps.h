// The steps of one update, which update_model() takes from the first to the last.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/execution.h"
#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/cloud/scan.h"
#include "update/joined_clouds.h"
#include "update/located_rims.h"
#include "update/model/model_index.h"
#include "update/update_model.h"

namespace cocoon {

// Each step is called once, in this order, as long as the one before returned true; false: the
// result is final, and take_result() comes next. Until then clouds are those that were joined;
// take_result() tells of those given. Model, clouds and options must outlive the object.
// Errors and complexity: those of update_model().
class UpdateSteps {
 public:
  // The surface of each cloud is looked for by itself.
  UpdateSteps(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
              const UpdateOptions& options);
  // Joined clouds are taken as one; `joined`: all of `clouds`, each in one of them.
  UpdateSteps(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
              std::vector<JoinedCloud> joined, const UpdateOptions& options);

  bool detect_boundaries(const Execution& execution);

  bool find_overlapping_facets(const ModelIndex& index, const Execution& execution);

  bool segment_and_choose(const ModelIndex& index, const Execution& execution);

  void reconstruct(const ModelIndex& index, const UpdateParts& parts, const Execution& execution);

  UpdateResult take_result();

 private:
  bool are_joined() const { return joined_.size() < given_.size(); }
  void tell_members();
  std::string name_of_cloud(std::size_t c) const;
  std::string name_of_loop(std::size_t c, std::size_t l) const;
  bool fail(UpdateStatus status, std::string message) {
    result_.status = status;
    result_.message = std::move(message);
    return false;
  }
  void warn(std::string message) { result_.warnings.push_back(std::move(message)); }
  void warn_of_cloud(std::size_t c, const std::vector<std::string>& warnings);

  // Refers to what is known so far.
  OutwardNormals outward(const ModelIndex& index) const;

  // Has contradicted islands go.
  void take_islands(const ModelIndex& index);
  void take_overrides();

  // Calls visit(cloud, loop) for the loops that take part in the border.
  template <class Visit>
  void for_each_border_loop(Visit visit) const {
    for (std::size_t c = 0; c < rims_.overlaps.size(); ++c) {
      for (std::size_t l = 0; l < rims_.overlaps[c].loops.size(); ++l) {
        if (rims_.overlaps[c].loops[l].match == LoopMatch::on_model) visit(c, l);
      }
    }
  }

  // One entry for each loop of the border.
  std::vector<RegionAngles> measure_angles(const ModelIndex& index, const Regions& regions) const;

  std::vector<CloudSurface> surfaces_of_cloud(std::size_t c, const Execution& execution) const;

  // A pin-hole that does not cut the model in two, by itself or with other loops, is none of the
  // border. Returns whether there was one.
  bool close_pin_holes(const ModelIndex& index, const Execution& execution);

  void trace_borders(const ModelIndex& index, const Execution& execution);

  void report_overlap(std::size_t c);

  // There is no surface, or no rim.
  bool fail_surface(std::size_t c);

  bool fail_no_overlap(std::size_t c, const ModelIndex& index, const Execution& execution);

  // Whether each border loop cuts the model in two.
  void find_separations(const ModelIndex& index);
  Separation separation_of(std::size_t c, std::size_t l) const {
    return result_.clouds[c].loops[l].separation;
  }

  // Whether a rim, though whole, runs around a handle: then the cloud is to be cut, too.
  bool cut_across_handles();

  // False if a loop has not cut the model in two.
  // `angles`: of each border loop. One whose band has no region inside may see that of another
  // band, which begins where it ends.
  bool check_separation(std::span<const RegionAngles> angles);

  // Where clouds are cut: takes regions that lie as a whole under each such cloud, or outside. None
  // is cut if needs_no_cut().
  bool segment(const ModelIndex& index, const std::vector<std::size_t>& joined,
               const Execution& execution);

  // Whether there are cuts, none of them is clear, and all are of single clouds, whose loops, taken
  // as whole ones, separate; all regions at them turn away from the cloud, and its samples tell
  // which of these lie under it.
  bool needs_no_cut(const ModelIndex& index, const std::vector<std::size_t>& joined,
                    std::span<const RegionCut> cuts, const Execution& execution) const;

  // Why the cut of this cloud, and of those joined to it, is not to be believed.
  std::optional<std::string> why_not_cut(std::size_t c, const RegionCut& cut,
                                         const ModelIndex& index) const;

  // Whether a scan ends on the model in regions that would go: then its rim is not all there, and
  // the cloud is to be cut.
  bool cut_where_scans_end(const ModelIndex& index, std::span<const RegionAngles> angles);

  enum class ToldBy : std::uint8_t { rim, samples, sure_angles };
  // Where both sides of a rim turn away from the cloud, by the choice so far, samples tell, or else
  // the angles if they differ much. Returns whether something was told.
  bool tell_sides(const ModelIndex& index, std::span<const RegionAngles> angles,
                  const Execution& execution);

  bool report_choice();

  const TriangleMesh& model_;
  std::span<const std::vector<Point>> given_;
  std::vector<JoinedCloud> joined_;             // of one member each where clouds are not joined
  std::vector<std::vector<Point>> samples_;     // of them, if clouds are joined
  std::span<const std::vector<Point>> clouds_;  // what the steps work on: given_ or samples_
  const UpdateOptions& options_;
  std::vector<std::vector<CloudSurface>> other_surfaces_;  // of each cloud, those not taken
  LocatedRims rims_;
  std::vector<std::uint8_t> is_cut_;  // clouds_to_cut()
  std::vector<Border> borders_;
  TriangleSet border_facets_;
  std::vector<IdVector<RegionId, std::uint8_t>> decided_;  // CutRegions::under, or by tell_sides()
  std::vector<ToldBy> told_by_;                            // of each cloud: tell_sides()
  UpdateResult result_;
};

}  // namespace cocoon
