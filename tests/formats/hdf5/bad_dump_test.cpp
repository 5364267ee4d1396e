// What read_state() refuses, and that nothing makes it crash.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/provenance.h"
#include "tests/formats/hdf5/changed_dump.h"
#include "tests/formats/scratch.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

using hdf5::Handle;
using test::made_up_dump;
using test::Scratch;

class BadDump : public test::ChangedDump {};

TEST_F(BadDump, ANewerVersionIsNamed) {
  EXPECT_EQ(after([](hid_t f) { set_number(f, "format_version", 4); }),
            "format version 4 is newer than the 3 known here");
  EXPECT_EQ(code_, ErrorCode::kBadInput);
}

TEST_F(BadDump, OtherHdf5IsNoDump) {
  EXPECT_EQ(after([](hid_t f) { H5Adelete(f, "format"); }), "an HDF5 file, but not a state dump");
  const auto with_a_number = [](hid_t f) {
    H5Adelete(f, "format");
    const Handle one(H5Screate(H5S_SCALAR), H5Sclose);
    H5Aclose(H5Acreate2(f, "format", H5T_NATIVE_DOUBLE, one.id(), H5P_DEFAULT, H5P_DEFAULT));
  };
  EXPECT_EQ(after(with_a_number), "an HDF5 file, but not a state dump");
}

TEST_F(BadDump, AMissingDatasetIsNamed) {
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/canvas/base", H5P_DEFAULT); }),
            "/canvas/base is missing");
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/fluid", H5P_DEFAULT); }), "/fluid/depth is missing");
}

TEST_F(BadDump, AMissingSmallDatasetIsNamed) {
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/lighting/sh", H5P_DEFAULT); }),
            "/lighting/sh is missing or malformed");
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/palette/K", H5P_DEFAULT); }),
            "/palette/K is missing or malformed");
}

TEST_F(BadDump, AMissingAttributeIsNamed) {
  EXPECT_EQ(after([](hid_t f) { H5Adelete(f, "state_sha256"); }),
            "state_sha256 is missing or malformed");
  EXPECT_EQ(after([](hid_t f) { H5Adelete(f, "canvas_width_m"); }),
            "canvas_width_m is missing or malformed");
}

TEST_F(BadDump, AShapeThatDoesNotFitIsNamed) {
  EXPECT_EQ(after([](hid_t f) {
              H5Lmove(f, "/canvas/reflectance", f, "/other", H5P_DEFAULT, H5P_DEFAULT);
              H5Ldelete(f, "/canvas/paper", H5P_DEFAULT);
              H5Lmove(f, "/other", f, "/canvas/paper", H5P_DEFAULT, H5P_DEFAULT);
              H5Lcopy(f, "/canvas/paper", f, "/canvas/reflectance", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/canvas/paper has 3 dimensions, must have 2");
}

TEST_F(BadDump, AnotherSizeIsNamed) {
  EXPECT_EQ(after([](hid_t f) {
              H5Ldelete(f, "/canvas/paper", H5P_DEFAULT);
              H5Lcopy(f, "/layers/K", f, "/canvas/paper", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/canvas/paper is 3 x 3, must be 7 x 9");
}

TEST_F(BadDump, AsleepMustHaveARowForEachTile) {
  EXPECT_EQ(after([](hid_t f) {
              H5Ldelete(f, "/fluid/asleep", H5P_DEFAULT);
              H5Lcopy(f, "/layers/K", f, "/fluid/asleep", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/fluid/asleep is 3 x 3, must be 2 x 5");
  EXPECT_EQ(code_, ErrorCode::kBadInput);
}

TEST_F(BadDump, AsleepMustFitTheTilesOfTheModel) {
  // 9 cells of 6.7 cm: tiles have 8 cells, and 16 where they may be as wide as the canvas.
  EXPECT_EQ(after([](hid_t f) { set_number(f, "sleep_tile", 10); }),
            "/fluid/asleep is 2 x 5, must be 1 x 5");
}

TEST_F(BadDump, AsleepMustBeFiniteNumbers) {
  EXPECT_EQ(after([](hid_t f) { set_float(f, "/fluid/asleep", NAN, 1, 4); }),
            "/fluid/asleep has a value that is not finite");
  EXPECT_EQ(after([](hid_t f) {
              H5Ldelete(f, "/fluid/asleep", H5P_DEFAULT);
              H5Lcopy(f, "/layers/channel", f, "/fluid/asleep", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/fluid/asleep is 3, must be 2 x 5");
}

TEST_F(BadDump, ACanvasOfNoWidthIsNamed) {
  EXPECT_EQ(after([](hid_t f) { set_number(f, "canvas_width_m", 1e-300); }),
            "canvas_width_m has the value 1e-300, outside 0.001..100");
}

TEST_F(BadDump, ALostAsleepIsFoundByTheHash) {
  const std::string message = after([](hid_t f) { H5Ldelete(f, "/fluid/asleep", H5P_DEFAULT); });
  EXPECT_EQ(message.find("its values have the hash "), 0u) << message;
}

TEST_F(BadDump, AChangedValueIsFoundByTheHash) {
  const std::string message = after([](hid_t f) { set_float(f, "/fluid/depth", 0.5f); });
  EXPECT_EQ(message.find("its values have the hash "), 0u) << message;
}

TEST_F(BadDump, AValueThatIsNotFiniteIsNamed) {
  EXPECT_EQ(after([](hid_t f) { set_float(f, "/canvas/base", INFINITY); }),
            "/canvas/base has a value that is not finite in row 4");
}

TEST_F(BadDump, AParameterOutOfItsRangeIsNamed) {
  const std::string message = after([](hid_t f) { set_number(f, "nu_max", -1); });
  EXPECT_EQ(message.find("nu_max -1 is outside"), 0u) << message;
}

TEST_F(BadDump, AParameterThatJoinedLaterHasItsDefault) {
  EXPECT_EQ(after([](hid_t f) { H5Adelete(f, "nu_max"); }), "fine");
  EXPECT_EQ(read_state(path_)->model.nu_max_m2_s, Model{}.nu_max_m2_s);
}

/// Puts three numbers in place of an attribute.
void spoil(hid_t file, const char* group, const char* name) {
  const Handle object(H5Gopen2(file, group, H5P_DEFAULT), H5Gclose);
  if (H5Aexists(object.id(), name) > 0) H5Adelete(object.id(), name);
  const hsize_t three = 3;
  const Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
  const Handle attribute(
      H5Acreate2(object.id(), name, H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  const double values[3] = {1, 1, 1};
  H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, values);
}

TEST_F(BadDump, AnOptionalAttributeThatIsNoPlainValueIsNoMissingOne) {
  for (const char* name : {"nu_max", "scheme", "detail", "log_sha256"}) {
    EXPECT_EQ(after([&](hid_t f) { spoil(f, "/", name); }),
              name + std::string(" is missing or malformed"));
    mend();
  }
  for (const char* name : {"varnish", "occlusion", "white_x", "tone_curve"}) {
    EXPECT_EQ(after([&](hid_t f) { spoil(f, "/lighting", name); }),
              "/lighting: an attribute malformed or out of range")
        << name;
    mend();
  }
}

TEST_F(BadDump, EveryTruncationIsAnError) {
  const std::string whole = test::slurp(path_);
  const std::string cut = scratch_.path("cut.h5");
  // Each length near both ends, and every 256th between: the middle is alike.
  for (std::size_t n = 0; n < whole.size();
       n += n < 64 || n + 32 > whole.size() ? 1 : 256 * test::kStride) {
    test::spill(cut, whole.substr(0, n));
    const auto dump = read_state(cut);
    ASSERT_FALSE(dump) << "cut to " << n << " of " << whole.size();
    ASSERT_EQ(dump.error().code, ErrorCode::kBadInput);
    ASSERT_EQ(dump.error().message.find('\n'), std::string::npos);
  }
}

TEST_F(BadDump, AFlippedByteNeverGivesOtherValues) {
  // Somewhere in the middle, where the compressed planes are: either it is found, or it hit
  // padding and the values are whole.
  const std::string whole = test::slurp(path_);
  const std::string hash = state_sha256(made_up_dump(9, 7, 2, 3).state);
  for (std::size_t at = whole.size() / 3; at < whole.size() / 2; at += 97 * test::kStride) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    test::spill(path_, bytes);
    const auto dump = read_state(path_);
    EXPECT_TRUE(!dump || state_sha256(dump->state) == hash) << "byte " << at;
  }
}

TEST(ReadState, SaysWhatItCannotOpen) {
  const Scratch scratch;
  const auto missing = read_state(scratch.path("a.h5"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kIo);
  test::spill(scratch.path("a.h5"), "hello");
  const auto text = read_state(scratch.path("a.h5"));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().message, scratch.path("a.h5") + ": not an HDF5 file");
}

TEST(DescribeFile, TellsWhatADumpHolds) {
  const Scratch scratch;
  DumpOptions options;
  options.provenance = {{"software", "pentimento 0.1"}, {"command", "render a.jsonl"}};
  ASSERT_TRUE(write_state(scratch.path("a.h5"), made_up_dump(9, 7, 2, 3), options));
  const auto described = describe_file(scratch.path("a.h5"));
  ASSERT_TRUE(described) << described.error().message;
  EXPECT_EQ(described->format, "hdf5");
  EXPECT_EQ(described->width, 9);
  EXPECT_EQ(described->height, 7);
  EXPECT_EQ(described->samples, "2 layers x 3 channels");
  EXPECT_EQ(provenance_value(described->provenance, "command"), "render a.jsonl");
  EXPECT_EQ(provenance_value(described->provenance, "step"), "5692");
  EXPECT_EQ(provenance_value(described->provenance, "software"), "pentimento 0.1");
}

TEST(DescribeFile, RefusesOtherFiles) {
  const Scratch scratch;
  test::spill(scratch.path("a.txt"), "hello");
  const auto described = describe_file(scratch.path("a.txt"));
  ASSERT_FALSE(described);
  EXPECT_EQ(described.error().code, ErrorCode::kBadInput);
}

TEST(Xdmf, NamesEveryPlaneOfTheDump) {
  const Scratch scratch;
  DumpOptions options;
  options.xdmf = true;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), made_up_dump(9, 7, 2, 3), options));
  const std::string text = test::slurp(scratch.path("a.h5.xdmf"));
  EXPECT_NE(text.find("a.h5:/fluid/depth</DataItem>"), std::string::npos);
  EXPECT_NE(text.find("Dimensions=\"8 10\""), std::string::npos);  // nodes, one more than cells
  EXPECT_NE(text.find("layers/1/pigment 2"), std::string::npos);
  const auto [status, parsed] = test::run(
      "/usr/bin/python3 -c 'import sys, xml.etree.ElementTree as e; "
      "print(len(list(e.parse(sys.argv[1]).iter(\"Attribute\"))), end=\"\")' " +
      scratch.path("a.h5.xdmf"));
  EXPECT_EQ(status, 0) << parsed;
  EXPECT_EQ(parsed, "14");  // 7 planes, the reflectance, 2 x 3 pigment planes
}

}  // namespace
}  // namespace pentimento
