#include "io/formats/xyz.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/encoding/column_names.h"
#include "io/encoding/number_text.h"
#include "io/encoding/point_text.h"
#include "io/encoding/text_lines.h"
#include "io/file_format.h"

namespace cocoon {

namespace {

enum class Separator { none, blank, comma, semicolon };

std::string not_decimal(std::string_view text) {
  return " is not a decimal number: " + in_quotes(text) +
         "; correct or remove this line, or begin it with # if it is a comment";
}

bool is_comment(const char* at, const char* end) {
  return *at == '#' || (*at == '/' && at + 1 != end && at[1] == '/');
}

void skip_blanks(const char*& at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
}

// Passes what separates two columns. False: something else follows, which belongs to the column.
bool read_separator(const char*& at, const char* end, Separator& separator) {
  const char* begin = at;
  skip_blanks(at, end);
  if (at == end || is_comment(at, end)) {
    separator = Separator::none;
    at = end;
    return true;
  }
  if (*at == ',' || *at == ';') {
    separator = *at == ',' ? Separator::comma : Separator::semicolon;
    ++at;
    skip_blanks(at, end);
    return true;
  }
  separator = Separator::blank;
  return at != begin;
}

// What separates the columns of a line: what there is of ; and , outside of quotes, in this order.
char separator_of(std::string_view line) {
  char found = ' ';
  char last = ' ';
  bool is_quoted = false;
  for (const char* at = line.data(); at != line.data() + line.size(); last = *at++) {
    if (*at == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (is_blank(last) && is_comment(at, line.data() + line.size())) break;
    if (*at == ';') return *at;
    if (*at == ',') found = *at;
  }
  return found;
}

// The columns of a line as text, for the rare lines that are no plain rows. Blanks around them are
// left out, and so is an empty last one.
std::vector<std::string_view> split_columns(std::string_view line) {
  const char separator = separator_of(line);
  std::vector<std::string_view> columns;
  const char* at = line.data();
  const char* end = at + line.size();
  skip_blanks(at, end);
  while (at != end && !is_comment(at, end)) {
    const char* begin = at;
    const char* column_end = at;  // without the blanks behind it
    bool is_quoted = false;
    while (at != end) {
      if (*at == '"') is_quoted = !is_quoted;
      if (!is_quoted && (separator == ' ' ? is_blank(*at) : *at == separator)) break;
      if (!is_blank(*at)) {
        if (at != column_end && is_comment(at, end)) break;
        column_end = at + 1;
      }
      ++at;
    }
    columns.emplace_back(begin, static_cast<std::size_t>(column_end - begin));
    if (at != end && *at == separator) ++at;
    skip_blanks(at, end);
  }
  return columns;
}

// One more than the commas outside of quotes: a comma at the end begins an empty column.
std::size_t count_comma_columns(std::string_view line) {
  std::size_t columns = 1;
  bool is_quoted = false;
  for (char c : without_comment(line)) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ',' && !is_quoted) ++columns;
  }
  return columns;
}

std::string_view without_quotes(std::string_view column) {
  const bool is_quoted = column.size() >= 2 && column.front() == column.back() &&
                         (column.front() == '"' || column.front() == '\'');
  return is_quoted ? column.substr(1, column.size() - 2) : column;
}

bool is_name(std::string_view column) {
  column = without_quotes(column);
  if (column.empty()) return false;
  const char* at = column.data();
  double value = 0;
  if (parse_double(at, column.data() + column.size(), value)) return false;  // also nan and inf
  const char first = column.front();
  return (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z') || first == '_' ||
         first == '"' || first == '\'';
}

// 0, 1, 2 ..., as pandas names the columns of a table that has no names.
bool counts_columns(std::span<const std::string_view> columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (without_quotes(columns[i]) != std::to_string(i)) return false;
  }
  return columns.size() >= 3;
}

bool is_whole(const Point& point) {
  return point.x == std::floor(point.x) && point.y == std::floor(point.y) &&
         point.z == std::floor(point.z);
}

class XyzReader {
 public:
  XyzReader(const FileBytes& file, NonFinitePoints& non_finite)
      : file_(file), lines_(text_of(file)), non_finite_(non_finite) {}

  PointCloud read() {
    std::string_view line;
    while (lines_.next(line)) {
      const char* at = line.data();
      const char* end = at + line.size();
      skip_blanks(at, end);
      if (at == end) continue;
      begins_with_tab_ = line.front() == '\t';
      line = {at, static_cast<std::size_t>(end - at)};
      if (is_comment(at, end)) {
        if (cloud_.points.empty()) read_comment(line);
        continue;
      }
      if (cloud_.points.empty() && (read_count(line) || read_header(line))) continue;
      read_row(line);
    }
    check_number_of_rows();
    leave_out_normals();
    tell_doubts();
    return std::move(cloud_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw file_error(file_.path, lines_.number(), message);
  }

  void read_row(std::string_view line) {
    if (cloud_.points.empty()) begin_rows(line);
    if (columns_.at != CoordinateColumns().at || line.front() == '"') {
      read_row_by_columns(line);
    } else {
      if (has_tabs_between_names_) require_coordinates(line);
      read_plain_row(line);
    }
  }

  // Before the first row, by its number of columns: a comment that happens to name x, y, z is none
  // of their names if it has another one.
  void begin_rows(std::string_view line) {
    const std::vector<std::string_view> columns = split_columns(line);
    cloud_.columns = columns.size();
    if (cloud_.header.empty() && comment_columns_.told == CoordinateColumns::Told::all &&
        comment_names_.size() == cloud_.columns) {
      columns_ = comment_columns_;
      names_ = comment_names_;
    }
    // What R writes in front of its rows are their names, in quotes.
    const bool begins_with_row = header_begins_with_tab_ || line.front() == '"';
    if (!names_.empty() && begins_with_row && cloud_.columns == names_.size() + 1) {
      names_.insert(names_.begin(), "");
      for (std::size_t& at : columns_.at) ++at;
    }
    cloud_.told_columns = columns_.told == CoordinateColumns::Told::all;
    cloud_.named_columns = names_.size();
    if (names_.empty()) {
      cloud_.first_row_counts_columns = counts_columns(columns);
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cloud_.coordinate_names[axis] = names_[columns_.at[axis]];
    }
  }

  // Where the names say so, or where values are in quotes.
  void read_row_by_columns(std::string_view line) {
    const std::size_t wanted = names_.empty() ? cloud_.columns : names_.size();
    std::vector<std::string_view> columns = split_columns(line);
    const char last = line[line.find_last_not_of(" \t")];
    const bool ends_empty = last == ',' || last == ';';
    if (ends_empty && columns.size() + 1 == wanted) columns.emplace_back();
    if (columns.size() != wanted) {
      fail("has " + std::to_string(columns.size()) + " columns, but " +
           (names_.empty() ? "earlier lines have " : "the header names ") + std::to_string(wanted) +
           "; if the comma is a decimal comma, write a point instead");
    }
    if (columns.size() < 3) {
      fail("a row needs three numbers x y z, this one has " + std::to_string(columns.size()) +
           "; correct or remove this line");
    }
    rows_are_counted_ = false;
    double xyz[3] = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view text = without_quotes(columns[columns_.at[axis]]);
      const char* at = text.data();
      if (parse_double(at, text.data() + text.size(), xyz[axis]) &&
          at == text.data() + text.size()) {
        continue;
      }
      fail("column " + std::to_string(columns_.at[axis] + 1) + not_decimal(text));
    }
    add({xyz[0], xyz[1], xyz[2]});
  }

  // Nothing between two tabs, or before the first, is a value that is missing, unless tabs align
  // the columns.
  void require_coordinates(std::string_view line) const {
    if (!begins_with_tab_ && line.find("\t\t") == std::string_view::npos) return;
    if (split_columns(line).size() >= names_.size()) return;
    std::size_t column = begins_with_tab_ ? 0 : 1;
    for (std::size_t at = 0; column > 0 && column < 3; ++column) {
      at = line.find('\t', at) + 1;
      if (at == 0) return;
      if (at < line.size() && line[at] == '\t') break;
    }
    if (column < 3) fail("column " + std::to_string(column + 1) + " is empty");
  }

  void read_plain_row(std::string_view line) {
    const char* at = line.data();
    const char* end = at + line.size();
    std::array<double, 3> xyz = {};
    std::array<Separator, 3> separators = {};
    for (std::size_t column = 0; column < 3; ++column) {
      const char* begin = at;
      if (!parse_double(at, end, xyz[column]) || !read_separator(at, end, separators[column])) {
        const std::string_view text(begin, static_cast<std::size_t>(end - begin));
        fail("column " + std::to_string(column + 1) +
             not_decimal(text.substr(0, text.find_first_of(" \t,;"))));
      }
      if (separators[column] == Separator::none && column < 2) {
        const bool may_be_count = column == 0 && cloud_.announced && !cloud_.points.empty();
        fail("a row needs three numbers x y z, this one has " + std::to_string(column + 1) +
             (may_be_count ? "; split a file of several scans, each under its count"
                           : "; correct or remove this line"));
      }
    }
    const bool mixed = separators[0] != separators[1] ||
                       (separators[2] != Separator::none && separators[2] != separators[0]);
    if (mixed) {
      fail("mixes separators; if the comma is a decimal comma, write a point instead");
    }
    if (separators[0] == Separator::comma) check_comma_columns(line);
    if (cloud_.points.empty()) first_number_ = xyz[0];
    const auto number = static_cast<double>(cloud_.points.size());
    rows_are_counted_ = rows_are_counted_ && xyz[0] == first_number_ + number;
    add({xyz[0], xyz[1], xyz[2]});
  }

  void add(const Point& point) {
    if (!is_finite(point)) non_finite_.note(cloud_.points.size(), lines_.number());
    cloud_.points.push_back(point);
  }

  // A decimal comma among commas shows itself by rows of different length.
  void check_comma_columns(std::string_view line) {
    const std::size_t columns = count_comma_columns(line);
    if (comma_columns_ == 0) comma_columns_ = columns;
    if (columns != comma_columns_) {
      fail("has " + std::to_string(columns) + " columns, earlier lines have " +
           std::to_string(comma_columns_) +
           "; if the comma is a decimal comma, write a point instead");
    }
  }

  // A whole number alone on the first line.
  bool read_count(std::string_view line) {
    std::int64_t count = 0;
    std::size_t end = 0;  // where a comment begins
    while (end < line.size() && !is_comment(&line[end], line.data() + line.size())) ++end;
    Fields fields(line.substr(0, end));
    if (cloud_.announced || !fields.integer(count) || !fields.done() || count < 0) return false;
    cloud_.announced = static_cast<std::size_t>(count);
    count_line_ = lines_.number();
    return true;
  }

  // CloudCompare's names of the columns are one.
  void read_comment(std::string_view line) {
    line.remove_prefix(line.front() == '#' ? 1 : 2);
    const std::vector<std::string_view> names = split_columns(line);
    const CoordinateColumns columns = coordinate_columns(names);
    if (columns.told != CoordinateColumns::Told::all) return;
    for (const std::string_view name : names) {
      if (!name.empty() && name.back() == ':') return;  // "columns: x y z" names what follows
    }
    comment_columns_ = columns;
    comment_names_.assign(names.begin(), names.end());
  }

  bool read_header(std::string_view line) {
    if (!cloud_.header.empty()) return false;
    const std::vector<std::string_view> names = split_columns(line);
    // Tables of pandas have no name for the column that numbers their rows.
    const std::size_t first = !names.empty() && without_quotes(names.front()).empty() ? 1 : 0;
    if (names.size() < first + 3) return false;
    const std::span<const std::string_view> named = std::span(names).subspan(first);
    const bool are_names = std::all_of(named.begin(), named.begin() + 3, is_name);
    if (!are_names && (first == 0 || !counts_columns(named))) return false;
    columns_ = coordinate_columns(names);
    if (columns_.told == CoordinateColumns::Told::none) columns_.at = {first, first + 1, first + 2};
    if (columns_.told == CoordinateColumns::Told::angles) {
      fail(
          "the header names latitude and longitude, which are angles; project the points first "
          "(to UTM, say), with coordinates and heights in one unit");
    }
    if (columns_.told == CoordinateColumns::Told::some) {
      fail("the header names some of x, y, z, but not all three; name the columns of all, or none");
    }
    names_.assign(names.begin(), names.end());
    if (line.find(',') != std::string_view::npos) comma_columns_ = count_comma_columns(line);
    cloud_.header = line;
    header_begins_with_tab_ = begins_with_tab_;
    has_tabs_between_names_ = line.find('\t') != std::string_view::npos;
    return true;
  }

  void check_number_of_rows() const {
    if (cloud_.announced && cloud_.points.size() < *cloud_.announced) {
      throw file_error(file_.path, count_line_,
                       "announces " + std::to_string(*cloud_.announced) + " points, but " +
                           std::to_string(cloud_.points.size()) + " follow; the file is cut off");
    }
    if (cloud_.points.empty() && !cloud_.announced) {
      throw file_error(file_.path, "holds no points; expected lines 'x y z'");
    }
  }

  // What was read as told may have been meant otherwise; see PointCloud.
  void tell_doubts() {
    constexpr std::size_t least_rows = 10;
    const std::vector<Point>& rows = cloud_.points;
    cloud_.first_column_counts_rows = rows_are_counted_ && rows.size() >= least_rows &&
                                      cloud_.columns > 3 && names_.empty() &&
                                      first_number_ == std::floor(first_number_);
    cloud_.first_row_counts_columns =
        cloud_.first_row_counts_columns && !std::all_of(rows.begin(), rows.end(), is_whole);
  }

  // Of a .pwn file that has them after all points.
  void leave_out_normals() {
    constexpr double tolerance = 0.01;
    std::vector<Point>& rows = cloud_.points;
    if (extension_of(file_.path) != ".pwn" || !cloud_.announced || cloud_.columns != 3) return;
    if (rows.size() != 2 * *cloud_.announced) return;
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(*cloud_.announced);
    const bool are_normals = std::all_of(
        middle, rows.end(), [](const Point& row) { return std::abs(norm(row) - 1) < tolerance; });
    if (are_normals) rows.erase(middle, rows.end());
  }

  const FileBytes& file_;
  TextLines lines_;
  NonFinitePoints& non_finite_;
  std::size_t count_line_ = 0;     // of the announced count
  std::size_t comma_columns_ = 0;  // 0: not known yet
  double first_number_ = 0;        // of the first row
  bool rows_are_counted_ = true;   // by their first numbers: each is one more than the last
  bool begins_with_tab_ = false;   // the current line
  // The same of pandas where tabs separate columns, if the rows have one more than the names.
  bool header_begins_with_tab_ = false;
  bool has_tabs_between_names_ = false;
  CoordinateColumns columns_;
  std::vector<std::string> names_;  // of all columns; empty: there is no header
  CoordinateColumns comment_columns_;
  std::vector<std::string> comment_names_;
  PointCloud cloud_;
};

}  // namespace

PointCloud read_xyz(const FileBytes& file, NonFinitePoints& non_finite) {
  return XyzReader(file, non_finite).read();
}

void write_xyz(AtomicFile& file, Points points, std::string_view extension) {
  const char separator = extension == ".csv" ? ',' : ' ';
  if (extension == ".csv") file.write("x,y,z\n");
  if (extension == ".pts") file.write(std::to_string(points.size()) + "\n");
  for (const Point& point : points) {
    std::string& text = file.buffer();
    append_point(text, point, separator);
    text += '\n';
    file.flush_if_full();
  }
}

}  // namespace cocoon
