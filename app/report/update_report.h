// An update as the JSON report and the HTML page show it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/job.h"
#include "app/json_report.h"
#include "app/report/html_report.h"
#include "cocone/reconstruct.h"
#include "geom/mesh_check.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/stray_samples.h"
#include "update/update_model.h"

namespace cocoon::app {

// Everything that went into an update and came out of it; nothing is owned.
struct UpdateRecord {
  std::string model_name;
  const TriangleMesh& model;
  const std::vector<std::string>& cloud_names;
  const std::vector<std::vector<Point>>& clouds;
  const UpdateResult& result;
  const MeshReport& certificate;  // of the updated mesh
  // For the page: the signed distances (signed_distance.h) from the model of the points of each
  // cloud, then of the vertices that --manifold added to the updated mesh.
  std::vector<std::vector<double>> deviation = {};
  // What was left out of each cloud as stray; empty: they were not filtered.
  std::span<const StraySamples> strays = {};
  RegionOverrides overrides = {};  // that were given
};

// "topology: Euler characteristic 0 -> 2": a handle went, or a part came; empty: it is as before.
std::string topology_change(const UpdateResult& result);

// As the report numbers them.
std::vector<std::size_t> numbers_of(const std::vector<RegionId>& regions);

// "kept" or "replaced", and why if not for its angle. `cloud`: what it is the verdict of.
std::string verdict_on(const RegionVerdict& group, const CloudReport& cloud,
                       std::span<const RegionId> islands, const RegionOverrides& overrides = {});

// The sections "input", "delaunay", "surface" and "update".
void add_update(JsonReport& report, const UpdateRecord& record);

// The sections "delaunay" and "surface": a model after updates, of which `reconstruction` tells,
// but for its mesh. A model that was given and not updated has no "delaunay".
void add_model(JsonReport& report, const ReconstructResult& reconstruction,
               const TriangleMesh& mesh, const MeshReport& certificate);

// The summary for people, on standard output.
void say_update(Job& job, const UpdateRecord& record);

// The stages of the update one after the other, with tables of counts, angles and times. Needs the
// deviation. `warnings`: those of the whole job.
ReportPage update_page(const UpdateRecord& record, const std::vector<StageTime>& timings,
                       const std::vector<std::string>& warnings);

}  // namespace cocoon::app
