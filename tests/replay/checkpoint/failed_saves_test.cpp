// A disk that does not take a slot: the job goes on without it, and what was saved before still
// holds.

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

#include "replay/checkpoint/checkpointer.h"
#include "tests/formats/faulty_disk.h"
#include "tests/replay/checkpoint/interrupted_job.h"
#include "tests/replay/checkpoint/two_slots.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::busy_log;
using test::checkpointed;
using test::comparable;
using test::FaultyDisk;
using test::InterruptingControl;
using test::JobFolder;
using test::rendered;

constexpr int kSteps = 43;  // of busy_log()

/// Saved after every tenth step, and before the outputs.
RenderJob often_saved(const JobFolder& folder, int detail) {
  RenderJob job = checkpointed(folder.job({"a.h5"}), folder);
  job.checkpoint.every_steps = 10;
  job.detail = detail;
  return job;
}

std::string plain_report(const JobFolder& folder, int detail) {
  RenderJob job = folder.job({"a.h5"});
  job.detail = detail;
  return comparable(rendered(job));
}

std::size_t slots_in(const JobFolder& folder) {
  std::size_t slots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("ck")))
    slots += entry.path().extension() == ".slot" ? 1 : 0;
  return slots;
}

TEST(FailedSaves, CostAWarningEachAndNothingElse) {
  for (const int detail : {1, 2}) {
    const JobFolder folder(busy_log());
    const std::string plain = plain_report(folder, detail);
    Control control;
    std::vector<std::string> warnings;
    control.warn = [&](const std::string& text) { warnings.push_back(text); };
    FaultyDisk disk;
    for (int slot = 1; slot <= 5; ++slot) disk.plan("rename", slot, {EIO});
    const Result<JobReport> done = render(often_saved(folder, detail), control);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(comparable(*done), plain);
    EXPECT_EQ(done->checkpoint->slots_written, 0);
    ASSERT_EQ(warnings.size(), 5u);
    EXPECT_EQ(warnings[0],
              folder.path("ck/1.slot") + ": Input/output error; this moment is not saved");
    EXPECT_FALSE(std::filesystem::exists(folder.path("ck")));
  }
}

/// Two strokes, each within a tile of a detail canvas 16 times as fine. The paint of the first
/// rests when the second begins, at step 150.
constexpr const char* kTwoTiles =
    R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.2,"height":0.15},)"
    R"("grid":{"width":48,"height":36},"steps_per_second":50})"
    R"(
{"t":0,"type":"slider","name":"size","value":0.01}
{"t":0.05,"type":"touch","phase":"down","x":0.03,"y":0.03}
{"t":0.15,"type":"touch","phase":"up","x":0.04,"y":0.04}
{"t":3,"type":"touch","phase":"down","x":0.17,"y":0.12}
{"t":3.2,"type":"touch","phase":"up","x":0.16,"y":0.11}
)";

TEST(FailedSaves, OfTheDetailCanvasAreMadeGoodByTheNext) {
  const JobFolder folder(kTwoTiles);
  const std::string plain = plain_report(folder, 16);
  RenderJob job = often_saved(folder, 16);
  job.checkpoint.every_steps = 100;
  {
    std::atomic<bool> cancelled{false};
    std::vector<std::string> warnings;
    Control control;
    control.cancelled = &cancelled;
    control.warn = [&](const std::string& text) { warnings.push_back(text); };
    control.progress = [&](const ProgressState& state) {
      if (state.phase == "simulate" && state.done >= 155) cancelled = true;
    };
    FaultyDisk disk;
    disk.plan("fsync", 1, {ENOSPC});  // of the planes of the first stroke's tile
    EXPECT_EQ(render(job, control).error().code, ErrorCode::kInterrupted);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find(".planes: No space left on device"), std::string::npos)
        << warnings[0];
  }
  const JobReport report = rendered(job);
  EXPECT_GE(report.checkpoint->resumed_step.value_or(0), 155);
  EXPECT_EQ(comparable(report), plain) << "the second slot has the first stroke's tile, too";
}

TEST(FailedSaves, OfAnInterruptedJobAreAnErrorAndTheSlotBeforeStays) {
  const JobFolder folder(busy_log());
  const std::string plain = plain_report(folder, 1);
  const RenderJob job = often_saved(folder, 1);
  {
    const InterruptingControl interrupting(10);  // the 16th step: those before a touch are skipped
    FaultyDisk disk;
    disk.plan("fsync", 3, {EIO});  // two for the slot of step 10: its bytes, its name
    const Result<JobReport> done = render(job, interrupting.control);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::kIo);
    EXPECT_EQ(done.error().message, "interrupted, and not saved: " + folder.path("ck/2.slot.part") +
                                        ": Input/output error");
    EXPECT_EQ(slots_in(folder), 1u);
  }
  const JobReport report = rendered(job);
  ASSERT_TRUE(report.checkpoint->resumed_step);
  EXPECT_LT(*report.checkpoint->resumed_step, kSteps);
  EXPECT_EQ(comparable(report), plain);
}

TEST(FailedSaves, ASlotThatCannotBeReadGivesWayToTheOneBefore) {
  const JobFolder folder(busy_log());
  const std::string plain = plain_report(folder, 1);
  const RenderJob job = often_saved(folder, 1);
  test::interrupt(job, 25);
  Control control;
  std::vector<std::string> warnings;
  control.warn = [&](const std::string& text) { warnings.push_back(text); };
  FaultyDisk disk;
  disk.plan("pread", 1, {EIO});
  const Result<JobReport> done = render(job, control);
  ASSERT_TRUE(done) << done.error().message;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            folder.path("ck/4.slot") + ": Input/output error; the slot before it is used");
  EXPECT_EQ(comparable(*done), plain);
}

}  // namespace
}  // namespace pentimento
