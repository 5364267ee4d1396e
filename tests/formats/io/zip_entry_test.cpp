#include "formats/io/zip_entry.h"

#include <gtest/gtest.h>
#include <zip.h>

#include <fstream>
#include <iterator>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// An archive with one entry, as another program writes it.
std::string archive_with(const std::string& entry, const std::string& content, zip_int32_t method) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.zip");
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
  zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
  const zip_int64_t index = zip_file_add(archive, entry.c_str(), source, 0);
  zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), method, 9);
  EXPECT_EQ(zip_close(archive), 0);
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ZipEntry, ReadsStoredAndDeflatedContent) {
  const std::string text(100000, 'x');
  for (const zip_int32_t method : {ZIP_CM_STORE, ZIP_CM_DEFLATE}) {
    const std::string bytes = archive_with("a/b.txt", text, method);
    const Result<std::string> read = read_zip_entry({"in.zip", bytes}, "a/b.txt", 100000);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, text);
  }
}

TEST(ZipEntry, NamesWhatIsMissing) {
  const std::string bytes = archive_with("a", "text", ZIP_CM_STORE);
  const Result<std::string> missing = read_zip_entry({"in.zip", bytes}, "b", 100);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(missing.error().message, "in.zip: b: No such file");
  EXPECT_EQ(read_zip_entry({"in.zip", "no archive"}, "a", 100).error().message,
            "in.zip: zip archive: Not a zip archive");
  EXPECT_FALSE(read_zip_entry({"in.zip", ""}, "a", 100));
}

// A bomb: 100 MB of zeros in 100 kB. Whatever the archive says of the entry's size, no more is
// unpacked than may be.
TEST(ZipEntry, StopsAtTheLimit) {
  const std::string bytes = archive_with("a", std::string(100'000'000, '\0'), ZIP_CM_DEFLATE);
  ASSERT_LT(bytes.size(), 200'000u);
  const Result<std::string> read = read_zip_entry({"in.zip", bytes}, "a", 1'000'000);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kLimit);
  EXPECT_EQ(read.error().message, "in.zip: a: unpacks to more than 1000000 bytes");
}

TEST(ZipEntry, FindsDamage) {
  std::string bytes = archive_with("a", std::string(1000, 'x'), ZIP_CM_STORE);
  bytes[500] = 'y';
  const Result<std::string> read = read_zip_entry({"in.zip", bytes}, "a", 100000);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "in.zip: a: CRC error");
}

}  // namespace
}  // namespace pentimento
