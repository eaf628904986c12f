#include "cocone/close_body.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "cocone/peel_cells.h"
#include "cocone/surface_mesh.h"
#include "geom/errors.h"
#include "tests/cocone/marked.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

// Half a sphere: nothing but the clean-up can tell which cells close it.
struct PeeledDome {
  std::vector<Point> points = shapes::cut_sphere(500, 0.2, 3);
  Stages stages{points};
  BoundarySamples labels = stages.labels();
  LinkedFacets surface = stages.surface(labels);
  CellMarks peeled = peel_cells(stages.triangulation, surface.set,
                                mark_cells(stages.triangulation, surface, labels.boundary));

  std::vector<CellId> poor_cells() const {
    std::vector<CellId> cells;
    for (const CellId c : stages.triangulation.finite_cells()) {
      if (is_poor(stages.triangulation, peeled.good, c)) cells.push_back(c);
    }
    return cells;
  }
  IdVector<CellId, CellLabel> label_all(const std::vector<CellId>& cells, CellLabel label) const {
    IdVector<CellId, CellLabel> labels_of_cells(stages.triangulation.num_cells(),
                                                CellLabel::unmarked);
    for (const CellId c : cells) labels_of_cells[c] = label;
    return labels_of_cells;
  }
  ClosedBody close(const KnownLabels& told, const ReconstructOptions& options = {}) const {
    return close_body({stages.triangulation, surface, labels.boundary, stages.poles}, peeled, told,
                      options);
  }
};

TEST(CloseBody, ByHandItIsTheBodyOfTheReconstruction) {
  const PeeledDome dome;
  ASSERT_TRUE(is_in_doubt(dome.peeled));
  const ClosedBody body = dome.close({});
  const ReconstructResult expected = reconstruct_tight(dome.points);
  EXPECT_EQ(surface_between(dome.stages.triangulation, body.marks).mesh.triangles,
            expected.mesh.triangles);
  EXPECT_EQ(body.clean_up.undecided_cells, expected.counters.clean_up.undecided_cells);
  EXPECT_EQ(body.likely_cells, 0U);
}

// Of cells that no good vertex tells anything about.
TEST(CloseBody, WhatIsKnownDecidesWhereMarksAreInDoubt) {
  const PeeledDome dome;
  const std::vector<CellId> cells = dome.poor_cells();
  ASSERT_GT(cells.size(), 10U);
  for (const CellLabel label : {CellLabel::in, CellLabel::out}) {
    KnownLabels told;
    told.labels = dome.label_all(cells, label);
    const ClosedBody body = dome.close(told);
    EXPECT_TRUE(std::all_of(cells.begin(), cells.end(), [&](CellId c) {
      return (body.marks.reached[c] == 0) == (label == CellLabel::in);
    }));
  }
}

// If the surface is no rougher by it; by all that is likely or by none.
TEST(CloseBody, WhatIsLikelyIsHeededWhereTheSurfaceIsNoRougher) {
  const PeeledDome dome;
  const ClosedBody without = dome.close({});
  std::vector<CellId> inside;
  for (const CellId c : dome.poor_cells()) {
    if (without.marks.reached[c] == 0) inside.push_back(c);
  }
  ASSERT_GT(inside.size(), 2U);
  KnownLabels told;
  told.likely = dome.label_all(inside, CellLabel::in);
  EXPECT_TRUE(needs_links(told));
  const ClosedBody agreed = dome.close(told);
  EXPECT_EQ(agreed.likely_cells, inside.size());
  EXPECT_EQ(agreed.contradicted_likely, 0U);
  EXPECT_EQ(agreed.heeded_likely, 0U);  // nothing to be heeded
  EXPECT_EQ(agreed.marks.reached, without.marks.reached);
  told.likely = dome.label_all(inside, CellLabel::out);
  const ClosedBody heeded = dome.close(told);
  EXPECT_EQ(heeded.contradicted_likely, inside.size());
  EXPECT_EQ(heeded.heeded_likely, inside.size());
  EXPECT_NE(heeded.marks.reached, without.marks.reached);
  // Then nothing would be left.
  for (CellLabel& label : told.likely) label = CellLabel::out;
  const ClosedBody refused = dome.close(told);
  EXPECT_GT(refused.contradicted_likely, inside.size());
  EXPECT_EQ(refused.heeded_likely, 0U);
  EXPECT_EQ(refused.marks.reached, without.marks.reached);
}

TEST(CloseBody, LabelsOfAnotherTriangulationAreRefused) {
  const PeeledDome dome;
  KnownLabels told;
  told.undisturbed = {CellId(0)};
  told.labels = IdVector<CellId, CellLabel>(3, CellLabel::unmarked);
  EXPECT_THROW(dome.close(told), InputError);
  told.undisturbed = {};
  EXPECT_THROW(dome.close(told), InputError);
  told = {};
  told.likely = IdVector<CellId, CellLabel>(3, CellLabel::in);
  EXPECT_THROW(dome.close(told), InputError);
  EXPECT_THROW(dome.close({}, {.max_contradicted_likely = -1}), InputError);
}

}  // namespace
}  // namespace cocoon
