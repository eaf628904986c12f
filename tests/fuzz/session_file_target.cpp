// Session files: damaged ones are refused; what is read fits together and reads back.
#include <string>

#include "app/session_file.h"
#include "geom/errors.h"
#include "io/byte_order.h"
#include "io/summed_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/io/temporary_folder.h"
#include "update/update_session.h"

namespace cocoon::fuzz {

void session_file_target(Bytes bytes) {
  if (bytes.size() < 8) return;
  std::string content(bytes.begin(), bytes.end());
  content.resize(content.size() / 8 * 8 - 8);
  Checksum checksum;
  checksum.add(content);
  append_little_endian(content, checksum.value());
  const TemporaryFolder folder;
  app::SavedSession session;
  try {
    session = app::load_session(folder.write("a.session", content).string());
    const std::string copy = (folder / "b.session").string();
    app::save_session(copy, session);
    const app::SavedSession again = app::load_session(copy);
    require(again.snapshot.model == session.snapshot.model, "the model reads back");
    require(again.snapshot.surface == session.snapshot.surface, "its surface reads back");
    require(again.notes == session.notes, "the notes read back");
    const UpdateSession live(std::move(session.snapshot));
    require(live.model() == again.snapshot.model, "a session has its model");
  } catch (const FileError&) {
  } catch (const InputError&) {
  }
}

}  // namespace cocoon::fuzz
