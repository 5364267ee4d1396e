#include "replay/session/log_plan.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/replay/list_reader.h"

namespace pentimento {
namespace {

using test::ListReader;

Result<LogPlan> plan(ListReader& reader, const Control& control = {}) {
  LogFiles files("-", false);
  return plan_log(reader, files, {}, {}, control);
}

TEST(LogPlan, CountsWhatTheLogHoldsAndRewindsIt) {
  ListReader reader;  // 45 steps a second
  reader.add(0, log::Color{});
  reader.stroke(0.1, 0.5, 0.1, 0.3, 0.1);
  reader.stroke(1, 2, 0.1, 0.3, 0.2);
  const auto found = plan(reader);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->events, 11);
  EXPECT_EQ(found->touches, 10);
  EXPECT_EQ(found->strokes, 2);
  EXPECT_EQ(found->steps, 91);  // to the end of the step at 2 s
  EXPECT_EQ(found->last_time_us, 2'000'000);
  const auto first = reader.next();
  ASSERT_TRUE(first && first->has_value());
  EXPECT_EQ((*first)->line, 2);
}

TEST(LogPlan, ALogOfStepsIsAsLongAsThose) {
  ListReader reader;
  for (int i = 0; i < 3; ++i) reader.add(i, log::Step{});
  const auto found = plan(reader);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->stepped);
  EXPECT_EQ(found->steps, 3);
}

TEST(LogPlan, AFileThatIsNotThereIsTheLinesFault) {
  ListReader reader;
  reader.add(0, log::Mark{"m"});
  log::Load load;
  load.file = "nowhere.png";
  reader.add(1, load);
  const auto found = plan(reader);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find(":3: "), std::string::npos) << found.error().message;
}

/// A long log in which somebody presses Ctrl-C.
class InterruptedReader : public ListReader {
 public:
  std::atomic<bool> stop = false;
  int read = 0;
  Result<std::optional<log::Event>> next() override {
    if (++read == 3) stop = true;
    return ListReader::next();
  }
};

TEST(LogPlan, StopsReadingWhenItIsToldTo) {
  InterruptedReader reader;
  for (int i = 0; i < 100; ++i) reader.add(i, log::Mark{"m"});
  Control control;
  control.cancelled = &reader.stop;
  const auto found = plan(reader, control);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(reader.read, 3);
}

}  // namespace
}  // namespace pentimento
