#include "app/watch/watch_notes.h"

#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "geom/errors.h"
#include "tests/temporary_folder.h"

namespace cocoon::app {
namespace {

using Notes = std::vector<std::string>;

NotedFile file_of(const std::string& name, const std::string& content, std::int64_t changed) {
  return {"scans/" + name, content, changed};
}

TEST(WatchNotes, HoldContentTimeAndName) {
  const TemporaryFolder folder;
  const auto time = std::filesystem::file_time_type::clock::from_sys(
      std::chrono::sys_time<std::chrono::nanoseconds>(std::chrono::nanoseconds(1234567890123)));
  const NotedFile file = noted_file(folder.write("a b.xyz", "1 2 3\n"), time);
  EXPECT_EQ(file.changed, 1234567890123);
  EXPECT_EQ(file.content, noted_file(folder.write("other.xyz", "1 2 3\n"), time).content);
  EXPECT_NE(file.content, noted_file(folder.write("other.xyz", "1 2 4\n"), time).content);
  EXPECT_EQ(note_of_applied(file), "applied " + file.content + " 1234567890123 a b.xyz");
  EXPECT_EQ(note_of_refused(file), "refused " + file.content + " 1234567890123 a b.xyz");
  EXPECT_EQ(note_of_model(folder / "a b.xyz", {}), "model " + file.content);
  EXPECT_EQ(note_of_model(folder / "a b.xyz", 0.5), "model " + file.content + " densify 0.5");
  EXPECT_THROW(noted_file(folder / "missing", time), FileError);
}

// Name, content and time: each by itself makes it another file.
TEST(WatchNotes, AFileIsKnownIfAllOfItIs) {
  const NotedFile file = file_of("a.xyz", "c0-6", 7);
  for (const std::string& note : {note_of_applied(file), note_of_refused(file)}) {
    const Notes notes = {"model m", note};
    EXPECT_TRUE(is_noted(notes, file));
    EXPECT_FALSE(is_noted(notes, file_of("a.xyz", "c1-6", 7)));
    EXPECT_FALSE(is_noted(notes, file_of("a.xyz", "c0-6", 8)));
    EXPECT_FALSE(is_noted(notes, file_of("b a.xyz", "c0-6", 7)));
    EXPECT_FALSE(is_noted(notes, file_of("xyz", "c0-6", 7)));
  }
  EXPECT_FALSE(is_noted(Notes{"model m"}, file));
  EXPECT_FALSE(is_noted(Notes{}, file));
}

// A, B, A under one name: after B it is there anew, even with its old time.
TEST(WatchNotes, TheLatestNoteOnANameCounts) {
  const NotedFile a = file_of("scan.xyz", "c0-6", 7);
  const NotedFile b = file_of("scan.xyz", "c1-6", 8);
  Notes notes = {"model m", note_of_applied(a), note_of_applied(b),
                 note_of_applied(file_of("other.xyz", "c2-6", 9))};
  EXPECT_FALSE(is_noted(notes, a));
  EXPECT_TRUE(is_noted(notes, b));
  notes.push_back(note_of_refused(a));
  EXPECT_TRUE(is_noted(notes, a));
  EXPECT_FALSE(is_noted(notes, b));
}

TEST(WatchNotes, AFileThatIsToBeAloneIsStillToBeTried) {
  const NotedFile file = file_of("a.xyz", "c0-6", 7);
  Notes notes = {"model m", note_of_alone(file)};
  EXPECT_FALSE(is_noted(notes, file));
  EXPECT_TRUE(is_to_be_alone(notes, file));
  EXPECT_FALSE(is_to_be_alone(notes, file_of("a.xyz", "c1-6", 7)));
  EXPECT_FALSE(is_to_be_alone(notes, file_of("b.xyz", "c0-6", 7)));
  EXPECT_EQ(count_notes(notes).applied + count_notes(notes).refused, 0U);
  notes.push_back(note_of_applied(file));
  EXPECT_TRUE(is_noted(notes, file));
  EXPECT_FALSE(is_to_be_alone(notes, file));
}

TEST(WatchNotes, NotesWithoutTimeStandForAnyTime) {
  Notes notes = {"model m", "cloud c0-6 a b.xyz"};
  for (const std::int64_t time : {7, 8}) {
    EXPECT_TRUE(is_noted(notes, file_of("a b.xyz", "c0-6", time)));
    EXPECT_FALSE(is_noted(notes, file_of("a b.xyz", "c1-6", time)));
    EXPECT_FALSE(is_noted(notes, file_of("b.xyz", "c0-6", time)));
  }
  notes.push_back(note_of_applied(file_of("a b.xyz", "c0-6", 8)));
  EXPECT_FALSE(is_noted(notes, file_of("a b.xyz", "c0-6", 7)));
}

// A note is one line, whatever a name holds, and is recognized again.
TEST(WatchNotes, AnyNameIsOneLine) {
  const NotedFile file = file_of("a\nb\t.xyz", "c0-6", 7);
  EXPECT_EQ(note_of_applied(file), "applied c0-6 7 a?b\t.xyz");
  EXPECT_TRUE(is_noted(Notes{note_of_applied(file)}, file));
  EXPECT_TRUE(is_noted(Notes{"cloud c0-6 a?b?.xyz"}, file));
}

TEST(WatchNotes, AreCounted) {
  const NotedFile a = file_of("a.xyz", "c0-6", 7);
  const NotedFile b = file_of("b.xyz", "c0-6", 7);
  Notes notes = {"model m",          "cloud c0-6 a.xyz", note_of_refused(a),
                 note_of_refused(a), note_of_refused(b), note_of_applied(b)};
  EXPECT_EQ(count_notes(notes).applied, 2U);
  EXPECT_EQ(count_notes(notes).refused, 1U);
  notes.push_back(note_of_applied(a));
  EXPECT_EQ(count_notes(notes).applied, 3U);
  EXPECT_EQ(count_notes(notes).refused, 0U);
}

// Session files hold what they hold: no note makes the program fail.
TEST(WatchNotes, OtherLinesAreNotesOfNoFile) {
  for (const char* note : {"", " ", "applied", "applied ", "refused  ", "cloud ", "cloud x",
                           "applied c0-6", "applied c0-6 7", "applied c0-6 7 "}) {
    EXPECT_FALSE(is_noted(Notes{note}, file_of("a.xyz", "c0-6", 7))) << note;
    count_notes(Notes{note});
  }
}

}  // namespace
}  // namespace cocoon::app
