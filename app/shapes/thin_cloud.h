// --thin: a cloud without the points that lie too close to others.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/job.h"
#include "geom/point.h"
#include "io/vertex_properties.h"

namespace cocoon::app {

// Leaves out points of the cloud that was read from `name`, and their properties if there are any,
// so that those that are left lie `distance` or more apart (thin_points); returns how many went.
// Throws InputError if fewer than four are left of four or more.
std::size_t thin_cloud(const std::string& name, double distance, std::vector<Point>& cloud,
                       VertexProperties* properties = nullptr);

// The same as stage "thin", if there is a distance; told in the summary.
std::size_t thin_input(Job& job, const std::string& name, const std::optional<double>& distance,
                       std::vector<Point>& cloud, VertexProperties* properties = nullptr);

// As "parameters/thin" and "input/thinned_points" of the report, if there is a distance.
void add_thinning(JsonReport& report, const std::optional<double>& distance,
                  std::size_t thinned_points);

}  // namespace cocoon::app
