#include "replay/estimate/memory_estimate.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdint>
#include <fstream>
#include <string>

#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;

constexpr std::int64_t kMB = 1'000'000;
// 400 x 300 cells of depth, two velocities, base, paper and stroke, three bands of reflectance, and
// two layers of two pigments: 13 planes of 4 bytes.
constexpr std::int64_t kCells = 120'000;
constexpr std::int64_t kState = kCells * 13 * 4;
constexpr std::int64_t kShader = 60 * kMB;  // Mesa and what it compiles

std::string log_on(int width, int height, const std::string& paper = "canvas") {
  return R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.4,)"
         R"("height":0.3},"grid":{"width":)" +
         std::to_string(width) + R"(,"height":)" + std::to_string(height) +
         R"(},"paper":{"texture":")" + paper +
         R"("},"palette":[{"name":"blue","color":"#1f2f8c"},{"name":"red","color":"#8c2f1f"}]})"
         "\n"
         R"({"t":0.1,"type":"touch","phase":"down","x":0.1,"y":0.1})"
         "\n"
         R"({"t":0.2,"type":"touch","phase":"up","x":0.3,"y":0.2})"
         "\n";
}

/// A job on 400 x 300 cells.
struct Estimated {
  JobFolder folder{log_on(400, 300)};
  RenderJob job;
  PaintSurvey survey;
  explicit Estimated(const std::vector<std::string>& outputs = {},
                     const std::vector<std::string>& stops = {})
      : job(folder.job(outputs, stops)) {}

  LogSession session() const { return std::move(*open_session(job, Control())); }
  JobNeeds needs() const { return job_needs(job, session(), survey); }
  std::int64_t memory() const { return needs().memory_bytes; }
};

std::int64_t memory_without_outputs(int detail = 1) {
  Estimated e;
  e.job.detail = detail;
  return e.memory();
}

/// Bytes of this process's writable memory, whether it was written to or not.
std::int64_t data_bytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    std::int64_t kibibytes = 0;
    if (word == "VmData:" && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

/// By the allocator, and as mappings beside it (core/base/plane_memory.h).
std::int64_t allocated() {
  const struct mallinfo2 info = ::mallinfo2();
  const auto of_allocator = static_cast<std::int64_t>(info.arena + info.hblkhd);
  return static_cast<std::int64_t>(info.uordblks + info.hblkhd) + data_bytes() - of_allocator;
}

/// False under a sanitizer, whose allocator keeps what others freed: what it maps says little.
bool allocator_tells() {
#if defined(PENTIMENTO_SANITIZED)
  return false;
#else
  const std::int64_t before = allocated();
  const Field<float> plane(1000, 1000);
  return allocated() - before >= 4 * kMB;
#endif
}

TEST(MemoryEstimate, OfASimulationIsWhatItAllocates) {
  if (!allocator_tells()) GTEST_SKIP() << "the allocator is another";
  const auto taken = [](int width, int height) {
    const JobFolder folder(log_on(width, height));
    const RenderJob job = folder.job({"a.h5"});
    LogSession session = std::move(*open_session(job, Control()));
    const Threads threads(1);
    const std::int64_t before = allocated();
    const auto simulation = std::move(*make_simulation(session, threads));
    simulation->set_color(0);
    simulation->set_gravity({1, 1, 9});
    simulation->begin_stroke(0, 1);
    Stamp stamp;
    stamp.x_m = stamp.y_m = 0.15;
    stamp.diameter_m = 0.1f;
    stamp.pressure = 1;
    simulation->stamp(0, stamp);
    for (int i = 0; i < 3; ++i) simulation->step();
    return allocated() - before;
  };
  const std::int64_t found = taken(800, 600) - taken(400, 300);
  Estimated large;
  large.folder.write("a.jsonl", log_on(800, 600));
  const std::int64_t foreseen = large.memory() - memory_without_outputs();
  // What the scheme needs beside the planes is foreseen as 24 planes. It allocates some 37, of
  // which not all are written: 0.74 of what is found.
  EXPECT_GT(static_cast<double>(foreseen), 0.65 * static_cast<double>(found));
  EXPECT_LT(static_cast<double>(foreseen), 1.3 * static_cast<double>(found));
}

TEST(MemoryEstimate, OfAProgrammeThatPaintsNothingIsItsCodeAndTheCanvas) {
  // 13 planes of the state and as many for a scheme and the brush as are foreseen: 24.
  const std::int64_t canvas = kCells * (13 + 24) * 4;
  EXPECT_EQ(memory_without_outputs(), 75 * kMB + canvas);
  // A detail canvas notes 150 bytes of each cell of its guide, and what its five wet planes held.
  EXPECT_EQ(memory_without_outputs(4), 75 * kMB + canvas + kCells * (150 + 5 * 4));
}

TEST(MemoryEstimate, ALargeCanvasTakesMemoryWhereThereIsPaint) {
  Estimated e;
  e.survey.reached_share = 0.25;
  e.survey.used_share = 0.0625;
  EXPECT_EQ(e.memory(), memory_without_outputs());  // 400 x 300 cells: large pages are filled
  constexpr std::int64_t kLarge = 2560 * 2048;
  e.folder.write("a.jsonl", log_on(2560, 2048));
  EXPECT_TRUE(memory_follows_paint(e.session()));
  // The paper's relief everywhere, twelve planes in a quarter, the scheme's in a quarter of it.
  constexpr std::int64_t kScheme = kLarge / 16 * 24 * 4;
  EXPECT_EQ(e.memory(), 75 * kMB + kLarge * 4 + kLarge / 4 * 12 * 4 + kScheme);
  e.folder.write("a.jsonl", log_on(2560, 2048, "smooth"));
  EXPECT_EQ(e.memory(), 75 * kMB + kLarge / 4 * 13 * 4 + kScheme);
  e.job.model = {{"scheme", "paper"}};
  EXPECT_FALSE(memory_follows_paint(e.session()));
  EXPECT_EQ(e.memory(), 75 * kMB + kLarge * (13 + 24) * 4);
}

TEST(MemoryEstimate, APosterOfALargeCanvasTakesMemoryWhereThereIsPaint) {
  constexpr std::int64_t kLarge = 2560 * 2048;
  Estimated e;
  e.survey.reached_share = e.survey.used_share = 0.25;
  e.folder.write("a.jsonl", log_on(2560, 2048, "smooth"));
  const std::int64_t at_one = e.memory();
  e.job.detail = 8;
  // 150 bytes of a painted cell and what its five wet planes held, two of a bare one.
  const std::int64_t followed = kLarge / 4 * (150 + 5 * 4) + kLarge / 4 * 3 * 2;
  EXPECT_EQ(e.memory(), at_one + followed);
  // A dump: the guide once more, and for each cell a word and a bit for each of its 64 finer cells,
  // twice; chunks at work.
  Estimated dump({"a.h5"});
  dump.survey.reached_share = dump.survey.used_share = 0.25;
  dump.folder.write("a.jsonl", log_on(2560, 2048, "smooth"));
  EXPECT_EQ(dump.memory(), 75 * kMB + kLarge / 4 * (3 * 13 + 24) * 4);  // a copy, and the file
  dump.job.detail = 8;
  EXPECT_EQ(dump.memory(),
            at_one + followed + kLarge / 4 * 13 * 4 + 2 * kLarge * (1 + 2) * 4 + 64 * kMB);
}

TEST(MemoryEstimate, ADumpIsHeldTwiceAndOfAFinerCanvasOnlyTheGuideIs) {
  Estimated dump({"a.h5"});
  EXPECT_EQ(dump.memory(), memory_without_outputs() + 2 * kState);
  dump.job.detail = 4;
  // Of each cell a word, and one for its 16 finer cells, twice; and chunks at work.
  const std::int64_t fine = memory_without_outputs(4) + kState + kCells * 2 * 2 * 4 + 64 * kMB;
  EXPECT_EQ(dump.memory(), fine);
  dump.survey.detail_bytes = 3e8;
  EXPECT_EQ(dump.memory(), fine + 300 * kMB);
}

TEST(MemoryEstimate, APictureIsShadedInTiles) {
  Estimated picture({"a.png"});
  picture.job.picture.tile = 64;
  picture.job.threads = 1;
  // 80 bytes of a tile's cell and of six around it; two targets of 16 bytes a pixel; strips of 64
  // rows in float and on their way into the file.
  constexpr std::int64_t kTargets = 64 * 64 * 16 * 2;
  const std::int64_t shading = kShader + 70 * 70 * 80 + kTargets + 400 * 64 * 3 * 7;
  EXPECT_EQ(picture.memory(), memory_without_outputs() + shading);
  // Cells are drawn one by one where several that are no whole number lie on a pixel.
  picture.job.size.width = 160;
  EXPECT_EQ(picture.memory(), memory_without_outputs() + shading);
  picture.job.size.width = 100;  // four cells a pixel, along either side
  const std::int64_t reduced = kShader + 262 * 262 * 80 + kTargets + 100 * 64 * 3 * 7;
  EXPECT_EQ(picture.memory(), memory_without_outputs() + reduced);
  // Of several threads one writes a strip while the others draw the next.
  picture.job.threads = 2;
  EXPECT_EQ(picture.memory(), memory_without_outputs() + reduced + 100 * 64 * 3 * 4);
  // Amounts of the channels are uploaded where they are asked for: a texture for four of them, and
  // two planes more of an EXR for two pigments.
  Estimated drawn({"a.exr"});
  drawn.job.picture.tile = 64;
  drawn.job.threads = 1;
  const std::int64_t plain = drawn.memory();
  drawn.job.picture.aovs = {"pigment"};
  EXPECT_EQ(drawn.memory() - plain, 70 * 70 * 16 + 400 * 64 * 2 * 7);
  // A dump after it: Mesa stays.
  picture.job.picture.outputs.push_back(picture.folder.path("a.h5"));
  picture.job.picture.tile = 16;
  EXPECT_EQ(picture.memory(), memory_without_outputs() + 2 * kState + kShader);
}

TEST(MemoryEstimate, DiskIsThatOfPicturesThatDoNotCompress) {
  const auto disk = [](const std::vector<std::string>& outputs, const auto& choose) {
    Estimated e(outputs);
    choose(e.job);
    return e.needs().disk_bytes;
  };
  const auto plain = [](RenderJob&) {};
  EXPECT_EQ(disk({"a.png"}, plain), kCells * 3);
  EXPECT_EQ(disk({"a.png"}, [](RenderJob& j) { j.picture.bit_depth = 16; }), kCells * 6);
  EXPECT_EQ(disk({"a.exr"}, plain), kCells * 6);
  EXPECT_EQ(disk({"a.exr"}, [](RenderJob& j) { j.picture.full_float = true; }), kCells * 12);
  EXPECT_EQ(disk({"a.exr"}, [](RenderJob& j) { j.picture.aovs = {"normal"}; }), kCells * 12);
  EXPECT_EQ(disk({"a.png"}, [](RenderJob& j) { j.picture.crop = {10, 10, 30, 20}; }), 30 * 20 * 3);
  EXPECT_EQ(disk({"a.h5"}, plain), kState);
  EXPECT_EQ(disk({"a.h5"}, [](RenderJob& j) { j.detail = 4; }), 17 * kState);  // with the guide
  EXPECT_EQ(disk({"a.png", "a.h5"}, plain), kCells * 3 + kState);
  EXPECT_EQ(Estimated({"%.png"}, {"0.1", "step:8"}).needs().disk_bytes, 2 * kCells * 3);
}

TEST(MemoryEstimate, AScratchFileTakesWhatTheLimitHasNoRoomFor) {
  Estimated e;
  e.job.detail = 4;
  e.survey.detail_bytes = 1e9;
  const std::int64_t others = memory_without_outputs(4);
  EXPECT_EQ(e.memory(), others + 1000 * kMB);
  EXPECT_EQ(e.needs().scratch_bytes, 0);
  e.job.scratch = "/";
  e.job.max_memory = others + 400 * kMB;
  EXPECT_EQ(e.memory(), others + 400 * kMB);
  EXPECT_EQ(e.needs().scratch_bytes, 1000 * kMB);
  EXPECT_EQ(e.needs().resident_bytes, 400 * kMB);
  e.job.max_memory = 100 * kMB;  // tiles at work are always held
  EXPECT_EQ(e.memory(), others + 128 * kMB);
  e.job.max_memory = others + 5000 * kMB;
  EXPECT_EQ(e.memory(), others + 1000 * kMB);
}

TEST(MemoryEstimate, AJobFitsExactlyWhereItIsToldThatItFits) {
  Estimated e({"a.h5"});
  e.job.max_memory = e.memory();
  EXPECT_TRUE(check_memory(e.job, e.session(), e.survey));
  e.job.max_memory = e.memory() - 1;
  const auto refused = check_memory(e.job, e.session(), e.survey);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kLimit);
  const std::string& message = refused.error().message;
  const std::string option = "--memory-limit ";
  const std::size_t at = message.find(option);
  ASSERT_NE(at, std::string::npos) << message;
  e.job.max_memory = std::stoll(message.substr(at + option.size())) << 20;  // M as in the option
  EXPECT_TRUE(check_memory(e.job, e.session(), e.survey)) << message;
}

TEST(MemoryEstimate, OnlyWhatHelpsIsOffered) {
  const auto offered = [](const auto& choose) {
    Estimated e;
    e.job.detail = 8;
    e.survey.detail_bytes = 1e9;
    e.job.max_memory = 500 * kMB;
    choose(e.job);
    const auto refused = check_memory(e.job, e.session(), e.survey);
    return refused ? std::string() : refused.error().message;
  };
  const std::string all = offered([](RenderJob&) {});
  EXPECT_NE(all.find("3200 x 2400 cells"), std::string::npos) << all;
  EXPECT_NE(all.find("the limit is 476 MiB"), std::string::npos) << all;
  EXPECT_NE(all.find(", --scratch DIR"), std::string::npos) << all;
  EXPECT_NE(all.find(", --detail 4"), std::string::npos) << all;
  const std::string tight = offered([](RenderJob& j) { j.max_memory = 200 * kMB; });
  EXPECT_EQ(tight.find("--scratch"), std::string::npos) << tight;
}

TEST(MemoryEstimate, MoreThanTheMachineHasIsNeverOffered) {
  Estimated e;
  e.job.detail = 8;
  e.survey.detail_bytes = 1e17;  // no machine has as much
  const auto refused = check_memory(e.job, e.session(), e.survey);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message.find("--memory-limit"), std::string::npos)
      << refused.error().message;
}

}  // namespace
}  // namespace pentimento
