// The kept inputs of the fuzzer: small files of each format, and those that once did harm.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "formats/log/write/to_json.h"
#include "tests/formats/log/log_text.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/grammar_log.h"

namespace pentimento::test {
namespace {

const std::filesystem::path kCorpus = PENTIMENTO_SOURCE_DIR "/tests/corpus/fuzz";

/// Whether the bytes of an input are a file. Else they are choices, and any bytes are as good.
bool reads_files(const std::string& target) {
  return target != "replay" && target != "dump-edits";
}

/// Returns how many files the folder has.
int replay_folder(const std::string& target) {
  int files = 0;
  const std::size_t parts = reads_files(target) ? 20 : 0;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus / target)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    SCOPED_TRACE(entry.path().string());
    fuzz(target, bytes);
    // Cut anywhere it does no harm either.
    for (std::size_t part = 0; part < parts; ++part)
      fuzz(target, std::string_view(bytes).substr(0, bytes.size() * part / parts));
    ++files;
  }
  return files;
}

TEST(FuzzCorpus, NoKeptInputDoesHarm) {
  for (const std::string& target : fuzz_targets())
    EXPECT_GT(replay_folder(target), 0) << target << " has no kept input";
}

/// The log as it would be written, read by the reader of logs.
log::Outcome written_and_read(const ListReader& log) {
  std::string text = log::header_json(log.head) + "\n";
  for (const log::Event& event : log.events) text += log::event_json(event) + "\n";
  return log::read_text(text);
}

TEST(FuzzCorpus, TheGrammarOfReplaysMakesValidLogsOnly) {
  std::mt19937 random(1);
  std::size_t most_events = 0;
  for (int i = 0; i < 300; ++i) {
    std::string bytes(random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    Choices choices(bytes);
    const ListReader log = grammar_log(choices);
    const log::Outcome read = written_and_read(log);
    ASSERT_TRUE(read.ok) << read.message;
    EXPECT_EQ(read.events.size(), log.events.size());
    most_events = std::max(most_events, log.events.size());
  }
  EXPECT_GT(most_events, 30u);
}

}  // namespace
}  // namespace pentimento::test
