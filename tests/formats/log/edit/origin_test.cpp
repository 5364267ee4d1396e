#include "formats/log/edit/origin.h"

#include <gtest/gtest.h>

namespace pentimento::log {
namespace {

TEST(Origin, IsNamedBesideEarlierOnes) {
  Header header;
  name_origin(header, "x-edited", "a.jsonl", "01");
  EXPECT_EQ(header.extensions, R"("x-edited":{"file":"a.jsonl","sha256":"01"})");
  name_origin(header, "x-edited", "b \"c\".jsonl", "02");
  name_origin(header, "x-edited", "d", "03");
  name_origin(header, "x-merged", "e", "04");
  EXPECT_EQ(header.extensions, R"("x-edited":{"file":"a.jsonl","sha256":"01"},)"
                               R"("x-edited-2":{"file":"b \"c\".jsonl","sha256":"02"},)"
                               R"("x-edited-3":{"file":"d","sha256":"03"},)"
                               R"("x-merged":{"file":"e","sha256":"04"})");
}

}  // namespace
}  // namespace pentimento::log
