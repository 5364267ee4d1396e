#include "formats/log/json/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace pentimento {

namespace {
constexpr std::size_t kLeastLength = 4;  // of a part of a name
constexpr std::size_t kMost = 3;         // parts that are suggested

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

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// The least distance of `name` from a word of `candidate`, whatever the case.
std::size_t distance_to_word(const std::string& name, const std::string& candidate) {
  std::size_t best = name.size();
  for (std::size_t begin = 0; begin < candidate.size();) {
    const std::size_t end = std::min(candidate.find_first_of(" -_", begin), candidate.size());
    best = std::min(best, edit_distance(name, candidate.substr(begin, end - begin)));
    begin = end + 1;
  }
  return best;
}

/// Candidates with the word that is nearest to `name`, if one is near; the first three.
std::vector<std::string> with_near_word(std::string_view name, std::size_t near,
                                        std::span<const std::string_view> candidates) {
  std::vector<std::string> found;
  if (name.size() < kLeastLength) return found;
  const std::string wanted = lower(name);
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = distance_to_word(wanted, lower(candidate));
    if (distance > near) continue;
    if (distance < near) found.clear();
    near = distance;
    if (found.size() < kMost) found.push_back(fmt::format("\"{}\"", candidate));
  }
  return found;
}

}  // namespace

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  constexpr std::size_t kMaxLength = 64;  // of names worth a suggestion
  if (name.size() > kMaxLength) return {};
  const std::size_t near = std::min<std::size_t>(3, (name.size() + 2) / 3);
  std::size_t best = near + 1;
  std::string_view nearest;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  if (!nearest.empty()) return fmt::format(" (did you mean \"{}\"?)", nearest);
  std::vector<std::string> found = containing(name, candidates);
  if (found.empty()) found = with_near_word(name, near, candidates);
  if (found.empty()) return {};
  const std::span<const std::string> all(found);
  const std::string before_last = fmt::format("{}", fmt::join(all.first(found.size() - 1), ", "));
  return fmt::format(" (did you mean {}{}{}?)", before_last, before_last.empty() ? "" : " or ",
                     found.back());
}

}  // namespace pentimento
