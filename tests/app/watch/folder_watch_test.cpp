#include "app/watch/folder_watch.h"

#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "tests/file_permissions.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

using namespace std::chrono_literals;

// Writes a file that changed so long ago; negative: its clock is ahead.
void put(const TemporaryFolder& folder, const std::string& name, std::chrono::seconds ago,
         const std::string& content = "1 2 3\n") {
  const std::filesystem::path path = folder.write(name, content);
  std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - ago);
}

void set_permissions(const TemporaryFolder& folder, unsigned mode) {
  std::filesystem::permissions(folder.path(), static_cast<std::filesystem::perms>(mode));
}

std::vector<std::string> names(const std::vector<FolderWatch::CompleteFile>& files) {
  std::vector<std::string> result;
  result.reserve(files.size());
  for (const auto& file : files) result.push_back(file.path.filename().string());
  return result;
}

using Names = std::vector<std::string>;

TEST(FolderWatch, AFileIsToldAtTheSecondPollAndOnce) {
  const TemporaryFolder folder;
  FolderWatch watch(folder.path(), 10s);
  EXPECT_EQ(names(watch.poll()), Names{});
  put(folder, "a.xyz", 60s);
  EXPECT_EQ(names(watch.poll()), Names{});
  EXPECT_EQ(watch.waiting(), 1U);
  EXPECT_EQ(names(watch.poll()), Names{"a.xyz"});
  EXPECT_EQ(watch.waiting(), 0U);
  EXPECT_EQ(names(watch.poll()), Names{});
  EXPECT_EQ(watch.waiting(), 0U);
}

// By any name, and also if they come into being later.
TEST(FolderWatch, FilesOfOursAreNoClouds) {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  namespace fs = std::filesystem;
  fs::create_symlink(elsewhere / "mesh.ply", folder / "link.ply");
  fs::create_directory_symlink(folder.path(), elsewhere / "here");
  FolderWatch watch(folder.path(), 10s,
                    {elsewhere / "mesh.ply", elsewhere / "here" / "out.ply", "model.xyz"});
  put(elsewhere, "mesh.ply", 60s);
  put(folder, "out.ply", 60s);
  put(folder, "model.xyz", 60s);  // not the one that is meant
  EXPECT_EQ(names(watch.poll()), Names{});
  EXPECT_EQ(watch.waiting(), 1U);
  EXPECT_EQ(names(watch.poll()), Names{"model.xyz"});
  put(folder, "out.ply", 50s, "4 5 6\n");
  EXPECT_EQ(names(watch.poll()), Names{});
  EXPECT_EQ(watch.waiting(), 0U);
  EXPECT_EQ(names(watch.poll()), Names{});
}

TEST(FolderWatch, OneThatChangedJustNowWaits) {
  const TemporaryFolder folder;
  FolderWatch watch(folder.path(), 3600s);
  put(folder, "a.xyz", 60s);
  put(folder, "ahead.xyz", -7200s);
  for (int poll = 0; poll < 3; ++poll) EXPECT_EQ(names(watch.poll()), Names{});
  EXPECT_EQ(watch.waiting(), 2U);
}

TEST(FolderWatch, TheEarliestChangedIsFirstThenByName) {
  const TemporaryFolder folder;
  FolderWatch watch(folder.path(), 10s);
  const auto changed = std::filesystem::file_time_type::clock::now() - 50s;
  for (const char* name : {"c.xyz", "a.xyz", "b.xyz"}) {
    put(folder, name, 50s);
    std::filesystem::last_write_time(folder / name, changed);
  }
  put(folder, "d.xyz", 70s);
  put(folder, "e.xyz", 40s);
  watch.poll();
  EXPECT_EQ(names(watch.poll()), (Names{"d.xyz", "a.xyz", "b.xyz", "c.xyz", "e.xyz"}));
}

// Another length or another time is enough; so is that it was gone.
TEST(FolderWatch, AFileThatChangesIsANewOne) {
  const TemporaryFolder folder;
  FolderWatch watch(folder.path(), 10s);
  const auto expect_new = [&] {
    EXPECT_EQ(names(watch.poll()), Names{});
    EXPECT_EQ(watch.waiting(), 1U);
    EXPECT_EQ(names(watch.poll()), Names{"a.xyz"});
  };
  put(folder, "a.xyz", 60s);
  expect_new();
  const auto changed = std::filesystem::last_write_time(folder / "a.xyz");
  put(folder, "a.xyz", 60s, "1 2 3\n4 5 6\n");
  std::filesystem::last_write_time(folder / "a.xyz", changed);
  expect_new();
  std::filesystem::last_write_time(folder / "a.xyz", changed + 20s);
  expect_new();
  std::filesystem::remove(folder / "a.xyz");
  EXPECT_EQ(names(watch.poll()), Names{});
  put(folder, "a.xyz", 60s);
  expect_new();
}

// What the first poll saw was there before; what changes or comes after it was not.
TEST(FolderWatch, TellsWhatWasThereBefore) {
  const TemporaryFolder folder;
  for (const char* name : {"gone.xyz", "stays.xyz", "written.xyz"}) put(folder, name, 60s);
  FolderWatch watch(folder.path(), 10s);
  watch.poll();
  put(folder, "late.xyz", 60s);
  put(folder, "written.xyz", 50s);
  const std::filesystem::path gone = folder / "gone.xyz";
  std::filesystem::rename(gone, folder / "elsewhere");
  const auto first = watch.poll();
  ASSERT_EQ(names(first), Names{"stays.xyz"});
  EXPECT_TRUE(first[0].was_there);
  EXPECT_EQ(first[0].changed, std::filesystem::last_write_time(folder / "stays.xyz"));
  std::filesystem::rename(folder / "elsewhere", gone);
  std::vector<std::string> later;
  for (int poll = 0; poll < 2; ++poll) {
    for (const auto& file : watch.poll()) {
      EXPECT_FALSE(file.was_there) << file.path;
      later.push_back(file.path.filename().string());
    }
  }
  EXPECT_EQ(later, (Names{"late.xyz", "written.xyz", "gone.xyz"}));
}

// Permissions that are taken away for a while, or a share with a hiccup.
TEST(FolderWatch, AFileThatCannotBeLookedAtIsNotForgotten) {
  const TemporaryFolder folder;
  const cocoon::test::ObeysPermissions here;
  put(folder, "a.xyz", 60s);
  FolderWatch watch(folder.path(), 10s);
  watch.poll();
  EXPECT_EQ(names(watch.poll()), Names{"a.xyz"});
  put(folder, "b.xyz", 60s);
  watch.poll();
  put(folder, "c.xyz", 60s);
  set_permissions(folder, 0600);  // it can be listed, and that is all
  for (int poll = 0; poll < 2; ++poll) {
    EXPECT_EQ(names(watch.poll()), Names{});
    EXPECT_EQ(watch.waiting(), 0U);
    EXPECT_EQ(watch.out_of_reach(),
              folder.path().string() + ": 3 files cannot be looked at (Permission denied)");
  }
  set_permissions(folder, 0700);
  EXPECT_EQ(names(watch.poll()), Names{"b.xyz"});
  EXPECT_EQ(watch.out_of_reach(), "");
  EXPECT_EQ(watch.waiting(), 1U);
  EXPECT_EQ(names(watch.poll()), Names{"c.xyz"});
}

TEST(FolderWatch, WhatCouldNotBeLookedAtAtFirstWasThere) {
  const TemporaryFolder folder;
  const cocoon::test::ObeysPermissions here;
  put(folder, "a.xyz", 60s);
  put(folder, "own.xyz", 60s);
  FolderWatch watch(folder.path(), 10s, {folder / "own.xyz"});
  set_permissions(folder, 0600);
  watch.poll();
  set_permissions(folder, 0700);
  put(folder, "late.xyz", 50s);
  watch.poll();
  const auto files = watch.poll();
  ASSERT_EQ(names(files), (Names{"a.xyz", "late.xyz"}));
  EXPECT_TRUE(files[0].was_there);
  EXPECT_FALSE(files[1].was_there);
}

// A share that is unmounted: there is no folder, or an empty one at which it is mounted again.
TEST(FolderWatch, AFolderThatWasAwayIsNotNew) {
  const TemporaryFolder place;
  namespace fs = std::filesystem;
  const fs::path scans = place / "scans";
  const auto put_scan = [&](const std::string& name, std::chrono::seconds ago) {
    put(place, "scans/" + name, ago);
  };
  fs::create_directory(scans);
  for (const char* name : {"a.xyz", "moved.xyz"}) put_scan(name, 60s);
  FolderWatch watch(scans, 10s);
  watch.poll();
  EXPECT_EQ(watch.poll().size(), 2U);

  fs::rename(scans, place / "away");
  EXPECT_THROW(watch.poll(), FileError);
  fs::rename(place / "away", scans);
  EXPECT_EQ(names(watch.poll()), Names{});
  EXPECT_EQ(watch.waiting(), 0U);

  fs::rename(scans, place / "away");
  fs::create_directory(scans);
  for (int poll = 0; poll < 2; ++poll) EXPECT_EQ(names(watch.poll()), Names{});
  put_scan("into another folder.xyz", 60s);
  for (int poll = 0; poll < 2; ++poll) watch.poll();
  fs::remove_all(scans);
  fs::rename(place / "away", scans);
  put_scan("while it was away.xyz", 60s);
  fs::rename(scans / "moved.xyz", place / "moved.xyz");
  EXPECT_EQ(names(watch.poll()), Names{});
  const auto files = watch.poll();
  ASSERT_EQ(names(files), Names{"while it was away.xyz"});
  EXPECT_TRUE(files[0].was_there);
  // What is not there any more is forgotten, and new when it is put there again.
  fs::rename(place / "moved.xyz", scans / "moved.xyz");
  watch.poll();
  EXPECT_EQ(names(watch.poll()), Names{"moved.xyz"});
}

TEST(FolderWatch, WhatCannotBeReadIsToldAgain) {
  const TemporaryFolder folder;
  put(folder, "a.xyz", 60s);
  FolderWatch watch(folder.path(), 10s);
  watch.poll();
  for (int poll = 0; poll < 3; ++poll) {
    const auto files = watch.poll();
    ASSERT_EQ(names(files), Names{"a.xyz"});
    EXPECT_TRUE(files[0].was_there);
    EXPECT_EQ(watch.waiting(), 0U);
    watch.try_again(files[0].path);
    EXPECT_EQ(watch.waiting(), 0U);
  }
}

// Also if it is as it was when the next poll comes.
TEST(FolderWatch, WhatChangedWhileItWasReadWaitsAgain) {
  const TemporaryFolder folder;
  put(folder, "a.xyz", 60s);
  FolderWatch watch(folder.path(), 10s);
  watch.poll();
  for (int poll = 0; poll < 2; ++poll) {
    const auto files = watch.poll();
    ASSERT_EQ(names(files), Names{"a.xyz"});
    EXPECT_TRUE(files[0].was_there);
    watch.wait_for(files[0].path);
    EXPECT_EQ(watch.waiting(), 1U);
    EXPECT_EQ(names(watch.poll()), Names{});
    EXPECT_EQ(watch.waiting(), 1U);
  }
}

TEST(FolderWatch, LengthOrTimeTellThatAFileHasChanged) {
  const TemporaryFolder folder;
  put(folder, "a.xyz", 60s);
  FolderWatch watch(folder.path(), 10s);
  watch.poll();
  const FolderWatch::CompleteFile file = watch.poll().at(0);
  EXPECT_FALSE(has_changed(file));
  put(folder, "a.xyz", 60s, "1 2 3\n4 5 6\n");
  std::filesystem::last_write_time(file.path, file.changed);
  EXPECT_TRUE(has_changed(file));
  put(folder, "a.xyz", 59s);
  EXPECT_TRUE(has_changed(file));
  put(folder, "a.xyz", 60s);
  std::filesystem::last_write_time(file.path, file.changed);
  EXPECT_FALSE(has_changed(file));
  std::filesystem::remove(file.path);
  EXPECT_FALSE(has_changed(file));
}

// So that the user hears why they are not applied.
TEST(FolderWatch, ScansThatMustBeConvertedFirstAreToldOf) {
  const TemporaryFolder folder;
  FolderWatch watch(folder.path(), 10s);
  for (const char* name : {"a.xyz.gz", "b.LAS", "c.e57"}) put(folder, name, 60s);
  watch.poll();
  EXPECT_EQ(names(watch.poll()), (Names{"a.xyz.gz", "b.LAS", "c.e57"}));
}

TEST(FolderWatch, OtherFilesAreNotLookedAt) {
  const TemporaryFolder folder;
  FolderWatch watch(folder.path(), 10s);
  put(folder, ".hidden.xyz", 60s);
  put(folder, "notes.md", 60s);
  std::filesystem::create_directory(folder / "folder.xyz");
  watch.poll();
  EXPECT_EQ(watch.waiting(), 0U);
  EXPECT_EQ(names(watch.poll()), Names{});
}

TEST(FolderWatch, AFolderThatIsGoneIsAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(FolderWatch(folder / "missing", 10s).poll(), FileError);
}

}  // namespace
}  // namespace cocoon::app
