#include "replay/film/film_planner.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

log::Event touch(double time_s, log::TouchPhase phase) {
  log::Event event;
  event.time_us = static_cast<std::int64_t>(time_s * 1e6 + 0.5);
  log::Touch what;
  what.phase = phase;
  event.action = what;
  return event;
}

/// Two strokes of a second, at 1 s and after a pause of 7 s, 10 steps a second; 10 s in all. The
/// second one has four times the samples of the first.
FilmPlanner two_strokes() {
  FilmPlanner planner(10, false);
  for (const auto& [begin, samples] : {std::pair(1.0, 5), std::pair(9.0, 20)}) {
    planner.add(touch(begin, log::TouchPhase::kDown));
    for (int i = 1; i < samples - 1; ++i)
      planner.add(touch(begin + 0.9 * i / (samples - 1), log::TouchPhase::kMove));
    planner.add(touch(begin + 0.9, log::TouchPhase::kUp));
  }
  return planner;
}

constexpr std::int_fast64_t kSteps = 100;
using Steps = std::vector<std::int64_t>;

FilmChoice of(FilmAxis along, int frames) {
  FilmChoice choice;
  choice.along = along;
  choice.frames = frames;
  return choice;
}

TEST(FilmPlanner, AlongTheClockFramesAreEven) {
  EXPECT_EQ(two_strokes().frames(of(FilmAxis::kWall, 4), kSteps), (Steps{25, 50, 75, 100}));
}

TEST(FilmPlanner, AlongThePaintingPausesAreCut) {
  // Half a second before each stroke and a second for each: 30 steps of the axis.
  const Steps frames = two_strokes().frames(of(FilmAxis::kPainting, 30), kSteps);
  EXPECT_EQ(frames[4], 10) << "the first pause takes 5 of 10 steps";
  EXPECT_EQ(frames[14], 20) << "the end of the first stroke";
  EXPECT_EQ(frames[19], 90) << "the second pause takes 5 of 70 steps";
  EXPECT_EQ(frames[20], 91);
  EXPECT_EQ(frames[29], 100);
}

TEST(FilmPlanner, PausesAreCutToWhatIsAsked) {
  FilmChoice choice = of(FilmAxis::kWall, 40);
  choice.idle_cut_s = 1;
  // 10 + 10 + 10 + 10 steps.
  const Steps frames = two_strokes().frames(choice, kSteps);
  EXPECT_EQ(frames[9], 10);
  EXPECT_EQ(frames[19], 20);
  EXPECT_EQ(frames[29], 90);
  choice.idle_cut_s = 0;
  choice.frames = 20;
  EXPECT_EQ(two_strokes().frames(choice, kSteps)[0], 11) << "nothing but strokes";
}

TEST(FilmPlanner, AlongTheEventsEachFrameHasAsMany) {
  // 25 samples: five in each frame, and the first stroke is the first frame.
  const Steps frames = two_strokes().frames(of(FilmAxis::kEvents, 5), kSteps);
  EXPECT_EQ(frames[0], 20);
  EXPECT_GT(frames[1], 90);
  EXPECT_EQ(frames[4], 100);
}

TEST(FilmPlanner, TheLengthGivesTheFrames) {
  FilmChoice choice;
  choice.length_s = 4;
  EXPECT_EQ(two_strokes().frames(choice, kSteps).size(), 100U) << "4 s of 25";
  choice.frames_per_second = 50;
  EXPECT_EQ(two_strokes().frames(choice, kSteps).size(), 200U);
  EXPECT_EQ(two_strokes().frames({}, kSteps).size(), 75U) << "3 s of painting, as long as it is";
  FilmChoice wall = of(FilmAxis::kWall, 1);
  wall.frames.reset();
  EXPECT_EQ(two_strokes().frames(wall, 10000).size(), 500U) << "no longer than 20 s";
}

TEST(FilmPlanner, FramesNeverGoBackAndEndAtTheEnd) {
  for (const FilmAxis axis : {FilmAxis::kPainting, FilmAxis::kEvents, FilmAxis::kWall}) {
    for (const int count : {1, 2, 7, 333}) {
      const Steps frames = two_strokes().frames(of(axis, count), kSteps);
      ASSERT_EQ(frames.size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end()));
      EXPECT_GE(frames.front(), 0);
      EXPECT_EQ(frames.back(), kSteps);
    }
  }
}

TEST(FilmPlanner, ALogWithoutAStrokeOrWithoutTimeHasItsLastFrame) {
  for (const FilmAxis axis : {FilmAxis::kPainting, FilmAxis::kEvents, FilmAxis::kWall}) {
    EXPECT_EQ(FilmPlanner(10, false).frames(of(axis, 3), 0), (Steps{0, 0, 0}));
    EXPECT_EQ(FilmPlanner(10, false).frames(of(axis, 2), 30).back(), 30);
  }
}

TEST(FilmPlanner, ALogOfStepsIsCountedInThem) {
  FilmPlanner planner(10, true);
  log::Event step;
  step.action = log::Step{};
  planner.add(touch(0, log::TouchPhase::kDown));
  for (int i = 0; i < 20; ++i) planner.add(step);
  planner.add(touch(0, log::TouchPhase::kUp));
  for (int i = 0; i < 80; ++i) planner.add(step);
  EXPECT_EQ(planner.frames(of(FilmAxis::kWall, 2), 100), (Steps{50, 100}));
  // The touch takes 21 steps, and the pause after it 5.
  EXPECT_EQ(planner.frames(of(FilmAxis::kPainting, 26), 100)[19], 20);
}

}  // namespace
}  // namespace pentimento
