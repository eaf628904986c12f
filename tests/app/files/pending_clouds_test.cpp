#include "app/files/pending_clouds.h"

#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "io/encoding/byte_order.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

const std::vector<std::string> notes = {"model"};
const PendingUpdate applied = {{"one"}, {{{1, 2, 3}, {4, 5, 6}}}, 0.25};
const PendingUpdate refused = {{"two"}, {}, {}, true};
const PendingUpdate together = {
    {"three", "and four"}, {{{7, 8, 9}}, {{1, 1, 1}, {2, 2, 2}}}, {}, false, true};

// Bytes of the file.
constexpr std::size_t at_version = 8;
constexpr std::size_t at_bits = 12;
constexpr std::size_t at_count = 32;

// Each follows those before it.
std::string save(const TemporaryFolder& folder, const std::vector<PendingUpdate>& updates) {
  std::string session = (folder / "s").string();
  std::vector<std::string> before = notes;
  for (const PendingUpdate& update : updates) {
    FileBatch batch;
    save_pending_clouds(session, before, update, batch);
    batch.commit();
    before.insert(before.end(), update.notes.begin(), update.notes.end());
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

// Who saved them used one name, who takes the session up another one.
TEST(PendingClouds, LieBesideTheSessionBehindSymbolicLinks) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  const std::string session = (folder / "real").string();
  const std::string link = (elsewhere / "link").string();
  std::filesystem::create_symlink(session, folder / "s");
  std::filesystem::create_symlink(folder / "s", link);
  save(folder, {applied});
  EXPECT_TRUE(std::filesystem::exists(session + ".cloud-1"));
  for (const std::string& name : {session, link}) {
    EXPECT_EQ(load_pending_clouds(name, notes).size(), 1U) << name;
  }
  remove_pending_clouds(link);
  EXPECT_FALSE(std::filesystem::exists(session + ".cloud-1"));
}

TEST(PendingClouds, ReadBackInOrder) {
  const TemporaryFolder folder;
  const std::vector<PendingUpdate> saved = {refused, together, applied, refused};
  const std::vector<PendingUpdate> loaded = load_pending_clouds(save(folder, saved), notes);
  ASSERT_EQ(loaded.size(), saved.size());
  for (std::size_t k = 0; k < saved.size(); ++k) {
    EXPECT_EQ(loaded[k].notes, saved[k].notes);
    EXPECT_EQ(loaded[k].clouds, saved[k].clouds);
    EXPECT_EQ(loaded[k].rho, saved[k].rho);
    EXPECT_EQ(loaded[k].refused, saved[k].refused);
    EXPECT_EQ(loaded[k].keep_crowded, saved[k].keep_crowded);
  }
  EXPECT_TRUE(std::filesystem::exists(pending_cloud_file((folder / "s").string(), 4)));
}

// What came after it cannot be applied without it, and is nothing to be removed silently.
TEST(PendingClouds, AMissingOneIsNamed) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {refused, together, applied});  // 1, 2 and 4
  for (const std::size_t missing : {1, 2}) {
    const std::string file = pending_cloud_file(session, missing);
    const std::string bytes(read_file(file).view());
    std::filesystem::remove(file);
    try {
      load_pending_clouds(session, notes);
      ADD_FAILURE() << missing;
    } catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()).find(file + ": is missing, but "), 0U) << error.what();
    }
    folder.write(std::filesystem::path(file).filename().string(), bytes);
  }
  EXPECT_EQ(load_pending_clouds(session, notes).size(), 3U);
  // However the folder is spelled.
  const std::string spelled = (folder / "").string() + "/./s";
  std::filesystem::remove(pending_cloud_file(session, 1));
  EXPECT_THROW(load_pending_clouds(spelled, notes), FileError);
  save(folder, {refused});
  EXPECT_EQ(load_pending_clouds(spelled, notes).size(), 3U);
  // Those before are in the session already.
  const std::vector<std::string> more = {"model", "two", "three", "and four"};
  EXPECT_EQ(load_pending_clouds(session, more).size(), 1U);
  const std::vector<std::string> all = {"model", "two", "three", "and four", "one"};
  EXPECT_EQ(load_pending_clouds(session, all).size(), 0U);
  // By numbers, not by letters.
  std::vector<std::string> many(10, "note");
  EXPECT_EQ(load_pending_clouds(session, many).size(), 0U);
  remove_pending_clouds(spelled);
  EXPECT_FALSE(std::filesystem::exists(pending_cloud_file(session, 1)));
}

TEST(PendingClouds, FilesOfSomebodyElseAreNotRemoved) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {applied});
  folder.write("s.cloud-7", "what somebody needs");
  remove_pending_clouds(session);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"s.cloud-7"});
  EXPECT_EQ(content_of(folder.file("s.cloud-7")), "what somebody needs");
}

// The first two had no number of clouds.
TEST(PendingClouds, VersionsBeforeAreReadAndOthersRefused) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {applied});
  const std::string bytes(read_file(pending_cloud_file(session, 1)).view());
  std::string before = bytes;
  before.erase(at_count, sizeof(std::uint64_t));
  for (const char version : {'\x01', '\x02'}) {
    folder.write("s.cloud-1", with_byte(before, at_version, version));
    const PendingUpdate loaded = load_pending_clouds(session, notes).at(0);
    EXPECT_EQ(loaded.clouds, applied.clouds);
    EXPECT_EQ(loaded.notes, applied.notes);
    EXPECT_TRUE(loaded.keep_crowded);
  }
  folder.write("s.cloud-1", with_byte(bytes, at_version, '\x03'));
  EXPECT_EQ(load_pending_clouds(session, notes).at(0).clouds, applied.clouds);
  EXPECT_TRUE(load_pending_clouds(session, notes).at(0).keep_crowded);
  for (const char version : {'\x00', '\x05'}) {
    folder.write("s.cloud-1", with_byte(bytes, at_version, version));
    EXPECT_THROW(load_pending_clouds(session, notes), FileError) << static_cast<int>(version);
  }
}

TEST(PendingClouds, NumbersThatDoNotFitTheFileAreRefused) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {together});
  const std::string bytes(read_file(pending_cloud_file(session, 1)).view());
  for (const std::size_t at : {at_count, at_count + 8, at_count + 16, at_count + 31}) {
    for (const char value : {'\x00', '\x7f', '\xff'}) {
      if (bytes[at] == value) continue;
      folder.write("s.cloud-1", with_byte(bytes, at, value));
      EXPECT_THROW(load_pending_clouds(session, notes), FileError) << at;
    }
  }
}

TEST(PendingClouds, ARefusedOneHasNoPoints) {
  const TemporaryFolder folder;
  const std::string session = save(folder, {applied});
  const std::string bytes(read_file(pending_cloud_file(session, 1)).view());
  folder.write("s.cloud-1", with_byte(bytes, at_bits, 3));
  EXPECT_THROW(load_pending_clouds(session, notes), FileError);
}

}  // namespace
}  // namespace cocoon::app
