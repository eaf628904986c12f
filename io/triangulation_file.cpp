#include "io/triangulation_file.h"

#include <functional>
#include <string>
#include <string_view>

#include "delaunay/check_delaunay.h"
#include "geom/arrays/large_pages.h"
#include "geom/arrays/room_to_grow.h"
#include "geom/parallel/parallel_reduce.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "io/triangulation_block.h"

namespace cocoon {
namespace {

constexpr std::string_view magic = "COCOONDT";
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = 48;

// --- Reading ---------------------------------------------------------------------------------

struct Header {
  std::size_t vertices = 0;
  std::size_t cells = 0;
  std::size_t finite_cells = 0;
  std::size_t points = 0;

  // Precondition: the numbers are ids, so that nothing overflows.
  std::size_t file_size() const {
    return header_size + 24 * vertices + 32 * cells + round_up_to_8(4 * points) + checksum_size;
  }
};

// The magic has been read. The block has `size` bytes with it.
Header read_header(SummedReader& file, std::size_t size) {
  if (size < header_size) {
    throw file_error(file.path(),
                     "the file ends inside its header: it was cut off; write it again");
  }
  if (const auto found = file.next<std::uint32_t>(); found != version) {
    throw file_error(file.path(), "triangulation file of version " + std::to_string(found) +
                                      ", but only version 1 can be read");
  }
  const auto zero = file.next<std::uint32_t>();
  Header header;
  for (std::size_t* number :
       {&header.vertices, &header.cells, &header.finite_cells, &header.points}) {
    *number = file.next<std::uint64_t>();
  }
  if (zero != 0 || header.vertices >= infinite_vertex.value || header.cells > max_cells ||
      header.finite_cells > header.cells || header.points >= infinite_vertex.value ||
      header.points < header.vertices) {
    throw file_error(file.path(), "the numbers in the header cannot be true: the file is damaged");
  }
  if (header.file_size() != size + checksum_size) {
    throw file_error(file.path(), "the file has " + std::to_string(size + checksum_size) +
                                      " bytes, but its header promises " +
                                      std::to_string(header.file_size()) +
                                      ": it was cut off or damaged");
  }
  return header;
}

UncheckedTriangulation read_rest(SummedReader& file, std::size_t size) {
  const Header header = read_header(file, size);
  TriangulationArrays arrays;
  // Whoever reads a triangulation may insert into it: its infinite vertex has a place of its own.
  arrays.points.reserve(with_room_to_grow(header.vertices + 1));
  arrays.points.resize(header.vertices);
  file.fill<double>(arrays.points.span());
  arrays.cells.reserve(with_room_to_grow(header.cells));
  arrays.cells.resize_for_overwrite(header.cells);
  prefer_large_pages(arrays.cells.raw());
  file.fill<std::uint32_t>(arrays.cells.span());
  arrays.vertex_of_point.resize(header.points);
  file.fill<std::uint32_t>(arrays.vertex_of_point.span());
  file.skip_to_word();
  return {std::move(arrays), header.finite_cells};
}

// --- Checks ----------------------------------------------------------------------------------

bool is_well_formed(const Cell& cell, bool must_be_infinite, std::size_t vertices) {
  const auto& [a, b, c, d] = cell.vertices;
  const bool in_place = a.index() < vertices && b.index() < vertices && c.index() < vertices &&
                        (must_be_infinite ? d == infinite_vertex : d.index() < vertices);
  return in_place && a != b && a != c && a != d && b != c && b != d && c != d;
}

// Whether the vertices of facet i of one cell are those of facet k of another. Precondition: the
// vertices of each cell differ.
bool are_one_facet(const Cell& cell, int i, const Cell& other, int k) {
  unsigned shared = 0;
  for (const int corner : facet_corners[i]) {
    const VertexId v = cell.vertices[static_cast<std::size_t>(corner)];
    for (const int behind : facet_corners[k]) {
      shared += other.vertices[static_cast<std::size_t>(behind)] == v ? 1U : 0U;
    }
  }
  return shared == 3;
}

enum class Facets { all, first_of_pairs };

// Whether the facets behind those of a cell are there, name them, and are the same triangles. Of
// the first of pairs: looks at the cells behind only from the facets with the smaller ids.
bool has_mutual_neighbors(const IdVector<CellId, Cell>& cells, CellId c, Facets facets) {
  for (int i = 0; i < 4; ++i) {
    const FacetId here = facet_id(c, i);
    const FacetId behind = cells[c].neighbors[static_cast<std::size_t>(i)];
    if (cell_of(behind).index() >= cells.size() || cell_of(behind) == c) return false;
    if (facets == Facets::first_of_pairs && behind < here) continue;
    const Cell& other = cells[cell_of(behind)];
    if (other.neighbors[static_cast<std::size_t>(index_of(behind))] != here) return false;
    if (!are_one_facet(cells[c], i, other, index_of(behind))) return false;
  }
  return true;
}

// Facets that name one with a larger id. If each of these is named back there are at least as many
// others; and just as many only if these, too, are named back.
std::size_t num_first_of_pairs(const IdVector<CellId, Cell>& cells, const Execution& execution) {
  return parallel_reduce(
      execution, cells.size(), std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (CellId c(begin); c.index() < end; ++c) {
          for (int i = 0; i < 4; ++i) {
            count += facet_id(c, i) < cells[c].neighbors[static_cast<std::size_t>(i)] ? 1U : 0U;
          }
        }
        return count;
      },
      std::plus<>());
}

// Neighbors lie here and there in memory: those of a cell that is looked at soon.
void ask_for_neighbors(const IdVector<CellId, Cell>& cells, CellId c) {
  constexpr std::size_t ahead = 12;
  if (c.index() + ahead >= cells.size()) return;
  for (const FacetId f : cells[CellId(c.index() + ahead)].neighbors) {
    if (c < cell_of(f) && cell_of(f).index() < cells.size()) __builtin_prefetch(&cells[cell_of(f)]);
  }
}

// Throws for the first of `count` elements for which holds(id) is false.
template <class IdType, class Holds>
void require_all(const std::filesystem::path& path, const Execution& execution, std::size_t count,
                 const char* element, const char* what, const Holds& holds) {
  const std::size_t wrong =
      first_failing(execution, count, [&](std::size_t i) { return holds(IdType(i)); });
  if (wrong == count) return;
  throw file_error(path, std::string(element) + " " + std::to_string(wrong) + " " + what +
                             ": this is no triangulation");
}

// The checksum was right, so whatever is wrong here was written so.
void validate(const std::filesystem::path& path, const UncheckedTriangulation& triangulation,
              const Execution& execution) {
  const TriangulationArrays& arrays = triangulation.arrays;
  const std::size_t vertices = arrays.points.size();
  const std::size_t points = arrays.vertex_of_point.size();
  require_all<VertexId>(path, execution, vertices, "vertex", "has a coordinate that is not finite",
                        [&](VertexId v) { return is_finite(arrays.points[v]); });
  require_all<CellId>(path, execution, arrays.cells.size(), "cell",
                      "has a vertex out of range or out of place", [&](CellId c) {
                        const bool infinite = c.index() >= triangulation.finite_cells;
                        return is_well_formed(arrays.cells[c], infinite, vertices);
                      });
  const auto require_mutual_neighbors = [&](Facets facets) {
    require_all<CellId>(path, execution, arrays.cells.size(), "cell",
                        "and one of its neighbors do not name each other", [&](CellId c) {
                          ask_for_neighbors(arrays.cells, c);
                          return has_mutual_neighbors(arrays.cells, c, facets);
                        });
  };
  require_mutual_neighbors(Facets::first_of_pairs);
  if (num_first_of_pairs(arrays.cells, execution) != 2 * arrays.cells.size()) {
    require_mutual_neighbors(Facets::all);
  }
  require_all<PointId>(path, execution, points, "point", "has a vertex out of range",
                       [&](PointId p) { return arrays.vertex_of_point[p].index() < vertices; });
  IdVector<VertexId, std::uint8_t> has_point(vertices, 0);
  for (const VertexId v : arrays.vertex_of_point) has_point[v] = 1;
  require_all<VertexId>(path, execution, vertices, "vertex", "has no input point",
                        [&](VertexId v) { return has_point[v] != 0; });
}

}  // namespace

void append_triangulation(SummedFile& file, const Triangulation& triangulation) {
  file.append(magic);
  file.append(version);
  file.append(std::uint32_t{0});
  file.append(std::uint64_t{triangulation.num_vertices()});
  file.append(std::uint64_t{triangulation.num_cells()});
  file.append(std::uint64_t{triangulation.num_finite_cells()});
  file.append(std::uint64_t{triangulation.vertex_of_point().size()});
  file.append_numbers<double>(triangulation.points().span());
  file.append_numbers<std::uint32_t>(triangulation.cell_records().span());
  file.append_numbers<std::uint32_t>(triangulation.vertex_of_point().span());
  file.fill_word();
}

std::size_t triangulation_block_size(const Triangulation& triangulation) {
  const Header header{triangulation.num_vertices(), triangulation.num_cells(),
                      triangulation.num_finite_cells(), triangulation.vertex_of_point().size()};
  return header.file_size() - checksum_size;
}

UncheckedTriangulation read_triangulation(SummedReader& file, std::size_t size) {
  if (size < magic.size() || file.take(magic.size()) != magic) {
    throw file_error(file.path(), "this is no triangulation file: it does not begin with COCOONDT");
  }
  return read_rest(file, size);
}

Triangulation checked_triangulation(const std::filesystem::path& path,
                                    UncheckedTriangulation triangulation,
                                    const Execution& execution) {
  validate(path, triangulation, execution);
  return Triangulation(std::move(triangulation.arrays), triangulation.finite_cells);
}

void save_triangulation(const std::filesystem::path& path, const Triangulation& triangulation) {
  SummedFile file(path);
  append_triangulation(file, triangulation);
  file.commit();
}

Triangulation load_triangulation(const std::filesystem::path& path,
                                 const LoadTriangulationOptions& options,
                                 const Execution& execution) {
  report_progress(execution, "load_triangulation", 0);
  SummedReader file(path, magic, "triangulation file", "write it again");
  UncheckedTriangulation unchecked = read_rest(file, magic.size() + file.left());
  file.finish();
  Triangulation triangulation = checked_triangulation(path, std::move(unchecked), execution);
  if (options.certify) {
    const DelaunayReport report = check_delaunay(triangulation, execution);
    if (!report.ok()) {
      throw file_error(path, "this is no Delaunay triangulation: " + report.first_violation);
    }
  }
  report_progress(execution, "load_triangulation", 1);
  return triangulation;
}

}  // namespace cocoon
