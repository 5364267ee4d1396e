// Films from the shell.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

TEST(CommandFilm, OneReplayMakesAFilmItsFramesAndTheEnd) {
  const Workplace place;
  const Ran ran = place.run(
      "render a.jsonl -o film.avi -o f-%02d.png -o end.png --length 0.2s --fps 20 --along events "
      "--json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto report = nlohmann::json::parse(ran.out);
  ASSERT_EQ(report["frame_steps"].size(), 4U) << "0.2 s of 20 frames";
  for (const char* name : {"film.avi", "f-00.png", "f-03.png", "end.png"})
    EXPECT_TRUE(place.has(name)) << name;
  EXPECT_FALSE(place.has("f-04.png"));
  const std::string step = report["frame_steps"][1].dump();
  ASSERT_EQ(place.run("render a.jsonl -o one.png --at step:" + step).code, 0);
  EXPECT_EQ(place.run("compare one.png f-01.png").code, 0);
}

TEST(CommandFilm, ManyFramesDoNotRunOutOfFiles) {
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o f-%03d.png --frames 80 --width 8", "ulimit -n 64;");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(place.has("f-079.png"));
}

TEST(CommandFilm, WhatMakesNoSenseIsRefusedInOneLine) {
  const Workplace place;
  for (const char* words : {"-o f.mp4 --at 1", "-o f.mp4 --length 0", "-o f.mp4 --along time",
                            "-o f.mp4 --frames 3 --length 3s", "-o end.png --frames 3",
                            "-o f.mp4 --width 33", "-o f.mp4 --fps 0"}) {
    const Ran ran = place.run(std::string("render a.jsonl ") + words);
    EXPECT_EQ(ran.code, 2) << words;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(place.files(), 1U) << words;
  }
}

}  // namespace
}  // namespace pentimento::test
