// Surface of the model that an update loses, or makes up, though nothing was scanned there.
#pragma once

#include <optional>
#include <span>

#include "geom/triangle_mesh.h"
#include "update/checks/lost_triangles.h"
#include "update/checks/made_up_surface.h"
#include "update/cloud/scan.h"
#include "update/model/mesh_change.h"
#include "update/update_model.h"

namespace cocoon {

struct LostSurfaceOptions {
  // Worth a warning from this share of the area that stays on.
  double min_area_share = 0.02;
  // Looked for if more than this share of the area that could stay is lost. A trial to make the
  // model dense is worth its time if large triangles lose this share of all area: of thirty models
  // with finer scans those that are meshes of scans lost 1.1 % at most, those of CAD programs 2.3 %
  // at least.
  double min_coarse_share = 0.015;
  AstrayOptions astray = {};
};

struct LostSurface {
  LostTriangles triangles;
  AstrayTriangles astray;       // of the lost ones
  std::optional<double> share;  // of the area that stays, astray; none: hardly any is lost
  bool warns = false;           // the share is worth a warning
  bool is_coarse = false;       // the astray triangles are too large for each of the scans
  // What large triangles (large_side), but for those of replaced regions, have lost where nothing
  // was scanned, whether or not the change has taken their vertices: what it has taken of them may
  // be little. And what large new ones have made up there, off the model, unless the update closes
  // openings of the model, which takes such triangles. As a share of the model's area.
  double large_share = 0;
  MadeUpSurface made_up;  // off the model, between its vertices, where nothing was scanned
  double spacing = 0;     // if there is any: of the scans, the largest
  bool makes_up = false;  // that is worth a warning: it does not close openings of the model
};

// Of a model that is sampled densely hardly any triangle is lost beside the change. `change`: from
// the model to `updated`, the mesh of the update, which is ok; `scans`: its clouds (scans_of).
// Errors: InputError for options out of range. Complexity: O(t); as astray_triangles, if more than
// the least share of the area is lost; and as UnscannedPlaces, of what is new or large. Source:
// ours.
LostSurface lost_surface(const TriangleMesh& model, std::span<const Scan> scans,
                         const UpdateResult& result, const MeshChange& change,
                         const TriangleMesh& updated, const LostSurfaceOptions& options = {});

}  // namespace cocoon
