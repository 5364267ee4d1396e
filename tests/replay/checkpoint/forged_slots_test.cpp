// Slots whose checksums are right and whose content is not: somebody made them. They are refused,
// and neither end the process nor write a file that the job does not name.

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "formats/checkpoint/memory_part.h"
#include "replay/checkpoint/slot.h"
#include "tests/replay/checkpoint/interrupted_job.h"
#include "tests/replay/checkpoint/two_slots.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using checkpoint::ArchiveReader;
using checkpoint::ArchiveWriter;
using checkpoint::SlotParts;
using test::busy_log;
using test::checkpointed;
using test::interrupt;
using test::JobFolder;
using test::refusal;
using test::survive;
using test::Survived;
using test::TwoSlots;

/// Writes a slot anew with other parts, and with the checksums that belong to them.
void forge(const std::string& slot, const std::function<void(SlotParts&)>& change) {
  Result<SlotParts> parts = checkpoint::read_slot(slot);
  ASSERT_TRUE(parts);
  change(*parts);
  const auto file = checkpoint::SlotWriter::create(slot);
  ASSERT_TRUE(file);
  for (const auto& [name, bytes] : *parts) (*file)->add(name, bytes);
  ASSERT_TRUE((*file)->finish());
}

void forge_memory(const std::string& slot, const std::function<void(SimulationMemory&)>& change) {
  forge(slot, [&](SlotParts& parts) {
    ArchiveReader from(parts["memory"]);
    SimulationMemory memory = checkpoint::take_memory(from);
    change(memory);
    ArchiveWriter to;
    checkpoint::put_memory(memory, to);
    parts["memory"] = to.bytes();
  });
}

/// Number `index` of the part `position`: cues, steps computed, step, stops done.
void forge_position(const std::string& slot, std::size_t index, std::int64_t value) {
  forge(slot, [&](SlotParts& parts) {
    ArchiveWriter number;
    number.i64(value);
    parts["position"].replace(index * sizeof(value), sizeof(value), number.bytes());
  });
}

void forge_outputs(const std::string& slot, const std::function<void(KeptOutput&)>& change) {
  forge(slot, [&](SlotParts& parts) {
    ArchiveReader from(parts["outputs"]);
    std::vector<KeptOutput> outputs = take_outputs(from);
    ASSERT_FALSE(outputs.empty());
    change(outputs[0]);
    ArchiveWriter to;
    put_outputs(outputs, to);
    parts["outputs"] = to.bytes();
  });
}

TEST(ForgedSlots, MemoryThatDoesNotFitGivesWayToTheSlotBefore) {
  const std::function<void(SimulationMemory&)> forgeries[] = {
      [](SimulationMemory& memory) { memory.touches.at(0).reservoir.texels.resize(4); },
      [](SimulationMemory& memory) { memory.touches.at(0).reservoir.texels.push_back(0); },
      [](SimulationMemory& memory) { memory.account.dried.channel.clear(); },
      [](SimulationMemory& memory) { memory.scheme.pop_back(); },
      [](SimulationMemory& memory) { memory.scheme.at(1) = -1; },
      [](SimulationMemory& memory) { memory.touches.push_back(memory.touches.front()); },
  };
  for (const auto& forgery : forgeries) {
    const TwoSlots two;
    ASSERT_EQ(two.slots().size(), 2u);
    forge_memory(two.slots().back(), forgery);
    const Survived survived = survive(two.job, 1000);
    ASSERT_TRUE(survived.report) << survived.report.error().message;
    EXPECT_TRUE(survived.report->checkpoint->older_slot);
    ASSERT_EQ(survived.warnings.size(), 1u);
    EXPECT_NE(survived.warnings[0].find("part \"memory\""), std::string::npos)
        << survived.warnings[0];
  }
}

TEST(ForgedSlots, IfNoMemoryFitsTheJobIsRefusedAsBadInput) {
  const TwoSlots two;
  for (const std::string& slot : two.slots())
    forge_memory(slot, [](SimulationMemory& m) { m.touches.at(0).reservoir.texels.resize(4); });
  EXPECT_EQ(refusal(two.job).code, ErrorCode::kBadInput);
}

TEST(ForgedSlots, TouchesThatAreNotThoseOfTheLogAreRefused) {
  for (const bool down : {true, false}) {
    const JobFolder folder(busy_log());
    const RenderJob job = checkpointed(folder.job({"a.h5"}), folder);
    interrupt(job, down ? 15 : 5);  // when none is down, and when two are
    forge_memory(folder.path("ck/1.slot"), [&](SimulationMemory& memory) {
      ASSERT_EQ(memory.touches.size(), 2u);
      for (TouchMemory& touch : memory.touches) touch.down = down;
    });
    const Error error = refusal(job);
    EXPECT_EQ(error.code, ErrorCode::kBadInput);
    EXPECT_NE(error.message.find("its touches"), std::string::npos) << error.message;
  }
}

TEST(ForgedSlots, APlaceThatTheLogDoesNotHaveIsRefused) {
  const TwoSlots two;
  forge_position(two.slots().back(), 0, 1'000'000'000);
  const Error error = refusal(two.job);
  EXPECT_EQ(error.code, ErrorCode::kBadInput);
  EXPECT_NE(error.message.find("the log ends before"), std::string::npos) << error.message;
}

TEST(ForgedSlots, StopsThatTheJobDoesNotHaveAreNoneThatAreDone) {
  const TwoSlots two;
  for (const std::string& slot : two.slots()) forge_position(slot, 3, 1);
  const Error error = refusal(two.job);
  EXPECT_EQ(error.code, ErrorCode::kBadInput);
  EXPECT_NE(error.message.find("more stops"), std::string::npos) << error.message;
}

TEST(ForgedSlots, CannotHaveTheJobWriteElsewhere) {
  const JobFolder folder(busy_log());
  const RenderJob job = checkpointed(folder.job({"f-%.h5"}, {"0.3", "0.9"}), folder);
  interrupt(job, 25);
  const std::string slot = folder.path("ck/1.slot");
  ASSERT_TRUE(std::filesystem::exists(slot));
  const std::string precious = folder.path("precious.h5");
  folder.write("precious.h5", "not to be lost");
  forge_outputs(slot, [&](KeptOutput& output) { output.file.file = precious; });
  const Error error = refusal(job);
  EXPECT_EQ(error.code, ErrorCode::kBadInput);
  EXPECT_NE(error.message.find("no output of this job"), std::string::npos) << error.message;
  EXPECT_EQ(test::slurp(precious), "not to be lost");
}

TEST(ForgedSlots, PlannedNamesAreThoseOfTheJobAndOfPlanesBesideItsPictures) {
  const std::vector<std::vector<PlannedOutput>> planned = {
      {{"a-%.png", "out/a-1.png", OutputKind::kPng}, {"a-%.h5", "out/a-1.h5", OutputKind::kState}}};
  for (const char* name : {"out/a-1.png", "out/a-1.depth.png", "out/a-1.h5"})
    EXPECT_TRUE(is_planned(name, planned)) << name;
  for (const char* name : {"out/b.png", "a-1.png", "out/a-1.x/../../b.png", "out/a-1.depth.h5", ""})
    EXPECT_FALSE(is_planned(name, planned)) << name;
}

}  // namespace
}  // namespace pentimento
