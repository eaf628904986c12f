#include "cocone/live/surface_state.h"

#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "cocone/dynamic_tight_cocone.h"
#include "cocone/mark_cells.h"
#include "geom/errors.h"
#include "tests/cocone/sample_shapes.h"

namespace cocoon {
namespace {

using Snapshot = DynamicTightCocone::Snapshot;

Snapshot snapshot_of(const std::vector<Point>& points) {
  DynamicTightCocone surface;
  surface.reconstruct(points);
  return surface.snapshot();
}

std::string fault_of(const Snapshot& snapshot, int threads = 1) {
  try {
    check_surface_state(snapshot.triangulation, snapshot.surface, {.threads = threads});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// The first cell with one of these flags.
CellId cell_with(const IdVector<CellId, std::uint8_t>& flags, unsigned wanted) {
  for (const CellId c : flags.ids()) {
    if ((flags[c] & wanted) != 0) return c;
  }
  return {};
}
unsigned lowest_bit(unsigned flags) { return flags & (~flags + 1); }

TEST(SurfaceState, WhatTheStagesFindHasNoFault) {
  const Snapshot certain = snapshot_of(shapes::sphere(400, 3));
  EXPECT_FALSE(certain.surface.sides.empty());
  EXPECT_EQ(fault_of(certain), "");
  const Snapshot uncertain = snapshot_of(shapes::noisy_sphere(400, 0.03, 3));
  EXPECT_TRUE(uncertain.surface.sides.empty());
  EXPECT_FALSE(uncertain.surface.marks.empty());
  EXPECT_FALSE(uncertain.surface.out.empty());
  EXPECT_EQ(fault_of(uncertain), "");
  EXPECT_EQ(fault_of({certain.triangulation, {}}), "");
}

// One value is changed at a time, in a way that no surface can have.
TEST(SurfaceState, WhatCannotBeIsRefused) {
  const Snapshot good = snapshot_of(shapes::sphere(400, 3));
  const auto fault_after = [&](auto spoil) {
    Snapshot spoiled = good;
    spoil(spoiled.surface);
    const std::string fault = fault_of(spoiled);
    EXPECT_EQ(fault, fault_of(spoiled, 4));
    EXPECT_EQ(fault.find('\n'), std::string::npos);
    return fault;
  };
  const std::string begins = "what is known of the surface does not fit: ";
  const auto first = [](auto& values) -> auto& { return values.raw().front(); };
  EXPECT_EQ(fault_after([&](SurfaceState& s) { s.candidates.steps.push_back(0); }),
            begins + "other numbers of vertices or cells");
  EXPECT_EQ(fault_after([&](SurfaceState& s) { s.sides.push_back(0); }),
            begins + "other numbers of vertices or cells");
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              first(s.candidates.normals).y = std::numeric_limits<double>::quiet_NaN();
            }),
            begins + "a normal");
  EXPECT_EQ(fault_after([&](SurfaceState& s) { first(s.candidates.vertex_flags) = 8; }),
            begins + "a vertex");
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              first(s.candidates.samples) = static_cast<SampleState>(3);
            }),
            begins + "a sample");
  // A finite cell that would be infinite, a candidate from one side only, a pruned facet that is
  // no candidate.
  const std::string flags = begins + "flags of cell ";
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              first(s.candidates.cell_flags) ^= cell_flag::finite | cell_flag::infinite;
            }),
            flags + "0");
  const IdVector<CellId, std::uint8_t>& kept = good.surface.candidates.cell_flags;
  const CellId candidate = cell_with(kept, cell_flag::candidate_facets);
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              const unsigned f = lowest_bit(kept[candidate]);
              s.candidates.cell_flags[candidate] = static_cast<std::uint8_t>(kept[candidate] & ~f);
            }).substr(0, flags.size()),
            flags);
  EXPECT_EQ(fault_after([&](SurfaceState& s) { first(s.candidates.pruned) = 16; }), flags + "0");
  // A facet of the surface with an outer side only, and one with two.
  const std::string side = begins + "a side of cell ";
  const CellId outer = cell_with(good.surface.sides, 15);
  const std::uint8_t sides = good.surface.sides[outer];
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              s.sides[outer] = static_cast<std::uint8_t>(sides & ~lowest_bit(sides));
            }).substr(0, side.size()),
            side);
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              s.sides[outer] = static_cast<std::uint8_t>(sides | lowest_bit(sides) << 4);
            }).substr(0, side.size()),
            side);
}

TEST(SurfaceState, MarksAndBodiesThatCannotBeAreRefused) {
  const Snapshot good = snapshot_of(shapes::noisy_sphere(400, 0.03, 3));
  ASSERT_FALSE(good.surface.marks.empty());
  const auto fault_after = [&](auto spoil) {
    Snapshot spoiled = good;
    spoil(spoiled.surface);
    const std::string fault = fault_of(spoiled);
    EXPECT_EQ(fault, fault_of(spoiled, 4));
    return fault;
  };
  const std::string begins = "what is known of the surface does not fit: ";
  for (const auto& spoil : std::vector<std::function<void(SurfaceState&)>>{
           [](SurfaceState& s) { s.marks.cells.push_back(0); },
           [](SurfaceState& s) { s.marks.vertices.push_back(0); },
           [](SurfaceState& s) { s.marks.vertices = {}; },
           [](SurfaceState& s) { s.out.push_back(1); }}) {
    EXPECT_EQ(fault_after(spoil), begins + "other numbers of vertices or cells");
  }
  EXPECT_EQ(fault_after([](SurfaceState& s) {
              s.marks.vertices[VertexId(7)] = mark_flag::good | mark_flag::folded;
            }),
            begins + "marks of a vertex");
  // A label and a flag that are not there, and a facet marked from one side only.
  const CellId marked = cell_with(good.surface.marks.cells, mark_flag::surface_facets);
  const std::string cell = begins + "marks of cell ";
  for (const unsigned wrong :
       {mark_flag::label, 64U, lowest_bit(good.surface.marks.cells[marked])}) {
    EXPECT_EQ(fault_after([&](SurfaceState& s) {
                const unsigned marks = s.marks.cells[marked];
                s.marks.cells[marked] = static_cast<std::uint8_t>(
                    wrong == mark_flag::label ? marks | wrong : marks ^ wrong);
              }).substr(0, cell.size()),
              cell);
  }
  // Facets of the surface are candidates.
  EXPECT_EQ(fault_after([&](SurfaceState& s) {
              CellId c(0);
              while ((s.candidates.cell_flags[c] & cell_flag::candidate_facets) != 0) {
                c = CellId(c.index() + 1);
              }
              s.marks.cells[c] = static_cast<std::uint8_t>(s.marks.cells[c] | 1);
            }).substr(0, cell.size()),
            cell);
  // An infinite cell in the body, and a side that is none.
  const std::string body = begins + "the body at cell ";
  EXPECT_EQ(fault_after([](SurfaceState& s) { s.out.raw().back() = 0; }).substr(0, body.size()),
            body);
  EXPECT_EQ(fault_after([](SurfaceState& s) { s.out.raw().front() = 2; }), body + "0");
}

// What would label the cells of the next surface has labels that can be: at good vertices they
// change across the surface and nowhere else, and what lies beyond all points is outside.
TEST(SurfaceState, LabelsThatCannotBeAreRefused) {
  const Snapshot good = snapshot_of(shapes::noisy_sphere(400, 0.03, 3));
  ASSERT_FALSE(good.surface.marks.empty());
  const auto fault_with_label = [&](CellId c, CellLabel label) {
    Snapshot spoiled = good;
    std::uint8_t& marks = spoiled.surface.marks.cells[c];
    const unsigned shifted = static_cast<unsigned>(label) << mark_flag::label_shift;
    marks = static_cast<std::uint8_t>((marks & ~mark_flag::label) | shifted);
    return fault_of(spoiled);
  };
  const CellId infinite = *good.triangulation.infinite_cells().begin();
  for (const CellId c : {CellId(0), CellId(400), infinite}) {
    std::size_t possible = 0;
    for (const CellLabel label : {CellLabel::unmarked, CellLabel::out, CellLabel::in}) {
      const std::string fault = fault_with_label(c, label);
      possible += fault.empty() ? 1 : 0;
      if (fault.empty()) continue;
      EXPECT_EQ(fault.rfind("what is known of the surface does not fit: marks of cell ", 0), 0U);
    }
    EXPECT_EQ(possible, 1U) << c.index();
  }
}

}  // namespace
}  // namespace cocoon
