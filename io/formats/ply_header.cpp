#include "io/formats/ply_header.h"

#include <array>
#include <string_view>
#include <utility>

#include "io/encoding/number_text.h"

namespace cocoon {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 18> type_names = {{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"int64", PlyType::int64},
    {"uint64", PlyType::uint64},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

class HeaderReader {
 public:
  explicit HeaderReader(const FileBytes& file) : file_(file), text_(file.view()) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  PlyHeader read() {
    read_magic();
    while (true) {
      Fields fields(next_line());
      const std::string_view keyword = fields.word();
      if (keyword == "end_header") break;
      read_statement(keyword, fields);
    }
    if (!format_seen_) fail("has no format line; the header is damaged");
    header_.body = at_;
    header_.lines = line_;
    check_counts();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw file_error(file_.path, line_, message);
  }

  void read_magic() {
    if (text_.empty())
      throw file_error(file_.path, "is empty (0 bytes); was it written completely?");
    const std::string_view start = text_.substr(at_);
    const std::size_t line_end = start.find_first_of("\r\n");
    if (Fields(start.substr(0, line_end)).word() != "ply" || !start.starts_with("ply")) {
      line_ = 1;
      fail("is no PLY file: its first line is not 'ply'; check the extension");
    }
    // CR alone ends the lines only if no LF follows the first one.
    if (line_end != std::string_view::npos && start[line_end] == '\r' &&
        start.substr(line_end + 1, 1) != "\n") {
      line_end_ = '\r';
    }
    next_line();
  }

  std::string_view next_line() {
    const std::size_t end = text_.find(line_end_, at_);
    if (end == std::string_view::npos) fail("the header has no end_header; the file is cut off");
    std::string_view line = text_.substr(at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at_ = end + 1;
    ++line_;
    return line;
  }

  void read_statement(std::string_view keyword, Fields& fields) {
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) return;
    if (keyword == "format") {
      read_format(fields);
    } else if (keyword == "element") {
      read_element(fields);
    } else if (keyword == "property") {
      read_property(fields);
    } else {
      fail("unknown word " + in_quotes(keyword) +
           " in the PLY header; correct this line, or end the header before it by "
           "end_header");
    }
  }

  void read_format(Fields& fields) {
    const std::string_view name = fields.word();
    const std::string_view version = fields.word();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::ascii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else {
      fail("unknown PLY format " + in_quotes(name));
    }
    if (version != "1.0")
      fail("PLY version " + in_quotes(version) +
           " is not known, only 1.0 is; write the file as that");
    if (format_seen_) fail("a second format line; the header is damaged");
    format_seen_ = true;
  }

  void read_element(Fields& fields) {
    PlyElement element;
    element.name = fields.word();
    element.line = line_;
    std::int64_t count = 0;
    if (!fields.integer(count) || count < 0) {
      fail("an element needs a name and a count from 0 to 2^63 - 1; correct this line");
    }
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void read_property(Fields& fields) {
    if (header_.elements.empty()) fail("a property before the first element");
    PlyProperty property;
    std::string_view type = fields.word();
    if (type == "list") {
      property.is_list = true;
      property.count_type = type_named(fields.word());
      if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
        fail("the length of a list cannot have a floating-point type; use uchar or int");
      }
      type = fields.word();
    }
    property.type = type_named(type);
    property.name = fields.word();
    if (property.name.empty()) fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_named(std::string_view name) const {
    for (const auto& [known, type] : type_names) {
      if (name == known) return type;
    }
    fail("unknown PLY type " + in_quotes(name) + "; use char to uint, float or double");
  }

  // No element can be shorter than this, so no count can make a reader reserve more than the file
  // could fill. An ascii value takes a digit and a separator (which the last one may lack).
  static std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding) {
    if (encoding == PlyEncoding::ascii) return 2 * element.properties.size();
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      bytes += size_of(property.is_list ? property.count_type : property.type);
    }
    return bytes;
  }

  void check_counts() const {
    const std::size_t available = text_.size() - header_.body + 1;
    for (const PlyElement& element : header_.elements) {
      const std::size_t least = least_bytes(element, header_.encoding);
      if (least == 0 || element.count <= available / least) continue;
      throw file_error(file_.path, element.line,
                       "announces " + std::to_string(element.count) + " elements " +
                           in_quotes(element.name) + ", but only " + std::to_string(available - 1) +
                           " bytes follow the header; the file is cut off or its header damaged");
    }
  }

  const FileBytes& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  char line_end_ = '\n';
  bool format_seen_ = false;
  PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::int64:
    case PlyType::uint64:
    case PlyType::float64:
      return 8;
  }
  return 0;
}

std::string_view name_of(PlyType type) {
  for (const auto& [name, known] : type_names) {
    if (known == type) return name;
  }
  return {};
}

PlyHeader read_ply_header(const FileBytes& file) { return HeaderReader(file).read(); }

}  // namespace cocoon
