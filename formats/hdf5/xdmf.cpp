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

/// One plane of /layers/pigment.
std::string slab_item(const std::string& file, const CanvasState& state, int layer, int channel) {
  const int ny = state.geometry.height;
  const int nx = state.geometry.width;
  return fmt::format(
      "        <DataItem ItemType=\"HyperSlab\" Dimensions=\"{0} {1}\">\n"
      "          <DataItem Dimensions=\"3 4\" Format=\"XML\">{2} {3} 0 0 1 1 1 1 1 1 {0} {1}"
      "</DataItem>\n"
      "          <DataItem Dimensions=\"{4} {5} {0} {1}\" NumberType=\"Float\" Precision=\"4\" "
      "Format=\"HDF\">{6}:/layers/pigment</DataItem>\n"
      "        </DataItem>\n",
      ny, nx, layer, channel, state.layers, state.channels, file);
}

std::string planes(const std::string& file, const StateDump& dump) {
  const CanvasState& state = dump.state;
  const std::string dimensions = fmt::format("{} {}", state.geometry.height, state.geometry.width);
  std::string out;
  for (const hdf5::CanvasDataset& dataset : hdf5::kCanvasDatasets) {
    const std::size_t rank = hdf5::shape_of(StateSource(state), dataset).size();
    if (rank == 2) out += plane(dataset.name + 1, "Scalar", whole_item(file, dataset, dimensions));
    if (rank == 3 && state.bands == 3)
      out += plane(dataset.name + 1, "Vector", whole_item(file, dataset, dimensions + " 3"));
  }
  for (int layer = 0; layer < state.layers; ++layer)
    for (int c = 0; c < state.channels; ++c)
      out += plane(fmt::format("layers/{}/{}", layer, dump.basis.name[static_cast<std::size_t>(c)]),
                   "Scalar", slab_item(file, state, layer, c));
  return out;
}

}  // namespace

std::string xdmf_text(const std::string& path, const StateDump& dump) {
  const CanvasGeometry& g = dump.state.geometry;
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
      dump.time_s, g.height + 1, g.width + 1, g.height_m / g.height, g.width_m / g.width,
      planes(file, dump));
}

}  // namespace pentimento
