#include "replay/timeline/undo.h"

#include <gtest/gtest.h>

#include <string>

namespace pentimento {
namespace {

log::Touch touch(log::TouchPhase phase, std::int64_t id = 0) {
  log::Touch t;
  t.phase = phase;
  t.id = id;
  return t;
}

/// s: a stroke, d: dry, c: clear, l: load, u: undo, r: redo, x: a stroke that is cancelled,
/// (: touch 1 goes down, ): touch 1 lifts, k: touch 1 is cancelled, g: gravity.
UndoTable table_of(const std::string& story) {
  UndoTable table;
  const auto add = [&](log::Action action) {
    log::Event event;
    event.action = std::move(action);
    table.add(event);
  };
  for (const char c : story) {
    if (c == 's' || c == 'x') add(touch(log::TouchPhase::kDown));
    if (c == 's') add(touch(log::TouchPhase::kUp));
    if (c == 'x') add(touch(log::TouchPhase::kCancel));
    if (c == '(') add(touch(log::TouchPhase::kDown, 1));
    if (c == ')') add(touch(log::TouchPhase::kUp, 1));
    if (c == 'k') add(touch(log::TouchPhase::kCancel, 1));
    if (c == 'd') add(log::Dry{});
    if (c == 'c') add(log::Clear{});
    if (c == 'l') add(log::Load{"a.png"});
    if (c == 'u') add(log::Undo{});
    if (c == 'r') add(log::Redo{});
    if (c == 'g') add(log::Gravity{});
  }
  return table;
}

/// One digit per unit: 1 = played.
std::string played(const std::string& story) {
  const UndoTable table = table_of(story);
  std::string text;
  for (std::int64_t i = 0; i < table.units(); ++i) text += table.played(i) ? '1' : '0';
  return text;
}

TEST(UndoTable, WithoutUndoEverythingIsPlayed) {
  EXPECT_EQ(played("sdscl"), "11111");
}
TEST(UndoTable, UndoTakesBackTheLastUnitWhateverItIs) {
  EXPECT_EQ(played("ssu"), "10");
  EXPECT_EQ(played("sdu"), "10");
  EXPECT_EQ(played("scu"), "10");
  EXPECT_EQ(played("slu"), "10");
}
TEST(UndoTable, SeveralUndosGoBackOneByOne) {
  EXPECT_EQ(played("sdsuu"), "100");
}
TEST(UndoTable, RedoBringsBackInOrder) {
  EXPECT_EQ(played("sssuuur"), "100");
  EXPECT_EQ(played("sssuuurr"), "110");
  EXPECT_EQ(played("sssuuurrr"), "111");
}
TEST(UndoTable, WhatTheDeviceTookBackCannotBeRedone) {
  EXPECT_EQ(played("(ur)"), "1");
  EXPECT_EQ(played("(ukr"), "0");
}
TEST(UndoTable, ANewUnitEndsWhatCouldBeRedone) {
  EXPECT_EQ(played("susr"), "01");
  EXPECT_EQ(played("sudr"), "01");
}
TEST(UndoTable, UndoSkipsWhatIsUndoneAlready) {
  EXPECT_EQ(played("ssusu"), "100");
  EXPECT_EQ(played("ssusuu"), "000");
}
TEST(UndoTable, ADroppedUnitIsNotRedoneLater) {
  EXPECT_EQ(played("ssusuur"), "100");
  EXPECT_EQ(played("ssusuurr"), "101");
}
TEST(UndoTable, WithNothingToActOnItDoesNothingAndCounts) {
  EXPECT_EQ(played("urs"), "1");
  EXPECT_EQ(table_of("urs").idle(), 2);
  EXPECT_EQ(table_of("suu").idle(), 1);
}
TEST(UndoTable, GravityIsNoUnit) {
  EXPECT_EQ(played("sgu"), "0");
}
TEST(UndoTable, ACancelledStrokeNeverWas) {
  EXPECT_EQ(played("sx"), "10");
  EXPECT_EQ(played("sxu"), "00");  // the undo takes the stroke before
  EXPECT_EQ(played("xur"), "0");   // nothing to undo, nothing to redo
}
TEST(UndoTable, UnitsCountFromWhenTheyBegin) {
  EXPECT_EQ(played("(s)u"), "10");  // the second stroke began last, though it ended first
}
TEST(UndoTable, AStrokeCanBeUndoneWhileItIsDrawn) {
  EXPECT_EQ(played("s(u)s"), "101");
}

}  // namespace
}  // namespace pentimento
