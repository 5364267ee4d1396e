#include "replay/checkpoint/checkpointer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/replay/checkpoint/interrupted_job.h"
#include "tests/replay/checkpoint/two_slots.h"
#include "tests/replay/small_job.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

using test::busy_log;
using test::checkpointed;
using test::comparable;
using test::interrupt;
using test::JobFolder;
using test::refusal;
using test::rendered;
using test::survive;
using test::Survived;
using test::TwoSlots;

/// Heavy mode: saved and brought back after every step (with sanitizers after some).
void expect_heavy_mode_changes_nothing(const std::string& log, RenderJob job,
                                       const JobFolder& folder) {
  folder.write("a.jsonl", log);
  const std::string plain = comparable(rendered(job));
  std::vector<std::string> files;
  for (const std::string& output : job.picture.outputs) files.push_back(test::slurp(output));
  const Survived survived = survive(checkpointed(job, folder), test::kStride);
  ASSERT_TRUE(survived.report) << survived.report.error().message;
  EXPECT_GT(survived.interruptions, test::kStride == 1 ? 12 : 1);  // idle steps are skipped
  EXPECT_EQ(comparable(*survived.report), plain);
  for (std::size_t i = 0; i < files.size(); ++i)
    EXPECT_EQ(test::slurp(job.picture.outputs[i]) == files[i], true) << job.picture.outputs[i];
  EXPECT_FALSE(std::filesystem::exists(folder.path("ck"))) << "a job that is done needs no slots";
}

TEST(Checkpointer, SavedAfterEveryStepAReplayIsAsIfItHadNotBeenInterrupted) {
  for (const int detail : {1, 2, 3}) {
    SCOPED_TRACE(detail);
    const JobFolder folder;
    RenderJob job = folder.job({"a.h5", "a.png"});
    job.detail = detail;
    expect_heavy_mode_changes_nothing(busy_log(), job, folder);
  }
}

TEST(Checkpointer, SoIsSpectralPaint) {
  const JobFolder folder;
  RenderJob job = folder.job({"a.h5"});
  job.detail = 2;
  expect_heavy_mode_changes_nothing(busy_log(R"("optics":"spectral",)"), job, folder);
}

TEST(Checkpointer, SoIsThePublishedFluid) {
  const JobFolder folder;
  RenderJob job = folder.job({"a.h5"});
  job.model = {{"scheme", "paper"}};
  expect_heavy_mode_changes_nothing(busy_log(), job, folder);
}

TEST(Checkpointer, SoAreSeveralStopsThatSettleAndAScratchFile) {
  const JobFolder folder;
  RenderJob stops = folder.job({"f-%.h5", "g-%.png"}, {"0.3", "0.6", "0.9"});
  stops.detail = 2;
  stops.scratch = folder.path("");
  folder.write("a.jsonl", busy_log());
  const std::string plain = comparable(rendered(stops));
  std::vector<std::string> files;
  for (const char* name : {"f-0.3.h5", "f-0.6.h5", "f-0.9.h5", "g-0.3.png", "g-0.6.png"}) {
    files.push_back(test::slurp(folder.path(name)));
    std::filesystem::remove(folder.path(name));
  }
  const Survived survived = survive(checkpointed(stops, folder), test::kStride);
  ASSERT_TRUE(survived.report) << survived.report.error().message;
  EXPECT_EQ(comparable(*survived.report), plain);
  std::size_t i = 0;
  for (const char* name : {"f-0.3.h5", "f-0.6.h5", "f-0.9.h5", "g-0.3.png", "g-0.6.png"})
    EXPECT_TRUE(test::slurp(folder.path(name)) == files[i++]) << name;

  RenderJob rests = folder.job({"a.h5"}, {"0.4"});
  rests.settle_s = 0.5;
  expect_heavy_mode_changes_nothing(busy_log(), rests, folder);
}

TEST(Checkpointer, SoIsWhatGoesOnFromADump) {
  const JobFolder folder;
  RenderJob first = folder.job({"half.h5"}, {"0.6"});
  first.detail = 2;
  folder.write("a.jsonl", busy_log());
  rendered(first);
  RenderJob job = folder.job({"a.h5"});
  job.from = folder.path("half.h5");
  job.detail = 2;
  expect_heavy_mode_changes_nothing(busy_log(), job, folder);
}

TEST(Checkpointer, SoIsWhatWasInterruptedBeforeItsFirstStep) {
  // The replay warns of the edge when it has read the log and is about to paint.
  const std::string log =
      busy_log().replace(busy_log().find(R"("height":0.15)"), 13, R"("height":0.15,"edge":"open")");
  const JobFolder folder;
  RenderJob job = folder.job({"a.png"}, {"0.6"});
  job.model = {{"sleep_tile", "0.02"}};  // so that some tiles sleep from the first step on
  folder.write("a.jsonl", log);
  const std::string plain = comparable(rendered(job));
  std::atomic<bool> cancelled = false;
  Control control;
  control.cancelled = &cancelled;
  control.warn = [&](const std::string&) { cancelled = true; };
  const Result<JobReport> done = render(checkpointed(job, folder), control);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, testing::HasSubstr("interrupted at step 0;"));
  EXPECT_EQ(comparable(rendered(checkpointed(job, folder))), plain);
}

TEST(Checkpointer, SoIsAFilm) {
  const JobFolder folder(busy_log());
  RenderJob job = folder.job({"film.avi", "frame-%02d.png"});
  job.film.frames = 9;
  const std::string plain = comparable(rendered(job));
  const std::string film = test::slurp(folder.path("film.avi"));
  const std::string frame = test::slurp(folder.path("frame-04.png"));
  const Survived survived = survive(checkpointed(job, folder), 2 * test::kStride);
  ASSERT_TRUE(survived.report) << survived.report.error().message;
  EXPECT_GT(survived.interruptions, test::kStride == 1 ? 15 : 2);
  EXPECT_EQ(comparable(*survived.report), plain);
  EXPECT_TRUE(test::slurp(folder.path("film.avi")) == film);
  EXPECT_TRUE(test::slurp(folder.path("frame-04.png")) == frame);
}

/// Of the paint alone: files of different folders have different names.
std::string comparable_paint(JobReport report) {
  report.outputs.clear();
  return comparable(report);
}

TEST(Checkpointer, ATornNewestSlotGivesWayToTheOneBefore) {
  const JobFolder folder(busy_log());
  RenderJob plain_job = folder.job({"a.h5"});
  plain_job.detail = 2;
  const std::string plain = comparable_paint(rendered(plain_job));
  for (const char* how : {"cut", "flipped", "empty", "planes"}) {
    SCOPED_TRACE(how);
    const TwoSlots two;
    ASSERT_EQ(two.slots().size(), 2u);
    std::string torn = two.slots().back();
    if (std::string(how) == "planes") torn.replace(torn.rfind("slot"), 4, "planes");
    std::string bytes = test::slurp(torn);
    if (std::string(how) == "empty") {
      bytes.clear();
    } else if (std::string(how) == "cut") {
      bytes.resize(bytes.size() / 2);
    } else {
      bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    }
    test::spill(torn, bytes);
    const Survived survived = survive(two.job, 1000);
    ASSERT_TRUE(survived.report) << survived.report.error().message;
    ASSERT_EQ(survived.warnings.size(), 1u);
    EXPECT_NE(survived.warnings[0].find("the slot before it is used"), std::string::npos)
        << survived.warnings[0];
    EXPECT_TRUE(survived.report->checkpoint->older_slot);
    EXPECT_EQ(comparable_paint(*survived.report), plain);
  }
}

TEST(Checkpointer, IfNoSlotIsWholeTheJobDoesNotBeginAnewInSilence) {
  const TwoSlots two;
  for (const std::string& slot : two.slots()) test::spill(slot, "torn");
  const Error error = refusal(two.job);
  EXPECT_EQ(error.code, ErrorCode::kBadInput);
  EXPECT_NE(error.message.find("remove the folder to begin anew"), std::string::npos)
      << error.message;
}

TEST(Checkpointer, SlotsOfAnotherJobAreRefusedWithTheReason) {
  const TwoSlots two;
  const auto reason = [&](const auto& change) {
    RenderJob other = two.job;
    change(other);
    const Error error = refusal(other);
    EXPECT_EQ(error.code, ErrorCode::kUsage) << error.message;
    return error.message.substr(error.message.find(": ") + 2);
  };
  EXPECT_EQ(reason([](RenderJob& j) { j.detail = 3; }), "it was saved for detail 2, not 3");
  EXPECT_EQ(reason([](RenderJob& j) {
              j.model = {{"bed_friction", "0.5"}};
            }).rfind("it was saved for model.bed_friction ", 0),
            0u);
  EXPECT_EQ(reason([](RenderJob& j) { j.command = "pentimento render --exposure 1"; }),
            "it was saved for command , not pentimento render --exposure 1");
  EXPECT_EQ(reason([](RenderJob& j) {
              j.picture.outputs.push_back("b.h5");
            }).rfind("it was saved for outputs ", 0),
            0u);
  two.folder.write("other.jsonl", busy_log() + "\n");
  EXPECT_EQ(reason([&](RenderJob& j) {
              j.log = two.folder.path("other.jsonl");
            }).rfind("it was saved for log ", 0),
            0u);
  EXPECT_EQ(two.slots().size(), 2u) << "they serve the job that they belong to";
  EXPECT_TRUE(survive(two.job, 1000).report);
}

TEST(Checkpointer, AFolderThatAnotherRunUsesIsRefused) {
  const JobFolder folder(busy_log());
  const RenderJob job = checkpointed(folder.job({"a.h5"}), folder);
  const auto other = SlotFolder::open(folder.path("ck"));
  ASSERT_TRUE(other);
  const Error error = refusal(job);
  EXPECT_EQ(error.code, ErrorCode::kUsage);
  EXPECT_NE(error.message.find("another run uses it"), std::string::npos) << error.message;
}

TEST(Checkpointer, HashesOfStepsAreRefused) {
  const JobFolder folder(busy_log());
  RenderJob job = checkpointed(folder.job({"a.h5"}), folder);
  job.hashes = folder.path("hashes");
  EXPECT_EQ(refusal(job).code, ErrorCode::kUsage);
  EXPECT_FALSE(std::filesystem::exists(folder.path("ck")));
}

/// A log whose step from 0.5 s on has so many stamps that it takes seconds.
std::string log_of_a_long_step() {
  std::string log =
      R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.2,"height":0.15},)"
      R"("grid":{"width":160,"height":120},"steps_per_second":4})"
      "\n"
      R"({"t":0,"type":"slider","name":"size","value":0.15})"
      "\n"
      R"({"t":0.1,"type":"touch","phase":"down","x":0.02,"y":0.02})"
      "\n"
      R"({"t":0.2,"type":"touch","phase":"up","x":0.03,"y":0.02})"
      "\n";
  for (int i = 0; i <= 2000; ++i) {
    log +=
        fmt::format(R"({{"t":{:.5f},"type":"touch","phase":"{}","x":{},"y":0.1}})", 0.5 + i * 1e-4,
                    i == 0      ? "down"
                    : i == 2000 ? "up"
                                : "move",
                    i % 2 == 0 ? 0.02 : 0.18);
    log += '\n';
  }
  return log;
}

TEST(Checkpointer, AnInterruptionWaitsASecondForALongStepAndNoLonger) {
  const JobFolder folder(log_of_a_long_step());
  RenderJob job = checkpointed(folder.job({"a.h5"}), folder);
  job.checkpoint.every_steps = 2;
  // The step before the long one is the last that tells of itself.
  std::atomic<bool> cancelled{false};
  std::atomic<std::int64_t> step{0};
  Control control;
  control.cancelled = &cancelled;
  control.progress = [&](const ProgressState& state) {
    if (state.phase == "simulate") step = state.done;
  };
  std::chrono::steady_clock::time_point asked;
  std::thread hand([&] {
    while (step < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    asked = std::chrono::steady_clock::now();
    cancelled = true;
  });
  const Result<JobReport> done = render(job, control);
  const auto ended = std::chrono::steady_clock::now();
  hand.join();
  ASSERT_FALSE(done) << "the step is too short for this machine";
  EXPECT_EQ(done.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(
      done.error().message,
      "interrupted within a long step, which is not saved; the same command goes on from step 2");
  EXPECT_GE(ended - asked, std::chrono::milliseconds(900));
}

TEST(Checkpointer, SavesAsOftenAsItIsTold) {
  const JobFolder folder(busy_log());
  RenderJob job = checkpointed(folder.job({"a.h5"}), folder);
  job.checkpoint.every_steps = 10;
  const JobReport often = rendered(job);  // 43 steps: at 10, 20, 30, 40, and before the outputs
  ASSERT_TRUE(often.checkpoint);
  EXPECT_EQ(often.checkpoint->slots_written, 5);
  EXPECT_GT(often.checkpoint->bytes_written, 0);
  EXPECT_FALSE(often.checkpoint->resumed_step);
  job.checkpoint.every_steps.reset();
  EXPECT_EQ(rendered(job).checkpoint->slots_written, 0) << "a moment's work is not worth a slot";
  EXPECT_FALSE(rendered(folder.job({"a.h5"})).checkpoint);
}

}  // namespace
}  // namespace pentimento
