#pragma once
// A comparison: what differs between two pictures or two states, how much and where, and whether
// the user allows it. NaN equals NaN and differs from everything else.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pentimento {

/// The differences in one channel of a picture or one dataset.
struct PlaneDifference {
  std::string name;
  double max = 0;        // largest |a - b|; infinite where only one side is finite
  double rms = 0;        // root of the mean of (a - b)^2
  double psnr_db = 0;    // 20 log10(peak / rms), infinite where equal; peak: 1 for pictures, the
                         // largest |a| for states
  double differing = 0;  // share of values that differ, 0..1
  std::int64_t values = 0;
  int max_x = -1;  // where the largest difference is; -1 = nowhere
  int max_y = -1;
  // Of a canvas against a finer one that was reduced, see fidelity():
  std::optional<double> relative_l2 = std::nullopt;
  std::optional<double> worst_block = std::nullopt;
  // Whether relative_l2 and worst_block have limits: a single layer of a detail canvas has none,
  // only the sum over layers is locked where a stroke's edge runs through a cell.
  bool locked = true;
};

/// The differences that are allowed. If nothing is set, not a single value may differ.
struct CompareThresholds {
  std::optional<double> max = std::nullopt;        // of each plane
  std::optional<double> rms = std::nullopt;        // of each plane
  std::optional<double> psnr_db = std::nullopt;    // at least this, of each plane
  std::optional<double> differing = std::nullopt;  // share of each plane
  std::optional<double> flip = std::nullopt;       // mean FLIP of pictures
  std::optional<double> relative_l2 =
      std::nullopt;  // of each that was reduced: depth, each pigment
  std::optional<double> worst_block = std::nullopt;  // likewise
  bool any() const {
    return max || rms || psnr_db || differing || flip || relative_l2 || worst_block;
  }
};

struct Comparison {
  std::string a, b;                     // the files
  std::string kind;                     // "picture" or "state"
  int reduced = 1;                      // the finer one was reduced by this factor
  std::vector<PlaneDifference> planes;  // the planes that both have
  std::vector<std::string> notes;   // what cannot be compared: sizes, missing planes, parameters
  bool comparable = true;           // false: a note alone makes them differ
  std::optional<double> flip_mean;  // pictures only
  std::optional<double> flip_max;
  bool equal = false;  // within the thresholds
};

/// Sets `equal` from the planes, the notes and `thresholds`.
void decide(Comparison& comparison, const CompareThresholds& thresholds);

/// For people: a table and a verdict, lines ending in '\n'.
std::string comparison_text(const Comparison& comparison);
/// For programs: one JSON object; infinite numbers become null.
std::string comparison_json(const Comparison& comparison);

}  // namespace pentimento
