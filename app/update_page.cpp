// The HTML page of an update: update_page() of update_report.h.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>

#include "app/surface_report.h"
#include "app/update_report.h"

namespace cocoon::app {

namespace {

constexpr const char* model_color = "#b9c3cd";
constexpr const char* kept_color = "#8fa9c4";
constexpr const char* replaced_color = "#d1495b";
constexpr const char* border_color = "#f2b134";
constexpr const char* loop_color = "#c1121f";
constexpr const char* new_color = "#e58f3c";
constexpr std::array<const char*, 6> group_colors = {"#4c9f70", "#5876b8", "#c88a2d",
                                                     "#8e5ea2", "#3ba3a8", "#b4656f"};
constexpr std::array<const char*, 4> cloud_colors = {"#d9620b", "#7b2d8b", "#0a7d6f", "#a31f34"};

// One line each.
constexpr const char* papers[] = {
    "Woo & Dey: Updating 3D triangular mesh models based on locally added point clouds, 2005",
    "Amenta, Choi, Dey & Leekha: A simple algorithm for homeomorphic surface reconstruction, 2002",
    "Dey & Giesen: Detecting undersampling in surface reconstruction, 2001",
    "Dey & Goswami: Tight Cocone: a water-tight surface reconstructor, 2003",
    "Devillers & Teillaud: Perturbations and vertex removal in a 3D Delaunay triangulation, 2003",
};

// Triangles of a mesh as indices in an order of our own, so that layers are ranges.
class IndexList {
 public:
  explicit IndexList(const TriangleMesh& mesh) : mesh_(mesh) {}

  void add(TriangleId triangle) {
    for (const VertexId vertex : mesh_.triangles[triangle]) indices.push_back(vertex.value);
  }
  std::size_t size() const { return indices.size(); }

  std::vector<std::uint32_t> indices;

 private:
  const TriangleMesh& mesh_;
};

class PageBuilder {
 public:
  explicit PageBuilder(const UpdateRecord& record) : record_(record) {}

  ReportPage build(const std::vector<StageTime>& timings) {
    page_.title = "Cocoon: local mesh update";
    page_.subtitle =
        fmt::format("{} updated by {} cloud{}; program version {}", record_.model_name,
                    record_.clouds.size(), record_.clouds.size() == 1 ? "" : "s", COCOON_VERSION);
    add_model();
    for (std::size_t c = 0; c < record_.clouds.size(); ++c) add_cloud(c);
    add_updated();
    add_stages();
    add_tables();
    add_timings(timings);
    page_.warnings = record_.result.warnings;
    page_.papers.assign(std::begin(papers), std::end(papers));
    return std::move(page_);
  }

 private:
  void add_layer(const std::string& id, const std::string& name, const std::string& geometry,
                 PageLayer::Kind kind, const char* color, std::size_t first, std::size_t count) {
    if (count > 0) page_.layers.push_back({id, name, geometry, kind, color, 1, first, count});
  }

  // The model's triangles once, in the order border, group 0, group 1, ...; behind them once more
  // those with a rim point on them.
  void add_model() {
    const TriangleMesh& model = record_.model;
    const Regions& regions = record_.result.regions;
    const auto add_group = [&](IndexList& list, RegionId group) {
      for (const TriangleId t : model.triangles.ids()) {
        if (regions.region_of_facet[t] == group) list.add(t);
      }
    };
    IndexList list(model);
    add_group(list, RegionId());
    const std::size_t border = list.size();
    std::vector<std::size_t> begins;
    for (const RegionId group : regions.regions.ids()) {
      begins.push_back(list.size());
      add_group(list, group);
    }
    begins.push_back(list.size());
    for (const CloudReport& cloud : record_.result.clouds) {
      for (const TriangleId t : cloud.overlapping_facets) list.add(t);
    }
    constexpr auto triangles = PageLayer::Kind::triangles;
    add_layer("model", "initial model", "model", triangles, model_color, 0, begins.back());
    add_layer("overlap", "overlapping facets", "model", triangles, border_color, begins.back(),
              list.size() - begins.back());
    add_layer("border", "border (with traced facets)", "model", triangles, border_color, 0, border);
    for (const RegionId group : regions.regions.ids()) {
      const std::size_t k = group.index();
      const std::size_t count = begins[k + 1] - begins[k];
      const bool replaced = record_.result.choice.replaced[group] != 0;
      add_layer(fmt::format("group-{}", k), fmt::format("group {}", k), "model", triangles,
                group_colors[k % group_colors.size()], begins[k], count);
      add_layer(fmt::format("choice-{}", k),
                fmt::format("group {}: {}", k, replaced ? "replaced" : "kept"), "model", triangles,
                replaced ? replaced_color : kept_color, begins[k], count);
    }
    page_.geometries.push_back({"model", model.points.raw(), std::move(list.indices)});
  }

  void add_cloud(std::size_t c) {
    const std::string name = fmt::format("cloud-{}", c + 1);
    const std::string title = record_.clouds.size() == 1 ? "cloud" : fmt::format("cloud {}", c + 1);
    const auto& points = record_.clouds[c];
    add_layer(name, title, name, PageLayer::Kind::points, cloud_colors[c % cloud_colors.size()], 0,
              points.size());
    page_.geometries.push_back({name, points, {}});

    const TriangleMesh& surface = record_.result.clouds[c].surface.mesh;
    IndexList list(surface);
    for (const TriangleId t : surface.triangles.ids()) list.add(t);
    const std::string surface_name = name + "-surface";
    add_layer(surface_name, title + ": its Cocone surface", surface_name,
              PageLayer::Kind::triangles, "#dcc7a1", 0, list.size());
    page_.geometries.push_back({surface_name, surface.points.raw(), std::move(list.indices)});
    add_loops(name, title, record_.result.clouds[c].surface.rim);
  }

  void add_loops(const std::string& name, const std::string& title, const CloudRim& rim) {
    PageGeometry geometry{name + "-loops", {}, {}};
    for (const RimLoop& loop : rim.loops) {
      const std::size_t first = geometry.points.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        geometry.indices.push_back(static_cast<std::uint32_t>(first + i));
        geometry.indices.push_back(static_cast<std::uint32_t>(first + loop.next(i)));
      }
      geometry.points.insert(geometry.points.end(), loop.points.begin(), loop.points.end());
    }
    add_layer(geometry.name, title + ": boundary loops", geometry.name, PageLayer::Kind::lines,
              loop_color, 0, geometry.indices.size());
    page_.geometries.push_back(std::move(geometry));
  }

  // Triangles between kept vertices only come first, then those with a vertex of a cloud.
  void add_updated() {
    const TriangleMesh& mesh = record_.result.mesh;
    IdVector<VertexId, std::uint8_t> kept(mesh.points.size(), 0);
    for (const VertexId vertex : record_.result.vertex_map) {
      if (!vertex.is_none()) kept[vertex] = 1;
    }
    IndexList list(mesh);
    std::size_t old_end = 0;
    for (const bool old : {true, false}) {
      for (const TriangleId t : mesh.triangles.ids()) {
        const Triangle& triangle = mesh.triangles[t];
        const bool all_kept =
            std::all_of(triangle.begin(), triangle.end(), [&](VertexId v) { return kept[v] != 0; });
        if (all_kept == old) list.add(t);
      }
      if (old) old_end = list.size();
    }
    constexpr auto triangles = PageLayer::Kind::triangles;
    add_layer("updated-old", "updated model: kept", "updated", triangles, model_color, 0, old_end);
    add_layer("updated-new", "updated model: new", "updated", triangles, new_color, old_end,
              list.size() - old_end);
    page_.geometries.push_back({"updated", mesh.points.raw(), std::move(list.indices)});
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
    std::vector<std::string> surfaces;
    for (std::size_t c = 1; c <= record_.clouds.size(); ++c) {
      model_and_clouds.push_back(fmt::format("cloud-{}$", c));
      rims.push_back(fmt::format("cloud-{}-loops$", c));
      surfaces.push_back(fmt::format("cloud-{}-", c));
    }
    add_stage(
        "Model and cloud",
        "The closed initial model, and the scan of what has changed, in the same coordinates.",
        model_and_clouds);
    add_stage("Boundary", "The Cocone surface of the cloud alone, and the closed loops of its rim.",
              surfaces);
    add_stage("Overlapping facets", "The facets of the model on which points of the rim lie.",
              rims);
    add_stage("Groups",
              "The border of overlapping facets, closed by tracing the rim from facet to facet, "
              "cuts the model into groups.",
              {"border", "group-"});
    add_stage("Choice",
              "The group with the small angle to the cloud lies under it and is replaced (red).",
              {"border", "choice-"});
    add_stage(
        "Updated model",
        "The closed surface of kept points and cloud; triangles with a point of the cloud are "
        "orange.",
        {"updated-"});
  }

  void add_tables() {
    const UpdateResult& result = record_.result;
    const auto number = [](std::size_t value) {
      return PageTable::Cell(static_cast<double>(value));
    };
    const auto word = [](const char* text) { return PageTable::Cell(std::string(text)); };
    PageTable points{"Points", {"", ""}, {}};
    points.rows.push_back({word("initial model"), number(record_.model.points.size())});
    for (const auto& cloud : record_.clouds) {
      points.rows.push_back({word("+ cloud"), number(cloud.size())});
    }
    points.rows.push_back({word("\u2212 replaced"), number(result.replacement.replaced)});
    points.rows.push_back({word("\u2212 equal to another"), number(result.replacement.duplicates)});
    points.rows.push_back({word("updated"), number(result.replacement.points.size())});
    page_.tables.push_back(std::move(points));

    PageTable angles{"Mean angle at the rim", {"cloud", "group", "degrees", "decision"}, {}};
    for (std::size_t c = 0; c < result.clouds.size(); ++c) {
      for (const GroupAngle& group : result.clouds[c].groups) {
        angles.rows.push_back({number(c + 1), number(group.group.index()), group.mean_angle_deg,
                               word(group.under_cloud ? "replaced" : "kept")});
      }
    }
    page_.tables.push_back(std::move(angles));

    if (!result.split.empty()) {
      PageTable split{"Groups split by labels",
                      {"group", "new group", "facets under the cloud", "edges cut", "reach"},
                      {}};
      for (const SplitRegion& part : result.split) {
        split.rows.push_back({number(part.outside.index()), number(part.under.index()),
                              number(part.under_facets), number(part.cut_edges), part.reach});
      }
      page_.tables.push_back(std::move(split));
    }

    const MeshReport& surface = record_.certificate;
    PageTable check{"Updated surface", {"", ""}, {}};
    check.rows = {{word("triangles"), number(surface.triangles)},
                  {word("open edges"), number(surface.open_edges)},
                  {word("edges with more than two triangles"), number(surface.overfull_edges)},
                  {word("pinched vertices"), number(surface.pinched_vertices)},
                  {word("components"), number(surface.components)},
                  {word("Euler characteristic"), static_cast<double>(surface.euler)},
                  {word("points not on it"), number(result.reconstruction.unused_points)},
                  {word("hash"), mesh_hash(result.mesh)}};
    page_.tables.push_back(std::move(check));
  }

  void add_timings(const std::vector<StageTime>& timings) {
    PageTable table{"Time", {"stage", "seconds"}, {}};
    for (const StageTime& time : timings) table.rows.push_back({time.stage, time.seconds});
    page_.tables.push_back(std::move(table));
  }

  const UpdateRecord& record_;
  ReportPage page_;
};

}  // namespace

ReportPage update_page(const UpdateRecord& record, const std::vector<StageTime>& timings) {
  return PageBuilder(record).build(timings);
}

}  // namespace cocoon::app
