#pragma once
// The limits of a log, in one table: the reader and the replay refuse what is over them before any
// work is done (exit code 4), `pentimento list limits` shows them, docs/cli.md has the same table.
// A limit is far above what sessions hold, and low enough that a hostile log cannot take the
// machine.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pentimento::log {

struct Limits {
  std::int64_t max_events = 200'000'000;
  std::int64_t max_steps = 100'000'000;
  std::int64_t max_line_bytes = 16 << 20;
  std::int64_t max_bytes = std::int64_t{32} << 30;
  std::int64_t max_stamps = 100'000'000;
  std::int64_t max_move_stamps = 500'000;
  std::int64_t max_touches = 64;
  std::int64_t max_colors = 65536;
  std::int64_t max_pigments = 4096;
  std::int64_t max_brushes = 1024;
  int max_depth = 16;  // of nesting; exceeding it is kBadInput, no event nests so deep
};

/// A row of the table.
struct LimitRow {
  std::string_view name;
  std::int64_t Limits::*value;
  std::string_view unit;
  std::string_view option;  // that raises it, as the user writes it
  std::string_view reason;
};

std::span<const LimitRow> limit_rows();

/// ", the limit (--max-events)", for messages about the limit `value`.
std::string limit_note(std::int64_t Limits::*value);

/// Sets one limit from `NAME=NUMBER`. Returns what is wrong with the text; empty if nothing.
std::string set_limit(Limits& limits, std::string_view text);

}  // namespace pentimento::log
