#include "core/detail/stamp/stamp_packet.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(StampPacket, LiesWithinTheRowAndHasWholeVectors) {
  for (const int side : {96, 119, 128}) {
    for (int x = 0; x < side; ++x) {
      for (int own = 1; own <= std::min(kPacketCells, side - x); ++own) {
        const StampPacket packet = packet_at(x, own, side);
        ASSERT_EQ(packet.cells % kVectorCells, 0);
        ASSERT_LT(packet.cells, own + kVectorCells);
        ASSERT_EQ(packet.first + packet.begin, x);
        ASSERT_EQ(packet.end - packet.begin, own);
        ASSERT_GE(packet.first, 0);
        ASSERT_LE(packet.first + packet.cells, side);
      }
    }
  }
}

}  // namespace
}  // namespace pentimento
