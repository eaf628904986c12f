#include "update/model/require_ascending.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>
#include <vector>

#include "geom/errors.h"

namespace cocoon {
namespace {

std::string refusal(std::initializer_list<std::size_t> indices, std::size_t count) {
  std::vector<VertexId> vertices;
  for (const std::size_t i : indices) vertices.push_back(VertexId(i));
  try {
    require_ascending("stage", "these", vertices, count);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RequireAscending, RefusesWhatIsOutOfOrderRepeatedOrOfAnotherModel) {
  EXPECT_EQ(refusal({}, 0), "");
  EXPECT_EQ(refusal({0, 3, 4}, 5), "");
  EXPECT_NE(refusal({3, 0}, 5).find("stage: these must be ascending"), std::string::npos);
  EXPECT_NE(refusal({3, 3}, 5), "");
  EXPECT_NE(refusal({3, 5}, 5).find('5'), std::string::npos);
}

}  // namespace
}  // namespace cocoon
