#include "cocone/marking/likely_labels.h"

#include <gtest/gtest.h>

#include "geom/errors.h"

namespace cocoon {
namespace {

using Labels = IdVector<CellId, CellLabel>;

Labels labels(std::initializer_list<CellLabel> list) {
  Labels result;
  for (const CellLabel label : list) result.push_back(label);
  return result;
}

constexpr CellLabel none = CellLabel::unmarked;
constexpr CellLabel in = CellLabel::in;
constexpr CellLabel out = CellLabel::out;

TEST(LikelyLabels, AreContradictedByCellsOnTheOtherSide) {
  const Labels likely = labels({none, in, out, in, out, none});
  IdVector<CellId, std::uint8_t> reached(6, 0);
  reached[CellId(0)] = reached[CellId(1)] = reached[CellId(4)] = 1;
  EXPECT_EQ(count_labels(likely), 4U);
  EXPECT_EQ(count_contradicted(likely, reached), 2U);  // the first IN, the first OUT
  EXPECT_EQ(count_contradicted(labels({}), {}), 0U);
  EXPECT_THROW(count_contradicted(labels({in}), reached), InputError);
}

TEST(LikelyLabels, YieldToKnownOnes) {
  KnownLabels known;
  known.likely = labels({none, in, out, in});
  EXPECT_EQ(with_likely(known), known.likely);
  known.labels = labels({in, out, none, none});
  EXPECT_EQ(with_likely(known), labels({in, out, out, in}));
}

}  // namespace
}  // namespace cocoon
