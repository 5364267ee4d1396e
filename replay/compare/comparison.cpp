#include "replay/compare/comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace pentimento {

namespace {

bool within(PlaneDifference d, const CompareThresholds& t) {
  if (!d.locked) d.relative_l2 = d.worst_block = std::nullopt;
  if (!t.any()) return d.differing == 0;
  return (!t.max || d.max <= *t.max) && (!t.rms || d.rms <= *t.rms) &&
         (!t.psnr_db || d.psnr_db >= *t.psnr_db) && (!t.differing || d.differing <= *t.differing) &&
         (!t.relative_l2 || !d.relative_l2 || *d.relative_l2 <= *t.relative_l2) &&
         (!t.worst_block || !d.worst_block || *d.worst_block <= *t.worst_block);
}

nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json plane_json(const PlaneDifference& d) {
  nlohmann::json out = {{"name", d.name},           {"max", number(d.max)},
                        {"rms", number(d.rms)},     {"psnr_db", number(d.psnr_db)},
                        {"differing", d.differing}, {"values", d.values}};
  if (d.max_x >= 0) out["max_at"] = {d.max_x, d.max_y};
  if (d.relative_l2) out["relative_l2"] = number(*d.relative_l2);
  if (d.worst_block) out["worst_block"] = number(*d.worst_block);
  return out;
}

}  // namespace

void decide(Comparison& comparison, const CompareThresholds& thresholds) {
  comparison.equal = comparison.comparable;
  for (const PlaneDifference& d : comparison.planes)
    comparison.equal = comparison.equal && within(d, thresholds);
  if (thresholds.flip && comparison.flip_mean)
    comparison.equal = comparison.equal && *comparison.flip_mean <= *thresholds.flip;
}

std::string comparison_text(const Comparison& comparison) {
  const bool fidelity = !comparison.planes.empty() && comparison.planes.front().relative_l2;
  std::string out = fmt::format(
      "{:<24} {:>12} {:>12} {:>10} {:>10}  {}{}\n", comparison.kind, "max", "rms", "PSNR dB",
      "differing", fidelity ? fmt::format("{:>11} {:>11}  ", "relative L2", "worst") : "",
      "largest at");
  for (const PlaneDifference& d : comparison.planes) {
    const std::string where = d.max_x < 0 ? "" : fmt::format("{},{}", d.max_x, d.max_y);
    const std::string near =
        d.relative_l2 ? fmt::format("{:>11.3g} {:>11.3g}  ", *d.relative_l2, *d.worst_block) : "";
    out += fmt::format("{:<24} {:>12.6g} {:>12.6g} {:>10.2f} {:>9.4f}%  {}{}\n", d.name, d.max,
                       d.rms, d.psnr_db, 100 * d.differing, near, where);
  }
  if (comparison.flip_mean)
    out +=
        fmt::format("FLIP mean {:.6f}, max {:.6f}\n", *comparison.flip_mean, *comparison.flip_max);
  for (const std::string& note : comparison.notes) out += note + "\n";
  return out + (comparison.equal ? "equal\n" : "different\n");
}

std::string comparison_json(const Comparison& comparison) {
  nlohmann::json out = {{"a", comparison.a},
                        {"b", comparison.b},
                        {"kind", comparison.kind},
                        {"equal", comparison.equal},
                        {"comparable", comparison.comparable},
                        {"reduced", comparison.reduced},
                        {"planes", nlohmann::json::array()},
                        {"notes", comparison.notes}};
  for (const PlaneDifference& d : comparison.planes) out["planes"].push_back(plane_json(d));
  if (comparison.flip_mean)
    out["flip"] = {{"mean", *comparison.flip_mean}, {"max", *comparison.flip_max}};
  return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace pentimento
