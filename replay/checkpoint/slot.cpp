#include "replay/checkpoint/slot.h"

#include <fmt/format.h>

#include "formats/checkpoint/memory_part.h"

namespace pentimento {

using checkpoint::ArchiveReader;
using checkpoint::ArchiveWriter;
using checkpoint::SlotParts;

namespace {
/// Takes one part apart with `take(reader)`.
template <typename Take>
Result<void> take_part(const SlotParts& parts, const std::string& part, const std::string& name,
                       const Take& take) {
  const auto found = parts.find(part);
  if (found == parts.end())
    return Error{ErrorCode::kBadInput, fmt::format("{}: it has no part \"{}\"", name, part)};
  ArchiveReader reader(found->second);
  take(reader);
  if (reader.complete()) return {};
  return Error{ErrorCode::kBadInput,
               fmt::format("{}: part \"{}\": {}", name, part, reader.problem())};
}

void put_position(const Slot& slot, ArchiveWriter& to) {
  to.i64(slot.position.cues);
  to.i64(slot.position.computed);
  to.i64(slot.step);
  to.u64(slot.stops_done);
}

void take_position(Slot& slot, ArchiveReader& from) {
  slot.position.cues = from.i64();
  slot.position.computed = from.i64();
  slot.step = from.i64();
  slot.stops_done = static_cast<std::size_t>(from.u64());
  if (slot.position.cues < 0 || slot.position.computed < 0) from.fail("it is before the start");
}

template <typename Put>
void add_part(checkpoint::SlotWriter& to, const std::string& part, const Put& put) {
  ArchiveWriter bytes;
  put(bytes);
  to.add(part, bytes.bytes());
}
}  // namespace

Result<Binding> binding_in(const SlotParts& parts, const std::string& name) {
  Binding binding;
  Result<void> taken =
      take_part(parts, "binding", name, [&](ArchiveReader& from) { binding = take_binding(from); });
  if (!taken) return taken.error();
  return binding;
}

Result<Slot> decode_slot(const SlotParts& parts, const SlotShape& shape, const std::string& name) {
  Slot slot;
  Result<void> taken;
  const auto take = [&](const char* part, const auto& body) {
    if (taken) taken = take_part(parts, part, name, body);
  };
  take("position", [&](ArchiveReader& from) { take_position(slot, from); });
  take("outputs", [&](ArchiveReader& from) { slot.outputs = take_outputs(from); });
  take("guide",
       [&](ArchiveReader& from) { slot.guide = checkpoint::take_canvas(shape.guide, from); });
  take("memory", [&](ArchiveReader& from) { slot.memory = checkpoint::take_memory(from); });
  if (shape.detail > 1) {
    take("detail", [&](ArchiveReader& from) {
      const DetailLayout layout(shape.guide.geometry, shape.detail);
      slot.detail = checkpoint::take_detail(layout, shape.guide.layers, shape.guide.channels, from);
    });
    take("planes", [&](ArchiveReader& from) { slot.planes = checkpoint::PlaneIndex::take(from); });
  }
  if (!taken) return taken.error();
  if (slot.guide.step == slot.step) return slot;
  return Error{ErrorCode::kBadInput, fmt::format("{}: its parts are not of one step", name)};
}

Result<std::uint64_t> write_slot(const std::string& path, const Slot& slot,
                                 const CanvasState& guide) {
  Result<std::unique_ptr<checkpoint::SlotWriter>> file = checkpoint::SlotWriter::create(path);
  if (!file) return file.error();
  checkpoint::SlotWriter& to = **file;
  add_part(to, "binding", [&](ArchiveWriter& part) { put_binding(slot.binding, part); });
  add_part(to, "position", [&](ArchiveWriter& part) { put_position(slot, part); });
  add_part(to, "outputs", [&](ArchiveWriter& part) { put_outputs(slot.outputs, part); });
  add_part(to, "guide", [&](ArchiveWriter& part) { checkpoint::put_canvas(guide, part); });
  add_part(to, "memory", [&](ArchiveWriter& part) { checkpoint::put_memory(slot.memory, part); });
  if (slot.detail) {
    add_part(to, "detail",
             [&](ArchiveWriter& part) { checkpoint::put_detail(*slot.detail, part); });
    add_part(to, "planes", [&](ArchiveWriter& part) { slot.planes.put(part); });
  }
  if (Result<void> finished = to.finish(); !finished) return finished.error();
  return to.bytes_written();
}

}  // namespace pentimento
