#include "core/shading/strip_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <thread>
#include <vector>

#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

using reference::WholePicture;

/// Red, green and blue of target 0, and the depth, the last of four values of target 1.
struct Source {
  std::vector<PlaneSource> planes = {{"R", TargetKind::kPicture, 0, 0},
                                     {"G", TargetKind::kPicture, 0, 1},
                                     {"B", TargetKind::kPicture, 0, 2},
                                     {"depth.Y", TargetKind::kNormal, 0, 3}};
  ShadeVariant variant;
  Source() { variant.target[static_cast<std::size_t>(TargetKind::kNormal)] = 1; }
  StripPlanes parts() const { return {planes, variant}; }
};

/// What is to be in a plane at (x, y).
float value(int target, int component, int x, int y) {
  return static_cast<float>(((target * 4 + component) * 100 + y) * 100 + x);
}

/// Writes a picture of 7 x 10 pixels in strips of 4 rows, each in tiles of 3 columns. Returns the
/// first failure.
Result<void> write_picture(StripWriter& writer) {
  for (int y = 0; y < 10; y += 4) {
    const int rows = std::min(4, 10 - y);
    for (int x = 0; x < 7; x += 3) {
      const int columns = std::min(3, 7 - x);
      for (int target = 0; target < 2; ++target) {
        std::vector<float> texels;
        for (int j = 0; j < rows; ++j)
          for (int i = 0; i < columns; ++i)
            for (int c = 0; c < 4; ++c) texels.push_back(value(target, c, x + i, y + j));
        writer.take(target, {x, columns}, rows, texels);
      }
    }
    if (auto written = writer.hand_on(y, rows); !written) return written;
  }
  return writer.finish();
}

class StripWriterTest : public testing::TestWithParam<bool> {
 protected:
  Source source_;
};

TEST_P(StripWriterTest, EverySinkGetsEveryPlaneInOrder) {
  WholePicture one, other;
  StripWriter writer(source_.parts(), 7, 4, {&one, &other}, GetParam());
  ASSERT_TRUE(write_picture(writer));
  for (const WholePicture* picture : {&one, &other}) {
    EXPECT_TRUE(picture->in_order);
    EXPECT_EQ(picture->strips, 3);
    EXPECT_EQ(picture->rows, 10);
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 7; ++x) {
        EXPECT_EQ(picture->at("R", x, y), value(0, 0, x, y));
        EXPECT_EQ(picture->at("B", x, y), value(0, 2, x, y));
        EXPECT_EQ(picture->at("depth.Y", x, y), value(1, 3, x, y));
      }
  }
}

struct Failing : PictureSink {
  int fails_at = 0, calls = 0;
  Result<void> write(const PictureStrip&) override {
    if (calls++ < fails_at) return {};
    return Error{ErrorCode::kIo, "full"};
  }
};

TEST_P(StripWriterTest, AfterAFailureNoSinkGetsAnything) {
  for (const int strips : {0, 1, 2}) {
    Failing failing;
    failing.fails_at = strips;
    WholePicture behind;
    StripWriter writer(source_.parts(), 7, 4, {&failing, &behind}, GetParam());
    const Result<void> written = write_picture(writer);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, "full");
    EXPECT_EQ(failing.calls, strips + 1);
    EXPECT_EQ(behind.strips, strips);
  }
}

INSTANTIATE_TEST_SUITE_P(AloneAndBeside, StripWriterTest, testing::Bool());

TEST(StripWriter, DrawsTheNextStripWhileTheSinkWorks) {
  struct Waiting : PictureSink {
    std::promise<void> next_is_drawn;
    std::thread::id worker;
    int strips = 0;
    Result<void> write(const PictureStrip&) override {
      if (strips++ == 0) next_is_drawn.get_future().wait();
      worker = std::this_thread::get_id();
      return {};
    }
  };
  const Source source;
  Waiting waiting;
  StripWriter writer(source.parts(), 2, 1, {&waiting}, true);
  const std::vector<float> texels(8);
  writer.take(0, {0, 2}, 1, texels);
  ASSERT_TRUE(writer.hand_on(0, 1));
  writer.take(0, {0, 2}, 1, texels);
  waiting.next_is_drawn.set_value();
  ASSERT_TRUE(writer.hand_on(1, 1));
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(waiting.strips, 2);
  EXPECT_NE(waiting.worker, std::this_thread::get_id());
}

}  // namespace
}  // namespace pentimento
