#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <variant>

#include "app/report/update_report.h"
#include "geom/signed_distance.h"
#include "tests/mesh_gallery.h"

namespace cocoon::app {
namespace {

// A sphere, and a cap of a larger one around a pole, whose rim lies on it: the upper one or, for
// `pole` -1, the lower one.
struct UpdatedSphere {
  explicit UpdatedSphere(double pole = 1) {
    const double angle = 2.399963229728653;  // of the sunflower
    const int count = 4000;
    clouds.emplace_back();
    for (int i = 0; i < count; ++i) {
      const double z = 1 - 2 * (i + 0.5) / count;
      if (z < 0.7) break;
      const double r = std::sqrt(1 - z * z);
      const double lift = std::max(0.0, 0.5 * (z - 0.8));
      clouds[0].push_back({r * std::cos(angle * i), r * std::sin(angle * i), pole * (z + lift)});
    }
    result = update_model(model, clouds);
    certificate = mesh_check(result.mesh);
  }
  ReportPage page() const {
    UpdateRecord record{"sphere", model, names, clouds, result, certificate};
    for (const auto& cloud : clouds) record.deviation.push_back(signed_distances(model, cloud));
    const Points vertices = result.mesh.points.raw();
    record.deviation.push_back(
        signed_distances(model, vertices.subspan(result.reconstruction.point_of_vertex.size())));
    return update_page(record, {}, {"one of reading"});
  }
  // As two views that overlap, each of which sees somewhat more than a half.
  void divide_cloud() {
    const std::vector<Point> whole = std::exchange(clouds[0], {});
    clouds.emplace_back();
    for (const Point& p : whole) {
      if (p.x < 0.2) clouds[0].push_back(p);
      if (p.x > -0.2) clouds[1].push_back(p);
    }
    names = {"left", "right"};
    result = update_model(model, clouds);
  }

  TriangleMesh model = gallery::sphere(4);
  std::vector<std::vector<Point>> clouds;
  std::vector<std::string> names = {"cap"};
  UpdateResult result;
  MeshReport certificate;
};

const PageGeometry& geometry_of(const ReportPage& page, const std::string& id) {
  return *std::find_if(page.geometries.begin(), page.geometries.end(),
                       [&](const PageGeometry& geometry) { return geometry.id == id; });
}

TEST(UpdatePage, ShowsTheUpdatedMeshWithThePointsOfTheInputs) {
  const UpdatedSphere sphere;
  ASSERT_EQ(sphere.result.status, UpdateStatus::ok) << sphere.result.message;
  const ReportPage page = sphere.page();
  EXPECT_EQ(page.stages.size(), 6U);
  for (const PageStage& stage : page.stages) EXPECT_FALSE(stage.layers.empty()) << stage.name;
  EXPECT_EQ(page.points.positions.size(), sphere.model.points.size() + sphere.clouds[0].size());
  EXPECT_EQ(page.points.labels.of_element.size(), page.points.positions.size());
  EXPECT_EQ(page.points.fields[0].values.size(), page.points.positions.size());
  const PageGeometry& updated = geometry_of(page, "updated");
  ASSERT_EQ(updated.indices.size(), 3 * sphere.result.mesh.triangles.size());
  for (const TriangleId t : sphere.result.mesh.triangles.ids()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = sphere.result.mesh.triangles[t][k];
      EXPECT_EQ(page.points.positions[updated.indices[3 * t.index() + k]],
                sphere.result.mesh.points[v]);
    }
  }
}

TEST(UpdatePage, CountsOfLayersAreThoseOfTheResult) {
  const UpdatedSphere sphere;
  const ReportPage page = sphere.page();
  const PageGeometry& model = geometry_of(page, "model");
  const auto count = [&](const std::string& id) {
    const auto layer = std::find_if(page.layers.begin(), page.layers.end(),
                                    [&](const PageLayer& entry) { return entry.id == id; });
    return std::count_if(model.labels.of_element.begin(), model.labels.of_element.end(),
                         [&](std::uint32_t label) {
                           return std::count(layer->labels.begin(), layer->labels.end(), label) > 0;
                         });
  };
  const UpdateResult& result = sphere.result;
  EXPECT_EQ(count("overlap"), std::ptrdiff_t(result.clouds[0].overlapping_facets.size()));
  EXPECT_EQ(count("overlap") + count("traced"), std::ptrdiff_t(result.regions.border_facets));
  ASSERT_EQ(result.replaced_groups.size(), 1U);
  EXPECT_EQ(count("replaced"),
            std::ptrdiff_t(result.regions.regions[result.replaced_groups[0]].facets));
  EXPECT_EQ(count("replaced") + count("kept") + count("overlap") + count("traced"),
            std::ptrdiff_t(sphere.model.triangles.size()));
}

TEST(UpdatePage, DeviationIsPositiveOutsideTheOldModel) {
  const UpdatedSphere sphere;
  const ReportPage page = sphere.page();
  const std::vector<double>& values = page.points.fields[0].values;
  const std::size_t top = sphere.model.points.size();  // the first point of the cloud is its pole
  EXPECT_NEAR(values[top], 0.1, 0.02);
  EXPECT_EQ(values[0], 0);
}

TEST(UpdatePage, LooksAtTheChange) {
  EXPECT_GT(UpdatedSphere(1).page().view.elevation_deg, 0);
  EXPECT_LT(UpdatedSphere(-1).page().view.elevation_deg, 0);
}

const PageTable& table_of(const ReportPage& page, const std::string& title) {
  return *std::find_if(page.tables.begin(), page.tables.end(),
                       [&](const PageTable& table) { return table.title == title; });
}

TEST(UpdatePage, JoinedCloudsHaveOneSurfaceAndRim) {
  UpdatedSphere sphere;
  sphere.divide_cloud();
  ASSERT_EQ(sphere.result.status, UpdateStatus::ok) << sphere.result.message;
  ASSERT_EQ(sphere.result.clouds[1].joined_with, 0U);
  const ReportPage page = sphere.page();
  const auto has_geometry = [&](const std::string& id) {
    return std::any_of(page.geometries.begin(), page.geometries.end(),
                       [&](const PageGeometry& geometry) { return geometry.id == id; });
  };
  EXPECT_TRUE(has_geometry("cloud-1") && has_geometry("cloud-2"));
  EXPECT_TRUE(has_geometry("cloud-1-surface") && has_geometry("cloud-1-loops"));
  EXPECT_FALSE(has_geometry("cloud-2-surface") || has_geometry("cloud-2-loops"));
  // Corners of the surface are points of the cloud in which they lie.
  const PageGeometry& surface = geometry_of(page, "cloud-1-surface");
  EXPECT_EQ(surface.name, "Cocone surface of the clouds 1, 2");
  const TriangleMesh& mesh = sphere.result.clouds[0].surface.mesh;
  ASSERT_EQ(surface.indices.size(), 3 * mesh.triangles.size());
  for (const TriangleId t : mesh.triangles.ids()) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(page.points.positions[surface.indices[3 * t.index() + k]],
                mesh.points[mesh.triangles[t][k]]);
    }
  }
  EXPECT_EQ(table_of(page, "Boundary").rows.size(), 1U);
}

TEST(UpdatePage, AnglesComeWithTheVerdictOfTheSummary) {
  UpdatedSphere sphere;
  ASSERT_EQ(sphere.result.replaced_groups.size(), 1U);
  const std::vector<RegionVerdict>& groups = sphere.result.clouds[0].groups;
  const auto expect_verdicts = [&] {
    const ReportPage page = sphere.page();
    const PageTable& table = table_of(page, "Mean angle at the rim");
    ASSERT_EQ(table.rows.size(), groups.size());
    for (std::size_t k = 0; k < groups.size(); ++k) {
      EXPECT_EQ(std::get<std::string>(table.rows[k].back()),
                verdict_on(groups[k], sphere.result.clouds[0], sphere.result.islands));
    }
  };
  expect_verdicts();
  // If it had gone since samples contradict it.
  sphere.result.islands = sphere.result.replaced_groups;
  expect_verdicts();
}

// As the certificate has it: a crossing of four sheets may be as closed as any other edge.
TEST(UpdatePage, VerdictsAreThoseOfTheCertificate) {
  UpdatedSphere sphere;
  sphere.certificate = MeshReport();
  EXPECT_EQ(sphere.page().verdicts[0], "open");  // no triangle
  sphere.certificate.watertight = true;
  sphere.certificate.edge_manifold = sphere.certificate.vertex_manifold = true;
  EXPECT_EQ(sphere.page().verdicts[0], "closed");
  EXPECT_EQ(sphere.page().verdicts[1], "manifold");
  EXPECT_EQ(sphere.page().warnings, (std::vector<std::string>{"one of reading"}));
}

TEST(UpdateReport, VerdictsSayWhyAGroupGoes) {
  RegionVerdict group;
  group.region = RegionId(3);
  const CloudReport cloud;
  CloudReport by_samples;
  by_samples.is_told_by_samples = true;
  CloudReport by_sure_angles;
  by_sure_angles.is_told_by_sure_angles = true;
  const std::vector<RegionId> islands = {RegionId(1), RegionId(3)};
  EXPECT_EQ(verdict_on(group, cloud, islands), "kept");
  EXPECT_EQ(verdict_on(group, cloud, {}, {.kept = {RegionId(3)}}), "kept, as was said");
  group.under_cloud = true;
  EXPECT_EQ(verdict_on(group, cloud, {}), "replaced");
  EXPECT_EQ(verdict_on(group, by_samples, {}), "replaced, as its samples tell");
  EXPECT_EQ(verdict_on(group, by_sure_angles, {}), "replaced, as sure angles tell");
  EXPECT_EQ(verdict_on(group, cloud, islands), "replaced: samples off the model lie over it");
  EXPECT_EQ(verdict_on(group, cloud, islands, {.replaced = {RegionId(3)}}),
            "replaced, as was said");
}

// Vertices that are no input points, as --manifold adds them.
TEST(UpdatePage, ShowsVerticesAddedBehindThoseOfTheUpdate) {
  UpdatedSphere sphere;
  TriangleMesh& mesh = sphere.result.mesh;
  const VertexId copy = mesh.points.push_back(mesh.points[mesh.triangles[TriangleId(0)][0]]);
  mesh.triangles[TriangleId(0)][0] = copy;
  const ReportPage page = sphere.page();
  EXPECT_EQ(page.points.parts.back().name, "added vertices");
  EXPECT_EQ(page.points.parts.back().count, 1U);
  EXPECT_EQ(geometry_of(page, "updated").indices[0], page.points.positions.size() - 1);
  EXPECT_EQ(page.points.fields[0].values.size(), page.points.positions.size());
}

}  // namespace
}  // namespace cocoon::app
