// Dumps of a canvas finer than the guide, written and read part by part.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/layout.h"
#include "formats/hdf5/state_dump.h"
#include "formats/hdf5/xdmf.h"
#include "formats/io/describe.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"
#include "tests/reference/made_up_canvas.h"

namespace pentimento {
namespace {

using reference::MadeUpCanvas;
using test::made_up_detail_dump;
using test::Scratch;

void expect_same_canvas(const CanvasSource& a, const CanvasSource& b) {
  ASSERT_EQ(a.geometry().width, b.geometry().width);
  ASSERT_EQ(a.geometry().height, b.geometry().height);
  const auto width = static_cast<std::size_t>(a.geometry().width);
  std::vector<float> x(width), y(width);
  std::vector<std::uint32_t> s(width), t(width);
  std::vector<PlaneId> planes = {{PlaneKind::kDepth},     {PlaneKind::kVelocityX},
                                 {PlaneKind::kVelocityY}, {PlaneKind::kBase},
                                 {PlaneKind::kPaper},     reflectance_plane(2)};
  for (int layer = 0; layer < a.layers(); ++layer)
    for (int c = 0; c < a.channels(); ++c) planes.push_back(pigment_plane(layer, c));
  for (int row = 0; row < a.geometry().height; ++row) {
    for (const PlaneId plane : planes) {
      a.read(plane, 0, row, x);
      b.read(plane, 0, row, y);
      ASSERT_EQ(x, y) << row;
    }
    a.read_strokes(0, row, s);
    b.read_strokes(0, row, t);
    ASSERT_EQ(s, t) << row;
  }
}

TEST(FineDump, GivesBackBothCanvases) {
  const Scratch scratch;
  const StateDump dump = made_up_detail_dump(11);  // 671 x 517: chunks are cut at both edges
  const auto written = write_state(scratch.path("a.h5"), dump, {});
  ASSERT_TRUE(written) << written.error().message;
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->detail, 11);
  EXPECT_EQ(back->guide_sha256, state_sha256(dump.state));
  EXPECT_EQ(back->state_sha256, detail_sha256(*dump.fine));
  EXPECT_EQ(state_sha256(back->state), state_sha256(dump.state));
  EXPECT_EQ(back->state.sleep, dump.state.sleep);
  ASSERT_TRUE(back->fine);
  expect_same_canvas(*back->fine, *dump.fine);
  EXPECT_TRUE(back->fine->status());
}

/// Writes the canvas's datasets anew: `change` says how they lie in the file, without it in one
/// piece.
void repack(const std::string& path, void (*change)(hid_t list, int rank)) {
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  for (const hdf5::CanvasDataset& what : hdf5::kCanvasDatasets) {
    const hdf5::Handle old(H5Dopen2(file.id(), what.name, H5P_DEFAULT), H5Dclose);
    const hdf5::Handle space(H5Dget_space(old.id()), H5Sclose);
    const hid_t type = what.is_integer ? H5T_NATIVE_UINT32 : H5T_NATIVE_FLOAT;
    std::vector<std::uint32_t> values(
        static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    ASSERT_GE(H5Dread(old.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    ASSERT_GE(H5Ldelete(file.id(), what.name, H5P_DEFAULT), 0);
    const hdf5::Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (change != nullptr) change(list.id(), H5Sget_simple_extent_ndims(space.id()));
    const hdf5::Handle dataset(
        H5Dcreate2(file.id(), what.name, type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
        H5Dclose);
    ASSERT_GE(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  }
}

TEST(FineDump, IsReadHoweverItLiesInTheFile) {
  const Scratch scratch;
  const StateDump dump = made_up_detail_dump(11);  // 671 x 517 cells: whole tiles and parts of some
  constexpr auto kOtherChunks = [](hid_t list, int rank) {
    std::vector<hsize_t> chunk(static_cast<std::size_t>(rank), 1);
    // As many values as in the writer's chunks.
    chunk[rank == 3 ? 0 : chunk.size() - 2] = 128;
    chunk[rank == 3 ? 1 : chunk.size() - 1] = 512;
    if (rank == 3) chunk[2] = 3;
    H5Pset_chunk(list, rank, chunk.data());
    H5Pset_shuffle(list);
    H5Pset_deflate(list, 1);
  };
  for (void (*change)(hid_t, int) : {static_cast<void (*)(hid_t, int)>(nullptr), +kOtherChunks}) {
    ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
    repack(scratch.path("a.h5"), change);
    const auto back = read_state(scratch.path("a.h5"));
    ASSERT_TRUE(back) << back.error().message;
    expect_same_canvas(*back->fine, *dump.fine);
    // It does not know which of its parts are bare.
    EXPECT_FALSE(back->fine->empty({0, 0, 1, 1}));
  }
}

TEST(FineDump, SeveralThreadsReadIt) {
  const Scratch scratch;
  const StateDump dump = made_up_detail_dump(11);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"), {7, nullptr});
  ASSERT_TRUE(back) << back.error().message;
  const CanvasSource& fine = *back->fine;
  const Threads threads(7);
  const std::vector<PlaneId> planes = {
      {PlaneKind::kDepth}, reflectance_plane(1), pigment_plane(1, 2)};
  fine.expect({0, 0, fine.geometry().width, fine.geometry().height}, planes, threads);
  std::atomic<int> wrong{0};
  threads.for_ranges(0, fine.geometry().height, 1, [&](int begin, int end) {
    const auto width = static_cast<std::size_t>(fine.geometry().width);
    std::vector<float> x(width), y(width);
    for (int row = begin; row < end; ++row)
      for (const PlaneId plane : planes) {
        fine.read(plane, 0, row, x);
        dump.fine->read(plane, 0, row, y);
        if (x != y) ++wrong;
      }
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(fine.status());
}

long resident_bytes() {
  long program_pages = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> program_pages >> pages;
  return pages * sysconf(_SC_PAGESIZE);
}

TEST(FineDump, EvenPartsTakeNoMemory) {
  class Even : public MadeUpCanvas {
   public:
    using MadeUpCanvas::MadeUpCanvas;
    void read(PlaneId, int, int, std::span<float> out) const override {
      std::fill(out.begin(), out.end(), 0.001f);
    }
  };
  const Scratch scratch;
  StateDump dump = made_up_detail_dump(32);
  dump.fine = std::make_shared<Even>(dump.fine->geometry(), 2, dump.state.channels);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  std::vector<float> row(static_cast<std::size_t>(back->fine->geometry().width));
  const long before = resident_bytes();
  for (int y = 0; y < back->fine->geometry().height; y += 256)
    for (int layer = 0; layer < 2; ++layer)
      for (int c = 0; c < dump.state.channels; ++c)
        back->fine->read(pigment_plane(layer, c), 0, y, row);
  // 288 parts of 256 KiB. Reading one at a time takes less than 1 MiB, a sanitizer keeps 16 MiB of
  // what was given back.
  EXPECT_LT(resident_bytes() - before, 24 << 20);
}

TEST(FineDump, KnowsWhereNothingIsWet) {
  // Paint in one corner: within the first of the file's chunks.
  class Corner : public MadeUpCanvas {
   public:
    using MadeUpCanvas::MadeUpCanvas;
    void read(PlaneId plane, int x, int y, std::span<float> out) const override {
      for (float& v : out) {
        const bool wet = plane.kind != PlaneKind::kBase && plane.kind != PlaneKind::kPaper &&
                         plane.kind != PlaneKind::kReflectance;
        v = wet && (x > 90 || y > 90) ? 0.0f : value(plane, x, y);
        // All alike in the last column of chunks, but not 0.
        if (plane == pigment_plane(1, 2) && x >= 512) v = 0.01f;
        ++x;
      }
    }
  };
  const Scratch scratch;
  StateDump dump = made_up_detail_dump(11);  // 671 x 517 cells
  dump.fine = std::make_shared<Corner>(dump.fine->geometry(), 2, dump.state.channels);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_FALSE(back->fine->empty({0, 0, 10, 10}));
  EXPECT_FALSE(back->fine->empty({250, 0, 20, 10}));
  EXPECT_FALSE(back->fine->empty({0, 250, 10, 20}));
  EXPECT_TRUE(back->fine->empty({256, 0, 256, 517}));
  EXPECT_TRUE(back->fine->empty({0, 256, 512, 261}));
  EXPECT_TRUE(back->fine->empty({511, 516, 1, 1}));
  EXPECT_FALSE(back->fine->empty({512, 516, 1, 1}));
}

TEST(FineDump, TheGuideIsThatOfADumpWithoutDetail) {
  const Scratch scratch;
  StateDump plain = made_up_detail_dump(4);
  plain.fine.reset();
  plain.detail = 1;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), plain, {}));
  ASSERT_TRUE(write_state(scratch.path("b.h5"), made_up_detail_dump(4), {}));
  const auto a = read_state(scratch.path("a.h5")), b = read_state(scratch.path("b.h5"));
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->guide_sha256, b->guide_sha256);
  EXPECT_EQ(a->guide_sha256, a->state_sha256);
  EXPECT_NE(b->guide_sha256, b->state_sha256);
}

TEST(FineDump, BytesDoNotDependOnThreads) {
  const Scratch scratch;
  const StateDump dump = made_up_detail_dump(8);
  const auto one = write_state(scratch.path("a.h5"), dump, {});
  DumpOptions options;
  options.threads = 7;
  const auto seven = write_state(scratch.path("b.h5"), dump, options);
  ASSERT_TRUE(one && seven);
  EXPECT_EQ(one->sha256, seven->sha256);
}

TEST(FineDump, BareCanvasTakesNoSpace) {
  // Nothing painted, nothing woven: all that is left is what says so.
  class Bare : public MadeUpCanvas {
   public:
    using MadeUpCanvas::MadeUpCanvas;
    void read(PlaneId, int, int, std::span<float> out) const override {
      std::fill(out.begin(), out.end(), 0.0f);
    }
    void read_strokes(int, int, std::span<std::uint32_t> out) const override {
      std::fill(out.begin(), out.end(), 0u);
    }
    bool empty(const CellWindow&) const override { return true; }
  };
  const Scratch scratch;
  StateDump dump = made_up_detail_dump(32);
  dump.fine = std::make_shared<Bare>(dump.fine->geometry(), 2, 3);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  // 2.9 M cells; the guide's 183 kB and minus zero in velocity_y remain.
  EXPECT_LT(std::filesystem::file_size(scratch.path("a.h5")), 600'000u);
  EXPECT_TRUE(read_state(scratch.path("a.h5")));
}

TEST(FineDump, OtherProgramsReadIt) {
  const Scratch scratch;
  const StateDump dump = made_up_detail_dump(11);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  test::spill(scratch.path("check.py"), R"(
import h5py, numpy as np, sys
f = h5py.File(sys.argv[1], 'r')
assert f.attrs['detail'] == 11 and f.attrs['format_version'] == 3
assert f['/fluid/depth'].shape == (517, 671) and f['/guide/fluid/depth'].shape == (47, 61)
assert f['/layers/pigment'].shape == (2, 3, 517, 671)
assert f['/guide/layers/pigment'].shape == (2, 3, 47, 61)
assert f['/guide/canvas/reflectance'].shape == (47, 61, 3)
assert '/guide/fluid/asleep' in f and '/fluid/asleep' not in f
assert np.all(f['/fluid/height'][...] == f['/canvas/base'][...] + f['/fluid/depth'][...])
assert f['/layers/stroke'][...].max() > 0
)");
  const auto [status, text] =
      test::run("/usr/bin/python3 " + scratch.path("check.py") + " " + scratch.path("a.h5"));
  EXPECT_EQ(status, 0) << text;
  EXPECT_NE(xdmf_text(scratch.path("a.h5"), dump).find("518 672"), std::string::npos);
}

TEST(FineDump, InfoTellsTheDetail) {
  const Scratch scratch;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), made_up_detail_dump(5), {}));
  const auto told = describe_state(scratch.path("a.h5"));
  ASSERT_TRUE(told);
  EXPECT_EQ(told->width, 305);
  EXPECT_EQ(provenance_value(told->provenance, "detail"), "5");
}

TEST(FineDump, IsRefusedWithAValueChanged) {
  const Scratch scratch;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), made_up_detail_dump(5), {}));
  test::spill(scratch.path("change.py"), R"(
import h5py, sys
with h5py.File(sys.argv[1], 'r+') as f:
    if sys.argv[2] == 'detail': f.attrs['detail'] = 4
    else: f[sys.argv[2]][40, 50] += float(sys.argv[3])
)");
  const auto after = [&](const std::string& change) {
    std::filesystem::copy_file(scratch.path("a.h5"), scratch.path("b.h5"),
                               std::filesystem::copy_options::overwrite_existing);
    const auto [status, text] = test::run("/usr/bin/python3 " + scratch.path("change.py") + " " +
                                          scratch.path("b.h5") + " " + change);
    EXPECT_EQ(status, 0) << text;
    const auto dump = read_state(scratch.path("b.h5"));
    EXPECT_FALSE(dump);
    return dump ? std::string() : dump.error().message;
  };
  EXPECT_NE(after("/fluid/depth 1").find("have the hash"), std::string::npos);
  EXPECT_NE(after("/guide/fluid/depth 1").find("have the hash"), std::string::npos);
  EXPECT_NE(after("/fluid/depth inf").find("not finite"), std::string::npos);
  EXPECT_NE(after("detail").find("not 4 times its guide"), std::string::npos);
}

/// A canvas whose reader is interrupted when it comes to the reflectance.
class Interrupting : public MadeUpCanvas {
 public:
  Interrupting(const CanvasGeometry& grid, std::atomic<bool>& cancelled)
      : MadeUpCanvas(grid, 2, 3), cancelled_(cancelled) {}
  void read(PlaneId plane, int x, int y, std::span<float> out) const override {
    MadeUpCanvas::read(plane, x, y, out);
    if (plane.kind == PlaneKind::kReflectance) cancelled_ = true;
    if (plane.kind == PlaneKind::kPigment) read_on_ = true;
  }
  bool read_on() const { return read_on_; }

 private:
  std::atomic<bool>& cancelled_;
  mutable std::atomic<bool> read_on_ = false;
};

TEST(FineDump, WritingHearsASignal) {
  const Scratch scratch;
  StateDump dump = made_up_detail_dump(11);
  std::atomic<bool> cancelled = false;
  const auto canvas = std::make_shared<Interrupting>(dump.fine->geometry(), cancelled);
  dump.fine = canvas;
  dump.state_sha256 = std::string(64, '0');  // else the hash would hear it
  DumpOptions options;
  options.cancelled = &cancelled;
  const auto written = write_state(scratch.path("a.h5"), dump, options);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kInterrupted);
  EXPECT_FALSE(canvas->read_on());
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path("")));
}

TEST(FineDump, WritingAGuideHearsASignal) {
  const Scratch scratch;
  const StateDump dump = test::made_up_dump(61, 47, 2, 3);
  const std::atomic<bool> cancelled = true;
  DumpOptions options;
  options.cancelled = &cancelled;
  const auto written = write_state(scratch.path("a.h5"), dump, options);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kInterrupted);
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path("")));
}

TEST(FineDump, AFullDiskIsAnErrorAndNoCrash) {
  // /dev/full cannot be mapped or renamed; a limit on the size of files takes the same path.
  const Scratch scratch;
  const StateDump dump = made_up_detail_dump(16);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{100}, rlim_t{5000}, rlim_t{1'500'000}}) {
    rlimit low = old;
    low.rlim_cur = bytes;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &low), 0);
    const auto written = write_state(scratch.path("a.h5"), dump, {});
    setrlimit(RLIMIT_FSIZE, &old);
    ASSERT_FALSE(written) << bytes;
    EXPECT_EQ(written.error().code, ErrorCode::kIo);
    EXPECT_FALSE(std::filesystem::exists(scratch.path("a.h5")));
  }
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
}

}  // namespace
}  // namespace pentimento
