#include "formats/hdf5/rehearsal.h"

#include <gtest/gtest.h>

#include <csignal>

namespace pentimento::hdf5 {
namespace {

TEST(Rehearsal, ACrashIsAnErrorThatNamesTheFile) {
  const Result<void> done = rehearse("a.h5", [] { std::raise(SIGKILL); });
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(done.error().message, "a.h5: a damaged HDF5 file");
}

TEST(Rehearsal, WhatTheChildDoesStaysThere) {
  int changed = 0;
  EXPECT_TRUE(rehearse("a.h5", [&] { changed = 1; }).ok());
  EXPECT_EQ(changed, 0);
}

}  // namespace
}  // namespace pentimento::hdf5
