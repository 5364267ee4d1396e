#include "replay/compare/compare.h"

namespace pentimento {

namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 29;  // posters: 6 GB a picture

Result<Comparison> compare_dumps(const std::string& a, const std::string& b, int thread_count) {
  const Result<StateDump> left = read_state(a, {thread_count});
  if (!left) return left.error();
  const Result<StateDump> right = read_state(b, {thread_count});
  if (!right) return right.error();
  return compare_states(*left, *right, Threads(thread_count));
}

Result<Comparison> compare_images(const std::string& a, const std::string& b, int thread_count) {
  ImageReadOptions options;
  options.limits.max_pixels = kMostPixels;
  const Result<Image> left = read_image(a, options);
  if (!left) return left.error();
  const Result<Image> right = read_image(b, options);
  if (!right) return right.error();
  return compare_pictures(*left, *right, Threads(thread_count));
}

}  // namespace

Result<Comparison> compare_files(const std::string& a, const std::string& b,
                                 const CompareThresholds& thresholds, int thread_count) {
  const Result<bool> dumps = is_hdf5_file(a);
  if (!dumps) return dumps.error();
  const Result<bool> other = is_hdf5_file(b);
  if (!other) return other.error();
  if (*dumps != *other)
    return Error{ErrorCode::kBadInput, a + " and " + b + ": a state against a picture"};
  Result<Comparison> comparison =
      *dumps ? compare_dumps(a, b, thread_count) : compare_images(a, b, thread_count);
  if (!comparison) return comparison.error();
  comparison->a = a;
  comparison->b = b;
  decide(*comparison, thresholds);
  return comparison;
}

}  // namespace pentimento
