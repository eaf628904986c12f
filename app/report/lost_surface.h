// Surface of the model that an update loses though nothing was scanned there, for people.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/json_report.h"
#include "geom/point.h"
#include "geom/triangle_mesh.h"
#include "update/report/lost_triangles.h"
#include "update/update_model.h"
#include "update/update_session.h"

namespace cocoon::app {

struct LostSurface {
  LostTriangles triangles;
  AstrayTriangles astray;       // of the lost ones
  std::optional<double> share;  // of the area that stays, astray; none: hardly a triangle is lost
  bool warns = false;           // the share is worth a warning
  // The model's triangles are too large for each of the scans, and it is worth a trial to make it
  // dense.
  bool is_coarse = false;
  std::optional<double> tried;  // it was made dense with this spacing, but kept no more so
};

// Of a model that is sampled densely hardly any triangle is lost beside the change. Precondition:
// the update is ok; `updated` is its mesh. Complexity: as astray_triangles, if a tenth of the
// triangles is lost.
LostSurface lost_surface(const TriangleMesh& model, const std::vector<std::vector<Point>>& clouds,
                         const SessionUpdate& update, const TriangleMesh& updated);

// Its counts, to the section "update".
void add_lost_surface(JsonReport& report, const LostSurface& lost);

// What the user is told, and what to do. Precondition: lost.warns.
std::string warning_of_lost_surface(const LostSurface& lost, const std::string& model_name,
                                    const TriangleMesh& model);

}  // namespace cocoon::app
