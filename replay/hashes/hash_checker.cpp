#include "replay/hashes/hash_checker.h"

#include <fmt/format.h>

#include <map>

namespace pentimento {

Error HashChecker::differ(HashDifference difference) {
  difference.last_equal_step = last_equal_step_;
  difference_ = std::move(difference);
  return {ErrorCode::kBadInput, "the replay is not what was recorded"};
}

/// Which fields and tiles differ. A tile that changed in only one of the two differs.
HashDifference HashChecker::compare(const StepHashes& recorded, std::int64_t step,
                                    std::int64_t line) const {
  HashDifference found{step, 0, line, {}, {}, {}};
  for (std::size_t f = 0; f < recorded.fields.size(); ++f)
    if (recorded.fields[f] != hashes_.fields()[f]) found.fields.emplace_back(kHashedFields[f]);
  std::map<int, std::pair<std::uint32_t, std::uint32_t>> tiles;
  for (const TileHash& tile : recorded.tiles) tiles[tile.tile].first = tile.hash;
  for (const TileHash& tile : hashes_.changed()) tiles[tile.tile].second = tile.hash;
  for (const auto& [tile, both] : tiles)
    if (both.first != both.second) found.tiles.push_back(hashes_.box(tile));
  return found;
}

Result<void> HashChecker::stepped(const CanvasState& state, std::int64_t line, bool whole_canvas) {
  hashes_.update(state, threads_, whole_canvas);
  Result<std::optional<StepHashes>> recorded = recorded_.next();
  if (!recorded) return recorded.error();
  if (!*recorded)
    return differ({state.step, 0, line, {}, {}, "the recorded replay has no step any more"});
  const StepHashes& then = **recorded;
  if (then.step != state.step)
    return differ({std::min(then.step, state.step),
                   0,
                   line,
                   {},
                   {},
                   fmt::format("the recorded replay computed step {} next, this one step {}",
                               then.step, state.step)});
  HashDifference found = compare(then, state.step, line);
  if (!found.fields.empty()) return differ(std::move(found));
  last_equal_step_ = state.step;
  ++steps_;
  return {};
}

Result<void> HashChecker::finish() {
  Result<std::optional<StepHashes>> more = recorded_.next();
  if (!more) return more.error();
  if (!*more) return {};
  return differ({(*more)->step, 0, (*more)->line, {}, {}, "the recorded replay goes on"});
}

}  // namespace pentimento
