#include "io/summed_file.h"

namespace cocoon {

void Checksum::add(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    hash_ ^= load_number<std::uint64_t>(bytes.data() + i, std::endian::little);
    hash_ *= 0x9E3779B97F4A7C15U;
    hash_ ^= hash_ >> 32;
  }
}

std::uint64_t checksum_of(std::string text) {
  text.resize(round_up_to_8(text.size()), '\0');
  Checksum checksum;
  checksum.add(text);
  return checksum.value();
}

void SummedFile::flush() {
  checksum_.add(bytes_);
  file_.write(bytes_);
  bytes_.clear();
}

void SummedFile::append_in_order(const char* numbers, std::size_t size, std::size_t width) {
  const std::size_t begin = bytes_.size();
  bytes_.append(numbers, size);
  if (std::endian::native == std::endian::little) return;
  reverse_each(std::span(bytes_).subspan(begin), width);
}

void SummedFile::commit(FileBatch* batch) {
  fill_word();
  flush();
  append_little_endian(bytes_, checksum_.value());
  file_.write(bytes_);
  file_.commit(batch);
}

std::string_view summed_content(const FileBytes& file, std::string_view magic,
                                std::string_view kind) {
  const std::string_view bytes = file.view();
  if (bytes.substr(0, magic.size()) != magic) {
    throw file_error(file.path, "this is no " + std::string(kind) + ": it does not begin with " +
                                    std::string(magic));
  }
  if (bytes.size() % 8 != 0 || bytes.size() < magic.size() + checksum_size) {
    throw file_error(file.path, "the file has " + std::to_string(bytes.size()) +
                                    " bytes, which is no whole number of words: it was cut off; "
                                    "write it again");
  }
  const std::string_view content = bytes.substr(0, bytes.size() - checksum_size);
  Checksum checksum;
  checksum.add(content);
  if (checksum.value() !=
      load_number<std::uint64_t>(bytes.data() + content.size(), std::endian::little)) {
    throw file_error(file.path,
                     "the checksum is wrong: the file was cut off or damaged; write it again");
  }
  return content;
}

}  // namespace cocoon
