#include "app/pending_clouds.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "io/byte_order.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "tests/io/temporary_folder.h"

namespace cocoon::app {
namespace {

const std::vector<std::string> notes = {"model"};
const PendingCloud applied = {"one", {{1, 2, 3}, {4, 5, 6}}, 0.25};
const PendingCloud refused = {"two", {}, {}, true};

// Each follows those before it.
std::string save(const TemporaryFolder& folder, const std::vector<PendingCloud>& clouds) {
  std::string session = (folder / "s").string();
  std::vector<std::string> before = notes;
  for (const PendingCloud& cloud : clouds) {
    FileBatch batch;
    save_pending_cloud(session, before, cloud, batch);
    batch.commit();
    before.push_back(cloud.note);
  }
  return session;
}

// With the checksum that belongs to it.
std::string with_byte(std::string bytes, std::size_t at, char value) {
  bytes[at] = value;
  bytes.resize(bytes.size() - checksum_size);
  append_little_endian(bytes, checksum_of(bytes));
  return bytes;
}

TEST(PendingCloud, AppliedAndRefusedReadBackInOrder) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {refused, applied, refused});
  const std::vector<PendingCloud> loaded = load_pending_clouds(session, notes);
  ASSERT_EQ(loaded.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const PendingCloud& saved = k == 1 ? applied : refused;
    EXPECT_EQ(loaded[k].note, saved.note);
    EXPECT_EQ(loaded[k].points, saved.points);
    EXPECT_EQ(loaded[k].rho, saved.rho);
    EXPECT_EQ(loaded[k].refused, saved.refused);
  }
}

TEST(PendingCloud, VersionsBeforeAreReadAndOthersRefused) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {applied});
  const std::string file = pending_cloud_file(session, 1);
  const std::string bytes(read_file(file).view());
  folder.write("s.cloud-1", with_byte(bytes, 8, 1));
  EXPECT_EQ(load_pending_clouds(session, notes).at(0).points, applied.points);
  for (const char version : {'\x00', '\x03'}) {
    folder.write("s.cloud-1", with_byte(bytes, 8, version));
    EXPECT_THROW(load_pending_clouds(session, notes), FileError) << static_cast<int>(version);
  }
}

TEST(PendingCloud, ARefusedOneHasNoPoints) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {applied});
  const std::string bytes(read_file(pending_cloud_file(session, 1)).view());
  folder.write("s.cloud-1", with_byte(bytes, 12, 3));
  EXPECT_THROW(load_pending_clouds(session, notes), FileError);
}

}  // namespace
}  // namespace cocoon::app
