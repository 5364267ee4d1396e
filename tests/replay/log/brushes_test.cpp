#include "replay/log/brushes.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

/// The one brush of a header, of that shape and with what `choose` says.
template <typename Choose>
BrushDefinition made(const std::string& shape, const Choose& choose) {
  log::Header header;
  log::BrushSpec& spec = header.brushes.emplace_back();
  spec.name = "mine";
  spec.shape = shape;
  choose(spec);
  LogFiles files("-", false);
  const auto table = BrushTable::make(header, files);
  EXPECT_TRUE(table) << table.error().message;
  return table->find("mine").clone();
}

TEST(Brushes, TakeWhatTheLogSaysAndKeepTheRestOfTheShape) {
  const BrushDefinition plain = made("flat", [](log::BrushSpec&) {});
  EXPECT_EQ(plain.name, "mine");
  EXPECT_EQ(plain.shape, TipShape::kFlat);
  const BrushDefinition said = made("flat", [](log::BrushSpec& s) {
    s.spacing = 0.11;
    s.size_pressure = 0.12;
    s.flow_pressure = 0.13;
    s.stiffness = 0.14;
    s.grip = 0.15;
    s.capacity = 160;
    s.film = 0.17;
    s.absorb = 0.18;
    s.follows_direction = true;
    s.size = {{0, 0.1}, {1, 0.9}};
    s.flow = {{0, 0.2}, {1, 0.8}};
    s.splay = {{0, 0.3}, {1, 0.7}};
  });
  EXPECT_EQ(said.spacing, 0.11f);
  EXPECT_EQ(said.size_pressure, 0.12f);
  EXPECT_EQ(said.flow_pressure, 0.13f);
  EXPECT_EQ(said.stiffness, 0.14f);
  EXPECT_EQ(said.grip, 0.15f);
  EXPECT_EQ(said.capacity, 160.0f);
  EXPECT_EQ(said.film, 0.17f);
  EXPECT_EQ(said.absorb, 0.18f);
  EXPECT_TRUE(said.follows_direction);
  EXPECT_FLOAT_EQ(said.size_at(0.5f), 0.5f);  // half way along each curve
  EXPECT_FLOAT_EQ(said.size_at(0), 0.1f);
  EXPECT_FLOAT_EQ(said.flow_at(0), 0.2f);
  EXPECT_FLOAT_EQ(said.splay_at(1), 0.7f);
}

TEST(Brushes, HairsOfAShapeWithoutAnyBeginAsThoseOfBristle) {
  const BrushDefinition bristle = made("bristle", [](log::BrushSpec&) {});
  const BrushDefinition rag = made("rag", [](log::BrushSpec& s) {
    s.bristles.emplace();
    s.bristles->count = 33;
    s.bristles->thickness = 0.5;
  });
  EXPECT_EQ(rag.bristles.count, 33);
  EXPECT_EQ(rag.bristles.thickness, 0.5f);
  EXPECT_EQ(rag.bristles.length_spread, bristle.bristles.length_spread);
  EXPECT_EQ(rag.bristles.clumping, bristle.bristles.clumping);
  const BrushDefinition other = made("bristle", [](log::BrushSpec& s) {
    s.bristles.emplace();
    s.bristles->length_spread = 0.25;
    s.bristles->clumping = 0.75;
  });
  EXPECT_EQ(other.bristles.count, bristle.bristles.count);
  EXPECT_EQ(other.bristles.length_spread, 0.25f);
  EXPECT_EQ(other.bristles.clumping, 0.75f);
}

TEST(Brushes, ALogsOwnHidesTheBuiltInOneOfItsName) {
  log::Header header;
  log::BrushSpec& spec = header.brushes.emplace_back();
  spec.name = "round";
  spec.shape = "flat";
  LogFiles files("-", false);
  const auto table = BrushTable::make(header, files);
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->first().shape, TipShape::kFlat);
  EXPECT_EQ(BrushTable().first().shape, TipShape::kRound);
  spec.shape = "square-ish";
  EXPECT_EQ(BrushTable::make(header, files).error().code, ErrorCode::kBadInput);
}

}  // namespace
}  // namespace pentimento
