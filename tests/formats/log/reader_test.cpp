#include "formats/log/reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "formats/io/sha256.h"
#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

const std::string kSmallLog =
    kHeaderLine + R"({"t":0,"type":"touch","phase":"down","id":1,"x":0.1,"y":0.2,"pressure":0.5})"
                  "\n"
                  R"({"t":0.0222225,"type":"touch","phase":"up","id":1,"x":0.3,"y":0.2})"
                  "\n"
                  R"({"t":1.5,"type":"mark","name":"größer"})"
                  "\n";

TEST(Reader, ReadsTimesAsWholeMicrosecondsAndKnowsTheirLines) {
  const Outcome outcome = read_text(kSmallLog);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  ASSERT_EQ(outcome.events.size(), 3u);
  EXPECT_EQ(outcome.events[1].time_us, 22223);  // half a microsecond rounds up
  EXPECT_EQ(outcome.events[2].time_us, 1500000);
  EXPECT_EQ(outcome.events[2].line, 4);
  EXPECT_EQ(std::get<Mark>(outcome.events[2].action).name, "größer");
}

TEST(Reader, KeepsTimeExactForACentury) {
  const Outcome outcome = read_text(kHeaderLine + R"({"t":2199999.123457,"type":"dry"})" +
                                    "\n");  // the default limit of steps
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.events[0].time_us, 2199999123457);
}

TEST(Reader, ReadsEveryTouchField) {
  const Outcome outcome = read_text(
      kHeaderLine + R"({"pressure":0.25,"y":2,"x":-1,"id":-7,"phase":"down","tilt_x":1,)"
                    R"("tilt_y":-2,"twist":3,"radius":0.004,"type":"touch","t":0,"x-raw":[1]})");
  ASSERT_TRUE(outcome.ok) << outcome.message;
  const Touch& touch = std::get<Touch>(outcome.events[0].action);
  EXPECT_EQ(touch.phase, TouchPhase::kDown);
  EXPECT_EQ(touch.id, -7);
  EXPECT_EQ(touch.x_m, -1);
  EXPECT_EQ(touch.y_m, 2);
  EXPECT_EQ(touch.pressure, 0.25);
  EXPECT_EQ(touch.tilt_x_deg, 1);
  EXPECT_EQ(touch.tilt_y_deg, -2);
  EXPECT_EQ(touch.twist_deg, 3);
  EXPECT_EQ(touch.radius_m, 0.004);
  EXPECT_EQ(outcome.events[0].extensions, R"("x-raw":[1])");
}

TEST(Reader, CarriageReturnsAndBlankLinesMakeNoDifference) {
  std::string text = "\r\n  \n" + kSmallLog;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3) {
    text.replace(at, 1, "\r\n\n");
  }
  const Outcome outcome = read_text(text);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.events.size(), 3u);
}

TEST(Reader, ALastLineNeedsNoLineFeed) {
  const Outcome outcome = read_text(kHeaderLine + R"({"t":0,"type":"dry"})");
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.events.size(), 1u);
}

TEST(Reader, HashesTheBytesOfTheLog) {
  EXPECT_EQ(read_text(kSmallLog).sha256, sha256_hex(kSmallLog));
}

TEST(Reader, RewindGivesTheSameEventsAgain) {
  const TemporaryFolder folder;
  auto reader = Reader::open(folder.write("a.jsonl", kSmallLog), {});
  ASSERT_TRUE(reader.ok());
  const Header* header = &(*reader)->header();
  ASSERT_TRUE((*reader)->next().ok());  // one event of the first pass
  ASSERT_TRUE((*reader)->rewind().ok());
  for (int pass = 0; pass < 2; ++pass) {
    int events = 0;
    for (;;) {
      const auto event = (*reader)->next();
      ASSERT_TRUE(event.ok()) << event.error().message;
      if (!*event) break;
      ++events;
    }
    EXPECT_EQ(events, 3);
    EXPECT_EQ((*reader)->sha256(), sha256_hex(kSmallLog));
    ASSERT_TRUE((*reader)->rewind().ok());
  }
  EXPECT_EQ(header, &(*reader)->header());
}

// A prefix is a log as long as no line is cut; otherwise the message says that it is cut.
TEST(Reader, EveryPrefixIsALogOrAnErrorThatSaysItIsCut) {
  for (std::size_t size = 0; size < kSmallLog.size(); ++size) {
    const Outcome outcome = read_text(kSmallLog.substr(0, size));
    const bool whole_line = size > 0 && (kSmallLog[size] == '\n' || kSmallLog[size - 1] == '\n');
    EXPECT_EQ(outcome.ok, whole_line) << size << " " << outcome.message;
    if (outcome.ok || size == 0) continue;
    EXPECT_NE(outcome.message.find("cut short"), std::string::npos) << outcome.message;
    EXPECT_EQ(outcome.code, ErrorCode::kBadInput);
  }
}

TEST(Reader, SalvageKeepsTheWholeEventsOfEveryPrefix) {
  ReaderOptions options;
  options.salvage = true;
  for (std::size_t size = kHeaderLine.size(); size <= kSmallLog.size(); ++size) {
    const std::string text = kSmallLog.substr(0, size);
    const Outcome outcome = read_text(text, options);
    ASSERT_TRUE(outcome.ok) << outcome.message;
    const auto line_feeds = std::count(text.begin(), text.end(), '\n');
    const bool open_line = text.back() != '\n';
    const bool cut = open_line && text.back() != '}';
    EXPECT_EQ(static_cast<std::int64_t>(outcome.events.size()), line_feeds - (!open_line || cut));
    EXPECT_EQ(outcome.salvaged.empty(), !cut);
    EXPECT_EQ(outcome.sha256, sha256_hex(text));
  }
  const Outcome outcome = read_text(kHeaderLine + R"({"t":0,"ty)", options);
  EXPECT_EQ(outcome.salvaged, "line 2 is cut short (10 bytes dropped)");
}

TEST(Reader, SalvageForgivesOnlyTheCut) {
  ReaderOptions options;
  options.salvage = true;
  EXPECT_FALSE(read_text(kHeaderLine + "{\"t\":0,\"ty\n{\"t\":0,\"type\":\"dry\"}\n", options).ok);
  EXPECT_FALSE(read_text(kHeaderLine.substr(0, 40), options).ok);
}

// Whatever a damaged byte makes of a log, the outcome is a log or one line of words.
TEST(Reader, SurvivesEveryByteDamagedInSeveralWays) {
  const TemporaryFolder folder;
  for (std::size_t at = 0; at < kSmallLog.size(); ++at) {
    for (const char byte : {'\0', '"', '{', '}', '[', ',', '9', '\xff', '\n', '\\'}) {
      std::string text = kSmallLog;
      text[at] = byte;
      const Outcome outcome = read_file(folder.write("a.jsonl", text));
      if (outcome.ok) continue;
      EXPECT_EQ(outcome.message.find('\n'), std::string::npos);
      EXPECT_NE(outcome.message.find("a.jsonl:"), std::string::npos);
    }
  }
}

TEST(Reader, LimitsAreErrorsOfTheirOwnCode) {
  const auto outcome_with = [](auto change, const std::string& events) {
    ReaderOptions options;
    change(options.limits);
    return read_text(kHeaderLine + events, options);
  };
  const std::string dry = "{\"t\":10,\"type\":\"dry\"}\n";
  Outcome outcome = outcome_with([](Limits& limits) { limits.max_events = 2; }, dry + dry + dry);
  EXPECT_EQ(outcome.code, ErrorCode::kLimit);
  EXPECT_EQ(outcome.message, "a.jsonl:4: more than 2 events, the limit (--max-events)");
  outcome = outcome_with([](Limits& limits) { limits.max_steps = 449; }, dry);
  EXPECT_EQ(outcome.code, ErrorCode::kLimit);
  EXPECT_EQ(outcome.message,
            "a.jsonl:2: t 10 is step 450, over 449 steps, the limit (--max-steps)");
  outcome = outcome_with([](Limits& limits) { limits.max_line_bytes = 100; },
                         dry + std::string(101, ' ') + "\n");
  EXPECT_EQ(outcome.code, ErrorCode::kLimit);
  EXPECT_EQ(outcome.message,
            "a.jsonl:3: the line is longer than 100 bytes, the limit (--max-line)");
  outcome = outcome_with([](Limits& limits) { limits.max_touches = 1; },
                         R"({"t":0,"type":"touch","phase":"down","x":0,"y":0})"
                         "\n"
                         R"({"t":0,"type":"touch","phase":"down","id":1,"x":0,"y":0})");
  EXPECT_EQ(outcome.code, ErrorCode::kLimit);
  outcome = outcome_with([](Limits& limits) { limits.max_colors = 1; },
                         R"({"t":0,"type":"color","value":"#000000"})"
                         "\n"
                         R"({"t":0,"type":"color","value":"#000001"})");
  EXPECT_EQ(outcome.code, ErrorCode::kLimit);
  outcome = outcome_with([](Limits& limits) { limits.max_steps = 1; },
                         "{\"t\":0,\"type\":\"step\"}\n{\"t\":0,\"type\":\"step\"}\n");
  EXPECT_EQ(outcome.code, ErrorCode::kLimit);
}

TEST(Reader, AMillionOpenBracketsAreRefusedQuickly) {
  const std::string deep(1'000'000, '[');
  const Outcome outcome = read_text(kHeaderLine + R"({"t":0,"type":"x-a","b":)" + deep +
                                    std::string(1'000'000, ']') + "}\n");
  EXPECT_EQ(outcome.code, ErrorCode::kBadInput);
  EXPECT_EQ(outcome.message, "a.jsonl:2: nested deeper than 16 levels");
}

TEST(Reader, AHundredThousandMembersAreCheckedForDuplicatesQuickly) {
  std::string members;
  for (int i = 0; i < 100'000; ++i) members += ",\"k" + std::to_string(i) + "\":0";
  const std::string start = R"({"t":0,"type":"x-a")";
  EXPECT_TRUE(read_text(kHeaderLine + start + members + "}\n").ok);
  const Outcome outcome = read_text(kHeaderLine + start + members + ",\"k7\":0}\n");
  EXPECT_EQ(outcome.message, R"(a.jsonl:2: duplicate key "k7")");
}

TEST(Reader, FilesOutsideAreAllowedOnRequest) {
  ReaderOptions options;
  options.allow_outside = true;
  EXPECT_TRUE(read_text(kHeaderLine + R"({"t":0,"type":"load","file":"/a/../b.png"})", options).ok);
}

TEST(Reader, ColoursAndNamesOfTheHeaderAreKnown) {
  const Outcome outcome = read_text(
      R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":1,"height":1},)"
      R"("palette":[{"name":"mud","color":"#604020"}],"brushes":[{"name":"mop","shape":"round"}]})"
      "\n"
      R"({"t":0,"type":"color","pigment":"mud"})"
      "\n"
      R"({"t":0,"type":"brush","name":"mop"})"
      "\n"
      R"({"t":0,"type":"brush","name":"knife"})");
  EXPECT_TRUE(outcome.ok) << outcome.message;
}

TEST(Reader, ExtensionsAreKeptWordForWord) {
  const std::string line = R"({ "type" : "x-zoom", "t":1e0, "scale": 2.50 })";
  const Outcome outcome = read_text(kHeaderLine + line + " \r\n");
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(std::get<Extension>(outcome.events[0].action).json, line);
  EXPECT_EQ(std::get<Extension>(outcome.events[0].action).type, "x-zoom");
}

TEST(Reader, WhatCannotBeOpenedIsAnInputOutputError) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_file(folder.file("none.jsonl")).code, ErrorCode::kIo);
  EXPECT_EQ(read_file(folder.path().string()).code, ErrorCode::kIo);
}

/// The outcome of reading `text` from a pipe as standard input.
Outcome read_from_standard_input(const std::string& text) {
  int ends[2] = {};
  EXPECT_EQ(::pipe(ends), 0);
  // Less than a pipe's buffer, so that one thread can write and read.
  EXPECT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  ::close(ends[1]);
  const int saved = ::dup(STDIN_FILENO);
  ::dup2(ends[0], STDIN_FILENO);
  ::close(ends[0]);
  Outcome outcome = read_file("-");
  ::dup2(saved, STDIN_FILENO);
  ::close(saved);
  return outcome;
}

TEST(Reader, ReadsStandardInput) {
  const Outcome outcome = read_from_standard_input(kSmallLog);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.events.size(), 3u);
  EXPECT_EQ(outcome.sha256, sha256_hex(kSmallLog));
  EXPECT_EQ(read_from_standard_input(kHeaderLine + "{}\n").message,
            "standard input:2: t is missing");
}

}  // namespace
}  // namespace pentimento::log
