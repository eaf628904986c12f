#include "io/summed_file.h"

namespace cocoon {

void Checksum::add_word(const char* word) {
  hash_ ^= load_number<std::uint64_t>(word, std::endian::little);
  hash_ *= 0x9E3779B97F4A7C15U;
  hash_ ^= hash_ >> 32;
}

void Checksum::add(std::string_view bytes) {
  if (num_begun_ > 0) {
    const std::size_t taken = std::min(bytes.size(), begun_.size() - num_begun_);
    std::copy_n(bytes.begin(), taken, begun_.begin() + static_cast<std::ptrdiff_t>(num_begun_));
    num_begun_ += taken;
    bytes.remove_prefix(taken);
    if (num_begun_ < begun_.size()) return;
    add_word(begun_.data());
  }
  const std::size_t whole = bytes.size() / 8 * 8;
  for (std::size_t i = 0; i < whole; i += 8) add_word(bytes.data() + i);
  bytes.remove_prefix(whole);
  std::copy(bytes.begin(), bytes.end(), begun_.begin());
  num_begun_ = bytes.size();
}

std::uint64_t checksum_of(std::string_view bytes) {
  Checksum checksum;
  checksum.add(bytes);
  checksum.add(std::string(round_up_to_8(bytes.size()) - bytes.size(), '\0'));
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

namespace {

FileError wrong_magic(const std::filesystem::path& path, std::string_view magic,
                      std::string_view kind, std::string_view remedy) {
  return file_error(path, "this is no " + std::string(kind) + ": it does not begin with " +
                              std::string(magic) + "; check the name, or " + std::string(remedy));
}

void require_whole_words(const std::filesystem::path& path, std::size_t size,
                         std::string_view magic, std::string_view remedy) {
  if (size % 8 == 0 && size >= magic.size() + checksum_size) return;
  throw file_error(path, "the file has " + std::to_string(size) +
                             " bytes, which is no whole number of words: it was cut off; " +
                             std::string(remedy));
}

}  // namespace

SummedReader::SummedReader(const std::filesystem::path& path, std::string_view magic,
                           std::string_view kind, std::string_view remedy)
    : file_(path), remedy_(remedy) {
  if (!file_.size()) whole_ = read_file(path);
  const std::size_t size = whole_ ? whole_->size : *file_.size();
  if (size < magic.size()) throw wrong_magic(path, magic, kind, remedy);
  left_ = size;
  if (take(magic.size()) != magic) throw wrong_magic(path, magic, kind, remedy);
  require_whole_words(path, size, magic, remedy);
  left_ -= checksum_size;
}

std::string SummedReader::take(std::size_t size) {
  std::string text(size, '\0');
  read(std::span(text));
  return text;
}

void SummedReader::read(std::span<char> bytes) {
  constexpr std::size_t piece = std::size_t{1} << 18;  // is in the cache still when it is summed up
  left_ -= bytes.size();
  while (!bytes.empty()) {
    const std::span<char> next = bytes.first(std::min(piece, bytes.size()));
    read_unsummed(next.data(), next.size());
    checksum_.add({next.data(), next.size()});
    bytes = bytes.subspan(next.size());
  }
}

void SummedReader::read_unsummed(char* to, std::size_t size) {
  if (whole_) {
    std::copy_n(whole_->data.get() + at_, size, to);
    at_ += size;
  } else if (file_.read(to, size) < size) {
    throw file_error(file_.path(), "the file became shorter while it was read; " + remedy_);
  }
}

void SummedReader::finish() {
  constexpr std::size_t piece = std::size_t{1} << 16;
  while (left_ > 0) take(std::min(piece, left_));
  std::array<char, checksum_size> sum{};
  read_unsummed(sum.data(), sum.size());
  if (checksum_.value() != load_number<std::uint64_t>(sum.data(), std::endian::little)) {
    throw file_error(file_.path(),
                     "the checksum is wrong: the file was cut off or damaged; " + remedy_);
  }
}

}  // namespace cocoon
