#include "formats/hdf5/xdmf.h"

#include <gtest/gtest.h>

#include "core/canvas/canvas_source.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;

/// What a reader of XML finds in the grid of `dump`'s file: nodes, origin, spacing and time. XDMF
/// names y before x.
std::string grid_read(const StateDump& dump) {
  const Scratch scratch;
  test::spill(scratch.path("a.xdmf"), xdmf_text("a.h5", dump));
  test::spill(scratch.path("read.py"), R"(
import sys, xml.etree.ElementTree as e
grid = e.parse(sys.argv[1]).find('Domain/Grid')
origin, spacing = (item.text.split() for item in grid.findall('Geometry/DataItem'))
print('nodes', grid.find('Topology').get('Dimensions'))
print('origin', *origin)
print('spacing', *('%.9f' % float(s) for s in spacing))
print('time', grid.find('Time').get('Value'), end='')
)");
  return test::run("/usr/bin/python3 " + scratch.path("read.py") + " " + scratch.path("a.xdmf"))
      .second;
}

TEST(Xdmf, SpacesTheCellsOverTheCanvas) {
  // 0.6 x 0.45 m on 9 x 7 cells: 0.45 / 7 down and 0.6 / 9 across, which differ.
  EXPECT_EQ(grid_read(test::made_up_dump(9, 7, 2, 3)),
            "nodes 8 10\norigin 0 0\nspacing 0.064285714 0.066666667\ntime 126.5");
}

TEST(Xdmf, SpacesTheCellsOfAFinerCanvasSoThatItIsAsLarge) {
  StateDump dump = test::made_up_dump(9, 7, 2, 3);
  // A canvas three times finer of the same shape: only its number of cells is looked at.
  CanvasGeometry fine = dump.state.geometry;
  fine.width *= 3;
  fine.height *= 3;
  const CanvasState state = make_canvas_state(fine, 2, dump.basis.channels(), 3, 0.9f);
  dump.detail = 3;
  dump.fine = std::make_shared<StateSource>(state);
  EXPECT_EQ(grid_read(dump),
            "nodes 22 28\norigin 0 0\nspacing 0.021428571 0.022222222\ntime 126.5");
}

TEST(Xdmf, NamesMayHaveTheSignsOfXml) {
  StateDump dump = test::made_up_dump(9, 7, 2, 3);
  dump.basis.name[0] = "red & \"pale\" <1>";
  EXPECT_EQ(grid_read(dump).substr(0, 5), "nodes");  // the text is well-formed
}

TEST(Xdmf, AReaderOfTheSlabsFindsThePlaneThatIsNamed) {
  const Scratch scratch;
  DumpOptions options;
  options.xdmf = true;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), test::made_up_dump(9, 7, 2, 3), options));
  test::spill(scratch.path("read.py"), R"(
import sys, h5py, xml.etree.ElementTree as e
f = h5py.File(sys.argv[1], 'r')
for plane in e.parse(sys.argv[1] + '.xdmf').iter('Attribute'):
    slab = plane.find('DataItem')
    if slab.get('ItemType') != 'HyperSlab': continue
    words = [int(w) for w in slab[0].text.split()]
    start, step, count = words[:4], words[4:8], words[8:]
    path = slab[1].text.split(':')[1]
    assert list(f[path].shape) == [int(n) for n in slab[1].get('Dimensions').split()]
    assert step == [1, 1, 1, 1] and count == [1, 1, 7, 9] and start[2:] == [0, 0]
    layer, name = plane.get('Name').split('/')[1:]
    assert start[0] == int(layer), plane.get('Name')
    assert f['/layers/channel'][start[1]].decode() == name, plane.get('Name')
    print(plane.get('Name'))
)");
  const auto [status, text] =
      test::run("/usr/bin/python3 " + scratch.path("read.py") + " " + scratch.path("a.h5"));
  EXPECT_EQ(status, 0) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 * 3) << text;
}

}  // namespace
}  // namespace pentimento
