#include "core/brush/stamp_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "core/base/random.h"
#include "core/layers/cell_packet.h"
#include "core/layers/deposit.h"
#include "core/layers/mix_layers.h"
#include "core/layers/pick_up.h"

namespace pentimento {
namespace {

constexpr int kLayers = 2, kChannels = 3, kStride = 4;
constexpr CanvasGeometry kGrid = {200, 60, 0.2, 0.06};
constexpr FootprintBox kBox = {20, 10, 150, 40, true};
const std::vector<float> kAmount(kChannels, 1.0f);

float any_share(std::uint32_t n) {
  return random_uniform(RandomPurpose::kBristle, 7, n);
}

/// Paint here and there; nothing of channel 2 of the upper layer.
CanvasState painted_canvas() {
  CanvasState state = make_canvas_state(kGrid, kLayers, kChannels, 1, 1);
  std::uint32_t n = 0;
  for (int y = 0; y < kGrid.height; ++y)
    for (int x = 0; x < kGrid.width; ++x) {
      state.depth_m(x, y) = 1e-3f * any_share(++n);
      state.stroke(x, y) = 1 + static_cast<std::uint32_t>(x / 40);
      for (int k = 0; k < kLayers * kChannels - 1; ++k)
        if ((x + y + k) % 3 != 0) state.pigment[static_cast<std::size_t>(k)](x, y) = any_share(++n);
    }
  return state;
}

/// Rows of so many touched cells, each beginning a little further to the right.
std::vector<TouchedCells> rows_of(const std::vector<int>& counts) {
  std::vector<TouchedCells> rows;
  std::size_t at = 0;
  for (int y = 0; y < kBox.height; ++y) {
    const int count = counts[static_cast<std::size_t>(y) % counts.size()];
    rows.push_back(count == 0 ? TouchedCells{0, 0, at} : TouchedCells{y / 2, y / 2 + count, at});
    at += static_cast<std::size_t>(count);
  }
  return rows;
}

bool same(const Field<float>& a, const Field<float>& b) {
  for (int y = 0; y < a.height(); ++y)
    if (std::memcmp(a.row(y), b.row(y), sizeof(float) * static_cast<std::size_t>(a.width())) != 0)
      return false;
  return true;
}
void expect_same(const CanvasState& a, const CanvasState& b) {
  EXPECT_TRUE(same(a.depth_m, b.depth_m));
  for (std::size_t k = 0; k < a.pigment.size(); ++k)
    EXPECT_TRUE(same(a.pigment[k], b.pigment[k])) << k;
  for (int y = 0; y < kGrid.height; ++y)
    for (int x = 0; x < kGrid.width; ++x) ASSERT_EQ(a.stroke(x, y), b.stroke(x, y));
}

TEST(StampCells, ShortRowsKeepCompanyAndLongOnesStay) {
  CanvasState state = painted_canvas();
  StampCells cells(state, kAmount);
  const std::vector<TouchedCells> rows = rows_of({10, 12, 0, 9, 130, 130, 8, 7});
  cells.cut(kBox, rows);
  std::size_t next = 0;
  for (const StampBand& band : cells.bands()) {
    EXPECT_EQ(band.at, next);  // no cell is left out, none comes twice
    std::size_t count = 0, longest = 0;
    for (int y = band.begin; y < band.end; ++y) {
      count += rows[static_cast<std::size_t>(y)].count();
      longest = std::max(longest, rows[static_cast<std::size_t>(y)].count());
    }
    EXPECT_EQ(band.cells, count);
    EXPECT_TRUE(longest < kPacketCells || band.end - band.begin == 1);
    next += count;
  }
  EXPECT_EQ(next, rows.back().at + rows.back().count());
  // Five times three short rows and two long ones, and two short ones that the next three join.
  ASSERT_EQ(cells.bands().size(), 5u * 2 + 6);
  EXPECT_EQ(cells.bands()[0].cells, 31u);
  EXPECT_EQ(cells.bands()[0].end, 4);
}

TEST(StampCells, OnlyTouchedCellsAreWritten) {
  CanvasState state = painted_canvas();
  const CanvasState before = clone_state(state);
  StampCells cells(state, kAmount);
  const std::vector<TouchedCells> rows = rows_of({10, 3, 0, 100});
  cells.cut(kBox, rows);
  for (int i = 0; i < static_cast<int>(cells.bands().size()); ++i) {
    const BandPaint paint = cells.gather(i);
    for (std::size_t x = 0; x < paint.depth_m.size(); ++x) {
      paint.depth_m[x] += 1;
      paint.stroke[x] = 99;
      // The plane that held nothing is written to as well.
      paint.layers.at(1, 2, static_cast<int>(x)) = 7;
    }
    cells.put_back(i);
  }
  for (int y = 0; y < kGrid.height; ++y)
    for (int x = 0; x < kGrid.width; ++x) {
      const bool in_box = y >= kBox.y && y < kBox.y + kBox.height;
      const TouchedCells row = in_box ? rows[static_cast<std::size_t>(y - kBox.y)] : TouchedCells{};
      const bool touched = x - kBox.x >= row.begin && x - kBox.x < row.end;
      ASSERT_EQ(state.depth_m(x, y), before.depth_m(x, y) + (touched ? 1 : 0)) << x << ", " << y;
      ASSERT_EQ(state.stroke(x, y), touched ? 99 : before.stroke(x, y));
      ASSERT_EQ(state.channel(1, 2)(x, y), touched ? 7 : 0);
      ASSERT_EQ(state.channel(0, 1)(x, y), before.channel(0, 1)(x, y));
    }
}

TEST(StampCells, PlanesOfNothingAreKnownUntilPaintIsLaid) {
  CanvasState state = painted_canvas();
  StampCells cells(state, kAmount);
  const std::vector<TouchedCells> rows = rows_of({10});
  cells.cut(kBox, rows);
  const BandPaint paint = cells.gather(0);
  EXPECT_TRUE(paint.layers.may_hold(0, 0));
  EXPECT_FALSE(paint.layers.may_hold(1, 2));
  paint.layers.at(1, 2, 5) = 1e-30f;
  cells.find_held(0);
  EXPECT_TRUE(paint.layers.may_hold(1, 2));
}

struct Strokes {
  PickUp pick_up{0.4f, 0.7f, 0.05f};
  Deposit deposit{2e-3f, 5};
  MixLayers mix{0.3f, 0.05f};
  std::vector<float> weight, paint;  // of all touched cells
};

/// One stamp's work on cells that lie side by side.
void work_on(const Strokes& s, const BandPaint& canvas, std::size_t at) {
  const std::span<const float> weight = std::span(s.weight).subspan(at, canvas.depth_m.size());
  std::vector<float> paint(
      s.paint.begin() + static_cast<std::ptrdiff_t>(at * kStride),
      s.paint.begin() + static_cast<std::ptrdiff_t>((at + weight.size()) * kStride));
  std::vector<float> picked_up(paint.size());
  std::vector<double> sums(1 + kChannels);
  pick_up_row(s.pick_up, canvas.layers, weight, canvas.depth_m.data(), picked_up.data(), kStride,
              sums);
  deposit_row(s.deposit, canvas.layers, canvas.depth_m, canvas.stroke, paint.data(), kStride, sums);
}

// The oracle: row by row, on the canvas itself.
TEST(StampCells, BandsGiveTheBitsOfSingleRows) {
  for (const std::vector<int>& counts : std::vector<std::vector<int>>{
           {10}, {1, 2, 0, 3}, {63, 64, 65}, {12, 100, 5}, {60, 60, 60, 60, 60, 60, 60, 60, 60}}) {
    CanvasState state = painted_canvas(), plain = painted_canvas();
    const std::vector<TouchedCells> rows = rows_of(counts);
    Strokes strokes;
    const std::size_t all = rows.back().at + rows.back().count();
    for (std::uint32_t i = 0; i < all; ++i) {
      strokes.weight.push_back(i % 5 == 0 ? 0 : any_share(i));
      for (std::uint32_t k = 0; k < kStride; ++k)
        strokes.paint.push_back(i % 7 == 0 || k == 1 ? 0 : 1e-3f * any_share(4 * i + k));
    }
    StampCells cells(state, kAmount);
    cells.cut(kBox, rows);
    for (int i = 0; i < static_cast<int>(cells.bands().size()); ++i) {
      const StampBand& band = cells.bands()[static_cast<std::size_t>(i)];
      const BandPaint canvas = cells.gather(i);
      work_on(strokes, canvas, band.at);
      cells.find_held(i);
      mix_layers_row(strokes.mix, canvas.layers,
                     std::span(strokes.weight).subspan(band.at, band.cells));
      cells.put_back(i);
    }
    LayerPlanes planes(plain, kAmount);
    for (int y = 0; y < kBox.height; ++y) {
      const TouchedCells& row = rows[static_cast<std::size_t>(y)];
      const int x = kBox.x + row.begin, canvas_y = kBox.y + y;
      const BandPaint canvas{planes.row(x, canvas_y),
                             {plain.depth_m.row(canvas_y) + x, row.count()},
                             plain.stroke.row(canvas_y) + x};
      work_on(strokes, canvas, row.at);
      mix_layers_row(strokes.mix, canvas.layers,
                     std::span(strokes.weight).subspan(row.at, row.count()));
    }
    expect_same(state, plain);
  }
}

}  // namespace
}  // namespace pentimento
