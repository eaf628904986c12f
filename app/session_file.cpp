#include "app/session_file.h"

#include <span>
#include <string_view>

#include "geom/errors.h"
#include "io/file_bytes.h"
#include "io/summed_file.h"
#include "io/triangulation_block.h"

namespace cocoon::app {

namespace {

constexpr std::string_view magic = "COCOONUS";
constexpr std::uint32_t version = 3;
constexpr std::size_t header_size = 88;

enum Bits : std::uint32_t {
  paper_mode = 1,
  has_alpha = 2,
  has_cocone = 4,
  has_sharp = 8,
  certified = 16
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

std::size_t surface_size(const Header& header, const Triangulation& triangulation) {
  const std::size_t if_certified = (header.bits & certified) != 0 ? 1 : 0;
  return round_up_to_8((30 + if_certified) * triangulation.num_vertices() +
                       (2 + if_certified) * triangulation.num_cells());
}

Header header_of(const SavedSession& session) {
  const SurfaceArguments& parameters = session.parameters;
  Header header;
  header.bits = (parameters.mode == "paper" ? paper_mode : 0U) |
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
  if (!snapshot.surface.empty()) header.surface_bytes = surface_size(header, triangulation);
  return header;
}

SurfaceArguments parameters_of(const Header& header) {
  SurfaceArguments parameters;
  if ((header.bits & paper_mode) != 0) parameters.mode = "paper";
  if ((header.bits & has_alpha) != 0) parameters.alpha_deg = header.angles[0];
  if ((header.bits & has_cocone) != 0) parameters.cocone_angle_deg = header.angles[1];
  if ((header.bits & has_sharp) != 0) parameters.sharp_angle_deg = header.angles[2];
  return parameters;
}

// Reads numbers one after the other. Precondition: the bytes are there.
class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : at_(bytes.data()) {}
  template <class T>
  T next() {
    const T value = load_number<T>(at_, std::endian::little);
    at_ += sizeof(T);
    return value;
  }
  // The next `count` records, made of numbers of type T.
  template <class T, class Container>
  void fill(Container& records, std::size_t count) {
    records.resize(count);
    const std::span all(records.begin(), records.end());
    load_numbers<T>(at_, std::endian::little, all);
    at_ += all.size_bytes();
  }
  std::string_view take(std::size_t size) {
    const std::string_view bytes(at_, size);
    at_ += size;
    return bytes;
  }

 private:
  const char* at_;
};

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
  file.fill_word();
}

SurfaceState read_surface(const std::string& path, std::string_view bytes, const Header& header,
                          const Triangulation& triangulation) {
  SurfaceState surface;
  if (bytes.empty()) return surface;
  if (bytes.size() != surface_size(header, triangulation)) {
    throw file_error(path,
                     "what is known of the surface does not fit the triangulation; make the "
                     "session again");
  }
  const std::size_t vertices = triangulation.num_vertices();
  const std::size_t cells = triangulation.num_cells();
  Cursor cursor(bytes);
  CandidateState& candidates = surface.candidates;
  cursor.fill<double>(candidates.normals, vertices);
  cursor.fill<std::uint32_t>(candidates.steps, vertices);
  cursor.fill<std::uint8_t>(candidates.vertex_flags, vertices);
  cursor.fill<std::uint8_t>(candidates.samples, vertices);
  cursor.fill<std::uint8_t>(candidates.cell_flags, cells);
  cursor.fill<std::uint8_t>(candidates.pruned, cells);
  if ((header.bits & certified) == 0) return surface;
  cursor.fill<std::uint8_t>(surface.sides, cells);
  cursor.fill<std::uint8_t>(surface.sheets, vertices);
  return surface;
}

Header read_header(const std::string& path, std::string_view content) {
  if (content.size() < header_size) {
    throw file_error(path,
                     "the file ends inside its header: it was cut off; make the session again");
  }
  Cursor cursor(content.substr(magic.size()));
  if (const auto found = cursor.next<std::uint32_t>(); found != version) {
    throw file_error(path, "session file of version " + std::to_string(found) +
                               ", but only version " + std::to_string(version) +
                               " can be read; make the session again");
  }
  Header header;
  header.bits = cursor.next<std::uint32_t>();
  bool plausible = header.bits < 32;
  for (double& angle : header.angles) {
    angle = cursor.next<double>();
    plausible = plausible && angle >= 0 && angle <= 180;
  }
  for (std::size_t* number :
       {&header.vertices, &header.triangles, &header.points, &header.note_bytes,
        &header.triangulation_bytes, &header.surface_bytes}) {
    *number = cursor.next<std::uint64_t>();
    plausible = plausible && *number <= content.size();
  }
  if (!plausible || header.content_size() != content.size()) {
    throw file_error(path,
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
  const FileBytes file = read_file(path);
  const std::string_view content = summed_content(file, magic, "session file");
  const Header header = read_header(path, content);
  SavedSession session;
  session.parameters = parameters_of(header);
  SessionSnapshot& snapshot = session.snapshot;
  Cursor cursor(content.substr(header_size));
  cursor.fill<double>(snapshot.model.points, header.vertices);
  cursor.fill<double>(snapshot.points, header.points);
  cursor.fill<std::uint32_t>(snapshot.point_of_vertex, header.vertices);
  cursor.fill<std::uint32_t>(snapshot.model.triangles, header.triangles);
  const std::size_t ids = 4 * header.vertices + 12 * header.triangles;
  cursor.take(round_up_to_8(ids) - ids);
  session.notes = lines_of(cursor.take(header.note_bytes));
  cursor.take(round_up_to_8(header.note_bytes) - header.note_bytes);
  if (header.triangulation_bytes > 0) {
    snapshot.triangulation =
        parse_triangulation(path, cursor.take(header.triangulation_bytes), execution);
  }
  snapshot.surface =
      read_surface(path, cursor.take(header.surface_bytes), header, snapshot.triangulation);
  try {
    check_snapshot(snapshot, execution);
  } catch (const InputError& error) {
    throw file_error(path, error.what());
  }
  return session;
}

}  // namespace cocoon::app
