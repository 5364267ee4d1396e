// A dump is read from an open file, wherever that lies; here it lies in memory.

#include "formats/hdf5/read_dump.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/formats/hdf5/dump_image.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/reference/made_up_canvas.h"

namespace pentimento {
namespace {

const std::string kName = "in memory";

Result<StateDump> read(const hdf5::Handle& file, bool whole) {
  return hdf5::read_dump({file.id(), kName, {}, nullptr}, whole);
}

StateDump made_up_fine_dump() {
  StateDump dump = test::made_up_dump(9, 7, 2, 3);
  dump.detail = 3;
  const CanvasGeometry fine = {27, 21, dump.state.geometry.width_m, dump.state.geometry.height_m};
  dump.fine = std::make_shared<reference::MadeUpCanvas>(fine, 2, dump.state.channels);
  return dump;
}

TEST(ReadDump, TakesADumpThatIsNoFileOfADisk) {
  const StateDump dump = test::made_up_dump(9, 7, 2, 3);
  const hdf5::Handle file = test::open_dump_image(test::dump_image(dump));
  ASSERT_TRUE(file.ok());
  const auto back = read(file, true);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->state_sha256, state_sha256(dump.state));
}

TEST(ReadDump, TheDetailCanvasKeepsTheFileOpen) {
  const StateDump dump = made_up_fine_dump();
  hdf5::Handle file = test::open_dump_image(test::dump_image(dump));
  const auto back = read(file, false);
  ASSERT_TRUE(back) << back.error().message;
  file = {};
  EXPECT_EQ(detail_sha256(*back->fine), detail_sha256(*dump.fine));
  EXPECT_TRUE(back->fine->status());
}

TEST(ReadDump, OnlyTheWholeReadingFindsAWrongHashOfTheDetailCanvas) {
  const hdf5::Handle file = test::open_dump_image(test::dump_image(made_up_fine_dump()));
  const hdf5::Handle depth(H5Dopen2(file.id(), "/fluid/depth", H5P_DEFAULT), H5Dclose);
  std::vector<float> values(27 * 21, 0.001f);
  ASSERT_GE(H5Dwrite(depth.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            0);
  EXPECT_TRUE(read(file, false));
  const auto whole = read(file, true);
  ASSERT_FALSE(whole);
  EXPECT_EQ(whole.error().code, ErrorCode::kBadInput);
  EXPECT_NE(whole.error().message.find("have the hash"), std::string::npos);
}

}  // namespace
}  // namespace pentimento
