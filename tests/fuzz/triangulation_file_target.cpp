// Triangulation files: damaged ones are refused, those made to deceive with a right checksum can be
// worked on without harm, and certified ones are Delaunay.
#include <algorithm>
#include <cstring>
#include <string>

#include "delaunay/canonical_order.h"
#include "delaunay/check_delaunay.h"
#include "geom/errors.h"
#include "io/encoding/byte_order.h"
#include "io/triangulation_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/temporary_folder.h"

namespace cocoon::fuzz {

namespace {

// As the header of the format defines it.
std::uint64_t checksum_of(const std::string& words) {
  std::uint64_t sum = 0;
  for (std::size_t at = 0; at + 8 <= words.size(); at += 8) {
    sum = (sum ^ load_number<std::uint64_t>(words.data() + at, std::endian::little)) *
          0x9E3779B97F4A7C15U;
    sum ^= sum >> 32;
  }
  return sum;
}

}  // namespace

void triangulation_file_target(Bytes bytes) {
  if (bytes.size() < 8) return;
  std::string content(bytes.begin(), bytes.end());
  content.resize(content.size() / 8 * 8 - 8);
  append_little_endian(content, checksum_of(content));
  const TemporaryFolder folder;
  const auto path = folder.write("a.cdt", content);
  Triangulation triangulation;
  try {
    triangulation = load_triangulation(path);
  } catch (const FileError&) {
    return;
  }
  const bool is_delaunay = check_delaunay(triangulation).ok();
  try {
    load_triangulation(path, {.certify = true});
    require(is_delaunay, "certified triangulations are Delaunay");
  } catch (const FileError&) {
    require(!is_delaunay, "Delaunay triangulations are certified");
  }
  if (!is_delaunay) return;
  const auto copy = folder / "b.cdt";
  save_triangulation(copy, triangulation);
  const Triangulation again = load_triangulation(copy, {.certify = true});
  require(again.cell_records() == triangulation.cell_records(), "it reads back");
  require(check_delaunay(canonical_order(triangulation)).ok(), "order changes nothing");
}

}  // namespace cocoon::fuzz
