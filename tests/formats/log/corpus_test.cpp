// The logs of tests/corpus/log and of the samples, through the reader and through the JSON Schema.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "formats/log/summary.h"
#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = PENTIMENTO_SOURCE_DIR;

bool is_log(const fs::path& path) {
  return path.filename().string().find(".jsonl") != std::string::npos;
}

std::vector<std::string> logs_in(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && is_log(entry.path())) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(LogCorpus, GoodLogsLoad) {
  const std::vector<std::string> paths = logs_in(kSource / "tests/corpus/log/good");
  EXPECT_GE(paths.size(), 10u);
  for (const std::string& path : paths) {
    const Outcome outcome = read_file(path);
    EXPECT_TRUE(outcome.ok) << outcome.message;
  }
}

TEST(LogCorpus, BadLogsAreRefusedAsBadInputInOneLine) {
  const std::vector<std::string> paths = logs_in(kSource / "tests/corpus/log/bad");
  EXPECT_GE(paths.size(), 50u);
  for (const std::string& path : paths) {
    const Outcome outcome = read_file(path);
    EXPECT_FALSE(outcome.ok) << path;
    EXPECT_EQ(outcome.code, ErrorCode::kBadInput) << path;
    EXPECT_TRUE(outcome.message.starts_with(path + ":")) << outcome.message;
    EXPECT_EQ(outcome.message.find('\n'), std::string::npos) << outcome.message;
  }
}

TEST(LogCorpus, CompressionMakesNoDifference) {
  const fs::path good = kSource / "tests/corpus/log/good";
  const std::string expected = read_file((good / "every-event.jsonl").string()).sha256;
  for (const char* name : {"gzip.jsonl.gz", "gzip-two-members.jsonl.gz", "zstd.jsonl.zst",
                           "zstd-two-frames.jsonl.zst", "zstd-by-content.jsonl"}) {
    EXPECT_EQ(read_file((good / name).string()).sha256, expected) << name;
  }
}

TEST(LogCorpus, SamplesLoad) {
  for (const std::string& path : logs_in(PENTIMENTO_SAMPLES)) {
    auto reader = Reader::open(path, {});
    ASSERT_TRUE(reader.ok()) << reader.error().message;
    const Result<Summary> summary = summarize(**reader);
    ASSERT_TRUE(summary.ok()) << summary.error().message;
    EXPECT_GT(summary->strokes, 0) << path;
  }
}

/// Lines of check_schema.py for `paths`.
std::vector<std::string> check_schema(const std::vector<std::string>& paths, int every) {
  std::string command = "python3 '" + (kSource / "tests/formats/log/check_schema.py").string() +
                        "' '" + (kSource / "docs/action-log.schema.json").string() + "' " +
                        std::to_string(every);
  for (const std::string& path : paths) command += " '" + path + "'";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::vector<std::string> lines(1);
  for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += static_cast<char>(c);
    }
  }
  lines.pop_back();
  EXPECT_EQ(::pclose(pipe), 0) << "python3 with jsonschema is needed (bootstrap installs it)";
  return lines;
}

TEST(LogSchema, AcceptsGoodLogsAndSamples) {
  std::vector<std::string> paths = logs_in(PENTIMENTO_SAMPLES);
  for (const std::string& path : logs_in(kSource / "tests/corpus/log/good")) {
    // Python's standard library has no zstd.
    if (path.find("zstd") == std::string::npos) paths.push_back(path);
  }
  const std::vector<std::string> lines = check_schema(paths, 100);
  EXPECT_EQ(lines.size(), paths.size());
  for (const std::string& line : lines) EXPECT_TRUE(line.starts_with("ok ")) << line;
}

TEST(LogSchema, RefusesWhatASingleLineShows) {
  std::vector<std::string> paths = logs_in(kSource / "tests/corpus/log/bad");
  std::erase_if(paths, [](const std::string& path) {
    return !fs::path(path).filename().string().starts_with("schema-");
  });
  const std::vector<std::string> lines = check_schema(paths, 1);
  EXPECT_EQ(lines.size(), paths.size());
  for (const std::string& line : lines) EXPECT_TRUE(line.starts_with("bad ")) << line;
}

}  // namespace
}  // namespace pentimento::log
