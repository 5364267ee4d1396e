#include "formats/checkpoint/slot_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>
#include <span>

#include "formats/checkpoint/archive.h"
#include "tests/formats/scratch.h"

namespace pentimento::checkpoint {
namespace {

using test::Scratch;
using test::slurp;

/// The bytes of a slot with two parts, as they are on the disk.
std::string some_slot(const Scratch& scratch) {
  const std::string path = scratch.path("1.slot");
  Result<std::unique_ptr<SlotWriter>> to = SlotWriter::create(path);
  EXPECT_TRUE(to) << to.error().message;
  (*to)->add("guide", "paint");
  EXPECT_FALSE(std::filesystem::exists(path)) << "it has its name only when it is whole";
  (*to)->add("memory", "brush and books");
  const Result<void> finished = (*to)->finish();
  EXPECT_TRUE(finished) << finished.error().message;
  EXPECT_EQ((*to)->bytes_written(), std::filesystem::file_size(path));
  return slurp(path);
}

TEST(SlotFile, HasThePartsThatWereWritten) {
  const Scratch scratch;
  some_slot(scratch);
  const Result<SlotParts> parts = read_slot(scratch.path("1.slot"));
  ASSERT_TRUE(parts) << parts.error().message;
  EXPECT_EQ(*parts, (SlotParts{{"guide", "paint"}, {"memory", "brush and books"}}));
  EXPECT_EQ(scratch.files(), 1u) << "no file of another name is left";
}

TEST(SlotFile, CutAnywhereIsRefused) {
  const Scratch scratch;
  const std::string bytes = some_slot(scratch);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Result<SlotParts> parts = parse_slot(bytes.substr(0, size), "a.slot");
    ASSERT_FALSE(parts) << size;
    EXPECT_EQ(parts.error().code, ErrorCode::kBadInput);
    EXPECT_EQ(parts.error().message.rfind("a.slot: ", 0), 0u) << parts.error().message;
  }
}

TEST(SlotFile, EveryBitThatFlipsIsFound) {
  const Scratch scratch;
  const std::string bytes = some_slot(scratch);
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      EXPECT_FALSE(parse_slot(damaged, "a.slot")) << "byte " << at << ", bit " << bit;
    }
}

TEST(SlotFile, SaysWhichPartIsDamaged) {
  const Scratch scratch;
  std::string bytes = some_slot(scratch);
  bytes[bytes.find("books")] = 'B';
  const Result<SlotParts> parts = parse_slot(bytes, "a.slot");
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().message, "a.slot: its part \"memory\" is damaged");
}

/// A slot of one part whose table says what `table` puts there; all checksums are right.
std::string forged_slot(const std::function<void(ArchiveWriter&)>& rows, std::uint64_t count) {
  ArchiveWriter file, table, trailer;
  const std::string_view magic = "pentimento checkpoint\n";
  file.raw(std::span<const char>(magic));
  file.u32(3);
  file.raw(std::span<const char>(std::string_view("paint")));
  table.u64(count);
  rows(table);
  trailer.u64(file.bytes().size());
  trailer.u64(checksum_of(table.bytes()));
  return file.bytes() + table.bytes() + trailer.bytes();
}

void put_row(ArchiveWriter& table, std::uint64_t offset, std::uint64_t size) {
  table.text("guide");
  table.u64(offset);
  table.u64(size);
  table.u64(checksum_of("paint"));
}

TEST(SlotFile, ATableThatIsForgedIsRefused) {
  constexpr std::uint64_t kBegin = 26;  // behind the first line and the version
  const auto problem = [](const std::function<void(ArchiveWriter&)>& rows, std::uint64_t count) {
    const Result<SlotParts> parts = parse_slot(forged_slot(rows, count), "a");
    return parts ? "" : parts.error().message;
  };
  const auto good = [](ArchiveWriter& to) { put_row(to, kBegin, 5); };
  EXPECT_EQ(problem(good, 1), "");
  EXPECT_EQ(problem([](ArchiveWriter& to) { put_row(to, kBegin, 6); }, 1),
            "a: a part lies outside of the file");
  EXPECT_EQ(problem([](ArchiveWriter& to) { put_row(to, kBegin - 1, 5); }, 1),
            "a: a part lies outside of the file");
  EXPECT_EQ(problem([](ArchiveWriter& to) { put_row(to, ~std::uint64_t{0}, 5); }, 1),
            "a: a part lies outside of the file");
  EXPECT_EQ(problem(
                [&](ArchiveWriter& to) {
                  good(to);
                  good(to);
                },
                2),
            "a: a part is there twice");
  EXPECT_EQ(problem(good, 0), "a: its table of parts is damaged");
  EXPECT_EQ(problem(good, 1000), "a: its table of parts is damaged");
}

TEST(SlotFile, OneLargerThanAnyCanvasIsALimitAndTakesNoMemory) {
  const Scratch scratch;
  some_slot(scratch);
  std::filesystem::resize_file(scratch.path("1.slot"), std::uint64_t{17} << 30);
  const Result<SlotParts> parts = read_slot(scratch.path("1.slot"));
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().code, ErrorCode::kLimit);
}

TEST(SlotFile, RefusesALinkAndAPipe) {
  const Scratch scratch;
  some_slot(scratch);
  std::filesystem::create_symlink(scratch.path("1.slot"), scratch.path("2.slot"));
  ASSERT_EQ(::mkfifo(scratch.path("3.slot").c_str(), 0600), 0);
  EXPECT_FALSE(read_slot(scratch.path("2.slot")));
  EXPECT_FALSE(read_slot(scratch.path("3.slot")));
}

}  // namespace
}  // namespace pentimento::checkpoint
