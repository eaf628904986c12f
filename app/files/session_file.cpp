#include "app/files/session_file.h"

#include <span>
#include <string_view>

#include "geom/arrays/room_to_grow.h"
#include "geom/errors.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "io/triangulation_block.h"

namespace cocoon::app {

namespace {

constexpr std::string_view magic = "COCOONUS";
constexpr std::uint32_t version = 5;
constexpr std::uint32_t oldest_version = 3;
constexpr std::size_t header_size = 88;

enum Bits : std::uint32_t {
  paper_mode = 1,
  has_alpha = 2,
  has_cocone = 4,
  has_sharp = 8,
  certified = 16,
  has_marks = 32,
  has_body = 64
};

struct Header {
  std::uint32_t bits = 0;
  double angles[3] = {0, 0, 0};
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t points = 0;
  std::size_t note_bytes = 0;
  std::size_t triangulation_bytes = 0;
  std::size_t surface_bytes = 0;

  std::size_t content_size() const {
    return header_size + 24 * vertices + 24 * points +
           round_up_to_8(4 * vertices + 12 * triangles) + round_up_to_8(note_bytes) +
           triangulation_bytes + surface_bytes;
  }
};

std::size_t surface_size(const Header& header, std::size_t vertices, std::size_t cells) {
  const auto one_if = [&](Bits bit) -> std::size_t { return (header.bits & bit) != 0 ? 1 : 0; };
  const std::size_t of_both = one_if(certified) + one_if(has_marks);
  return round_up_to_8((30 + of_both) * vertices + (2 + of_both + one_if(has_body)) * cells);
}

Header header_of(const SavedSession& session) {
  const SurfaceArguments& parameters = session.parameters;
  Header header;
  header.bits = (parameters.mode == Mode::paper ? paper_mode : 0U) |
                (parameters.alpha_deg ? has_alpha : 0U) |
                (parameters.cocone_angle_deg ? has_cocone : 0U) |
                (parameters.sharp_angle_deg ? has_sharp : 0U);
  header.angles[0] = parameters.alpha_deg.value_or(0);
  header.angles[1] = parameters.cocone_angle_deg.value_or(0);
  header.angles[2] = parameters.sharp_angle_deg.value_or(0);
  const SessionSnapshot& snapshot = session.snapshot;
  header.vertices = snapshot.model.points.size();
  header.triangles = snapshot.model.triangles.size();
  header.points = snapshot.points.size();
  for (const std::string& note : session.notes) header.note_bytes += note.size() + 1;
  const Triangulation& triangulation = snapshot.triangulation;
  if (triangulation.num_cells() > 0) {
    header.triangulation_bytes = triangulation_block_size(triangulation);
  }
  if (!snapshot.surface.sides.empty()) header.bits |= certified;
  if (!snapshot.surface.marks.empty()) header.bits |= has_marks;
  if (!snapshot.surface.out.empty()) header.bits |= has_body;
  if (!snapshot.surface.empty()) {
    header.surface_bytes =
        surface_size(header, triangulation.num_vertices(), triangulation.num_cells());
  }
  return header;
}

SurfaceArguments parameters_of(const Header& header) {
  SurfaceArguments parameters;
  if ((header.bits & paper_mode) != 0) parameters.mode = Mode::paper;
  if ((header.bits & has_alpha) != 0) parameters.alpha_deg = header.angles[0];
  if ((header.bits & has_cocone) != 0) parameters.cocone_angle_deg = header.angles[1];
  if ((header.bits & has_sharp) != 0) parameters.sharp_angle_deg = header.angles[2];
  return parameters;
}

void append_surface(SummedFile& file, const SurfaceState& surface) {
  const CandidateState& candidates = surface.candidates;
  file.append_numbers<double>(candidates.normals.span());
  file.append_numbers<std::uint32_t>(candidates.steps.span());
  file.append_numbers<std::uint8_t>(candidates.vertex_flags.span());
  file.append_numbers<std::uint8_t>(candidates.samples.span());
  file.append_numbers<std::uint8_t>(candidates.cell_flags.span());
  file.append_numbers<std::uint8_t>(candidates.pruned.span());
  file.append_numbers<std::uint8_t>(surface.sides.span());
  file.append_numbers<std::uint8_t>(surface.sheets.span());
  file.append_numbers<std::uint8_t>(surface.marks.cells.span());
  file.append_numbers<std::uint8_t>(surface.marks.vertices.span());
  file.append_numbers<std::uint8_t>(surface.out.span());
  file.fill_word();
}

// The next `count` records, made of numbers of type T.
template <class T, class Container>
void fill(SummedReader& file, Container& records, std::size_t count) {
  records.reserve(with_room_to_grow(count));
  records.resize(count);
  file.fill<T>(std::span(records.begin(), records.end()));
}

SurfaceState read_surface(SummedReader& file, const Header& header,
                          const TriangulationArrays& triangulation) {
  SurfaceState surface;
  if (header.surface_bytes == 0) return surface;
  const std::size_t vertices = triangulation.points.size();
  const std::size_t cells = triangulation.cells.size();
  if (header.surface_bytes != surface_size(header, vertices, cells)) {
    throw file_error(file.path(),
                     "what is known of the surface does not fit the triangulation; make the "
                     "session again");
  }
  CandidateState& candidates = surface.candidates;
  fill<double>(file, candidates.normals, vertices);
  fill<std::uint32_t>(file, candidates.steps, vertices);
  fill<std::uint8_t>(file, candidates.vertex_flags, vertices);
  fill<std::uint8_t>(file, candidates.samples, vertices);
  fill<std::uint8_t>(file, candidates.cell_flags, cells);
  fill<std::uint8_t>(file, candidates.pruned, cells);
  if ((header.bits & certified) != 0) {
    fill<std::uint8_t>(file, surface.sides, cells);
    fill<std::uint8_t>(file, surface.sheets, vertices);
  }
  if ((header.bits & has_marks) != 0) {
    fill<std::uint8_t>(file, surface.marks.cells, cells);
    fill<std::uint8_t>(file, surface.marks.vertices, vertices);
  }
  if ((header.bits & has_body) != 0) fill<std::uint8_t>(file, surface.out, cells);
  file.skip_to_word();
  return surface;
}

Header read_header(SummedReader& file) {
  const std::size_t content = magic.size() + file.left();
  if (content < header_size) {
    throw file_error(file.path(),
                     "the file ends inside its header: it was cut off; make the session again");
  }
  if (const auto found = file.next<std::uint32_t>(); found < oldest_version || found > version) {
    throw file_error(file.path(), "session file of version " + std::to_string(found) +
                                      ", but only versions " + std::to_string(oldest_version) +
                                      " to " + std::to_string(version) +
                                      " can be read; make the session again");
  }
  Header header;
  header.bits = file.next<std::uint32_t>();
  bool plausible = header.bits < 128;
  for (double& angle : header.angles) {
    angle = file.next<double>();
    plausible = plausible && angle >= 0 && angle <= 180;
  }
  for (std::size_t* number :
       {&header.vertices, &header.triangles, &header.points, &header.note_bytes,
        &header.triangulation_bytes, &header.surface_bytes}) {
    *number = file.next<std::uint64_t>();
    plausible = plausible && *number <= content;
  }
  if (!plausible || header.content_size() != content) {
    file.finish();  // knows better, as a rule
    throw file_error(file.path(),
                     "the numbers in the header do not fit the length of the file: it is "
                     "damaged; make the session again");
  }
  return header;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

}  // namespace

bool same_parameters(const SurfaceArguments& a, const SurfaceArguments& b) {
  return a.mode == b.mode && a.alpha_deg == b.alpha_deg &&
         a.cocone_angle_deg == b.cocone_angle_deg && a.sharp_angle_deg == b.sharp_angle_deg;
}

void save_session(const std::string& path, const SavedSession& session, FileBatch* batch) {
  const SessionSnapshot& snapshot = session.snapshot;
  const Header header = header_of(session);
  SummedFile file(path);
  file.append(magic);
  file.append(version);
  file.append(header.bits);
  for (const double angle : header.angles) file.append(angle);
  for (const std::size_t number :
       {header.vertices, header.triangles, header.points, header.note_bytes,
        header.triangulation_bytes, header.surface_bytes}) {
    file.append(std::uint64_t{number});
  }
  file.append_numbers<double>(snapshot.model.points.span());
  file.append_numbers<double>(std::span(snapshot.points));
  file.append_numbers<std::uint32_t>(snapshot.point_of_vertex.span());
  file.append_numbers<std::uint32_t>(snapshot.model.triangles.span());
  file.fill_word();
  for (const std::string& note : session.notes) file.append(std::string_view(note + "\n"));
  file.fill_word();
  if (header.triangulation_bytes > 0) append_triangulation(file, snapshot.triangulation);
  if (header.surface_bytes > 0) append_surface(file, snapshot.surface);
  file.commit(batch);
}

SavedSession load_session(const std::string& path, const Execution& execution) {
  SummedReader file(path, magic, "session file", "make the session again");
  const Header header = read_header(file);
  SavedSession session;
  session.parameters = parameters_of(header);
  SessionSnapshot& snapshot = session.snapshot;
  fill<double>(file, snapshot.model.points, header.vertices);
  fill<double>(file, snapshot.points, header.points);
  fill<std::uint32_t>(file, snapshot.point_of_vertex, header.vertices);
  fill<std::uint32_t>(file, snapshot.model.triangles, header.triangles);
  file.skip_to_word();
  session.notes = lines_of(file.take(header.note_bytes));
  file.skip_to_word();
  UncheckedTriangulation triangulation;
  if (header.triangulation_bytes > 0) {
    triangulation = read_triangulation(file, header.triangulation_bytes);
  }
  snapshot.surface = read_surface(file, header, triangulation.arrays);
  file.finish();
  snapshot.triangulation = checked_triangulation(path, std::move(triangulation), execution);
  try {
    check_snapshot(snapshot, execution);
  } catch (const InputError& error) {
    throw file_error(path, error.what());
  }
  return session;
}

}  // namespace cocoon::app
