#include "tests/fuzz/fuzz_dump.h"

#include <hdf5.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "core/simulation/simulation.h"
#include "formats/hdf5/input_driver.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_dump.h"
#include "formats/hdf5/read_small.h"
#include "formats/hdf5/xdmf.h"
#include "tests/formats/hdf5/dump_image.h"
#include "tests/formats/hdf5/library_leaks.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/log/log_text.h"
#include "tests/fuzz/dump_editor.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/reference/made_up_canvas.h"

namespace pentimento::test {

namespace {

constexpr int kMostEdits = 8;
constexpr int kMostCellsToSimulate = 1024;

Result<StateDump> read(hid_t file) {
  static const std::string kName = kFuzzName;
  return hdf5::read_dump({file, kName, {}, nullptr}, true);
}

void check_finite(const Field<float>& plane) {
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) PENTIMENTO_CHECK(std::isfinite(plane(x, y)));
}

/// What comes of a dump that was read: the same hash again, a sidecar, and a replay that goes on.
void use(StateDump dump) {
  PENTIMENTO_CHECK(state_sha256(dump.state) == dump.guide_sha256);
  check_finite(dump.state.depth_m);
  for (const Field<float>& plane : dump.state.pigment) check_finite(plane);
  xdmf_text(kFuzzName, dump);
  const CanvasGeometry& grid = dump.state.geometry;
  if (grid.width * grid.height > kMostCellsToSimulate) return;
  static const Threads threads(1);
  SimulationSetup setup;
  setup.geometry = grid;
  setup.model = dump.model;
  setup.model.layers = dump.state.layers;
  setup.basis = dump.basis;
  setup.dt_s = static_cast<float>(1 / dump.steps_per_second);
  setup.paper_m = paper_relief_of(dump.state);
  setup.paper_reflectance.assign(static_cast<std::size_t>(dump.state.bands), 0.9f);
  Simulation simulation(std::move(setup), threads);
  simulation.restore(std::move(dump.state));
  simulation.step();
}

std::string plain_image() {
  return dump_image(made_up_dump(9, 7, 2, 3));
}

/// A canvas two times finer than its guide, with what goes on from it.
std::string fine_image() {
  constexpr int kFactor = 2;
  StateDump dump = made_up_dump(9, 7, 2, 3);
  dump.detail = kFactor;
  const CanvasGeometry& guide = dump.state.geometry;
  const CanvasGeometry fine = {kFactor * guide.width, kFactor * guide.height, guide.width_m,
                               guide.height_m};
  dump.fine = std::make_shared<reference::MadeUpCanvas>(fine, 2, dump.state.channels);
  dump.checkpoint = make_checkpoint(DetailLayout(guide, kFactor), 2 * dump.state.channels);
  return dump_image(dump);
}

/// Takes the hash that the error names into the dump, as a forger would. False if it names none.
bool forge_hash(hid_t file, const std::string& problem) {
  constexpr std::size_t kHashLength = 64;
  const std::string words = "values have the hash ";
  const std::size_t at = problem.find(words);
  if (at == std::string::npos) return false;
  const std::string hash = problem.substr(at + words.size(), kHashLength);
  const std::string said = problem.substr(problem.rfind(' ') + 1);
  const hdf5::Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose);
  const hdf5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), hash.size());
  const hdf5::Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  bool named = false;
  for (const char* name : {"state_sha256", "guide_sha256"}) {
    if (hdf5::text_attribute(root.id(), name) != said) continue;
    H5Adelete(root.id(), name);
    const hdf5::Handle made(
        H5Acreate2(root.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    named = H5Awrite(made.id(), type.id(), hash.c_str()) >= 0;
  }
  return named;
}

hdf5::Handle edited_dump(std::string_view choices_of_edits) {
  static const std::array<std::string, 2> images = {plain_image(), fine_image()};
  Choices choices(choices_of_edits);
  hdf5::Handle file = open_dump_image(choices.of(images));
  PENTIMENTO_CHECK(file.ok());
  DumpEditor editor(file.id(), choices);
  for (int i = 0; i < kMostEdits && !choices.made(); ++i) editor.edit();
  return file;
}

}  // namespace

void fuzz_dump(std::string_view bytes) {
  const IgnoreLibraryLeaks ignore;
  const hdf5::Silence silence;
  hdf5::load_no_filters();
  const hdf5::Handle file = hdf5::open_to_read(kFuzzName, access_to_image(bytes).id());
  if (!file.ok()) return;
  Result<StateDump> dump = read(file.id());
  if (!dump) return check_problem(dump.error(), kFuzzName);
  use(std::move(*dump));
}

void fuzz_dump_edits(std::string_view bytes) {
  const IgnoreLibraryLeaks ignore;
  const hdf5::Silence silence;
  const hdf5::Handle file = edited_dump(bytes);
  // With a detail canvas there are two hashes to forge.
  for (int hashes = 0; hashes <= 2; ++hashes) {
    Result<StateDump> dump = read(file.id());
    if (dump) return use(std::move(*dump));
    check_problem(dump.error(), kFuzzName);
    if (!forge_hash(file.id(), dump.error().message)) return;
  }
}

void fuzz_dump_by_child(std::string_view bytes) {
  const IgnoreLibraryLeaks ignore;
  static const log::TemporaryFolder folder;
  const auto dump = read_state(folder.write(kFuzzName, std::string(bytes)));
  if (!dump) check_problem(dump.error(), kFuzzName);
}

void fuzz_dump_edits_by_child(std::string_view bytes) {
  const IgnoreLibraryLeaks ignore;
  const hdf5::Silence silence;
  const hdf5::Handle file = edited_dump(bytes);
  H5Fflush(file.id(), H5F_SCOPE_GLOBAL);
  std::string image(static_cast<std::size_t>(H5Fget_file_image(file.id(), nullptr, 0)), '\0');
  H5Fget_file_image(file.id(), image.data(), image.size());
  fuzz_dump_by_child(image);
}

}  // namespace pentimento::test
