#include "app/files/session_file.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "io/encoding/byte_order.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "tests/cocone/sample_shapes.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

// Each by itself: what a session remembers of its parameters.
const std::vector<std::function<void(SurfaceArguments&)>> settings{
    [](SurfaceArguments& a) { a.mode = Mode::paper; },
    [](SurfaceArguments& a) { a.alpha_deg = 25; },
    [](SurfaceArguments& a) { a.cocone_angle_deg = 20; },
    [](SurfaceArguments& a) { a.sharp_angle_deg = 80; },
};

TEST(SessionFile, EachParameterCounts) {
  for (const auto& set : settings) {
    SurfaceArguments given;
    set(given);
    EXPECT_FALSE(same_parameters(given, {}));
    EXPECT_TRUE(same_parameters(given, given));
  }
  SurfaceArguments other_rho;
  other_rho.rho = 0.2;
  EXPECT_TRUE(same_parameters(other_rho, {}));
}

TEST(SessionFile, KeepsParametersAndNotes) {
  const TemporaryFolder folder;
  const std::string path = (folder / "session").string();
  SavedSession session;
  session.snapshot.points = shapes::sphere(4, 1);
  session.notes = {"one", "", "three words here"};
  for (const auto& set : settings) {
    session.parameters = {};
    set(session.parameters);
    save_session(path, session);
    const SavedSession loaded = load_session(path);
    EXPECT_TRUE(same_parameters(loaded.parameters, session.parameters));
    EXPECT_EQ(loaded.notes, session.notes);
    EXPECT_EQ(loaded.snapshot.points, session.snapshot.points);
  }
}

// With the checksum that belongs to it.
std::string with_version(std::string bytes, char version) {
  bytes[8] = version;
  bytes.resize(bytes.size() - checksum_size);
  append_little_endian(bytes, checksum_of(bytes));
  return bytes;
}

TEST(SessionFile, VersionsBeforeAreReadAndOthersRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "session").string();
  SavedSession session;
  session.snapshot.points = shapes::sphere(4, 1);
  session.notes = {"cloud of before"};
  save_session(path, session);
  const std::string bytes(read_file(path).view());
  for (const char version : {'\x03', '\x04'}) {
    folder.write("session", with_version(bytes, version));
    EXPECT_EQ(load_session(path).notes, session.notes) << static_cast<int>(version);
  }
  for (const char version : {'\x02', '\x06'}) {
    folder.write("session", with_version(bytes, version));
    EXPECT_THROW(load_session(path), FileError) << static_cast<int>(version);
  }
}

}  // namespace
}  // namespace cocoon::app
