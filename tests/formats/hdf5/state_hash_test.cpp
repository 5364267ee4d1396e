// What is hashed of a state, as docs/state-format.md says it.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <atomic>
#include <memory>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/state_dump.h"
#include "formats/hdf5/write_small.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using reference::MadeUpCanvas;
using test::made_up_detail_dump;
using test::made_up_dump;
using test::Scratch;

/// What the script in docs/state-format.md prints for a dump that is written now.
std::string documented_hash(const StateDump& dump) {
  const Scratch scratch;
  const std::string page = test::slurp(PENTIMENTO_SOURCE_DIR "/docs/state-format.md");
  const std::size_t begin = page.find("```python\n") + 10;
  test::spill(scratch.path("hash.py"), page.substr(begin, page.find("```", begin) - begin));
  if (!write_state(scratch.path("a.h5"), dump, {})) return "not written";
  // The interpreter of the distribution: it has the distribution's h5py.
  return test::run("/usr/bin/python3 " + scratch.path("hash.py") + " " + scratch.path("a.h5"))
      .second;
}

TEST(StateHash, TheDocumentedScriptFindsTheSameHash) {
  const StateDump dump = made_up_dump(61, 47, 2, 3);
  EXPECT_EQ(documented_hash(dump), state_sha256(dump.state) + "\n");
}

TEST(StateHash, TheDocumentedScriptFindsTheSameHashWhereAllIsAwake) {
  const Scratch scratch;
  StateDump dump = made_up_dump(61, 47, 2, 3);
  dump.state.sleep.clear();
  EXPECT_EQ(documented_hash(dump), state_sha256(dump.state) + "\n");
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  const auto back = read_state(scratch.path("a.h5"));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->state.sleep.empty());
}

TEST(StateHash, ChangesWithEveryPlane) {
  const StateDump dump = made_up_dump(9, 8, 2, 1);
  const std::string before = state_sha256(dump.state);
  const auto changed = [&](auto&& change) {
    StateDump other = made_up_dump(9, 8, 2, 1);
    change(other.state);
    return state_sha256(other.state) != before;
  };
  EXPECT_FALSE(changed([](CanvasState&) {}));
  EXPECT_TRUE(changed([](CanvasState& s) { s.depth_m(8, 7) += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.velocity_x_m_s(8, 7) += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.velocity_y_m_s(8, 7) += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.base_m(8, 7) += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.paper.set(8, 7, s.base_m(8, 7), 1); }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.reflectance[2].set(8, 7, 1); }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.channel(1, 0)(8, 7) += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.stroke(8, 7) += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.step += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.sleep.back() += 1; }));
  EXPECT_TRUE(changed([](CanvasState& s) { s.sleep.clear(); }));
}

TEST(StateHash, IsFrozen) {
  // Computed once; a change here means that hashes in old dumps and reports no longer match, so
  // the format version must rise.
  const CanvasState state = make_canvas_state({4, 3, 1, 0.75}, 2, 1, 3, 0.5f);
  EXPECT_EQ(state_sha256(state),
            "0b060e9449b4c6c767c632671828ac8ea3b4ef09af00368a16baa88d16438dc7");
}

TEST(DetailHash, TheDocumentedScriptFindsTheSameHash) {
  // 671 x 517 cells: whole parts, parts that are cut, and parts that are empty.
  const StateDump dump = made_up_detail_dump(11);
  EXPECT_EQ(documented_hash(dump), detail_sha256(*dump.fine) + "\n");
}

TEST(DetailHash, DoesNotDependOnThreads) {
  const StateDump dump = made_up_detail_dump(11);
  const std::string one = detail_sha256(*dump.fine);
  for (const int threads : {2, 7}) EXPECT_EQ(detail_sha256(*dump.fine, Threads(threads)), one);
  EXPECT_EQ(detail_sha256(*dump.fine, Threads::backwards()), one);
}

/// A canvas with one value changed in the last cell of its last part.
class Touched : public MadeUpCanvas {
 public:
  Touched(const CanvasGeometry& grid, PlaneId plane) : MadeUpCanvas(grid, 2, 3), plane_(plane) {}
  void read(PlaneId plane, int x, int y, std::span<float> out) const override {
    MadeUpCanvas::read(plane, x, y, out);
    const bool last = y == geometry().height - 1 &&
                      x + static_cast<int>(out.size()) == geometry().width && plane == plane_;
    if (last) out.back() += 1;
  }
  bool empty(const CellWindow& window) const override {
    return window.x + window.width < geometry().width && MadeUpCanvas::empty(window);
  }

 private:
  PlaneId plane_;
};

TEST(DetailHash, ChangesWithEveryPlane) {
  const CanvasGeometry grid = made_up_detail_dump(11).fine->geometry();
  const std::string before = detail_sha256(MadeUpCanvas(grid, 2, 3));
  for (const PlaneId plane :
       {PlaneId{PlaneKind::kDepth}, PlaneId{PlaneKind::kVelocityX}, PlaneId{PlaneKind::kVelocityY},
        PlaneId{PlaneKind::kBase}, PlaneId{PlaneKind::kPaper}, reflectance_plane(0),
        reflectance_plane(2), pigment_plane(0, 0), pigment_plane(1, 2)})
    EXPECT_NE(detail_sha256(Touched(grid, plane)), before) << static_cast<int>(plane.kind);
  EXPECT_EQ(detail_sha256(Touched(grid, pigment_plane(2, 0))), before);  // which it does not have
}

/// A canvas all of whose values are 0, but those of one plane, which are alike up to the last.
class Flat : public MadeUpCanvas {
 public:
  Flat(const CanvasGeometry& grid, float value, float last)
      : MadeUpCanvas(grid, 2, 3), value_(value), last_(last) {}
  void read(PlaneId plane, int x, int y, std::span<float> out) const override {
    const bool is_base = plane.kind == PlaneKind::kBase;
    std::fill(out.begin(), out.end(), is_base ? value_ : 0.0f);
    if (is_base && y == geometry().height - 1 &&
        x + static_cast<int>(out.size()) == geometry().width)
      out.back() = last_;
  }
  void read_strokes(int, int, std::span<std::uint32_t> out) const override {
    std::fill(out.begin(), out.end(), 0u);
  }
  bool empty(const CellWindow&) const override { return true; }

 private:
  float value_, last_;
};

TEST(DetailHash, PartsOfOneValueAreHashedByTheirValueAndSize) {
  StateDump dump = made_up_detail_dump(11);
  const CanvasGeometry grid = dump.fine->geometry();
  for (const auto& [value, last] : {std::pair{0.0f, 0.0f}, {0.25f, 0.25f}, {0.25f, 0.5f}}) {
    dump.fine = std::make_shared<Flat>(grid, value, last);
    EXPECT_EQ(documented_hash(dump), detail_sha256(*dump.fine) + "\n");
  }
}

TEST(DetailHash, IsFrozen) {
  // As StateHash.IsFrozen: a change here means that the format version must rise.
  EXPECT_EQ(detail_sha256(*made_up_detail_dump(11).fine),
            "ed37555791555d61219ca28ee0b44488a9cb03b812f43b3df8414a77458dcf1c");
}

TEST(DetailHash, StopsWhenItIsCancelled) {
  const StateDump dump = made_up_detail_dump(11);
  const std::atomic<bool> cancelled = true;
  EXPECT_NE(detail_sha256(*dump.fine, Threads(1), &cancelled), detail_sha256(*dump.fine));
}

/// Writes a dump of version 3, calls it one of `version` with this hash, and reads it.
Result<StateDump> read_as(std::int64_t version, const std::string& hash) {
  const Scratch scratch;
  const std::string path = scratch.path("a.h5");
  EXPECT_TRUE(write_state(path, made_up_detail_dump(11), {}));
  {
    const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    for (const char* name : {"format_version", "state_sha256"}) H5Adelete(file.id(), name);
    EXPECT_TRUE(hdf5::set_attribute(file.id(), "format_version", version));
    EXPECT_TRUE(hdf5::set_attribute(file.id(), "state_sha256", std::string_view(hash)));
  }
  return read_state(path);
}

TEST(DetailHash, DumpsOfVersion2HaveTheSerialHash) {
  const StateDump dump = made_up_detail_dump(11);
  const std::string serial = serial_sha256(*dump.fine), parts = detail_sha256(*dump.fine);
  const auto back = read_as(2, serial);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->state_sha256, serial);
  EXPECT_TRUE(read_as(3, parts));
  EXPECT_FALSE(read_as(2, parts));
  EXPECT_FALSE(read_as(3, serial));
}

TEST(DetailHash, TheSerialOneIsThatOfAStateInWhichNothingSleeps) {
  StateDump dump = made_up_dump(61, 47, 2, 3);
  dump.state.sleep.clear();
  EXPECT_EQ(serial_sha256(StateSource(dump.state)), state_sha256(dump.state));
}

}  // namespace
}  // namespace pentimento
