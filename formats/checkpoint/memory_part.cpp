#include "formats/checkpoint/memory_part.h"

#include <utility>

namespace pentimento::checkpoint {

namespace {
// A touch in the file without its texels: id, stroke, flags, two shares, the count of texels.
constexpr std::size_t kLeastTouchBytes = 4 + 4 + 1 + 1 + 4 + 4 + 8;

void put_flow(const PaintFlow& flow, ArchiveWriter& to) {
  to.f64(flow.medium_m3);
  to.list(std::span<const double>(flow.channel));
}

PaintFlow take_flow(ArchiveReader& from) {
  PaintFlow flow;
  flow.medium_m3 = from.f64();
  flow.channel = from.list<double>();
  return flow;
}

void put_touch(const TouchMemory& touch, ArchiveWriter& to) {
  to.i32(touch.id);
  to.u32(touch.stroke_id);
  to.flag(touch.down);
  to.flag(touch.reservoir.as_loaded);
  to.f32(touch.reservoir.density_frac);
  to.f32(touch.reservoir.dry_ahead_frac);
  to.list(std::span<const float>(touch.reservoir.texels));
}

TouchMemory take_touch(ArchiveReader& from) {
  TouchMemory touch;
  touch.id = from.i32();
  touch.stroke_id = from.u32();
  touch.down = from.flag();
  touch.reservoir.as_loaded = from.flag();
  touch.reservoir.density_frac = from.f32();
  touch.reservoir.dry_ahead_frac = from.f32();
  touch.reservoir.texels = from.list<float>();
  return touch;
}
}  // namespace

void put_memory(const SimulationMemory& memory, ArchiveWriter& to) {
  to.u64(memory.touches.size());
  for (const TouchMemory& touch : memory.touches) put_touch(touch, to);
  put_flow(memory.account.deposited, to);
  put_flow(memory.account.picked_up, to);
  put_flow(memory.account.dried, to);
  to.i64(memory.stamps);
  to.flag(memory.fresh);
  to.list(std::span<const double>(memory.scheme));
}

SimulationMemory take_memory(ArchiveReader& from) {
  SimulationMemory memory;
  const std::uint64_t touches = from.count(kLeastTouchBytes);
  for (std::uint64_t i = 0; i < touches && from.ok(); ++i) {
    TouchMemory touch = take_touch(from);
    if (!memory.touches.empty() && touch.id <= memory.touches.back().id)
      from.fail("its touches are not in order");
    memory.touches.push_back(std::move(touch));
  }
  memory.account.deposited = take_flow(from);
  memory.account.picked_up = take_flow(from);
  memory.account.dried = take_flow(from);
  memory.stamps = from.i64();
  memory.fresh = from.flag();
  memory.scheme = from.list<double>();
  return memory;
}

}  // namespace pentimento::checkpoint
