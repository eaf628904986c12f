// Point sets with names, for tests that run over many of them.
#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

#include "geom/point.h"

namespace cocoon {

struct NamedSet {
  const char* name;
  std::function<std::vector<Point>()> make;
};

inline std::ostream& operator<<(std::ostream& out, const NamedSet& set) { return out << set.name; }

inline std::string name_of(const testing::TestParamInfo<NamedSet>& info) { return info.param.name; }

}  // namespace cocoon
