#include "replay/commands/convert.h"

#include <gtest/gtest.h>

#include <atomic>

#include "replay/commands/validate.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

ConvertJob job(const test::JobFolder& folder, const std::string& input) {
  ConvertJob out;
  out.input = folder.path(input);
  out.output = folder.path("out.jsonl");
  return out;
}

TEST(Convert, ARecordingBecomesAValidLogThatNamesItsSource) {
  const test::JobFolder folder;
  const std::string rows = "0 10 10 0.5\n1 20 30 0.6\n2 20 30 0\n50 30 10 0.5\n51 40 40 0.7\n";
  folder.write("a.dat", rows);
  ConvertJob with = job(folder, "a.dat");
  with.edits.size_factor = 2;
  const auto done = convert(with);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->format, "mypaint");
  EXPECT_EQ(done->strokes, 2);
  EXPECT_EQ(done->samples, 4);
  EXPECT_DOUBLE_EQ(done->duration_s, 12);  // a pause of 49 s is cut to 10
  EXPECT_FALSE(done->report.kept.empty());
  const auto facts = validate_log(folder.path("out.jsonl"), {});
  ASSERT_TRUE(facts) << facts.error().message;
  EXPECT_EQ(facts->summary.strokes, 2);
  EXPECT_EQ(facts->summary.event_count, done->events);
  const std::string hash = test::run("sha256sum " + folder.path("a.dat")).second.substr(0, 64);
  EXPECT_EQ(facts->header.extensions,
            R"("x-source":{"format":"mypaint","file":"a.dat","sha256":")" + hash + "\"}");
}

TEST(Convert, ALogStaysTheSamePaintingAndIsNamed) {
  const test::JobFolder folder(test::kSmallLog);
  const auto done = convert(job(folder, "a.jsonl"));
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->format, "log");
  const auto before = validate_log(folder.path("a.jsonl"), {});
  const auto after = validate_log(folder.path("out.jsonl"), {});
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->summary.events, before->summary.events);
  EXPECT_EQ(after->steps, before->steps);
  EXPECT_EQ(after->header.extensions,
            R"("x-edited":{"file":"a.jsonl","sha256":")" + before->summary.sha256 + "\"}");
  // Edited again, it names both.
  ConvertJob again = job(folder, "out.jsonl");
  again.output = folder.path("twice.jsonl");
  again.edits.speed = 2;
  ASSERT_TRUE(convert(again));
  const auto twice = validate_log(folder.path("twice.jsonl"), {});
  ASSERT_TRUE(twice);
  EXPECT_NE(twice->header.extensions.find("\"x-edited-2\""), std::string::npos);
  EXPECT_NEAR(twice->summary.duration_s(), before->summary.duration_s() / 2, 1e-6);
}

TEST(Convert, TheSensorIsNamedAndTheLogCountedAsItIs) {
  const test::JobFolder folder(test::kSmallLog);
  folder.write("g.csv", "t,x,y,z\n0,0,9.8,0\n1,0,0,9.8\n");
  ConvertJob with = job(folder, "a.jsonl");
  with.edits.gravity_file = folder.path("g.csv");
  with.edits.trim_s = {0, 0.5};
  const auto done = convert(with);
  ASSERT_TRUE(done) << done.error().message;
  const auto after = validate_log(folder.path("out.jsonl"), {});
  ASSERT_TRUE(after);
  const std::string hash = test::run("sha256sum " + folder.path("g.csv")).second.substr(0, 64);
  EXPECT_NE(
      after->header.extensions.find(R"("x-gravity":{"file":"g.csv","sha256":")" + hash + "\"}"),
      std::string::npos)
      << after->header.extensions;
  EXPECT_EQ(done->strokes, 2);
  EXPECT_EQ(done->log_strokes, after->summary.strokes);
  EXPECT_LT(done->log_samples, done->samples);
}

TEST(Convert, TwoLogsBecomeOneThatNamesBoth) {
  const test::JobFolder folder(test::kSmallLog);
  folder.write("b.jsonl", test::small_header() + R"({"t":0.1,"type":"brush","name":"flat"}
{"t":0.2,"type":"touch","phase":"down","x":0.3,"y":0.2,"pressure":0.5}
{"t":0.4,"type":"touch","phase":"move","x":0.35,"y":0.25,"pressure":0.5}
{"t":30,"type":"touch","phase":"up","x":0.35,"y":0.2}
)");
  ConvertJob merge = job(folder, "a.jsonl");
  merge.edits.merged_log = folder.path("b.jsonl");
  const auto done = convert(merge);
  ASSERT_TRUE(done) << done.error().message;
  const auto a = validate_log(folder.path("a.jsonl"), {}),
             b = validate_log(folder.path("b.jsonl"), {});
  const auto both = validate_log(folder.path("out.jsonl"), {});
  ASSERT_TRUE(a && b && both) << both.error().message;
  EXPECT_EQ(both->summary.strokes, a->summary.strokes + b->summary.strokes);
  EXPECT_GE(both->summary.duration_s(), 30);
  EXPECT_EQ(both->header.extensions,
            R"("x-edited":{"file":"a.jsonl","sha256":")" + a->summary.sha256 +
                R"("},"x-merged":{"file":"b.jsonl","sha256":")" + b->summary.sha256 + "\"}");
}

TEST(Convert, RefusesToMergeWhatUndoes) {
  const test::JobFolder folder(test::kSmallLog);
  folder.write("undo.jsonl", test::kSmallLog + "{\"t\":60,\"type\":\"undo\"}\n");
  std::string wide = test::kSmallLog;
  wide.replace(wide.find("\"width\":0.4"), 11, "\"width\":0.8");
  folder.write("wide.jsonl", wide);
  const auto error = [&](const std::string& in, const std::string& other) {
    ConvertJob merge = job(folder, in);
    merge.edits.merged_log = folder.path(other);
    const auto done = convert(merge);
    EXPECT_NE(test::run("test -e " + folder.path("out.jsonl")).first, 0);
    return done ? "none" : done.error().message;
  };
  const std::string problem =
      "undo.jsonl: a log with `undo` or `redo` cannot be merged with another";
  EXPECT_EQ(error("a.jsonl", "undo.jsonl"), folder.path(problem));
  EXPECT_EQ(error("undo.jsonl", "a.jsonl"), folder.path(problem));
  EXPECT_EQ(error("a.jsonl", "wide.jsonl"),
            "wide.jsonl: the canvas is 0.4 x 0.3 m, the other log's 0.8 x 0.3 m; a copy made with "
            "--fit can be merged");
}

TEST(Convert, AJobThatIsToldToStopLeavesNothing) {
  const test::JobFolder folder(test::kSmallLog);
  const std::atomic<bool> stop = true;
  ConvertJob stopped = job(folder, "a.jsonl");
  stopped.control = [&] {
    Control control;
    control.cancelled = &stop;
    return control;
  };
  const auto done = convert(stopped);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(test::run("ls -A " + folder.path("")).second, "a.jsonl\n");
}

TEST(Convert, NothingIsWrittenWhereSomethingIsWrong) {
  const test::JobFolder folder(test::kSmallLog + "{\"t\":\n");
  folder.write("none.txt", "hello");
  folder.write("bad.dat", "0 1 2 3\n");
  folder.write("g.csv", "a,b\n");
  ConvertJob unknown = job(folder, "bad.dat");
  unknown.format = "mypant";
  ConvertJob gravity = job(folder, "a.jsonl");
  folder.write("b.jsonl", test::kSmallLog);
  gravity.input = folder.path("b.jsonl");
  gravity.edits.gravity_file = folder.path("g.csv");
  const std::pair<ConvertJob, ErrorCode> bad[] = {{job(folder, "a.jsonl"), ErrorCode::kBadInput},
                                                  {job(folder, "none.txt"), ErrorCode::kBadInput},
                                                  {job(folder, "bad.dat"), ErrorCode::kBadInput},
                                                  {job(folder, "missing"), ErrorCode::kIo},
                                                  {unknown, ErrorCode::kUsage},
                                                  {gravity, ErrorCode::kBadInput}};
  for (const auto& [wrong, code] : bad) {
    const auto done = convert(wrong);
    ASSERT_FALSE(done) << wrong.input;
    EXPECT_EQ(done.error().code, code) << done.error().message;
    EXPECT_NE(test::run("test -e " + folder.path("out.jsonl")).first, 0);
  }
  EXPECT_EQ(convert(unknown).error().message,
            "--as: no format is called 'mypant' (did you mean \"mypaint\"?)");
}

}  // namespace
}  // namespace pentimento
