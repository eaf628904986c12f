#include "io/polyline_file.h"

#include <string>

#include "geom/id_vector.h"
#include "io/atomic_file.h"
#include "io/encoding/number_text.h"
#include "io/file_bytes.h"
#include "io/file_format.h"
#include "io/formats/obj.h"

namespace cocoon {

void write_polylines(const std::filesystem::path& path, Points points,
                     std::span<const std::vector<VertexId>> loops, FileBatch* batch) {
  if (extension_of(path) != ".obj") {
    throw file_error(path, "loops are written as OBJ polylines; use the extension .obj");
  }
  constexpr std::size_t unused = ~std::size_t{0};
  IdVector<VertexId, std::size_t> number(points.size(), unused);  // in the file, from 0
  std::vector<Point> used;
  for (const std::vector<VertexId>& loop : loops) {
    for (VertexId v : loop) {
      if (v.index() >= points.size()) {
        throw file_error(path, "not written: a loop has a corner that is no vertex");
      }
      if (number[v] != unused) continue;
      number[v] = used.size();
      used.push_back(points[v.index()]);
    }
  }

  AtomicFile file(path);
  write_obj(file, used);
  for (const std::vector<VertexId>& loop : loops) {
    if (loop.empty()) continue;
    std::string& text = file.buffer();
    text += 'l';
    for (std::size_t i = 0; i <= loop.size(); ++i) {
      text += ' ';
      append_number(text, number[loop[i % loop.size()]] + 1);
    }
    text += '\n';
    file.flush_if_full();
  }
  file.commit(batch);
}

}  // namespace cocoon
