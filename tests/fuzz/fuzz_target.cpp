#include "tests/fuzz/fuzz_target.h"

#include <memory>
#include <span>

#include "core/base/check.h"
#include "formats/checkpoint/canvas_part.h"
#include "formats/checkpoint/detail_part.h"
#include "formats/checkpoint/memory_part.h"
#include "formats/checkpoint/plane_index.h"
#include "formats/checkpoint/slot_file.h"
#include "formats/import/gravity_file.h"
#include "formats/import/sketch/recording.h"
#include "formats/import/sketch/sketch_log.h"
#include "formats/log/reader.h"
#include "formats/log/write/to_json.h"
#include "tests/formats/log/log_text.h"
#include "tests/fuzz/fuzz_checks.h"
#include "tests/fuzz/fuzz_dump.h"
#include "tests/fuzz/fuzz_picture.h"
#include "tests/fuzz/fuzz_replay.h"

namespace pentimento::test {

namespace {
constexpr const char* kName = kFuzzName;

/// Writes as a file would be written, to nowhere.
class NowhereWriter : public log::Writer {
 public:
  void write(const log::Header& header) override { bytes_ += log::header_json(header).size(); }
  void write(const log::Event& event) override {
    bytes_ += log::event_json(event).size();
    PENTIMENTO_CHECK(event.time_us >= last_us_);
    last_us_ = event.time_us;
  }
  Result<Published> finish() override { return Published{}; }

 private:
  std::size_t bytes_ = 0;
  std::int64_t last_us_ = 0;
};

void fuzz_recording(const sketch::Format& format, std::string_view bytes) {
  sketch::format_of(bytes);
  const Result<sketch::Sketch> drawing = format.read({kName, bytes}, {});
  if (!drawing) return check_problem(drawing.error(), kName);
  NowhereWriter writer;
  const Result<sketch::LogCounts> counts = write_log(*drawing, {}, {}, writer);
  PENTIMENTO_CHECK(counts || counts.error().code == ErrorCode::kBadInput ||
                   counts.error().code == ErrorCode::kLimit);
}

void fuzz_log(std::string_view bytes, const log::ReaderOptions& options) {
  static const log::TemporaryFolder folder;
  const std::string path = folder.write(kName, std::string(bytes));
  const Result<std::unique_ptr<log::Reader>> reader = log::Reader::open(path, options);
  if (!reader) return check_problem(reader.error(), kName);
  while (true) {
    const Result<std::optional<log::Event>> event = (*reader)->next();
    if (!event) return check_problem(event.error(), kName);
    if (!*event) return;
    log::event_json(**event);
  }
}

/// Takes one part of a slot apart as a resumed replay does, on a canvas of 4 x 3 cells.
void take_part(std::string_view name, std::string_view bytes) {
  const CanvasGeometry grid = {4, 3, 0.4, 0.3};
  constexpr int kLayers = 2, kChannels = 2, kBands = 3, kDetail = 2;
  checkpoint::ArchiveReader from(bytes);
  if (name == "guide") {
    const CanvasState state = checkpoint::take_canvas({grid, kLayers, kChannels, kBands}, from);
    if (!from.complete()) return;
    checkpoint::ArchiveWriter again;
    checkpoint::put_canvas(state, again);
  } else if (name == "memory") {
    checkpoint::take_memory(from);
  } else if (name == "detail") {
    const DetailLayout layout(grid, kDetail);
    const auto notes = checkpoint::take_detail(layout, kLayers, kChannels, from);
    if (!from.complete()) return;
    for (int t = 0; t < layout.tiles(); ++t) restore_open_cells(notes.checkpoint, layout, t);
  } else if (name == "planes") {
    checkpoint::PlaneIndex::take(from).generations();
  }
}

/// A whole slot; or, as checksums hide the parts from a fuzzer, the name of a part, a line feed and
/// its bytes.
void fuzz_checkpoint(std::string_view bytes) {
  const Result<checkpoint::SlotParts> parts = checkpoint::parse_slot(bytes, kName);
  if (!parts) check_problem(parts.error(), kName);
  if (parts)
    for (const auto& [name, part] : *parts) take_part(name, part);
  const std::size_t end = bytes.find('\n');
  if (end != std::string_view::npos) take_part(bytes.substr(0, end), bytes.substr(end + 1));
}
void fuzz_gravity(std::string_view bytes) {
  const Result<sketch::GravityRecording> gravity = sketch::read_gravity({kName, bytes}, {});
  if (!gravity) check_problem(gravity.error(), kName);
}

void fuzz_plain_log(std::string_view bytes) {
  fuzz_log(bytes, {});
}

void fuzz_repair(std::string_view bytes) {
  log::ReaderOptions options;
  options.repair = true;
  fuzz_log(bytes, options);
}

struct Target {
  const char* name;
  void (*take)(std::string_view bytes);
};
constexpr Target kTargets[] = {
    {"checkpoint", fuzz_checkpoint}, {"dump", fuzz_dump},     {"dump-edits", fuzz_dump_edits},
    {"gravity", fuzz_gravity},       {"log", fuzz_plain_log}, {"palette", fuzz_palette},
    {"picture", fuzz_picture},       {"repair", fuzz_repair}, {"replay", fuzz_replay},
};
constexpr Target kByChild[] = {{"dump-child", fuzz_dump_by_child},
                               {"dump-edits-child", fuzz_dump_edits_by_child}};
}  // namespace

std::vector<std::string> fuzz_targets() {
  std::vector<std::string> out;
  for (const Target& target : kTargets) out.emplace_back(target.name);
  for (const sketch::Format& format : sketch::formats()) out.emplace_back(format.name);
  return out;
}

void fuzz(const std::string& target, std::string_view bytes) {
  const std::span<const Target> plain = kTargets, by_child = kByChild;
  for (const std::span<const Target> targets : {plain, by_child})
    for (const Target& one : targets)
      if (target == one.name) return one.take(bytes);
  const sketch::Format* format = sketch::find_format(target);
  PENTIMENTO_CHECK(format != nullptr);
  fuzz_recording(*format, bytes);
}

}  // namespace pentimento::test
