// The HTML page of an update: update_page() of update_report.h.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <numeric>

#include "app/report/surface_report.h"
#include "app/report/update_report.h"
#include "geom/messages/counted.h"
#include "update/report/vertex_origins.h"

namespace cocoon::app {

namespace {

constexpr const char* model_color = "#b4bfca";
constexpr const char* kept_color = "#8fa9c4";
constexpr const char* replaced_color = "#d1495b";
constexpr const char* overlap_color = "#f2b134";
constexpr const char* traced_color = "#f8dda0";
constexpr const char* loop_color = "#c1121f";
constexpr const char* surface_color = "#dcc7a1";
constexpr const char* new_color = "#e58f3c";
constexpr std::array<const char*, 8> group_colors = {"#4e79a7", "#59a14f", "#b07aa1", "#4fb3bf",
                                                     "#9c755f", "#86bcb6", "#6b6ecf", "#a0a84f"};
constexpr std::array<const char*, 4> cloud_colors = {"#d9620b", "#7b2d8b", "#0a7d6f", "#a31f34"};

// Groups beyond these many are one layer: a list that is too long to read helps nobody.
constexpr std::size_t max_group_layers = 12;

// Labels of facets of the initial model; groups follow.
constexpr std::uint32_t overlapping_label = 0;
constexpr std::uint32_t traced_label = 1;
constexpr std::uint32_t first_group_label = 2;

// Labels of triangles of the updated model.
constexpr std::uint32_t kept_only_label = 0;
constexpr std::uint32_t new_label = 1;

// One line each.
constexpr const char* papers[] = {
    "Woo & Dey: Updating 3D triangular mesh models based on locally added point clouds, 2005",
    "Amenta, Choi, Dey & Leekha: A simple algorithm for homeomorphic surface reconstruction, 2002",
    "Dey & Giesen: Detecting undersampling in surface reconstruction, 2001",
    "Dey & Goswami: Tight Cocone: a water-tight surface reconstructor, 2003",
    "Devillers & Teillaud: Perturbations and vertex removal in a 3D Delaunay triangulation, 2003",
};

std::vector<std::uint32_t> numbers_from(std::size_t first, std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
  return numbers;
}

// "2"; "1, 3, 4" of the first of joined clouds.
std::string numbers_told(const UpdateRecord& record, std::size_t c) {
  std::vector<std::size_t> numbers = members_told(record.result.clouds, c);
  for (std::size_t& number : numbers) ++number;
  return fmt::format("{}", fmt::join(numbers, ", "));
}

// The scene of the page. Its points are the vertices of the model, then the clouds.
class SceneBuilder {
 public:
  SceneBuilder(const UpdateRecord& record, ReportPage& page) : record_(record), page_(page) {}

  void build() {
    name_groups();
    add_points();
    add_model();
    add_group_layers();
    for (std::size_t c = 0; c < record_.clouds.size(); ++c) add_cloud(c);
    add_updated();
    add_stages();
    look_at_the_change();
  }

 private:
  using Kind = PageGeometry::Kind;

  std::size_t cloud_begin(std::size_t c) const { return page_.points.parts[c + 1].first; }
  std::size_t position_of(std::size_t c, PointId p) const {
    const CloudPoint point = point_told(record_.result.clouds, record_.clouds, c, p);
    return cloud_begin(point.cloud) + point.index;
  }
  std::string cloud_name(std::size_t c) const {
    return record_.clouds.size() == 1 ? "cloud" : fmt::format("cloud {}", c + 1);
  }

  void add_layer(PageLayer layer) { page_.layers.push_back(std::move(layer)); }

  // "group 1: replaced, mean angle 7.2 degrees"; the angle is that of the cloud that counts most.
  void name_groups() {
    const RegionChoice& choice = record_.result.choice;
    for (const RegionId group : record_.result.regions.regions.ids()) {
      std::string name = fmt::format("group {}: {}", group.index(),
                                     choice.replaced[group] != 0 ? "replaced" : "kept");
      const RegionVerdict* seen = nullptr;
      for (const CloudReport& cloud : record_.result.clouds) {
        for (const RegionVerdict& angle : cloud.groups) {
          if (angle.region == group && (seen == nullptr || angle.edges > seen->edges))
            seen = &angle;
        }
      }
      if (seen != nullptr) name += fmt::format(", mean angle {:.1f}\u00b0", seen->mean_angle_deg());
      group_names_.push_back(std::move(name));
    }
  }

  void add_points() {
    PagePoints& points = page_.points;
    points.positions = record_.model.points.raw();
    points.parts.push_back({"initial model", 0, points.positions.size()});
    points.labels.texts = {"border vertex", "", "sample of the rim", "boundary sample"};
    const std::size_t first_group = points.labels.texts.size();
    for (const std::string& name : group_names_) points.labels.texts.push_back(name);
    const auto& groups = record_.result.regions.group_of_vertex;
    for (const VertexId v : record_.model.points.ids()) {
      const std::size_t label = groups[v].is_none() ? 0 : first_group + groups[v].index();
      points.labels.of_element.push_back(static_cast<std::uint32_t>(label));
    }
    for (std::size_t c = 0; c < record_.clouds.size(); ++c) {
      const auto& cloud = record_.clouds[c];
      points.parts.push_back({cloud_name(c), points.positions.size(), cloud.size()});
      points.positions.insert(points.positions.end(), cloud.begin(), cloud.end());
      points.labels.of_element.resize(points.positions.size(), 1);
    }
    for (std::size_t c = 0; c < record_.clouds.size(); ++c) {
      const CloudSurface& surface = record_.result.clouds[c].surface;
      const auto label_vertex = [&](VertexId v, std::uint32_t label) {
        points.labels.of_element[position_of(c, surface.point_of_vertex[v])] = label;
      };
      for (const VertexId v : surface.mesh.points.ids()) {
        if (surface.boundary_sample[v] != 0) label_vertex(v, 3);
      }
      for (const RimLoop& loop : surface.rim.loops) {
        for (const VertexId v : loop.vertices) label_vertex(v, 2);
      }
    }
    add_split_vertices();
    std::vector<double> deviation(record_.model.points.size(), 0);
    for (const auto& of_cloud : record_.deviation) {
      deviation.insert(deviation.end(), of_cloud.begin(), of_cloud.end());
    }
    points.fields.push_back({"deviation", std::move(deviation)});
  }

  // The vertices of the updated mesh that are no input points: what --manifold added.
  void add_split_vertices() {
    const std::vector<Point>& vertices = record_.result.mesh.points.raw();
    const std::size_t first = record_.result.reconstruction.point_of_vertex.size();
    if (first == vertices.size()) return;
    PagePoints& points = page_.points;
    points.parts.push_back({"added vertices", points.positions.size(), vertices.size() - first});
    points.positions.insert(points.positions.end(),
                            vertices.begin() + static_cast<std::ptrdiff_t>(first), vertices.end());
    points.labels.of_element.resize(points.positions.size(), 1);
  }

  void add_model() {
    const TriangleMesh& model = record_.model;
    const Regions& regions = record_.result.regions;
    PageGeometry geometry{"model", "initial model", Kind::triangles, {}, {}};
    geometry.labels.texts = {"overlapping facet", "facet traced between overlapping ones"};
    for (const std::string& name : group_names_) geometry.labels.texts.push_back(name);
    for (const TriangleId t : model.triangles.ids()) {
      for (const VertexId v : model.triangles[t]) geometry.indices.push_back(v.value);
      const RegionId region = regions.region_of_facet[t];
      geometry.labels.of_element.push_back(region.is_none() ? traced_label
                                                            : first_group_label + region.value);
    }
    for (const CloudReport& cloud : record_.result.clouds) {
      for (const TriangleId t : cloud.overlapping_facets) {
        std::uint32_t& label = geometry.labels.of_element[t.index()];
        if (label == traced_label) label = overlapping_label;
      }
    }
    page_.geometries.push_back(std::move(geometry));
    add_layer({"model", "initial model", "model", model_color, {}, "", 1});
    add_layer(
        {"overlap", "overlapping facets", "model", overlap_color, {overlapping_label}, "", 1});
    add_layer(
        {"traced", "facets traced between them", "model", traced_color, {traced_label}, "", 1});
  }

  void add_group_layers() {
    const auto& regions = record_.result.regions.regions;
    std::vector<std::size_t> kept;
    std::vector<std::size_t> replaced;
    std::vector<RegionId> by_size;
    for (const RegionId group : regions.ids()) {
      const bool goes = record_.result.choice.replaced[group] != 0;
      (goes ? replaced : kept).push_back(first_group_label + group.index());
      by_size.push_back(group);
    }
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](RegionId a, RegionId b) { return regions[a].facets > regions[b].facets; });
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < by_size.size(); ++i) {
      const std::size_t k = by_size[i].index();
      if (i >= max_group_layers) {
        others.push_back(first_group_label + k);
        continue;
      }
      add_layer({fmt::format("group-{}", k),
                 fmt::format("group {}", k),
                 "model",
                 group_colors[i % group_colors.size()],
                 {first_group_label + k},
                 "",
                 1});
    }
    if (!others.empty()) {
      add_layer({"group-others", fmt::format("{} smaller groups", others.size()), "model",
                 surface_color, others, "", 1});
    }
    if (!kept.empty()) add_layer({"kept", "kept groups", "model", kept_color, kept, "", 1});
    if (!replaced.empty()) {
      add_layer({"replaced", "replaced groups", "model", replaced_color, replaced, "", 1});
    }
  }

  void add_cloud(std::size_t c) {
    const std::string id = fmt::format("cloud-{}", c + 1);
    const std::string name = cloud_name(c);
    const CloudSurface& surface = record_.result.clouds[c].surface;
    const auto index_of = [&](VertexId v) {
      return static_cast<std::uint32_t>(position_of(c, surface.point_of_vertex[v]));
    };
    page_.geometries.push_back(
        {id, name, Kind::points, numbers_from(cloud_begin(c), record_.clouds[c].size()), {}});
    add_layer({id, name, id, cloud_colors[c % cloud_colors.size()], {}, "", 1});
    if (record_.result.clouds[c].joined_with) return;
    const bool is_alone = members_told(record_.result.clouds, c).size() == 1;
    const std::string told = is_alone ? name : "clouds " + numbers_told(record_, c);

    PageGeometry sheet{id + "-surface", "Cocone surface of the " + told, Kind::triangles, {}, {}};
    for (const Triangle& triangle : surface.mesh.triangles) {
      for (const VertexId v : triangle) sheet.indices.push_back(index_of(v));
    }
    add_layer({sheet.id, told + ": Cocone surface", sheet.id, surface_color, {}, "", 1});
    page_.geometries.push_back(std::move(sheet));

    PageGeometry loops{id + "-loops", "boundary of the " + told, Kind::lines, {}, {}};
    for (std::size_t l = 0; l < surface.rim.loops.size(); ++l) {
      const RimLoop& loop = surface.rim.loops[l];
      loops.labels.texts.push_back(fmt::format("loop {}, {} edges", l, loop.size()));
      for (std::size_t i = 0; i < loop.size(); ++i) {
        loops.indices.push_back(index_of(loop.vertices[i]));
        loops.indices.push_back(index_of(loop.vertices[loop.next(i)]));
        loops.labels.of_element.push_back(static_cast<std::uint32_t>(l));
      }
    }
    add_layer({loops.id, told + ": boundary loops", loops.id, loop_color, {}, "", 1});
    page_.geometries.push_back(std::move(loops));
  }

  void add_updated() {
    IdVector<VertexId, VertexOrigin> origins = vertex_origins(record_.result);
    const auto added = static_cast<std::uint32_t>(record_.clouds.size() + 1);
    for (std::uint32_t i = 0; origins.size() < record_.result.mesh.points.size(); ++i) {
      origins.push_back({added, i});
    }
    PageGeometry geometry{"updated", "updated model", Kind::triangles, {}, {}};
    geometry.labels.texts = {"kept vertices only", "with a vertex of a cloud"};
    for (const Triangle& triangle : record_.result.mesh.triangles) {
      bool all_kept = true;
      for (const VertexId v : triangle) {
        const auto& [input, index] = origins[v];
        const std::size_t first = page_.points.parts[input].first;
        geometry.indices.push_back(static_cast<std::uint32_t>(first + index));
        all_kept = all_kept && input == 0;
      }
      geometry.labels.of_element.push_back(all_kept ? kept_only_label : new_label);
    }
    page_.geometries.push_back(std::move(geometry));
    add_layer(
        {"updated-old", "updated model: kept", "updated", model_color, {kept_only_label}, "", 1});
    add_layer({"updated-new", "updated model: new", "updated", new_color, {new_label}, "", 1});
    add_layer(
        {"deviation", "updated model: deviation", "updated", model_color, {}, "deviation", 1});
  }

  // Towards the new triangles of the updated model, which add_updated() labeled.
  void look_at_the_change() {
    const std::vector<std::uint32_t>& labels = page_.geometries.back().labels.of_element;
    std::vector<TriangleId> changed;
    for (const TriangleId t : record_.result.mesh.triangles.ids()) {
      if (labels[t.index()] != kept_only_label) changed.push_back(t);
    }
    page_.view = view_towards(record_.result.mesh, changed);
  }

  // Adds a stage that shows the layers whose ids begin with one of the given names; with '$' at
  // its end, a name stands for the whole id.
  void add_stage(const std::string& name, const std::string& caption,
                 const std::vector<std::string>& shown) {
    PageStage stage{name, caption, {}};
    for (const PageLayer& layer : page_.layers) {
      const bool wanted = std::any_of(shown.begin(), shown.end(), [&](const std::string& prefix) {
        return (layer.id + "$").rfind(prefix, 0) == 0;
      });
      if (wanted) stage.layers.push_back(layer.id);
    }
    page_.stages.push_back(std::move(stage));
  }

  void add_stages() {
    std::vector<std::string> model_and_clouds = {"model$"};
    std::vector<std::string> rims = {"model$", "overlap$"};
    for (std::size_t c = 1; c <= record_.clouds.size(); ++c) {
      model_and_clouds.push_back(fmt::format("cloud-{}$", c));
      rims.push_back(fmt::format("cloud-{}-loops$", c));
    }
    add_stage("Model and cloud", "The model and the scan of what has changed.", model_and_clouds);
    add_stage("Boundary",
              "The boundary loops of the cloud (red), and the facets on which they lie (yellow).",
              rims);
    add_stage("Groups", "The border of those facets, closed by tracing, cuts the model in groups.",
              {"overlap$", "traced$", "group-"});
    add_stage("Chosen region",
              "The group at a small angle to the cloud lies under it and is replaced (red).",
              {"overlap$", "traced$", "kept$", "replaced$"});
    add_stage("Updated model", "The closed surface of the kept points and the cloud (orange).",
              {"updated-"});
    add_stage("Deviation", "Distance from the old model: red lies outside it, blue inside.",
              {"deviation$"});
  }

  const UpdateRecord& record_;
  ReportPage& page_;
  std::vector<std::string> group_names_;
};

PageTable::Cell number(std::size_t value) { return static_cast<double>(value); }
PageTable::Cell word(std::string text) { return text; }

PageTable point_table(const UpdateRecord& record) {
  const Replacement& replacement = record.result.replacement;
  PageTable table{"Points", {"", ""}, {}};
  table.rows.push_back({word("initial model"), number(record.model.points.size())});
  for (const auto& cloud : record.clouds) {
    table.rows.push_back({word("+ cloud"), number(cloud.size())});
  }
  table.rows.push_back({word("\u2212 replaced"), number(replacement.vertices.replaced)});
  if (replacement.left_out > 0) {
    table.rows.push_back({word("\u2212 left out, in layers"), number(replacement.left_out)});
  }
  table.rows.push_back({word("\u2212 equal to another"), number(replacement.duplicates)});
  table.rows.push_back({word("updated"), number(replacement.points.size())});
  return table;
}

PageTable angle_table(const UpdateRecord& record) {
  PageTable table{"Mean angle at the rim", {"cloud", "group", "facets", "degrees", "decision"}, {}};
  for (std::size_t c = 0; c < record.result.clouds.size(); ++c) {
    if (record.result.clouds[c].joined_with) continue;
    for (const RegionVerdict& group : record.result.clouds[c].groups) {
      table.rows.push_back({word(numbers_told(record, c)), number(group.region.index()),
                            number(record.result.regions.regions[group.region].facets),
                            group.mean_angle_deg(),
                            word(verdict_on(group, record.result.clouds[c], record.result.islands,
                                            record.overrides))});
    }
  }
  return table;
}

PageTable rim_table(const UpdateRecord& record) {
  PageTable table{
      "Boundary", {"cloud", "loops", "rim points", "on facets", "border facets", "rho"}, {}};
  for (std::size_t c = 0; c < record.result.clouds.size(); ++c) {
    const CloudReport& cloud = record.result.clouds[c];
    if (cloud.joined_with) continue;
    table.rows.push_back({word(numbers_told(record, c)), number(cloud.loops.size()),
                          number(cloud.boundary_points), number(cloud.overlapping_facets.size()),
                          number(cloud.border.facets), cloud.surface.search.rho});
  }
  return table;
}

PageTable surface_table(const UpdateRecord& record) {
  const MeshReport& surface = record.certificate;
  PageTable table{"Updated surface", {"", ""}, {}};
  table.rows = {{word("triangles"), number(surface.triangles)},
                {word("open edges"), number(surface.open_edges)},
                {word("edges with more than two triangles"), number(surface.overfull_edges)},
                {word("pinched vertices"), number(surface.pinched_vertices)},
                {word("components"), number(surface.components)},
                {word("Euler characteristic"), static_cast<double>(surface.euler)},
                {word("points not on it"), number(record.result.reconstruction.unused_points)},
                {word("hash"), mesh_hash(record.result.mesh)}};
  return table;
}

// Steps in the order in which they ran; what ran inside a step is behind it, moved to the right.
PageTable time_table(const std::vector<StageTime>& timings) {
  PageTable table{"Time", {"step", "seconds"}, {}, true};
  for (const StageTime& time : timings) {
    if (time.stage.find('/') != std::string::npos) continue;
    table.rows.push_back({time.stage, time.seconds});
    for (const StageTime& inner : timings) {
      if (inner.stage.rfind(time.stage + "/", 0) != 0) continue;
      table.rows.push_back({"\u2003" + inner.stage.substr(time.stage.size() + 1), inner.seconds});
    }
  }
  return table;
}

std::vector<std::string> verdicts_of(const MeshReport& surface) {
  std::vector<std::string> verdicts;
  verdicts.emplace_back(surface.watertight ? "closed" : "open");
  const bool manifold = surface.edge_manifold && surface.vertex_manifold;
  verdicts.emplace_back(manifold ? "manifold" : "not manifold");
  verdicts.push_back(counted(surface.components, "component"));
  return verdicts;
}

}  // namespace

ReportPage update_page(const UpdateRecord& record, const std::vector<StageTime>& timings,
                       const std::vector<std::string>& warnings) {
  ReportPage page;
  page.title = "Cocoon: local mesh update";
  page.subtitle =
      fmt::format("{} updated by {}", record.model_name, counted(record.clouds.size(), "cloud"));
  page.verdicts = verdicts_of(record.certificate);
  SceneBuilder(record, page).build();
  page.tables = {point_table(record), angle_table(record), rim_table(record), surface_table(record),
                 time_table(timings)};
  page.warnings = warnings;
  page.papers.assign(std::begin(papers), std::end(papers));
  return page;
}

}  // namespace cocoon::app
