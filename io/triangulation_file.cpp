#include "io/triangulation_file.h"

#include <span>
#include <string>
#include <string_view>

#include "delaunay/cell_pool.h"
#include "delaunay/check_delaunay.h"
#include "geom/large_pages.h"
#include "geom/parallel_reduce.h"
#include "io/byte_order.h"
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

// `bytes` begin with a header.
Header read_header(const std::filesystem::path& path, std::string_view bytes) {
  const auto number32 = [&](std::size_t at) {
    return load_number<std::uint32_t>(bytes.data() + at, std::endian::little);
  };
  const auto number64 = [&](std::size_t at) {
    return load_number<std::uint64_t>(bytes.data() + at, std::endian::little);
  };
  if (number32(8) != version) {
    throw file_error(path, "triangulation file of version " + std::to_string(number32(8)) +
                               ", but only version 1 can be read");
  }
  const Header header{number64(16), number64(24), number64(32), number64(40)};
  if (number32(12) != 0 || header.vertices >= infinite_vertex.value || header.cells > max_cells ||
      header.finite_cells > header.cells || header.points >= infinite_vertex.value ||
      header.points < header.vertices) {
    throw file_error(path, "the numbers in the header cannot be true: the file is damaged");
  }
  if (header.file_size() != bytes.size() + checksum_size) {
    throw file_error(path, "the file has " + std::to_string(bytes.size() + checksum_size) +
                               " bytes, but its header promises " +
                               std::to_string(header.file_size()) + ": it was cut off or damaged");
  }
  return header;
}

TriangulationArrays read_arrays(std::string_view bytes, const Header& header) {
  const char* at = bytes.data() + header_size;
  const auto take = [&at]<class T, class Record>(T, std::span<Record> records) {
    load_numbers<T>(at, std::endian::little, records);
    at += records.size_bytes();
  };
  TriangulationArrays arrays;
  arrays.points.resize(header.vertices);
  take(double{}, arrays.points.span());
  arrays.cells.resize_for_overwrite(header.cells);
  prefer_large_pages(arrays.cells.raw());
  take(std::uint32_t{}, arrays.cells.span());
  arrays.vertex_of_point.resize(header.points);
  take(std::uint32_t{}, arrays.vertex_of_point.span());
  return arrays;
}

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

bool has_mutual_neighbors(const IdVector<CellId, Cell>& cells, CellId c) {
  for (int i = 0; i < 4; ++i) {
    const FacetId here = facet_id(c, i);
    const FacetId behind = cells[c].neighbors[static_cast<std::size_t>(i)];
    if (cell_of(behind).index() >= cells.size() || cell_of(behind) == c) return false;
    const Cell& other = cells[cell_of(behind)];
    if (other.neighbors[static_cast<std::size_t>(index_of(behind))] != here) return false;
    // Each pair of cells once.
    if (here < behind && !are_one_facet(cells[c], i, other, index_of(behind))) return false;
  }
  return true;
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
void validate(const std::filesystem::path& path, const Header& header,
              const TriangulationArrays& arrays, const Execution& execution) {
  require_all<VertexId>(path, execution, header.vertices, "vertex",
                        "has a coordinate that is not finite",
                        [&](VertexId v) { return is_finite(arrays.points[v]); });
  require_all<CellId>(path, execution, header.cells, "cell",
                      "has a vertex out of range or out of place", [&](CellId c) {
                        return is_well_formed(arrays.cells[c], c.index() >= header.finite_cells,
                                              header.vertices);
                      });
  require_all<CellId>(path, execution, header.cells, "cell",
                      "and one of its neighbors do not name each other",
                      [&](CellId c) { return has_mutual_neighbors(arrays.cells, c); });
  require_all<PointId>(
      path, execution, header.points, "point", "has a vertex out of range",
      [&](PointId p) { return arrays.vertex_of_point[p].index() < header.vertices; });
  IdVector<VertexId, std::uint8_t> has_point(header.vertices, 0);
  for (const VertexId v : arrays.vertex_of_point) has_point[v] = 1;
  require_all<VertexId>(path, execution, header.vertices, "vertex", "has no input point",
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

Triangulation parse_triangulation(const std::filesystem::path& path, std::string_view bytes,
                                  const Execution& execution) {
  if (bytes.substr(0, magic.size()) != magic) {
    throw file_error(path, "this is no triangulation file: it does not begin with COCOONDT");
  }
  if (bytes.size() < header_size) {
    throw file_error(path, "the file ends inside its header: it was cut off; write it again");
  }
  const Header header = read_header(path, bytes);
  TriangulationArrays arrays = read_arrays(bytes, header);
  validate(path, header, arrays, execution);
  return Triangulation(std::move(arrays), header.finite_cells);
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
  Triangulation triangulation;
  {
    const FileBytes file = read_file(path);
    // The header knows better than the checksum what is wrong with the length.
    if (file.size >= header_size + checksum_size && file.view().substr(0, magic.size()) == magic) {
      read_header(path, file.view().substr(0, file.size - checksum_size));
    }
    triangulation =
        parse_triangulation(path, summed_content(file, magic, "triangulation file"), execution);
  }
  if (options.certify) {
    const DelaunayReport report = check_delaunay(triangulation, {}, execution);
    if (!report.ok()) {
      throw file_error(path, "this is no Delaunay triangulation: " + report.first_violation);
    }
  }
  report_progress(execution, "load_triangulation", 1);
  return triangulation;
}

}  // namespace cocoon
