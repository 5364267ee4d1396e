#include "formats/hdf5/rehearsal.h"

#include <gtest/gtest.h>

#include <csignal>

namespace pentimento::hdf5 {
namespace {

TEST(Rehearsal, ACrashIsAnErrorThatNamesTheFile) {
  const Result<bool> done = rehearse("a.h5", [] { return std::raise(SIGKILL) == 0; });
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(done.error().message, "a.h5: a damaged HDF5 file");
}

TEST(Rehearsal, WhatTheChildDoesStaysThere) {
  int changed = 0;
  EXPECT_TRUE(*rehearse("a.h5", [&] { return ++changed == 1; }));
  EXPECT_FALSE(*rehearse("a.h5", [&] { return false; }));
  EXPECT_EQ(changed, 0);
}

}  // namespace
}  // namespace pentimento::hdf5
