#include "replay/batch/row.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace pentimento {

namespace {
using nlohmann::json;

constexpr std::array<std::pair<RowKind, std::string_view>, 10> kNames = {{
    {RowKind::kPassed, "passed"},
    {RowKind::kExit, "exit"},
    {RowKind::kCrash, "crash"},
    {RowKind::kTimeout, "timeout"},
    {RowKind::kMemory, "memory"},
    {RowKind::kState, "state"},
    {RowKind::kPicture, "picture"},
    {RowKind::kNoGolden, "no golden"},
    {RowKind::kNotDeterministic, "not deterministic"},
    {RowKind::kNotRun, "not run"},
}};

json number(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

double number_or_infinity(const json& value) {
  return value.is_number() ? value.get<double>() : HUGE_VAL;
}

json difference_json(const GoldenDifference& d) {
  return {{"of", d.of},       {"name", d.name}, {"max", number(d.max)},
          {"share", d.share}, {"x", d.x},       {"y", d.y}};
}

GoldenDifference difference_of(const json& object) {
  return {object.at("of"),    object.at("name"), number_or_infinity(object.at("max")),
          object.at("share"), object.at("x"),    object.at("y")};
}
}  // namespace

std::string_view name_of(RowKind kind) {
  for (const auto& [one, name] : kNames)
    if (one == kind) return name;
  return "";
}

std::string row_json(const BatchRow& row) {
  json out = {{"id", row.id},
              {"kind", std::string(name_of(row.kind))},
              {"reasons", row.reasons},
              {"key", row.key},
              {"golden_picture_sha256", row.golden_picture_sha256},
              {"differences", json::array()}};
  for (const GoldenDifference& d : row.differences)
    out["differences"].push_back(difference_json(d));
  if (!row.key.empty()) out["result"] = json::parse(result_json(row.result));
  if (row.flip) out["flip"] = *row.flip;
  if (row.last_wall_s) out["last_wall_s"] = *row.last_wall_s;
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<BatchRow> parse_row(const std::string& text, const std::string& name) {
  const json object = json::parse(text, nullptr, false);
  try {
    BatchRow row;
    const std::string kind = object.at("kind");
    for (const auto& [one, its_name] : kNames)
      if (kind == its_name) row.kind = one;
    row.id = object.at("id");
    row.reasons = object.at("reasons").get<std::vector<std::string>>();
    row.key = object.at("key");
    row.golden_picture_sha256 = object.at("golden_picture_sha256");
    for (const json& d : object.at("differences")) row.differences.push_back(difference_of(d));
    if (object.contains("flip")) row.flip = object.at("flip").get<double>();
    if (object.contains("last_wall_s")) row.last_wall_s = object.at("last_wall_s").get<double>();
    if (!object.contains("result")) return row;
    Result<JobResult> result = parse_result(object.at("result").dump(), name);
    if (!result) return result.error();
    row.result = std::move(*result);
    return row;
  } catch (const json::exception&) {
    return Error{ErrorCode::kBadInput, name + ": not a row of a run"};
  }
}

}  // namespace pentimento
