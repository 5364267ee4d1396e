#include <cstdio>
#include <string_view>

#include "replay/compare/compare.h"

namespace pentimento {

namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 29;  // posters: 6 GB a picture

/// Tells a dump by its first bytes. If a file cannot be opened, the readers report it.
bool is_hdf5(const std::string& path) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1A\n";
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr) return false;
  char head[kSignature.size()];
  const std::size_t n = std::fread(head, 1, sizeof head, file);
  std::fclose(file);
  return std::string_view(head, n) == kSignature;
}

Result<Comparison> compare_dumps(const std::string& a, const std::string& b,
                                 const Threads& threads) {
  const Result<StateDump> left = read_state(a);
  if (!left) return left.error();
  const Result<StateDump> right = read_state(b);
  if (!right) return right.error();
  return compare_states(*left, *right, threads);
}

Result<Comparison> compare_images(const std::string& a, const std::string& b,
                                  const Threads& threads) {
  ImageReadOptions options;
  options.limits.max_pixels = kMostPixels;
  const Result<Image> left = read_image(a, options);
  if (!left) return left.error();
  const Result<Image> right = read_image(b, options);
  if (!right) return right.error();
  return compare_pictures(*left, *right, threads);
}

}  // namespace

Result<Comparison> compare_files(const std::string& a, const std::string& b,
                                 const CompareThresholds& thresholds, const Threads& threads) {
  const bool dumps = is_hdf5(a);
  if (dumps != is_hdf5(b))
    return Error{ErrorCode::kBadInput, a + " and " + b + ": a state against a picture"};
  Result<Comparison> comparison =
      dumps ? compare_dumps(a, b, threads) : compare_images(a, b, threads);
  if (!comparison) return comparison.error();
  comparison->a = a;
  comparison->b = b;
  decide(*comparison, thresholds);
  return comparison;
}

}  // namespace pentimento
