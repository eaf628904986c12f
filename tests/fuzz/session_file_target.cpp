// Session files, and clouds beside them: damaged ones are refused; what is read fits together and
// reads back.
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "app/files/pending_clouds.h"
#include "app/files/session_file.h"
#include "geom/errors.h"
#include "io/encoding/byte_order.h"
#include "io/summed_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/temporary_folder.h"
#include "update/update_session.h"

namespace cocoon::fuzz {

namespace {

bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0);
}

void check_pending_clouds(const TemporaryFolder& folder) {
  const std::vector<app::PendingUpdate> updates =
      app::load_pending_clouds((folder / "a.session").string(), {});
  require(updates.size() == 1, "there is one");
  const app::PendingUpdate& update = updates[0];
  FileBatch batch;
  app::save_pending_clouds((folder / "b.session").string(), {}, update, batch);
  batch.commit();
  const app::PendingUpdate again =
      app::load_pending_clouds((folder / "b.session").string(), {}).at(0);
  require(again.notes == update.notes, "the notes read back");
  require(again.rho.has_value() == update.rho.has_value(), "so does whether rho was given");
  require(again.refused == update.refused, "and whether it was refused");
  require(again.keep_crowded == update.keep_crowded, "and whether all samples came in");
  require(std::equal(again.clouds.begin(), again.clouds.end(), update.clouds.begin(),
                     update.clouds.end(), same_bits),
          "the points read back");
}

}  // namespace

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
    if (content.starts_with("COCOONCL")) {
      folder.write("a.session.cloud-0", content);
      check_pending_clouds(folder);
      return;
    }
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
