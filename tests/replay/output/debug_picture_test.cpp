#include "replay/output/debug_picture.h"

#include <gtest/gtest.h>

#include "replay/output/debug_legend.h"
#include "tests/reference/made_up_canvas.h"
#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

ChannelBasis one_channel() {
  ChannelBasis basis;
  basis.name = {"a"};
  basis.amount = Eigen::VectorXf::Ones(1);
  return basis;
}

reference::WholePicture picture_of(const DebugColors& colors, const CanvasSource& canvas,
                                   const DebugFrame& frame) {
  reference::WholePicture picture;
  const Result<void> written =
      write_debug_picture(colors, canvas, one_channel(), frame, {&picture}, Control());
  EXPECT_TRUE(written.ok());
  EXPECT_TRUE(picture.in_order);
  return picture;
}

TEST(DebugPicture, APixelHasTheColourOfTheCellUnderItsCentre) {
  // A canvas three times as wide as the picture, which is streamed in strips.
  const reference::MadeUpCanvas canvas({900, 600, 0.9, 0.6}, 2, 1);
  const DebugColors colors(DebugView::kHeight, {0, 1e-3, 1e-3, "mm"});
  const auto picture = picture_of(colors, canvas, {{300, 200, 0}, 0, 0, 300, 200});
  EXPECT_EQ(picture.width, 300);
  EXPECT_EQ(picture.rows, 200 + debug_legend_height(300));
  EXPECT_GT(picture.strips, 3);
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{150, 77}, std::pair{299, 199}}) {
    const float height = canvas.value({PlaneKind::kBase}, 3 * x + 1, 3 * y + 1) +
                         canvas.value({PlaneKind::kDepth}, 3 * x + 1, 3 * y + 1);
    EXPECT_EQ(picture.at("G", x, y), colors.at(static_cast<double>(height))[1]);
  }
}

TEST(DebugPicture, ACropIsThatPartOfTheWhole) {
  const reference::MadeUpCanvas canvas({320, 256, 0.32, 0.256}, 2, 1);
  const DebugColors colors(DebugView::kWetness, {0, 1e-3, 1e-3, "mm"});
  const auto whole = picture_of(colors, canvas, {{640, 512, 0}, 0, 0, 640, 512});
  const auto part = picture_of(colors, canvas, {{640, 512, 0}, 100, 200, 300, 70});
  for (int y = 0; y < 70; y += 7)
    for (int x = 0; x < 300; x += 11)
      EXPECT_EQ(part.at("B", x, y), whole.at("B", x + 100, y + 200));
}

/// How many pixels at the left of these rows of a legend are not bare page.
int ink(const std::array<Field<float>, 3>& legend, int y0, int y1) {
  const float page = linear_of({250, 250, 250})[0];
  int marked = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = 0; x < 150; ++x)
      if (legend[0](x, y) != page) ++marked;
  return marked;
}
constexpr int kTitleEnd = 22, kNumbersBegin = 42, kNumbersEnd = 60;
// A letter is drawn in strokes of at least four pixels; the titles begin with twelve letters or
// more.
constexpr int kLeastTitle = 12 * 4, kLeastNumbers = 2 * 4;

TEST(DebugLegend, HasATitleABarFromEndToEndAndNumbers) {
  const DebugColors colors(DebugView::kHeight, {0, 2e-3, 1e-3, "mm"});
  const auto legend = draw_debug_legend(colors, 400);
  ASSERT_TRUE(legend.ok()) << legend.error().message;
  const auto& rgb = *legend;
  EXPECT_EQ(rgb[0].height(), debug_legend_height(400));
  const auto at = [&](int x, int y) { return Linear3{rgb[0](x, y), rgb[1](x, y), rgb[2](x, y)}; };
  EXPECT_EQ(at(12, 30), color_at(viridis(), 0));
  EXPECT_EQ(at(387, 30), color_at(viridis(), 1));
  EXPECT_EQ(at(0, 0), linear_of({250, 250, 250}));
  EXPECT_GT(ink(rgb, 0, kTitleEnd), kLeastTitle);
  EXPECT_GT(ink(rgb, kNumbersBegin, kNumbersEnd), kLeastNumbers);
}

TEST(DebugLegend, NumbersStandEvenlyAlsoWhereTheScaleDoesNotBeginAtNothing) {
  // From 1 to 2 in five parts: a tick under the bar at each end and at the four values between.
  const auto legend = draw_debug_legend(DebugColors(DebugView::kHeight, {1, 2, 1, "m"}), 400);
  ASSERT_TRUE(legend.ok());
  constexpr int kTicks = 39, kBegin = 12, kLast = 387;
  std::vector<int> ticks, even;
  for (int x = 0; x < 400; ++x)
    if ((*legend)[0](x, kTicks) != linear_of({250, 250, 250})[0]) ticks.push_back(x);
  for (int i = 0; i <= 5; ++i) even.push_back(kBegin + (kLast - kBegin) * i / 5);
  EXPECT_EQ(ticks, even);
}

TEST(DebugLegend, OfAPosterIsLargerAndEveryViewHasOne) {
  EXPECT_GT(debug_legend_height(8000), 5 * debug_legend_height(800));
  for (const DebugView view : {DebugView::kHeight, DebugView::kVelocity, DebugView::kPigment,
                               DebugView::kLayers, DebugView::kWetness}) {
    const auto legend = draw_debug_legend(DebugColors(view, {0, 2, 1, "mm"}), kLeastLegendWidth);
    ASSERT_TRUE(legend.ok());
    EXPECT_GT(ink(*legend, 0, kTitleEnd), kLeastTitle);
    // Nothing runs into the outermost column.
    for (int y = 0; y < (*legend)[0].height(); ++y)
      EXPECT_EQ((*legend)[0](kLeastLegendWidth - 1, y), linear_of({250, 250, 250})[0]);
  }
}

}  // namespace
}  // namespace pentimento
