// A machine whose calls fail while a job goes on from its slots: what the job then says or writes
// is right, and the same command again ends as if nothing had happened.

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string>

#include "replay/checkpoint/checkpointer.h"
#include "tests/formats/faulty_disk.h"
#include "tests/replay/checkpoint/two_slots.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

namespace fs = std::filesystem;
constexpr int kOfEachCall = 6;  // spread over the whole run
using test::comparable;
using test::FaultyDisk;
using test::rendered;
using test::TwoSlots;

class FailedResume : public testing::Test {
 protected:
  FailedResume() {
    RenderJob plain = two_.job;
    plain.checkpoint = {};
    plain_ = comparable(rendered(plain));
    whole_ = test::slurp(output());
    fs::remove(output());
    fs::copy(slots(), kept(), fs::copy_options::recursive);
    two_.job.checkpoint.every_steps = 5;
  }
  std::string slots() const { return two_.folder.path("ck"); }
  std::string kept() const { return two_.folder.path("kept"); }
  std::string output() const { return two_.folder.path("a.h5"); }
  void begin_again() const {
    fs::remove(output());
    fs::remove_all(slots());
    fs::copy(kept(), slots(), fs::copy_options::recursive);
  }
  /// Goes on with the fault, and then without it.
  void expect_no_harm(const std::string& call, int number) {
    SCOPED_TRACE(testing::Message() << call << " " << number);
    begin_again();
    Result<JobReport> hurt = Error{};
    {
      FaultyDisk disk;
      disk.plan(call, number, {EIO});
      hurt = render(two_.job, Control());
    }
    if (hurt) {
      EXPECT_EQ(comparable(*hurt), plain_);
      EXPECT_TRUE(test::slurp(output()) == whole_);
    } else {
      EXPECT_EQ(hurt.error().code, ErrorCode::kIo);
      EXPECT_EQ(hurt.error().message.find('\n'), std::string::npos);
      ++errors_;
      EXPECT_TRUE(!fs::exists(output()) || test::slurp(output()) == whole_) << "half a dump";
    }
    EXPECT_EQ(comparable(rendered(two_.job)), plain_);
  }

  TwoSlots two_;
  std::string plain_, whole_;
  int errors_ = 0;
};

TEST_F(FailedResume, EndsInOneLineOrAsIfNothingHadFailed) {
  begin_again();
  FaultyDisk sound;
  EXPECT_EQ(comparable(rendered(two_.job)), plain_);
  const std::vector<std::string> names = {"read", "write", "fsync", "rename"};
  std::vector<int> counts;
  for (const std::string& name : names) counts.push_back(sound.calls(name));
  FaultyDisk::current() = nullptr;
  int faults = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_GT(counts[i], 0) << names[i];
    const int step = std::max(1, counts[i] * test::kStride / kOfEachCall);
    for (int number = 1; number <= counts[i]; number += step, ++faults)
      expect_no_harm(names[i], number);
  }
  EXPECT_GT(errors_, 0) << "the dump's own calls cannot be made good";
  EXPECT_LT(errors_, faults) << "a slot that is not written costs a warning";
}

}  // namespace
}  // namespace pentimento
