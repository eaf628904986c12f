// What the steps of one update share: its input, and what is known so far.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geom/id_vector.h"
#include "geom/triangle_mesh.h"
#include "update/cloud/outward_normals.h"
#include "update/joined_clouds.h"
#include "update/located_rims.h"
#include "update/model/model_index.h"
#include "update/model/triangle_set.h"
#include "update/rim_angles.h"
#include "update/segment_model.h"
#include "update/trace_border.h"
#include "update/update_model.h"

namespace cocoon {

// The steps are called in this order, each once, as long as the one before has not failed (false,
// or none):
//   detect_boundaries  find_overlap  segment_under_clouds  choose_replaced  reconstruct_updated
// From the third to the fourth go the angles at the rims; all else is here.
// Clouds are those that were joined; take_result() tells of those given. Model, clouds and options
// must outlive the object.
struct UpdateRun {
  // The surface of each cloud is looked for by itself.
  UpdateRun(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
            const UpdateOptions& options);
  // Joined clouds are taken as one; `joined`: all of `clouds`, each in one of them.
  UpdateRun(const TriangleMesh& model, std::span<const std::vector<Point>> clouds,
            std::vector<JoinedCloud> joined, const UpdateOptions& options);
  // `clouds` may refer to the object.
  UpdateRun(const UpdateRun&) = delete;
  UpdateRun& operator=(const UpdateRun&) = delete;

  UpdateResult take_result();

  bool are_joined() const { return joined.size() < given.size(); }
  std::string name_of_cloud(std::size_t c) const;
  std::string name_of_loop(std::size_t c, std::size_t l) const;
  // Returns false, as the step that fails does. Of several failures that counts whose status comes
  // first, and of equal ones the one told first.
  bool fail(UpdateStatus status, std::string message);
  void warn(std::string message) { result.warnings.push_back(std::move(message)); }
  void warn_of_cloud(std::size_t c, const std::vector<std::string>& warnings);

  // Calls visit(cloud, loop) for the loops that take part in the border.
  template <class Visit>
  void for_each_border_loop(Visit visit) const {
    for (std::size_t c = 0; c < rims.overlaps.size(); ++c) {
      for (std::size_t l = 0; l < rims.overlaps[c].loops.size(); ++l) {
        if (rims.overlaps[c].loops[l].match == LoopMatch::on_model) visit(c, l);
      }
    }
  }
  // Of each cloud, with its samples as they are in the rim that was taken.
  std::vector<Scan> scans() const { return scans_of(clouds, result.clouds); }
  // One entry for each border loop.
  std::vector<RegionAngles> measure_angles(const Regions& regions) const;
  // Of the samples of each cloud. Refers to what is known so far.
  OutwardNormals outward() const;

  const TriangleMesh& model;
  std::span<const std::vector<Point>> given;
  std::vector<JoinedCloud> joined;                 // of one member each where none are joined
  std::vector<std::vector<Point>> joined_samples;  // of them, if clouds are joined
  std::span<const std::vector<Point>> clouds;      // what the steps work on: given or joined
  const UpdateOptions& options;
  std::vector<LayerOptions> layers;   // of each cloud: those of `options`, but for who sets them
  const ModelIndex* index = nullptr;  // of the model, from find_overlap on
  std::vector<std::vector<CloudSurface>> other_surfaces;  // of each cloud, those not taken
  LocatedRims rims;
  std::vector<Border> borders;
  TriangleSet border_facets;                              // of all of them
  std::optional<Regions> whole_regions;                   // by these, once they are asked for
  std::vector<std::uint8_t> is_cut;                       // clouds_to_cut(), or more
  std::vector<IdVector<RegionId, std::uint8_t>> decided;  // which regions lie under each cloud,
                                                          // where its rim does not tell
  UpdateResult result;

 private:
  void begin_clouds();
  void tell_members();
};

}  // namespace cocoon
