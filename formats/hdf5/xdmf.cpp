#include "formats/hdf5/xdmf.h"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "formats/hdf5/layout.h"

namespace pentimento {

namespace {

/// `text` between tags.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string plane(const std::string& name, const char* number, const std::string& item) {
  return fmt::format(
      "      <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Cell\">\n{}      </Attribute>\n",
      escaped(name), number, item);
}

std::string whole_item(const std::string& file, const hdf5::CanvasDataset& dataset,
                       const std::string& dimensions) {
  return fmt::format(
      "        <DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"4\" Format=\"HDF\">"
      "{}:{}</DataItem>\n",
      dimensions, dataset.is_integer ? "UInt" : "Float", file, dataset.name);
}

/// Of the canvas in the dump's own groups.
hdf5::CanvasShape shape_of(const StateDump& dump) {
  return dump.fine ? hdf5::shape_of(*dump.fine) : hdf5::shape_of(StateSource(dump.state));
}

/// One plane of /layers/pigment.
std::string slab_item(const std::string& file, const hdf5::CanvasShape& canvas, int layer,
                      int channel) {
  const int ny = canvas.height;
  const int nx = canvas.width;
  return fmt::format(
      "        <DataItem ItemType=\"HyperSlab\" Dimensions=\"{0} {1}\">\n"
      "          <DataItem Dimensions=\"3 4\" Format=\"XML\">{2} {3} 0 0 1 1 1 1 1 1 {0} {1}"
      "</DataItem>\n"
      "          <DataItem Dimensions=\"{4} {5} {0} {1}\" NumberType=\"Float\" Precision=\"4\" "
      "Format=\"HDF\">{6}:/layers/pigment</DataItem>\n"
      "        </DataItem>\n",
      ny, nx, layer, channel, canvas.layers, canvas.channels, file);
}

std::string planes(const std::string& file, const StateDump& dump) {
  const hdf5::CanvasShape canvas = shape_of(dump);
  const std::string dimensions = fmt::format("{} {}", canvas.height, canvas.width);
  std::string out;
  for (const hdf5::CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    const std::size_t rank = hdf5::shape_of(canvas, dataset).size();
    if (rank == 2) out += plane(dataset.name + 1, "Scalar", whole_item(file, dataset, dimensions));
    if (rank == 3 && canvas.bands == 3)
      out += plane(dataset.name + 1, "Vector", whole_item(file, dataset, dimensions + " 3"));
  }
  for (int layer = 0; layer < canvas.layers; ++layer)
    for (int c = 0; c < canvas.channels; ++c)
      out += plane(fmt::format("layers/{}/{}", layer, dump.basis.name[static_cast<std::size_t>(c)]),
                   "Scalar", slab_item(file, canvas, layer, c));
  return out;
}

}  // namespace

std::string xdmf_text(const std::string& path, const StateDump& dump) {
  const hdf5::CanvasShape g = shape_of(dump);
  const auto [width_m, height_m] =
      std::pair(dump.state.geometry.width_m, dump.state.geometry.height_m);
  const std::string file = escaped(std::filesystem::path(path).filename().string());
  return fmt::format(
      "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
      "    <Grid Name=\"canvas\" GridType=\"Uniform\">\n"
      "      <Time Value=\"{}\"/>\n"
      "      <Topology TopologyType=\"2DCoRectMesh\" Dimensions=\"{} {}\"/>\n"
      "      <Geometry GeometryType=\"ORIGIN_DXDY\">\n"
      "        <DataItem Dimensions=\"2\" Format=\"XML\">0 0</DataItem>\n"
      "        <DataItem Dimensions=\"2\" Format=\"XML\">{} {}</DataItem>\n"
      "      </Geometry>\n{}    </Grid>\n  </Domain>\n</Xdmf>\n",
      dump.time_s, g.height + 1, g.width + 1, height_m / g.height, width_m / g.width,
      planes(file, dump));
}

}  // namespace pentimento
