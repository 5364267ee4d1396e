#include "formats/exr/exr_header.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <functional>
#include <string>

#include "formats/image/read_image.h"
#include "formats/io/describe.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;

/// A file whose pixels were never written, which its header does not tell.
void write_header(const std::string& path, int width, int height, int channels) {
  Imf::Header header(width, height);
  for (int c = 0; c < channels; ++c)
    header.channels().insert("c" + std::to_string(c), Imf::Channel(Imf::HALF));
  header.insert("note", Imf::StringAttribute("abc"));
  const Imf::OutputFile file(path.c_str(), header);
}

/// Replaces `from`, which must be there.
void change(const std::string& path, const std::string& from, const std::string& to) {
  std::string bytes = test::slurp(path);
  const std::size_t at = bytes.find(from);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, from.size(), to);
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(ExrHeader, IsSoundUpToTheMostChannels) {
  const Scratch scratch;
  write_header(scratch.path("a.exr"), 4, 4, exr::kMostChannels);
  EXPECT_TRUE(exr::check_header(scratch.path("a.exr")));
  write_header(scratch.path("a.exr"), 4, 4, exr::kMostChannels + 1);
  const Result<void> more = exr::check_header(scratch.path("a.exr"));
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().code, ErrorCode::kLimit);
  EXPECT_EQ(more.error().message, scratch.path("a.exr") + ": 4161 channels, the limit is 4160");
}

TEST(ExrHeader, AnAttributeLongerThanTheFileIsDamage) {
  const Scratch scratch;
  const std::string path = scratch.path("a.exr");
  write_header(path, 4, 4, 3);
  // Of a type that nobody knows, for which the library takes as much memory as it says.
  using namespace std::string_literals;
  change(path, "string\0\x03\0\0\0"s, "strunk\0\x03\0\0\x70"s);
  for (const Result<void>& done : {exr::check_header(path), Result<void>(read_image(path).error()),
                                   Result<void>(describe_exr(path).error())}) {
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::kBadInput);
    EXPECT_EQ(done.error().message.find(path + ": a damaged OpenEXR file: "), 0u);
  }
}

TEST(ExrHeader, WhatTheLibraryReadsPastIsDamage) {
  const Scratch scratch;
  const std::string path = scratch.path("a.exr");
  using namespace std::string_literals;
  write_header(path, 4, 4, 3);
  change(path, "note\0string\0"s, "note\0\0tring\0"s);  // a type without a name
  const Result<void> nameless = exr::check_header(path);
  ASSERT_FALSE(nameless);
  EXPECT_EQ(nameless.error().code, ErrorCode::kBadInput);
  write_header(path, 4, 4, 3);
  change(path, "dataWindow\0box2i"s, "someWindow\0box2i"s);  // needed, and missing
  const Result<void> missing = exr::check_header(path);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kBadInput);
}

TEST(ExrHeader, AListOfChannelsEndsWhereTheFileSays) {
  const Scratch scratch;
  const std::string path = scratch.path("a.exr");
  using namespace std::string_literals;
  write_header(path, 4, 4, 3);
  // A name is longer by a letter, and the zero that ends the list is gone: its length is right.
  change(path, "chlist\0\x3a\0\0\0c0"s, "chlist\0\x3a\0\0\0cc0"s);
  change(path, "\1\0\0\0\1\0\0\0\0compression"s, "\1\0\0\0\1\0\0\0compression"s);
  const Result<void> done = exr::check_header(path);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kBadInput);
}

/// Makes the data window of a picture of 4 x 4 end at `right` and `bottom`, four bytes each.
void change_window(const std::string& path, const std::string& right, const std::string& bottom) {
  using namespace std::string_literals;
  const std::string begin = "dataWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0"s;
  change(path, begin + "\x03\0\0\0\x03\0\0\0"s, begin + right + bottom);
}

TEST(ExrHeader, RowsAndTablesThatNoMemoryOrFileHoldsAreRefused) {
  const Scratch scratch;
  const std::string path = scratch.path("a.exr");
  using namespace std::string_literals;
  write_header(path, 4, 4, 3);
  change_window(path, "\xff\xff\xff\3"s, "\3\0\0\0"s);  // 2^26 wide: 16 rows of 3 halves
  const Result<void> wide = exr::check_header(path);
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.error().code, ErrorCode::kLimit);
  EXPECT_EQ(wide.error().message,
            path + ": rows that are packed together take 6442450944 bytes, the limit is 268435456");
  write_header(path, 4, 4, 3);
  change_window(path, "\3\0\0\0"s, "\xff\xff\xff\3"s);  // 2^26 high: 2^22 chunks
  const Result<void> high = exr::check_header(path);
  ASSERT_FALSE(high);
  EXPECT_EQ(high.error().code, ErrorCode::kBadInput);
}

TEST(ExrHeader, EveryPartIsLookedAt) {
  const Scratch scratch;
  const std::string path = scratch.path("a.exr");
  std::array<Imf::Header, 2> parts = {Imf::Header(4, 4), Imf::Header(4, 4)};
  for (int part = 0; part < 2; ++part) {
    Imf::Header& header = parts[static_cast<std::size_t>(part)];
    header.setName("part " + std::to_string(part));
    header.setType(Imf::SCANLINEIMAGE);
    for (int c = 0; c < (part == 0 ? 3 : exr::kMostChannels + 1); ++c)
      header.channels().insert("c" + std::to_string(c), Imf::Channel(Imf::HALF));
  }
  { const Imf::MultiPartOutputFile file(path.c_str(), parts.data(), 2); }
  const Result<void> second = exr::check_header(path);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kLimit);
}

TEST(ExrHeader, ManyChannelsOfManyPixelsAreRefusedBeforeMemoryIsTaken) {
  const Scratch scratch;
  write_header(scratch.path("a.exr"), 16384, 8192, 33);
  const Result<Image> read = read_image(scratch.path("a.exr"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kLimit);
  EXPECT_EQ(
      read.error().message,
      scratch.path("a.exr") + ": 33 channels of 134217728 pixels, the limit is 4294967296 in all");
}

}  // namespace
}  // namespace pentimento
