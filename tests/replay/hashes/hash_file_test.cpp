#include "replay/hashes/hash_file.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

const HashHeader kHeader = {"abc", "pentimento 1", "pentimento render a.jsonl", 64, 48, 8, 8};

void write(const std::string& path) {
  auto writer = HashWriter::create(path, kHeader, false);
  ASSERT_TRUE(writer);
  (*writer)->write({7, 12, {1, 2, 3, 4, 5, 6, 7, 0xffffffffffffffff}, {{3, 0xdeadbeef}, {4, 0}}});
  (*writer)->write({9, 12, {}, {}});
  ASSERT_TRUE((*writer)->complete());
  ASSERT_TRUE((*writer)->publish());
}

TEST(HashFile, ReadsBackWhatWasWrittenPlainAndCompressed) {
  const test::Scratch scratch;
  for (const char* name : {"a.hashes", "a.hashes.gz", "a.hashes.zst"}) {
    write(scratch.path(name));
    const auto reader = HashReader::open(scratch.path(name));
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_EQ((*reader)->header().log_sha256, "abc");
    EXPECT_EQ((*reader)->header().command, kHeader.command);
    EXPECT_EQ((*reader)->header().height, 48);
    EXPECT_EQ((*reader)->header().tile_width, 8);
    const auto first = (*reader)->next();
    ASSERT_TRUE(first);
    EXPECT_EQ((*first)->step, 7);
    EXPECT_EQ((*first)->line, 12);
    EXPECT_EQ((*first)->fields[7], 0xffffffffffffffff);
    EXPECT_EQ((*first)->tiles, (std::vector<TileHash>{{3, 0xdeadbeef}, {4, 0}}));
    EXPECT_EQ((*(*reader)->next())->step, 9);
    EXPECT_FALSE(*(*reader)->next());
  }
}

TEST(HashFile, NothingIsThereBeforeItIsPublished) {
  const test::Scratch scratch;
  { const auto writer = HashWriter::create(scratch.path("a.hashes"), kHeader, false); }
  EXPECT_EQ(scratch.files(), 0U);
}

TEST(HashFile, SaysWhatIsWrongAndWhere) {
  const test::Scratch scratch;
  const auto problem = [&](const std::string& bytes) {
    test::spill(scratch.path("a"), bytes);
    const auto reader = HashReader::open(scratch.path("a"));
    if (!reader) return reader.error().message;
    const auto step = (*reader)->next();
    return step ? std::string() : step.error().message;
  };
  write(scratch.path("good"));
  const std::string good = test::slurp(scratch.path("good"));
  const std::string head = good.substr(0, good.find('\n') + 1);
  const std::string name = scratch.path("a");
  EXPECT_EQ(problem("{}\n"), name + ":1: not a file of hashes");
  EXPECT_EQ(problem("[]\n"), name + ":1: not a JSON object");
  EXPECT_EQ(problem(head + "{\"step\":1}\n"), name + ":2: not the hashes of a step");
  EXPECT_EQ(problem(head + R"({"step":1,"line":1,"fields":["x","","","","","","",""],"tiles":[]})"),
            name + ":2: not the hashes of a step");
  std::string newer = head;
  newer.replace(newer.find("\"version\":1"), 11, "\"version\":2");
  EXPECT_EQ(problem(newer), name + ":1: a newer version than this program's");
  EXPECT_EQ(HashReader::open(scratch.path("nowhere")).error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento
