#include "replay/commands/easel.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/brush/builtin_brushes.h"
#include "formats/hdf5/state_dump.h"
#include "formats/image/read_image.h"
#include "formats/io/provenance.h"
#include "formats/log/write/writer.h"
#include "replay/commands/render.h"

namespace pentimento {
namespace {

/// 64 x 48 cells of 0.4 x 0.3 m, two pigments.
log::Header small_canvas() {
  log::Header header;
  header.canvas_width_m = 0.4;
  header.canvas_height_m = 0.3;
  header.grid_width = 64;
  header.grid_height = 48;
  for (const char* name : {"Prussian Blue", "Titanium White"}) {
    header.palette.emplace_back().name = name;
    header.palette.back().library = true;
  }
  return header;
}

BrushSettings sliders(float size_m) {
  BrushSettings settings;
  settings.size_m = size_m;
  settings.medium_frac = 0.8f;
  return settings;
}

std::unique_ptr<Easel> easel_of(const log::Header& header) {
  Result<std::unique_ptr<Easel>> easel = Easel::open(header, 1);
  EXPECT_TRUE(easel.ok());
  return std::move(*easel);
}

std::string hash_of(Easel& easel) {
  return state_sha256(easel.simulation().state());
}

/// The log of SameStrokes below, written by hand. 0.3 m at 0.5 m/s take 0.6 s.
std::string write_log(const std::filesystem::path& path) {
  auto writer = std::move(*log::Writer::create(path, log::Compression::kNone));
  writer->write(small_canvas());
  const auto add = [&](std::int64_t time_us, log::Action action) {
    writer->write(log::Event{time_us, 0, std::move(action), {}});
  };
  const auto touch = [&](std::int64_t time_us, log::TouchPhase phase, double x, double y) {
    log::Touch sample;
    sample.phase = phase;
    sample.x_m = x;
    sample.y_m = y;
    sample.pressure = 0.75;
    add(time_us, sample);
  };
  add(0, log::BrushChange{"flat"});
  add(0, log::Slider{"size", 0.05});
  add(0, log::Slider{"medium", 0.8});
  touch(0, log::TouchPhase::kDown, 0.05, 0.1);
  touch(300000, log::TouchPhase::kMove, 0.2, 0.1);
  touch(600000, log::TouchPhase::kUp, 0.35, 0.1);
  add(1000000, log::Dry{});
  add(1000000, log::BrushChange{"knife"});
  add(1000000, log::Slider{"size", 0.08});
  add(1000000, log::Color{"Titanium White", {}, {}});
  touch(1000000, log::TouchPhase::kDown, 0.2, 0.05);
  touch(1400000, log::TouchPhase::kUp, 0.2, 0.25);
  add(2000000, log::Mark{"end"});
  EXPECT_TRUE(writer->finish().ok());
  return path.string();
}

TEST(Easel, SameStrokesAsALog_EndInTheSameState) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "easel_test";
  std::filesystem::create_directories(folder);
  RenderJob job;
  job.log = write_log(folder / "strokes.jsonl");
  job.picture.outputs = {(folder / "strokes.png").string()};
  job.threads = 2;
  const Result<JobReport> report = render(job, {});
  ASSERT_TRUE(report.ok());

  const std::unique_ptr<Easel> easel = easel_of(small_canvas());
  easel->take_brush("flat", sliders(0.05f));
  easel->stroke({{0.05, 0.1, 0.75f}, {0.2, 0.1, 0.75f}, {0.35, 0.1, 0.75f}});
  easel->wait(0.4);
  easel->dry();
  easel->take_brush("knife", sliders(0.08f));
  easel->take_color("Titanium White");
  easel->stroke({{0.2, 0.05, 0.75f}, {0.2, 0.25, 0.75f}});
  easel->wait(0.63);  // until 2.03 s: a replay does the whole step in which the log ends
  EXPECT_EQ(easel->simulation().state().step, 91);  // 2 s of 45 steps, and that one
  EXPECT_EQ(hash_of(*easel), report->state_sha256);
  std::filesystem::remove_all(folder);
}

std::string hash_painted_by_a_caller_who_rounds(int direction) {
  std::fenv_t before;
  std::fegetenv(&before);
  std::fesetround(direction);
  const std::unique_ptr<Easel> easel = easel_of(small_canvas());
  easel->take_brush("flat", sliders(0.05f));
  easel->stroke({{0.05, 0.1, 0.75f}, {0.2, 0.13, 0.75f}, {0.35, 0.1, 0.75f}});
  easel->wait(0.4);
  EXPECT_EQ(std::fegetround(), direction);  // it has its own back
  std::fesetenv(&before);
  return hash_of(*easel);
}

TEST(Easel, TheCallersRoundingChangesNothing) {
  const std::string hash = hash_painted_by_a_caller_who_rounds(FE_TONEAREST);
  EXPECT_EQ(hash_painted_by_a_caller_who_rounds(FE_UPWARD), hash);
  EXPECT_EQ(hash_painted_by_a_caller_who_rounds(FE_TOWARDZERO), hash);
}

TEST(Easel, AStrokeTakesTheTimeOfTheHand) {
  const std::unique_ptr<Easel> easel = easel_of(small_canvas());
  easel->stroke({{0.05, 0.1}, {0.35, 0.1}}, 0.1);
  EXPECT_EQ(easel->simulation().state().step, 135);  // 3 s of 45 steps
}

TEST(Easel, APictureHasTheShapeOfTheCanvas_AndThePaint) {
  const std::string path = std::filesystem::temp_directory_path() / "easel_picture.png";
  const std::unique_ptr<Easel> easel = easel_of(small_canvas());
  easel->take_brush("flat", sliders(0.1f));
  easel->stroke({{0.05, 0.15}, {0.35, 0.15}});
  ASSERT_TRUE(easel->write_png(path, 128).ok());
  const std::array<Field<float>, 3> rgb = std::move(*read_rgb(path));
  EXPECT_EQ(rgb[0].width(), 128);
  EXPECT_EQ(rgb[0].height(), 96);
  // Prussian blue on a white canvas: darker than half of it, and blue above red.
  EXPECT_LT(rgb[0](64, 48), rgb[0](64, 5) / 2);
  EXPECT_GT(rgb[2](64, 48), rgb[0](64, 48));
  EXPECT_EQ(provenance_value(describe_file(path)->provenance, "state_sha256"), hash_of(*easel));
  std::filesystem::remove(path);
}

TEST(Easel, APictureChangesNothing) {
  const std::string path = std::filesystem::temp_directory_path() / "easel_between.png";
  const std::unique_ptr<Easel> shown = easel_of(small_canvas()), hidden = easel_of(small_canvas());
  for (Easel* easel : {shown.get(), hidden.get()}) {
    easel->stroke({{0.05, 0.1}, {0.35, 0.12}});
    if (easel == shown.get()) {
      ASSERT_TRUE(easel->write_png(path).ok());
    }
    easel->stroke({{0.05, 0.12}, {0.35, 0.1}});
  }
  EXPECT_EQ(hash_of(*shown), hash_of(*hidden));
  std::filesystem::remove(path);
}

TEST(Easel, AWrongNameIsSaidWhereThePictureIsWritten) {
  const std::string path = std::filesystem::temp_directory_path() / "easel_unpainted.png";
  for (const bool brush : {true, false}) {
    const std::unique_ptr<Easel> easel = easel_of(small_canvas());
    if (brush) easel->take_brush("broom", {});
    if (!brush) easel->take_color("mauve");
    easel->take_color("magenta");  // the first one counts
    easel->stroke({{0.05, 0.1}, {0.35, 0.1}});
    const Result<Published> picture = easel->write_png(path);
    ASSERT_FALSE(picture.ok());
    EXPECT_NE(picture.error().message.find(brush ? "broom" : "mauve"), std::string::npos);
    EXPECT_EQ(easel->simulation().account().deposited.medium_m3, 0);
    EXPECT_FALSE(std::filesystem::exists(path));
  }
}

TEST(Easel, AnUnknownPigmentOpensNoCanvas) {
  log::Header header = small_canvas();
  header.palette.back().name = "unobtainium";
  EXPECT_EQ(Easel::open(header, 1).error().code, ErrorCode::kBadInput);
}

/// Half a painting: wet paint that runs, a brush that has picked up the other colour.
std::unique_ptr<Easel> half_painted() {
  std::unique_ptr<Easel> easel = easel_of(small_canvas());
  easel->take_brush("flat", sliders(0.05f));
  easel->set_gravity(0, 9.81, 1);
  easel->stroke({{0.05, 0.1}, {0.2, 0.1}, {0.35, 0.12}});
  easel->take_color("Titanium White");
  easel->stroke({{0.2, 0.05}, {0.2, 0.25}});
  easel->wait(0.3);
  return easel;
}

void finish(Easel& easel) {
  easel.stroke({{0.3, 0.05}, {0.1, 0.25}});
  easel.wait(0.5);
  easel.dry();
  easel.stroke({{0.1, 0.2}, {0.3, 0.2}});
  easel.wait(1);
}

TEST(EaselFork, GoesOnBitForBitAndAlone) {
  const std::unique_ptr<Easel> easel = half_painted();
  const std::string before = hash_of(*easel);
  const std::unique_ptr<Easel> fork = easel->fork();
  EXPECT_EQ(hash_of(*fork), before);
  finish(*fork);
  EXPECT_EQ(hash_of(*easel), before) << "what the fork paints is not on this canvas";
  const std::string finished = hash_of(*fork);
  EXPECT_NE(finished, before);
  finish(*easel);
  EXPECT_EQ(hash_of(*easel), finished);
  EXPECT_EQ(easel->simulation().account().deposited.medium_m3,
            fork->simulation().account().deposited.medium_m3);
  // Between the last stamp of a stroke and the step that feels it.
  const std::unique_ptr<Easel> one = half_painted();
  one->stroke({{0.1, 0.1}, {0.3, 0.2}});
  const std::unique_ptr<Easel> other = one->fork();
  one->wait(0.2);
  other->wait(0.2);
  EXPECT_EQ(hash_of(*one), hash_of(*other));
  // Of a fork, when the one that it came from is gone.
  std::unique_ptr<Easel> gone = half_painted();
  const std::unique_ptr<Easel> last = gone->fork();
  gone.reset();
  finish(*last);
  EXPECT_EQ(hash_of(*last), finished);
}

TEST(Easel, StepsAreTheTimeThatTheyTake) {
  const std::unique_ptr<Easel> a = half_painted(), b = half_painted();
  a->step(45);
  b->wait(1);
  EXPECT_EQ(a->simulation().state().step, b->simulation().state().step);
  finish(*a);
  finish(*b);
  EXPECT_EQ(hash_of(*a), hash_of(*b));
}

TEST(Easel, ThePictureInMemoryIsThatOfTheFile) {
  const std::unique_ptr<Easel> easel = half_painted();
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "easel_memory.png";
  ASSERT_TRUE(easel->write_png(file.string(), 32));
  const Result<EaselPicture> picture = easel->picture(32);
  ASSERT_TRUE(picture) << picture.error().message;
  ImageReadOptions raw;
  raw.meaning = SampleMeaning::kRaw;
  const Result<Image> image = read_image(file.string(), raw);
  ASSERT_TRUE(image);
  ASSERT_EQ(picture->width, image->width);
  ASSERT_EQ(picture->height, image->height);
  for (int y = 0; y < image->height; ++y)
    for (int x = 0; x < image->width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = 3 * static_cast<std::size_t>(y * image->width + x) + c;
        ASSERT_EQ(picture->rgb[at], std::lround(255 * image->plane[c](x, y)));
      }
  std::filesystem::remove(file);
}

TEST(Easel, EaselsThatShareTipsDrawEachOnce) {
  const auto tips = std::make_shared<TipRack>();
  const auto paint = [&] {
    auto easel = std::move(*Easel::open(small_canvas(), 1, tips));
    easel->stroke({{0.1, 0.1, 0.8f}, {0.2, 0.1, 0.8f}});
    return easel;
  };
  const auto first = paint(), second = paint();
  EXPECT_EQ(hash_of(*first), hash_of(*second));
  // The rack, the two brushes, and this pointer.
  EXPECT_EQ(tips->find(*builtin_brush("round")).use_count(), 4);
  const auto alone = easel_of(small_canvas());
  alone->stroke({{0.1, 0.1, 0.8f}, {0.2, 0.1, 0.8f}});
  EXPECT_EQ(hash_of(*alone), hash_of(*first));
}

}  // namespace
}  // namespace pentimento
