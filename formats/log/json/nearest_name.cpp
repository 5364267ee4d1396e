#include "formats/log/json/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace pentimento {

namespace {

/// Levenshtein's distance, by the rows of its table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

/// Candidates that contain `name`, whatever the case; the first three.
std::vector<std::string> containing(std::string_view name,
                                    std::span<const std::string_view> candidates) {
  constexpr std::size_t kLeastLength = 4, kMost = 3;
  std::vector<std::string> found;
  if (name.size() < kLeastLength) return found;
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  for (const std::string_view candidate : candidates)
    if (found.size() < kMost && std::search(candidate.begin(), candidate.end(), name.begin(),
                                            name.end(), same) != candidate.end())
      found.push_back(fmt::format("\"{}\"", candidate));
  return found;
}

}  // namespace

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  constexpr std::size_t kMaxLength = 64;  // of names worth a suggestion
  if (name.size() > kMaxLength) return {};
  std::size_t best = std::min<std::size_t>(3, (name.size() + 2) / 3) + 1;
  std::string_view nearest;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  if (!nearest.empty()) return fmt::format(" (did you mean \"{}\"?)", nearest);
  const std::vector<std::string> found = containing(name, candidates);
  if (found.empty()) return {};
  const std::span<const std::string> all(found);
  const std::string before_last = fmt::format("{}", fmt::join(all.first(found.size() - 1), ", "));
  return fmt::format(" (did you mean {}{}{}?)", before_last, before_last.empty() ? "" : " or ",
                     found.back());
}

}  // namespace pentimento
