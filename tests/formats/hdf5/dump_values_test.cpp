// Every value that a dump holds is finite and in its range, or the dump is refused.

#include <cmath>
#include <limits>

#include "formats/io/provenance.h"
#include "tests/formats/hdf5/changed_dump.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

class DumpValues : public test::ChangedDump {
 protected:
  /// Sets the first value of a dataset of any shape.
  static void set_first(hid_t file, const char* name, double value) {
    const Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    const hsize_t one = 1;
    const std::vector<hsize_t> at(8, 0);
    H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, at.data());
    const Handle memory(H5Screate_simple(1, &one, nullptr), H5Sclose);
    ASSERT_GE(
        H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, &value), 0)
        << name;
  }
  static void set_of_group(hid_t file, const char* group, const char* name, double value) {
    const Handle opened(H5Gopen2(file, group, H5P_DEFAULT), H5Gclose);
    set_number(opened.id(), name, value);
  }
};

TEST_F(DumpValues, NoDatasetMayHoldWhatIsNotFinite) {
  int number = 0;
  for (const char* name : {"/fluid/depth",
                           "/fluid/velocity_x",
                           "/fluid/velocity_y",
                           "/canvas/base",
                           "/canvas/paper",
                           "/canvas/reflectance",
                           "/layers/pigment",
                           "/fluid/asleep",
                           "/layers/K",
                           "/layers/S",
                           "/layers/amount",
                           "/layers/load",
                           "/palette/K",
                           "/palette/S",
                           "/lighting/lamp_direction",
                           "/lighting/lamp_color",
                           "/lighting/lamp_position",
                           "/lighting/more_lamps",
                           "/lighting/sh",
                           "/lighting/probe",
                           "/lighting/reflection"})
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()}) {
      if (number++ % test::kStride != 0) continue;
      SCOPED_TRACE(name);
      EXPECT_NE(after([&](hid_t f) { set_first(f, name, value); }), "fine");
      EXPECT_EQ(code_, ErrorCode::kBadInput);
      mend();
    }
}

TEST_F(DumpValues, NoDatasetMayHoldWhatOverflows) {
  for (const char* name :
       {"/fluid/depth", "/fluid/velocity_x", "/canvas/base", "/canvas/reflectance",
        "/layers/pigment", "/fluid/asleep", "/layers/K", "/layers/load", "/palette/S",
        "/lighting/lamp_direction", "/lighting/lamp_color", "/lighting/lamp_position",
        "/lighting/more_lamps", "/lighting/sh", "/lighting/probe", "/lighting/reflection"}) {
    SCOPED_TRACE(name);
    EXPECT_NE(after([&](hid_t f) { set_first(f, name, 3e38); }), "fine");
    EXPECT_EQ(code_, ErrorCode::kBadInput);
    mend();
  }
}

TEST_F(DumpValues, AValueOutOfItsRangeIsNamed) {
  EXPECT_EQ(after([](hid_t f) { set_float(f, "/fluid/depth", 3e38f); }),
            "/fluid/depth has the value 3e+38, outside 0..1000 in row 4");
  EXPECT_EQ(after([](hid_t f) { set_float(f, "/fluid/depth", -0.001f); }),
            "/fluid/depth has the value -0.001, outside 0..1000 in row 4");
  mend();
  EXPECT_EQ(after([](hid_t f) { set_first(f, "/palette/K", -1); }),
            "/palette/K has the value -1, outside 0..1000000000");
  mend();
  EXPECT_EQ(after([](hid_t f) { set_first(f, "/lighting/sh", std::nan("")); }),
            "/lighting/sh has a value that is not finite");
}

TEST_F(DumpValues, NumbersOfTheRootHaveRanges) {
  for (const auto& [name, value] : {std::pair{"time_s", std::nan("")},
                                    {"time_s", -1.0},
                                    {"step", -1.0},
                                    {"step", 9e18},
                                    {"steps_per_second", 1e300},
                                    {"steps_per_second", std::nan("")},
                                    {"canvas_width_m", 1e9},
                                    {"canvas_height_m", std::nan("")},
                                    {"canvas_height_m", -1.0},
                                    {"nu_max", std::nan("")}}) {
    SCOPED_TRACE(name);
    EXPECT_NE(after([&, key = name, number = value](hid_t f) { set_number(f, key, number); }),
              "fine");
    EXPECT_EQ(code_, ErrorCode::kBadInput);
    mend();
  }
  EXPECT_EQ(after([](hid_t f) { set_number(f, "nu_min", 900); }),
            "nu_min 900 is not below nu_max 0.02");
}

TEST_F(DumpValues, NumbersOfTheLightHaveRanges) {
  int number = 0;
  for (const char* name : {"lamp_intensity", "reflection_fov_deg", "roughness_wet", "roughness_dry",
                           "refractive_index", "relief_scale", "exposure_ev", "varnish",
                           "occlusion", "white_x", "white_y"})
    for (const double value : {std::nan(""), 3e38, -3e38}) {
      if (number++ % test::kStride != 0) continue;
      SCOPED_TRACE(name);
      EXPECT_NE(after([&](hid_t f) { set_of_group(f, "/lighting", name, value); }), "fine");
      EXPECT_EQ(code_, ErrorCode::kBadInput);
      mend();
    }
  EXPECT_EQ(after([](hid_t f) { set_of_group(f, "/lighting", "roughness_wet", 0); }),
            "roughness_wet has the value 0, outside 0.001..1");
}

TEST_F(DumpValues, ALampIsSomewhere) {
  EXPECT_EQ(after([](hid_t f) {
              for (hsize_t i = 0; i < 3; ++i) {
                const Handle dataset(H5Dopen2(f, "/lighting/lamp_position", H5P_DEFAULT), H5Dclose);
                const float zero[3] = {};
                H5Dwrite(dataset.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, zero);
              }
            }),
            "/lighting: lamps of a wrong shape, or a value out of range");
}

TEST_F(DumpValues, WhatADumpSaysIsQuotedInOneLineAndCutShort) {
  const auto twice = [](const std::string& name) {
    return [name](hid_t f) {
      const Handle dataset(H5Dopen2(f, "/palette/name", H5P_DEFAULT), H5Dclose);
      const Handle type(H5Dget_type(dataset.id()), H5Tclose);
      const char* names[] = {name.c_str(), "b", name.c_str()};
      H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, names);
    };
  };
  EXPECT_EQ(after(twice("two\nlines\x1b[31m")), "/palette/name has \"two lines [31m\" twice");
  const std::string said = after(twice(std::string(5000, 'x')));
  EXPECT_LT(said.size(), 320);
  EXPECT_TRUE(said.starts_with("/palette/name has \"xxx")) << said;
}

TEST_F(DumpValues, TwoPigmentsOfOneNameAreRefused) {
  for (const char* name : {"/palette/name", "/layers/channel"}) {
    EXPECT_EQ(after([&](hid_t f) {
                const Handle dataset(H5Dopen2(f, name, H5P_DEFAULT), H5Dclose);
                const Handle type(H5Dget_type(dataset.id()), H5Tclose);
                const char* names[] = {"a", "b", "a"};
                H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, names);
              }),
              std::string(name) + " has \"a\" twice");
    mend();
  }
}

TEST_F(DumpValues, BandsFitTheOptics) {
  EXPECT_EQ(after([](hid_t f) {
              for (const char* name : {"/canvas/reflectance", "/layers/K", "/layers/S"})
                H5Ldelete(f, name, H5P_DEFAULT);
              const hsize_t shape[] = {7, 9, 4};
              const Handle space(H5Screate_simple(3, shape, nullptr), H5Sclose);
              const Handle made(H5Dcreate2(f, "/canvas/reflectance", H5T_IEEE_F32LE, space.id(),
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                H5Dclose);
              for (const char* name : {"/palette/K", "/palette/S", "/palette/wavelength"}) {
                H5Ldelete(f, name, H5P_DEFAULT);
                const hsize_t of_palette[] = {3, 4}, of_bands[] = {4};
                const bool bands = std::string(name) == "/palette/wavelength";
                const Handle plane(
                    H5Screate_simple(bands ? 1 : 2, bands ? of_bands : of_palette, nullptr),
                    H5Sclose);
                const Handle dataset(H5Dcreate2(f, name, H5T_IEEE_F64LE, plane.id(), H5P_DEFAULT,
                                                H5P_DEFAULT, H5P_DEFAULT),
                                     H5Dclose);
              }
            }),
            "/canvas/reflectance has 4 bands, the model 3");
}

TEST_F(DumpValues, TextThatIsNoUtf8IsMended) {
  EXPECT_EQ(after([](hid_t f) {
              const Handle notes(H5Gopen2(f, "/provenance", H5P_DEFAULT), H5Gclose);
              const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
              H5Tset_size(type.id(), 4);
              const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
              const Handle made(
                  H5Acreate2(notes.id(), "note", type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                  H5Aclose);
              H5Awrite(made.id(), type.id(), "a\xff\xfe");
            }),
            "fine");
  EXPECT_EQ(provenance_value(read_state(path_)->provenance, "note"), "a\uFFFD\uFFFD");
}

}  // namespace
}  // namespace pentimento
