#include "app/files/carried_properties.h"

#include <filesystem>
#include <fmt/format.h>
#include <utility>

#include "geom/search/nearest_point.h"
#include "io/file_format.h"

namespace cocoon::app {

namespace {

void leave_out(Job& job, const std::string& file, const std::string& why) {
  job.report().append("properties_left_out", fmt::format("{}: {}", file, why));
  job.warn(fmt::format("{}: property {}; it is left out", file, why));
}

void report_columns(Job& job, const GatheredProperties& gathered) {
  for (std::size_t k = 0; k < gathered.properties.columns.size(); ++k) {
    const PlyProperty& declaration = gathered.properties.columns[k].declaration;
    JsonReport entry;
    entry.set("name", declaration.name);
    entry.set("type", type_text(declaration));
    entry.set("missing", gathered.missing[k]);
    job.report().append("properties", entry);
    if (gathered.missing[k] == 0) continue;
    job.warn(fmt::format("property {}: {} of {} vertices {} no value", declaration.name,
                         gathered.missing[k], gathered.properties.rows,
                         gathered.missing[k] == 1 ? "has" : "have"));
  }
}

}  // namespace

bool holds_properties(const std::string& output) {
  return format_of(std::filesystem::path(output)) == FileFormat::ply;
}

VertexProperties carried_properties(Job& job, std::span<const VertexProperties> tables,
                                    const std::vector<std::string>& names,
                                    std::span<const RowOrigin> origins) {
  GatheredProperties gathered = gather_properties(tables, origins);
  for (std::size_t t = 0; t < tables.size(); ++t) {
    for (const std::string& why : tables[t].left_out) leave_out(job, names[t], why);
  }
  for (const PropertyConflict& conflict : gathered.conflicts) {
    const PlyProperty& kept = gathered.properties.columns[conflict.column].declaration;
    leave_out(job, names[conflict.table],
              fmt::format("{} is no {} as in the files before", kept.name, type_text(kept)));
  }
  report_columns(job, gathered);
  return std::move(gathered.properties);
}

VertexProperties properties_of_samples(const VertexProperties& table, Points samples) {
  if (table.columns.empty()) return {samples.size(), {}, table.left_out};
  const NearestPointTree vertices(samples.first(table.rows));
  std::vector<RowOrigin> origins;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    origins.push_back({0, i < table.rows ? i : vertices.nearest(samples[i]).point.index()});
  }
  return select_rows(table, origins);
}

std::vector<RowOrigin> rows_of(const ReconstructResult& surface) {
  std::vector<RowOrigin> origins;
  for (const PointId point : surface.point_of_vertex) origins.push_back({0, point.index()});
  return origins;
}

VertexProperties properties_of_surface(Job& job, const VertexProperties& table,
                                       const std::string& name, const ReconstructResult& surface) {
  return carried_properties(job, {&table, 1}, {name}, rows_of(surface));
}

}  // namespace cocoon::app
