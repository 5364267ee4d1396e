#include "formats/hdf5/state_dump.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/optics/paints/paint_maker.h"
#include "formats/io/provenance.h"
#include "tests/core/base/resident_memory.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::made_up_dump;
using test::Scratch;

// The interpreter of the distribution: it has the distribution's h5py.
constexpr const char* kPython = "/usr/bin/python3 ";

template <typename T>
void expect_same_bits(const Field<T>& a, const Field<T>& b) {
  ASSERT_EQ(a.width(), b.width());
  ASSERT_EQ(a.height(), b.height());
  for (int y = 0; y < a.height(); ++y)
    ASSERT_EQ(std::memcmp(a.row(y), b.row(y), sizeof(T) * static_cast<std::size_t>(a.width())), 0)
        << "row " << y;
}

void expect_same_state(const CanvasState& a, const CanvasState& b) {
  EXPECT_EQ(a.geometry.width_m, b.geometry.width_m);
  EXPECT_EQ(a.geometry.height_m, b.geometry.height_m);
  EXPECT_EQ(a.layers, b.layers);
  EXPECT_EQ(a.channels, b.channels);
  EXPECT_EQ(a.step, b.step);
  expect_same_bits(a.depth_m, b.depth_m);
  expect_same_bits(a.velocity_x_m_s, b.velocity_x_m_s);
  expect_same_bits(a.velocity_y_m_s, b.velocity_y_m_s);
  expect_same_bits(a.base_m, b.base_m);
  expect_same_bits(paper_relief_of(a), paper_relief_of(b));
  expect_same_bits(a.stroke, b.stroke);
  EXPECT_EQ(a.sleep, b.sleep);
  ASSERT_EQ(a.pigment.size(), b.pigment.size());
  for (std::size_t i = 0; i < a.pigment.size(); ++i) expect_same_bits(a.pigment[i], b.pigment[i]);
  for (std::size_t i = 0; i < a.reflectance.size(); ++i)
    expect_same_bits(a.reflectance[i].values(), b.reflectance[i].values());
}

void expect_same_light(const Lighting& a, const Lighting& b) {
  EXPECT_EQ(a.lamps, b.lamps);
  EXPECT_EQ(a.varnish, b.varnish);
  EXPECT_EQ(a.occlusion, b.occlusion);
  EXPECT_EQ(a.white_xy, b.white_xy);
  EXPECT_EQ(a.tone, b.tone);
  EXPECT_EQ(a.environment.L, b.environment.L);
  EXPECT_EQ(a.reflection.fov_deg, b.reflection.fov_deg);
  EXPECT_EQ(a.reflection.mirror, b.reflection.mirror);
  for (std::size_t c = 0; c < 3; ++c) expect_same_bits(a.reflection.rgb[c], b.reflection.rgb[c]);
  for (std::size_t c = 0; c < 3; ++c) expect_same_bits(a.probe[c], b.probe[c]);
  EXPECT_EQ(a.roughness_wet, b.roughness_wet);
  EXPECT_EQ(a.roughness_dry, b.roughness_dry);
  EXPECT_EQ(a.refractive_index, b.refractive_index);
  EXPECT_EQ(a.relief_scale, b.relief_scale);
  EXPECT_EQ(a.exposure_ev, b.exposure_ev);
}

class DumpShape : public testing::TestWithParam<std::tuple<int, int, int, int>> {};
// Sizes below, at and beyond one chunk; no pigments; optical channels (12 pigments).
INSTANTIATE_TEST_SUITE_P(Shapes, DumpShape,
                         testing::Values(std::tuple{1, 1, 1, 1}, std::tuple{61, 47, 2, 3},
                                         std::tuple{300, 450, 2, 2}, std::tuple{20, 10, 8, 12},
                                         std::tuple{20, 10, 2, 0}));

TEST(StateDump, KeepsTheWavelengthsOfItsBands) {
  const Scratch scratch;
  StateDump dump = made_up_dump(20, 10, 2, 3);
  dump.model.optics = OpticsKind::kSpectral;
  dump.model.bands = 38;
  dump.model.saunderson_k2 = 0.65f;
  const PaintMaker maker(dump.model);
  dump.palette = {maker.from_color("a", {0.1f, 0.2f, 0.3f}), *maker.from_library("cadmium red"),
                  *maker.from_library("golden cobalt blue")};
  dump.basis = make_channels(dump.palette, maker.wavelength_nm());
  dump.state.bands = 38;
  while (dump.state.reflectance.size() < 38)
    dump.state.reflectance.push_back(dump.state.reflectance.front().clone());
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->basis.wavelength_nm, maker.wavelength_nm());
  EXPECT_EQ(back->model.saunderson_k2, 0.65f);
  EXPECT_EQ(back->palette[2].K, dump.palette[2].K);
  expect_same_state(back->state, dump.state);
  dump.model.bands = 13;
  ASSERT_TRUE(write_state(scratch.path("b.h5"), dump, {}));
  const auto wrong = read_state(scratch.path("b.h5"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("38 bands, the model 13"), std::string::npos);
}

TEST(StateDump, ItsGroundIsThatOfItsCorner) {
  const Scratch scratch;
  StateDump dump = made_up_dump(20, 10, 2, 3);
  dump.state.reflectance[1].fill(0.6f);
  dump.state.reflectance[1].set(7, 4, 0.1f);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  const GroundPlane& plane = back->state.reflectance[1];
  EXPECT_EQ(plane.ground(), 0.6f);
  EXPECT_EQ(plane(7, 4), 0.1f);
  // So it takes memory only where it was painted.
  for (int x = 0; x < 20; ++x) EXPECT_EQ(plane.differences().bits()(x, 4) != 0, x == 7);
}

TEST_P(DumpShape, ComesBackBitForBit) {
  const Scratch scratch;
  const auto [width, height, layers, pigments] = GetParam();
  const StateDump dump = made_up_dump(width, height, layers, pigments);
  DumpOptions options;
  options.provenance = {{"software", "pentimento 0.1 (test)"}, {"command", "render"}};
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, options));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  expect_same_state(back->state, dump.state);
  expect_same_light(back->lighting, dump.lighting);
  EXPECT_EQ(back->basis.name, dump.basis.name);
  EXPECT_EQ(back->basis.K, dump.basis.K);
  EXPECT_EQ(back->basis.S, dump.basis.S);
  EXPECT_EQ(back->basis.amount, dump.basis.amount);
  EXPECT_EQ(back->basis.load, dump.basis.load);
  EXPECT_EQ(back->palette.size(), dump.palette.size());
  EXPECT_EQ(back->model.nu_max_m2_s, dump.model.nu_max_m2_s);
  EXPECT_EQ(back->model.scheme, dump.model.scheme);
  EXPECT_EQ(back->time_s, dump.time_s);
  EXPECT_EQ(back->log_sha256, dump.log_sha256);
  EXPECT_EQ(back->state_sha256, state_sha256(dump.state));
  EXPECT_EQ(provenance_value(back->provenance, "command"), "render");
}

TEST(StateDump, BytesDoNotDependOnThreads) {
  const Scratch scratch;
  const StateDump dump = made_up_dump(300, 450, 2, 2);
  const auto one = write_state(scratch.path("a.h5"), dump, {});
  DumpOptions options;
  options.threads = 7;
  const auto seven = write_state(scratch.path("b.h5"), dump, options);
  ASSERT_TRUE(one && seven);
  EXPECT_EQ(one->sha256, seven->sha256);
}

TEST(StateDump, EmptyCanvasTakesLittleSpace) {
  const Scratch scratch;
  StateDump dump = made_up_dump(8, 8, 2, 2);
  dump.state = make_canvas_state({1024, 768, 1, 0.75}, 2, 2, 3, 0);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  // 38 MB of zeros; what is stored is minus zero in velocity_y, and the structure of the file.
  EXPECT_LT(std::filesystem::file_size(scratch.path("a.h5")), 200'000u);
}

TEST(StateDump, ABareCanvasTakesNoMemoryWhenItIsRead) {
  if (is_marked_when_given()) GTEST_SKIP();
  const Scratch scratch;
  StateDump dump = made_up_dump(8, 8, 2, 2);
  dump.state = make_canvas_state({2560, 2048, 1, 0.8}, 2, 2, 3, 0);
  dump.state.velocity_y_m_s(700, 900) = 0.1f;
  dump.state.velocity_x_m_s(1100, 900) = -0.0f;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const long before_mib = resident_mib();
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  // Nine planes of paint would be 180 MiB. To find that they are bare may take as much as reading.
  EXPECT_LT(resident_mib() - before_mib, 20 + taken_by_reading_mib(180));
  expect_same_state(back->state, dump.state);
}

TEST(StateDump, H5dumpReadsEverything) {
  const Scratch scratch;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), made_up_dump(61, 47, 2, 3), {}));
  const auto [status, text] = test::run("h5dump " + scratch.path("a.h5") + " | tail -c 200");
  EXPECT_EQ(status, 0) << text;
  const auto [header_status, header] = test::run("h5dump -Hp " + scratch.path("a.h5"));
  EXPECT_EQ(header_status, 0);
  for (const char* word : {"SHUFFLE", "DEFLATE", "velocity_y", "pentimento-state"})
    EXPECT_NE((header + test::run("h5dump -a format " + scratch.path("a.h5")).second).find(word),
              std::string::npos)
        << word;
}

TEST(StateDump, H5pyReadsWhatTheTableOfDatasetsPromises) {
  const Scratch scratch;
  const StateDump dump = made_up_dump(61, 47, 2, 3);
  DumpOptions options;
  options.provenance = {{"software", "pentimento 0.1 (test)"}};
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, options));
  test::spill(scratch.path("check.py"), R"(
import h5py, numpy as np, sys
f = h5py.File(sys.argv[1], 'r')
shapes = {'/fluid/height': (47, 61), '/fluid/depth': (47, 61), '/fluid/velocity_x': (47, 61),
          '/fluid/velocity_y': (47, 61), '/canvas/base': (47, 61), '/canvas/paper': (47, 61),
          '/canvas/reflectance': (47, 61, 3), '/layers/pigment': (2, 3, 47, 61),
          '/layers/stroke': (47, 61), '/layers/channel': (3,), '/palette/name': (3,),
          '/palette/K': (3, 3), '/palette/S': (3, 3), '/palette/wavelength': (3,),
          '/lighting/sh': (9, 3), '/fluid/asleep': (8 * 6, 5)}  # tiles of 8 cells
for name, shape in shapes.items():
    assert f[name].shape == shape, (name, f[name].shape)
    assert 'units' in f[name].attrs and 'long_name' in f[name].attrs, name
assert f['/layers/stroke'].dtype == np.uint32
assert f['/fluid/depth'].attrs['units'] == 'm'
assert np.all(f['/fluid/height'][...] == f['/canvas/base'][...] + f['/fluid/depth'][...])
assert np.all(f['/fluid/velocity_y'][...] >= 0)  # the made-up state runs down in no cell
assert f.attrs['format'] == 'pentimento-state' and f.attrs['format_version'] == 1
assert f.attrs['canvas_width_m'] == 0.6 and f.attrs['step'] == 5692
assert abs(f.attrs['nu_max'] - 0.02) < 1e-9 and f.attrs['scheme'] == 'conservative'
assert f.attrs['software'] == 'pentimento 0.1 (test)'
assert f.attrs['guide_sha256'] == f.attrs['state_sha256']
print(f['/palette/name'][1].decode(), end='')
)");
  const auto [status, text] =
      test::run(kPython + scratch.path("check.py") + " " + scratch.path("a.h5"));
  EXPECT_EQ(status, 0) << text;
  EXPECT_EQ(text, "pigment 1");
}

}  // namespace
}  // namespace pentimento
