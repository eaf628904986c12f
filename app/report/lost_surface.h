// Surface of the model that an update loses though nothing was scanned there, for people.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/json_report.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/checks/lost_triangles.h"
#include "update/checks/made_up_surface.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

struct LostSurfaceOptions {
  // Worth a warning from this share of the area that stays on.
  double min_area_share = 0.02;
  // Looked for if more than this share of the area that could stay is lost. A trial to make the
  // model dense is worth its time if large triangles lose this share of all area: of thirty models
  // with finer scans those that are meshes of scans lost 1.1 % at most, those of CAD programs 2.3 %
  // at least.
  double min_coarse_share = 0.015;
  AstrayOptions astray;
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
  std::string tried;      // what became of a trial that was not taken; empty: there was none
};

// Of a model that is sampled densely hardly any triangle is lost beside the change. Precondition:
// the update is ok; `updated` is its mesh. Complexity: as astray_triangles, if more than the
// least share of the area is lost.
LostSurface lost_surface(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds,
                         const SessionUpdate& update, const TriangleMesh& updated,
                         const LostSurfaceOptions& options = {});

// Its counts, to the section "update".
void add_lost_surface(JsonReport& report, const LostSurface& lost);

// What the user is told, and what to do. Precondition: lost.warns.
std::string warning_of_lost_surface(const LostSurface& lost, const std::string& model_name,
                                    const TriangleMesh& model);

// Likewise. Precondition: lost.makes_up.
std::string warning_of_made_up_surface(const LostSurface& lost, const std::string& model_name);

}  // namespace cocoon::app
