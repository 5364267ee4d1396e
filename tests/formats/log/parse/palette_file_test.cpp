#include "formats/log/parse/palette_file.h"

#include <gtest/gtest.h>

#include <string>

namespace pentimento::log {
namespace {

TEST(PaletteFile, WhatAnErrorQuotesIsOneShortLine) {
  // Found by the fuzzer: a number that is none of a computer's, after a name of bytes that are no
  // text.
  const std::string path =
      PENTIMENTO_SOURCE_DIR "/tests/corpus/fuzz/palette/name-of-control-characters.bin";
  const auto palette = read_palette_file(path);
  ASSERT_FALSE(palette);
  EXPECT_EQ(palette.error().code, ErrorCode::kBadInput);
  const std::string& message = palette.error().message;
  EXPECT_EQ(message.find(path + ": "), 0u);
  EXPECT_LT(message.size(), path.size() + 310);
  for (const char c : message) EXPECT_TRUE(c >= ' ' || static_cast<signed char>(c) < 0);
}

}  // namespace
}  // namespace pentimento::log
