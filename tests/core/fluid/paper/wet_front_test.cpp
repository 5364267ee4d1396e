// A9: what the step leaves as velocity, with films that come and without.

#include "core/fluid/paper/wet_front.h"

#include <gtest/gtest.h>

#include "core/fluid/paper/planes.h"
#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

constexpr int kFrontWidth = 40;

/// A row of film that ends at x = 20, with a bare cell in it, and velocities everywhere.
struct FrontRow {
  FrontRow() : canvas(kFrontWidth, 1), planes(make_planes(kFrontWidth, 1, 2)) {
    canvas.pour(0, 0, 20, 1, 0.002f, 0.1f);
    canvas.state.depth_m(7, 0) = 0;
    for (int x = 0; x < kFrontWidth; ++x) {
      planes.u_m_s[0](x, 0) = 0.01f * static_cast<float>(x + 1);
      planes.v_m_s[0](x, 0) = -0.02f;
    }
  }
  Velocity velocity() const { return {planes.u_m_s[0], planes.v_m_s[0]}; }
  TestCanvas canvas;
  Planes planes;
};

TEST(WetFront, WithoutFilmsThatComeBothWaysGiveTheSameBits) {
  FrontRow plain, general;
  const Columns row{0, kFrontWidth};
  EXPECT_FALSE(any_inflow(general.planes.inflow, 0, row));
  EXPECT_TRUE(update_velocity_row(plain.velocity(), 0, row, plain.canvas.state));
  EXPECT_TRUE(update_velocity_row(general.canvas.contact, general.velocity(), general.planes.inflow,
                                  0, row, general.canvas.state));
  EXPECT_TRUE(
      paper::same_bits(plain.canvas.state.velocity_x_m_s, general.canvas.state.velocity_x_m_s));
  EXPECT_TRUE(
      paper::same_bits(plain.canvas.state.velocity_y_m_s, general.canvas.state.velocity_y_m_s));
  EXPECT_EQ(plain.canvas.state.velocity_x_m_s(7, 0), 0);   // bare
  EXPECT_EQ(plain.canvas.state.velocity_x_m_s(25, 0), 0);  // beyond the film
  EXPECT_GT(plain.canvas.state.velocity_x_m_s(19, 0), 0);
  EXPECT_FALSE(update_velocity_row(plain.velocity(), 0, row, plain.canvas.state));
}

TEST(WetFront, FilmsThatCameAreForgotten) {
  FrontRow front;
  const Columns row{0, kFrontWidth};
  FrontInflow& inflow = front.planes.inflow;
  inflow.count(20, 0) = 2;
  inflow.u_m_s(20, 0) = 0.06f;
  inflow.v_m_s(20, 0) = 0.02f;
  EXPECT_TRUE(any_inflow(inflow, 0, row));
  EXPECT_FALSE(any_inflow(inflow, 0, {0, 20}));
  update_velocity_row(front.canvas.contact, front.velocity(), inflow, 0, row, front.canvas.state);
  EXPECT_FLOAT_EQ(front.canvas.state.velocity_x_m_s(20, 0), 0.03f);  // the mean of both
  EXPECT_FLOAT_EQ(front.canvas.state.velocity_y_m_s(20, 0), 0.01f);
  clear_inflow(0, row, inflow);
  for (const Field<float>* plane : {&inflow.count, &inflow.u_m_s, &inflow.v_m_s})
    EXPECT_EQ((*plane)(20, 0), 0);
}

// Whatever an earlier step left there: the live cells are written before they are read, and the
// cells around them hold nothing that moves.
TEST(WetFront, MarginsBeyondTheLiveCellsStand) {
  FrontRow front;
  Planes& planes = front.planes;
  for (std::size_t i = 0; i < 3; ++i) {
    planes.u_m_s[i].fill(1);
    planes.v_m_s[i].fill(1);
  }
  planes.moved.fill(1);
  prepare_margin_row(front.canvas.state, 0, {5, 22}, {6, 21}, planes);
  for (const int x : {5, 21})
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(planes.u_m_s[i](x, 0), 0);
      EXPECT_EQ(planes.v_m_s[i](x, 0), 0);
      EXPECT_EQ(planes.moved(x, 0), 0);
      EXPECT_EQ(planes.height_m[1](x, 0), planes.height_m[0](x, 0));
    }
  EXPECT_EQ(planes.height_m[0](19, 0),
            front.canvas.state.depth_m(19, 0) + front.canvas.state.base_m(19, 0));
  EXPECT_EQ(planes.wet(19, 0), 1);
  EXPECT_EQ(planes.wet(7, 0), 0);
  EXPECT_EQ(planes.wet(20, 0), 0);
}

}  // namespace
}  // namespace pentimento::paper
