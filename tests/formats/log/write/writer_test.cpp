#include "formats/log/write/writer.h"

#include <gtest/gtest.h>

#include "formats/log/write/to_json.h"
#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

/// Enough events that every compressor gives out more than one block.
std::vector<Event> many_events() {
  std::vector<Event> events(20'000);
  for (std::size_t i = 0; i < events.size(); ++i) {
    events[i].time_us = static_cast<std::int64_t>(i) * 8333;
    events[i].action = Gravity{0.001 * static_cast<double>(i % 977), 0.1, 9.7};
  }
  return events;
}

class WriterOf : public testing::TestWithParam<const char*> {};

TEST_P(WriterOf, GivesWhatIsReadBack) {
  const TemporaryFolder folder;
  const std::string path = folder.file(GetParam());
  auto writer = Writer::create(path, compression_of(path));
  ASSERT_TRUE(writer.ok()) << writer.error().message;
  Header header;
  header.title = "written";
  (*writer)->write(header);
  const std::vector<Event> events = many_events();
  for (const Event& event : events) (*writer)->write(event);
  ASSERT_FALSE(std::filesystem::exists(path)) << "the name appears only when all is written";
  const Result<Published> published = (*writer)->finish();
  ASSERT_TRUE(published.ok()) << published.error().message;
  const Outcome outcome = read_file(path);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.header.title, "written");
  ASSERT_EQ(outcome.events.size(), events.size());
  EXPECT_EQ(event_json(outcome.events.back()), event_json(events.back()));
}
INSTANTIATE_TEST_SUITE_P(Names, WriterOf, testing::Values("a.jsonl", "a.jsonl.gz", "a.jsonl.zst"));

TEST_P(WriterOf, LeavesNothingBehindWithoutFinish) {
  const TemporaryFolder folder;
  {
    auto writer = Writer::create(folder.file(GetParam()), compression_of(GetParam()));
    ASSERT_TRUE(writer.ok());
    (*writer)->write(Header());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// A cut anywhere in compressed data is an error that says so; salvage keeps the whole events.
TEST_P(WriterOf, EveryCutIsNoticed) {
  const TemporaryFolder folder;
  const std::string path = folder.file(GetParam());
  auto writer = Writer::create(path, compression_of(path));
  ASSERT_TRUE(writer.ok());
  (*writer)->write(Header());
  for (int i = 0; i < 5; ++i) (*writer)->write(Event{i * 1000, 0, Dry{}, ""});
  ASSERT_TRUE((*writer)->finish().ok());
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const bool plain = compression_of(path) == Compression::kNone;
  for (std::size_t size = 0; size < bytes.size() && !plain; ++size) {
    const Outcome outcome = read_file(folder.write("cut", bytes.substr(0, size)));
    EXPECT_FALSE(outcome.ok) << size;
    ReaderOptions salvage;
    salvage.salvage = true;
    const Outcome rest = read_file(folder.write("cut", bytes.substr(0, size)), salvage);
    EXPECT_TRUE(!rest.ok || !rest.salvaged.empty()) << size;
  }
}

TEST(Writer, OfAnUnwritablePlaceFailsAtOnce) {
  const auto writer = Writer::create("/nonexistent/folder/a.jsonl", Compression::kNone);
  ASSERT_FALSE(writer.ok());
  EXPECT_EQ(writer.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento::log
