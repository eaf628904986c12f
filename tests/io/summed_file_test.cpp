// What was written comes back piece by piece, and no damage stays unseen, whatever was read.
#include "io/summed_file.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/errors.h"
#include "geom/random/random.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

constexpr std::string_view magic = "SUMMEDUP";

std::string random_text(std::size_t size, Random& random) {
  std::string text;
  while (text.size() < size) text.push_back(static_cast<char>('a' + random.below(26)));
  return text;
}

TEST(SummedFile, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  Random random(1);
  for (const std::size_t size : {0U, 1U, 7U, 8U, 13U, 100000U, 300001U}) {
    const std::string text = random_text(size, random);
    std::vector<double> numbers(size);
    for (double& number : numbers) number = random.uniform();
    SummedFile file(folder / "a");
    file.append(magic);
    file.append(std::uint32_t{7});
    file.append(std::uint32_t{9});
    file.append_numbers<double>(std::span<const double>(numbers));
    file.append(std::string_view(text));
    file.fill_word();
    file.append(std::uint64_t{11});
    file.commit();

    SummedReader reader(folder / "a", magic, "file", "write it again");
    EXPECT_EQ(reader.left(), 8 + 8 * size + round_up_to_8(size) + 8);
    EXPECT_EQ(reader.next<std::uint32_t>(), 7U);
    EXPECT_EQ(reader.next<std::uint32_t>(), 9U);
    std::vector<double> read(size);
    reader.fill<double>(std::span(read));
    EXPECT_EQ(read, numbers);
    EXPECT_EQ(reader.take(size), text);
    reader.skip_to_word();
    EXPECT_EQ(reader.next<std::uint64_t>(), 11U);
    EXPECT_EQ(reader.left(), 0U);
    reader.finish();
  }
}

// One bit in each word, also where nobody has read when the file is finished.
TEST(SummedFile, DamageIsSeenWhateverWasRead) {
  const TemporaryFolder folder;
  Random random(2);
  SummedFile file(folder / "a");
  file.append(magic);
  file.append(std::string_view(random_text(200, random)));
  file.commit();
  const std::string whole = content_of(folder / "a");
  const auto finish_behind = [&](const std::string& content, std::size_t read) {
    const auto path = folder.write("b", content);
    return message_of<FileError>(path, [&] {
      SummedReader reader(path, magic, "file", "write it again");
      reader.take(read);
      reader.finish();
    });
  };
  for (const std::size_t read : {0U, 101U, 200U}) {
    EXPECT_EQ(finish_behind(whole, read), "");
    for (std::size_t at = magic.size(); at < whole.size(); at += 5) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.below(8)));
      EXPECT_EQ(finish_behind(damaged, read),
                ": the checksum is wrong: the file was cut off or damaged; write it again")
          << at;
    }
  }
  EXPECT_NE(finish_behind(whole.substr(0, whole.size() - 8), 0), "");
  EXPECT_EQ(finish_behind(whole.substr(0, whole.size() - 3), 0),
            ": the file has 213 bytes, which is no whole number of words: it was cut off; write it "
            "again");
  std::string other = whole;
  other[0] = 'T';
  EXPECT_EQ(
      finish_behind(other, 0),
      ": this is no file: it does not begin with SUMMEDUP; check the name, or write it again");
}

// Whatever pieces the bytes come in; and words may not change places unseen.
TEST(SummedFile, ChecksumsAreOfTheBytesInTheirOrder) {
  Random random(3);
  const std::string text = random_text(160, random);
  for (int trial = 0; trial < 50; ++trial) {
    Checksum checksum;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t taken = std::min(text.size() - at, std::size_t{random.below(30)});
      checksum.add(std::string_view(text).substr(at, taken));
      at += taken;
    }
    EXPECT_EQ(checksum.value(), checksum_of(text));
  }
  EXPECT_NE(checksum_of(text.substr(8, 8) + text.substr(0, 8)), checksum_of(text.substr(0, 16)));
  std::string turned = text;  // the highest bits of two words
  for (const std::size_t at : {7U, 15U}) turned[at] = static_cast<char>(turned[at] ^ 0x80);
  EXPECT_NE(checksum_of(turned), checksum_of(text));
  EXPECT_EQ(checksum_of("abc"), checksum_of(std::string("abc\0\0", 5)));
}

}  // namespace
}  // namespace cocoon
