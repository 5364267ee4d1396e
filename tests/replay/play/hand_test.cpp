#include "replay/play/hand.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// Writes down what it is told.
class NotingPainter : public Painter {
 public:
  std::vector<std::string> told;

  void set_settings(const BrushSettings& settings) override {
    note(fmt::format("settings, pickup {}", settings.pickup));
  }
  void set_brush(const BrushDefinition& brush) override { note("brush " + brush.name); }
  void set_color(int pigment) override { note(fmt::format("color {}", pigment)); }
  void set_color(int pigment, float from, float to) override {
    note(fmt::format("color {} from {} to {}", pigment, from, to));
  }
  void begin_stroke(int touch_id, std::uint32_t stroke_id) override {
    note(fmt::format("begin {} of touch {}", stroke_id, touch_id));
  }
  void expect(int touch_id, const Stamp& next) override {
    note(fmt::format("expect {} of {} m", touch_id, next.diameter_m));
  }
  void stamp(int touch_id, const Stamp&) override { note(fmt::format("stamp {}", touch_id)); }
  void end_stroke(int touch_id) override { note(fmt::format("end {}", touch_id)); }
  void set_gravity(Vec3f g) override { note(fmt::format("gravity {} {} {}", g.x, g.y, g.z)); }
  void set_model(const Model& model) override {
    model_ = model;
    note(fmt::format("model, brush_push {}", model.brush_push));
  }
  void dry() override { note("dry"); }
  void clear() override { note("clear"); }
  void load(const std::vector<Field<float>>& bands) override {
    note(fmt::format("load {} x {} x {}", bands.size(), bands[0].width(), bands[0].height()));
  }
  const Model& model() const override { return model_; }
  const CanvasGeometry& geometry() const override { return grid_; }

 private:
  void note(std::string what) { told.push_back(std::move(what)); }
  Model model_;
  CanvasGeometry grid_ = {8, 6, 0.4, 0.3};
};

using Told = std::vector<std::string>;

Palette blue_and_red() {
  std::vector<log::PigmentSpec> specs(2);
  specs[0].name = "blue";
  specs[0].color = log::Rgb{0.1, 0.1, 0.6};
  specs[1].name = "red";
  specs[1].color = log::Rgb{0.6, 0.1, 0.1};
  return *Palette::make(specs);
}

/// A hand and what it told its painter since it took the brush up.
class HandTest : public testing::Test {
 protected:
  Told after(const std::vector<Cue>& cues, std::optional<Vec3f> gravity = {}) {
    NotingPainter painter;
    Hand hand(painter, {brushes_, palette_, 1, files_, gravity});
    first_ = std::exchange(painter.told, {});
    for (const Cue& cue : cues) {
      const Result<void> applied = hand.apply(cue);
      EXPECT_TRUE(applied.ok());
    }
    return painter.told;
  }
  static Cue cue(decltype(Cue::what) what) { return {0, 1, 0, std::move(what)}; }

  const test::Scratch scratch_;
  LogFiles files_{scratch_.path("a.jsonl"), false};
  BrushTable brushes_;
  Palette palette_ = blue_and_red();
  Told first_;
};

TEST_F(HandTest, TakesTheFirstBrushAndColourUpOnATabletThatLiesFaceUp) {
  EXPECT_EQ(after({}), Told{});
  EXPECT_EQ(first_, (Told{"gravity 0 -0 9.81", "brush round", "settings, pickup 0.3", "color 1"}));
}

TEST_F(HandTest, TellsStrokesTouchByTouch) {
  EXPECT_EQ(after({cue(StrokeBegin{0, 7}), cue(StrokeBegin{1, 8}), cue(StrokeStamp{1, Stamp()}),
                   cue(StrokeEnd{0})}),
            (Told{"begin 7 of touch 0", "begin 8 of touch 1", "stamp 1", "end 0"}));
}

TEST_F(HandTest, TellsWhichStampProbablyFollows) {
  NotingPainter painter;
  Hand hand(painter, {brushes_, palette_, 1, files_, {}});
  painter.told.clear();
  Stamp wide;
  wide.diameter_m = 0.5f;
  const Cue stamp = cue(StrokeStamp{1, Stamp()}), next = cue(StrokeStamp{2, wide});
  const Cue end = cue(StrokeEnd{1});
  EXPECT_TRUE(hand.apply(stamp, &next).ok());
  EXPECT_TRUE(hand.apply(stamp, &end).ok());
  EXPECT_TRUE(hand.apply(end, &next).ok());
  EXPECT_EQ(painter.told, (Told{"expect 2 of 0.5 m", "stamp 1", "stamp 1", "end 1"}));
}

TEST_F(HandTest, TellsWhatTheLogDoes) {
  EXPECT_EQ(after({cue(log::Color{"blue", {}, {}}), cue(log::Color{"red", {}, {{0.5, 1}}})}),
            (Told{"color 0", "color 1 from 0.5 to 1"}));
  EXPECT_EQ(after({cue(log::BrushChange{"flat"}), cue(log::Slider{"pickup", 0.5}),
                   cue(log::Slider{"brush_push", 0.25}), cue(log::Dry{}), cue(log::Clear{})}),
            (Told{"brush flat", "settings, pickup 0.5", "model, brush_push 0.25", "dry", "clear"}));
}

TEST_F(HandTest, TurnsGravityFromTheSensorsFrameIntoTheCanvass) {
  EXPECT_EQ(after({cue(log::Gravity{1, 2, 3})}), Told{"gravity 1 -2 3"});
}

TEST_F(HandTest, AGivenGravityStandsInPlaceOfTheLogs) {
  EXPECT_EQ(after({cue(log::Gravity{1, 2, 3})}, Vec3f{0, 5, 8}), Told{});
  EXPECT_EQ(first_.front(), "gravity 0 5 8");
}

}  // namespace
}  // namespace pentimento
