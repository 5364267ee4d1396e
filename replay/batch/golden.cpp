#include "replay/batch/golden.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "formats/io/file_sha256.h"
#include "formats/io/publish.h"
#include "formats/io/read_file.h"
#include "formats/io/sha256.h"
#include "replay/batch/moment.h"
#include "replay/compare/compare.h"

namespace pentimento {

namespace {
namespace fs = std::filesystem;
using nlohmann::json;
constexpr std::int64_t kMostBytes = std::int64_t{1} << 40;

json entry_json(const GoldenEntry& entry) {
  json out = {{"id", entry.id}, {"exit", entry.exit_code}, {"state_sha256", entry.state_sha256}};
  if (!entry.picture_sha256.empty()) out["picture_sha256"] = entry.picture_sha256;
  if (!entry.dump_sha256.empty()) out["dump_sha256"] = entry.dump_sha256;
  return out;
}

std::optional<GoldenEntry> entry_of(const std::string& line) {
  const json object = json::parse(line, nullptr, false);
  try {
    return GoldenEntry{object.at("id"), object.at("exit"), object.at("state_sha256"),
                       object.value("picture_sha256", ""), object.value("dump_sha256", "")};
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

/// Copies a file to FOLDER/SHA256.ENDING. Returns its hash; empty if there is no such file.
Result<std::string> put(const std::string& file, const fs::path& folder, const char* ending) {
  std::error_code problem;
  if (!fs::exists(file, problem)) return std::string();
  Result<std::string> bytes = read_file(file, kMostBytes);
  if (!bytes) return bytes.error();
  const std::string hash = sha256_hex(*bytes);
  fs::create_directories(folder, problem);
  const fs::path target = folder / (hash + ending);
  if (const Result<std::string> there = file_sha256(target.string()); there && *there == hash)
    return hash;
  if (Result<Published> done = publish_bytes(target.string(), *bytes); !done) return done.error();
  return hash;
}
}  // namespace

Result<GoldenStore> GoldenStore::open(const std::string& path) {
  GoldenStore store(path);
  const std::string index = (fs::path(path) / "index.jsonl").string();
  std::error_code ignored;
  if (!fs::exists(index, ignored)) return store;
  Result<std::string> text = read_file(index, kMostBytes);
  if (!text) return text.error();
  std::istringstream lines(*text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::optional<GoldenEntry> entry = entry_of(line);
    if (!entry)
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}:{}: not an entry of a golden index", index, number)};
    const std::string id = entry->id;
    if (!store.entries_.emplace(id, std::move(*entry)).second)
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}:{}: a second entry of {}", index, number, json(id).dump())};
  }
  return store;
}

const GoldenEntry* GoldenStore::find(const std::string& id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

Result<std::string> GoldenStore::picture(const GoldenEntry& entry) const {
  const std::string file =
      (fs::path(path_) / "pictures" / (entry.picture_sha256 + ".png")).string();
  const Result<std::string> hash = file_sha256(file);
  if (!hash) return hash.error();
  if (*hash != entry.picture_sha256)
    return Error{ErrorCode::kBadInput, file + ": not the golden picture that was taken"};
  return file;
}

std::string GoldenStore::dump(const GoldenEntry& entry) const {
  return (fs::path(path_) / "states" / (entry.dump_sha256 + ".h5")).string();
}

bool GoldenStore::is_taken(const BatchRow& row, const RunFolder& run) const {
  const GoldenEntry* entry = find(row.id);
  if (entry == nullptr || entry->exit_code != row.result.done.code ||
      entry->state_sha256 != row.result.state_sha256)
    return false;
  const std::string picture_sha256 = run.hash_of(row.key, "picture.png");
  if (entry->picture_sha256 == picture_sha256) return true;
  if (entry->picture_sha256.empty() || picture_sha256.empty()) return picture_sha256.empty();
  // Another build writes its name into the file: the pixels decide.
  const Result<std::string> golden = picture(*entry);
  if (!golden) return false;
  const Result<Comparison> same =
      compare_files(*golden, run.file_of(row.key, "picture.png"), {}, 0);
  return same && same->equal;
}

Result<GoldenEntry> GoldenStore::take(const BatchRow& row, const RunFolder& run) const {
  GoldenEntry entry{row.id, row.result.done.code, row.result.state_sha256, "", ""};
  Result<std::string> picture =
      put(run.file_of(row.key, "picture.png"), fs::path(path_) / "pictures", ".png");
  if (!picture) return picture.error();
  Result<std::string> dump =
      put(run.file_of(row.key, "state.h5"), fs::path(path_) / "states", ".h5");
  if (!dump) return dump.error();
  entry.picture_sha256 = *picture;
  entry.dump_sha256 = *dump;
  return entry;
}

Result<void> GoldenStore::write_index() const {
  std::string text;
  for (const auto& [id, entry] : entries_)
    text += entry_json(entry).dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  Result<Published> done = publish_bytes((fs::path(path_) / "index.jsonl").string(), text);
  if (!done) return done.error();
  return {};
}

void GoldenStore::remove_unnamed() const {
  std::set<std::string> named;
  for (const auto& [id, entry] : entries_) {
    named.insert(entry.picture_sha256 + ".png");
    named.insert(entry.dump_sha256 + ".h5");
  }
  for (const char* part : {"pictures", "states"}) {
    std::error_code ignored;
    std::vector<fs::path> unnamed;
    for (const auto& file : fs::directory_iterator(fs::path(path_) / part, ignored))
      if (!named.contains(file.path().filename().string())) unnamed.push_back(file.path());
    for (const fs::path& file : unnamed) fs::remove(file, ignored);
  }
}

Result<std::vector<std::string>> GoldenStore::update(const std::vector<BatchRow>& rows,
                                                     const RunFolder& run,
                                                     const std::string& reason) {
  std::vector<std::string> taken;
  std::error_code problem;
  fs::create_directories(path_, problem);
  for (const BatchRow& row : rows) {
    if (row.key.empty() || row.result.done.end != ChildEnd::kExit || is_taken(row, run)) continue;
    Result<GoldenEntry> entry = take(row, run);
    if (!entry) return entry.error();
    entries_[row.id] = std::move(*entry);
    taken.push_back(row.id);
  }
  if (taken.empty()) return taken;
  const std::string changes = (fs::path(path_) / "changes.jsonl").string();
  const Result<std::string> before = read_file(changes, kMostBytes);
  const json line = {{"when", utc_now()}, {"reason", reason}, {"ids", taken}};
  Result<Published> told =
      publish_bytes(changes, (before ? *before : std::string()) +
                                 line.dump(-1, ' ', false, json::error_handler_t::replace) + "\n");
  if (!told) return told.error();
  // The index comes last: until then the old entries hold, and their files are there.
  if (Result<void> wrote = write_index(); !wrote) return wrote.error();
  remove_unnamed();
  return taken;
}

}  // namespace pentimento
