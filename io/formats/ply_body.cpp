#include "io/formats/ply_body.h"

#include <cmath>
#include <iterator>

#include "io/encoding/byte_order.h"

namespace cocoon {

namespace {

constexpr double two_to_63 = 9223372036854775808.0;

// A whole number stored or written as floating point; false if it is none.
bool whole_number(double value, std::int64_t& result) {
  if (!(std::abs(value) < two_to_63) || value != std::trunc(value)) return false;
  result = static_cast<std::int64_t>(value);
  return true;
}

bool parse(const char*& at, const char* end, float& value) { return parse_float(at, end, value); }
bool parse(const char*& at, const char* end, double& value) { return parse_double(at, end, value); }
bool parse(const char*& at, const char* end, std::uint64_t& value) {
  return parse_integer(at, end, value);
}
template <class T>
bool parse(const char*& at, const char* end, T& value) {
  std::int64_t wide = 0;
  if (!parse_integer(at, end, wide)) return false;
  value = static_cast<T>(wide);
  return static_cast<std::int64_t>(value) == wide;
}

template <class T>
bool append_parsed(std::string_view word, std::string& bytes) {
  const char* at = word.data();
  const char* end = at + word.size();
  T value{};
  if (!parse(at, end, value) || at != end) return false;
  append_little_endian(bytes, value);
  return true;
}

bool append_word(std::string_view word, PlyType type, std::string& bytes) {
  switch (type) {
    case PlyType::int8:
      return append_parsed<std::int8_t>(word, bytes);
    case PlyType::uint8:
      return append_parsed<std::uint8_t>(word, bytes);
    case PlyType::int16:
      return append_parsed<std::int16_t>(word, bytes);
    case PlyType::uint16:
      return append_parsed<std::uint16_t>(word, bytes);
    case PlyType::int32:
      return append_parsed<std::int32_t>(word, bytes);
    case PlyType::uint32:
      return append_parsed<std::uint32_t>(word, bytes);
    case PlyType::int64:
      return append_parsed<std::int64_t>(word, bytes);
    case PlyType::uint64:
      return append_parsed<std::uint64_t>(word, bytes);
    case PlyType::float32:
      return append_parsed<float>(word, bytes);
    case PlyType::float64:
      return append_parsed<double>(word, bytes);
  }
  return false;
}

}  // namespace

PlyTextBody::PlyTextBody(const FileBytes& file, const PlyHeader& header)
    : file_(file), header_lines_(header.lines), lines_(file.view().substr(header.body)) {}

void PlyTextBody::begin_element(const PlyElement& element, std::size_t index) {
  std::string_view line;
  do {
    if (!lines_.next(line)) {
      throw file_error(file_.path, "ends before element " + in_quotes(element.name) + " " +
                                       std::to_string(index) + " of " +
                                       std::to_string(element.count) + "; the file is cut off");
    }
    fields_ = Fields(line);
  } while (fields_.done());
  short_line_ = 0;
}

void PlyTextBody::go_on_behind_short_line(const char* expected) {
  if (!fields_.done()) return;
  if (short_line_ == 0) {
    short_line_ = line();
    expected_there_ = expected;
  }
  std::string_view line;
  while (fields_.done()) {
    if (!lines_.next(line)) fail_short_line();
    fields_ = Fields(line);
  }
}

double PlyTextBody::number(PlyType) {
  double value = 0;
  if (fields_.number(value)) return value;
  go_on_behind_short_line("a number");
  if (!fields_.number(value)) fail_value("a number");
  return value;
}

std::int64_t PlyTextBody::integer(PlyType) {
  std::int64_t value = 0;
  double number = 0;
  if (fields_.integer(value)) return value;
  go_on_behind_short_line("a whole number");
  if (fields_.integer(value)) return value;
  Fields field = fields_;  // stays there for the message
  if (!field.number(number) || !whole_number(number, value)) fail_value("a whole number");
  fields_ = field;
  return value;
}

std::size_t PlyTextBody::list_length(PlyType count_type, PlyType) {
  const std::int64_t length = integer(count_type);
  // A value takes a digit and a separator.
  if (length < 0 || static_cast<std::size_t>(length) > fields_.rest().size() / 2 + 1) {
    throw file_error(file_.path, line(),
                     "a list of " + std::to_string(length) +
                         " values does not fit its line; the file is damaged");
  }
  return static_cast<std::size_t>(length);
}

void PlyTextBody::skip(PlyType, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) next_word();
}

bool PlyTextBody::append(PlyType type, std::size_t count, std::string& bytes) {
  bool all = true;
  for (std::size_t i = 0; i < count; ++i) {
    all = append_word(next_word(), type, bytes) && all;
  }
  return all;
}

std::string_view PlyTextBody::next_word() {
  const std::string_view word = fields_.word();
  if (!word.empty()) return word;
  go_on_behind_short_line("one more value");
  return fields_.word();
}

void PlyTextBody::end_element() {
  if (fields_.done()) return;
  if (short_line_ != 0) fail_short_line();
  if (++surplus_lines_ == 1) first_surplus_line_ = line();
}

void PlyTextBody::fail_short_line() const {
  throw file_error(file_.path, short_line_,
                   std::string("expected ") + expected_there_ +
                       ", found the end of the line; does the line match the header?");
}

void PlyTextBody::fail_value(const char* expected) {
  if (short_line_ != 0) fail_short_line();
  throw file_error(file_.path, line(),
                   std::string("expected ") + expected + ", found " + in_quotes(fields_.word()) +
                       "; does the line match the header?");
}

PlyBinaryBody::PlyBinaryBody(const FileBytes& file, const PlyHeader& header)
    : file_(file),
      at_(file.data.get() + header.body),
      end_(file.data.get() + file.size),
      order_(header.encoding == PlyEncoding::little_endian ? std::endian::little
                                                           : std::endian::big) {}

std::string PlyBinaryBody::place() const {
  return "element " + in_quotes(element_->name) + " " + std::to_string(index_) + " of " +
         std::to_string(element_->count) + ", byte " + std::to_string(at_ - file_.data.get());
}

const char* PlyBinaryBody::take(std::size_t size, std::size_t count) {
  if (count > static_cast<std::size_t>(end_ - at_) / size) {
    throw file_error(file_.path, "ends within " + place() + "; the file is cut off or damaged");
  }
  const char* taken = at_;
  at_ += size * count;
  return taken;
}

double PlyBinaryBody::number(PlyType type) {
  const char* bytes = take(size_of(type));
  switch (type) {
    case PlyType::int8:
      return load_number<std::int8_t>(bytes, order_);
    case PlyType::uint8:
      return load_number<std::uint8_t>(bytes, order_);
    case PlyType::int16:
      return load_number<std::int16_t>(bytes, order_);
    case PlyType::uint16:
      return load_number<std::uint16_t>(bytes, order_);
    case PlyType::int32:
      return load_number<std::int32_t>(bytes, order_);
    case PlyType::uint32:
      return load_number<std::uint32_t>(bytes, order_);
    case PlyType::int64:
      return static_cast<double>(load_number<std::int64_t>(bytes, order_));
    case PlyType::uint64:
      return static_cast<double>(load_number<std::uint64_t>(bytes, order_));
    case PlyType::float32:
      return load_number<float>(bytes, order_);
    case PlyType::float64:
      return load_number<double>(bytes, order_);
  }
  return 0;
}

std::int64_t PlyBinaryBody::integer(PlyType type) {
  const std::string where = type == PlyType::float32 || type == PlyType::float64 ? place() : "";
  switch (type) {
    case PlyType::int32:
      return load_number<std::int32_t>(take(4), order_);
    case PlyType::uint32:
      return load_number<std::uint32_t>(take(4), order_);
    case PlyType::int64:
      return load_number<std::int64_t>(take(8), order_);
    // Beyond 2^63 it becomes negative, which no index or length may be.
    case PlyType::uint64:
      return static_cast<std::int64_t>(load_number<std::uint64_t>(take(8), order_));
    default:
      break;
  }
  std::int64_t value = 0;
  if (!whole_number(number(type), value)) {
    throw file_error(file_.path, where + " has an index that is no whole number");
  }
  return value;
}

std::size_t PlyBinaryBody::list_length(PlyType count_type, PlyType type) {
  const std::int64_t length = integer(count_type);
  if (length < 0) {
    throw file_error(file_.path, "announces a list of " + std::to_string(length) + " values in " +
                                     place() + "; it is damaged");
  }
  if (static_cast<std::size_t>(length) > static_cast<std::size_t>(end_ - at_) / size_of(type)) {
    throw file_error(file_.path, "announces a list of " + std::to_string(length) + " values in " +
                                     place() +
                                     ", more than the file holds; it is cut off or damaged");
  }
  return static_cast<std::size_t>(length);
}

void PlyBinaryBody::skip(PlyType type, std::size_t count) { take(size_of(type), count); }

bool PlyBinaryBody::append(PlyType type, std::size_t count, std::string& bytes) {
  const std::size_t size = size_of(type);
  const char* values = take(size, count);
  if (order_ == std::endian::little) {
    bytes.append(values, size * count);
    return true;
  }
  for (const char* value = values; value != values + size * count; value += size) {
    bytes.append(std::make_reverse_iterator(value + size), std::make_reverse_iterator(value));
  }
  return true;
}

}  // namespace cocoon
