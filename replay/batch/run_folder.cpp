#include "replay/batch/run_folder.h"

#include <fmt/format.h>

#include <filesystem>

#include "formats/io/part_file.h"
#include "formats/io/publish.h"
#include "formats/io/read_file.h"
#include "formats/io/sha256.h"

namespace pentimento {

namespace {
namespace fs = std::filesystem;
constexpr std::int64_t kMostReportBytes = std::int64_t{1} << 28;

Result<void> publish_text(const std::string& path, const std::string& text) {
  Result<Published> published = publish_bytes(path, text);
  if (!published) return published.error();
  return {};
}
/// Moves what `work` has and `place` has not: pictures or dumps that were not wanted before.
void add_missing_files(const fs::path& work, const fs::path& place) {
  std::error_code ignored;
  for (const auto& file : fs::directory_iterator(work, ignored)) {
    const fs::path target = place / file.path().filename();
    if (!fs::exists(target, ignored)) fs::rename(file.path(), target, ignored);
  }
}
}  // namespace

Result<RunFolder> RunFolder::make(const std::string& path) {
  for (const char* part : {"results", "rows", "golden"}) {
    std::error_code problem;
    fs::create_directories(fs::path(path) / part, problem);
    if (problem)
      return Error{ErrorCode::kIo,
                   fmt::format("{}: no folder can be made there: {}", path, problem.message())};
  }
  remove_stale_part_folders((fs::path(path) / "results").string());
  return RunFolder(path);
}

Result<RunFolder> RunFolder::open(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::path(path) / "manifest.jsonl", ignored))
    return Error{ErrorCode::kBadInput, path + ": not the folder of a run of `batch`"};
  return RunFolder(path);
}

std::string RunFolder::file_of(const std::string& key, const std::string& name) const {
  return (fs::path(path_) / "results" / key / name).string();
}

std::string RunFolder::hash_of(const std::string& key, const std::string& name) const {
  const Result<std::string> bytes = read_file(file_of(key, name), std::int64_t{1} << 40);
  return bytes ? sha256_hex(*bytes) : std::string();
}

std::string RunFolder::golden_picture(const std::string& sha256) const {
  return (fs::path(path_) / "golden" / (sha256 + ".png")).string();
}

std::string RunFolder::row_file(const std::string& id) const {
  return (fs::path(path_) / "rows" / (sha256_hex(id) + ".json")).string();
}

std::optional<JobResult> RunFolder::find(const std::string& key) const {
  const std::string name = file_of(key, "result.json");
  const Result<std::string> text = read_file(name, kMostReportBytes);
  if (!text) return std::nullopt;
  Result<JobResult> result = parse_result(*text, name);
  if (!result || result->key != key) return std::nullopt;
  return std::move(*result);
}

Result<std::string> RunFolder::begin(const std::string& key) const {
  // Two processes of two machines may do the same job: the name has process and machine in it.
  const fs::path work = part_name((fs::path(path_) / "results" / key).string());
  std::error_code problem;
  if (!fs::create_directory(work, problem))
    return Error{ErrorCode::kIo, path_ + ": no folder can be made for a job"};
  return fs::absolute(work, problem).string();
}

void RunFolder::discard(const std::string& work) {
  std::error_code ignored;
  fs::remove_all(work, ignored);
}

Result<JobResult> RunFolder::keep(const JobResult& result, const std::string& work) const {
  if (Result<void> wrote = publish_text(work + "/result.json", result_json(result) + "\n"); !wrote)
    return wrote.error();
  const fs::path place = fs::path(path_) / "results" / result.key;
  std::error_code problem;
  fs::rename(work, place, problem);  // fails if there is something
  if (!problem) return result;
  const std::optional<JobResult> standing = find(result.key);
  if (standing && standing->is_final()) {
    if (standing->state_sha256 == result.state_sha256) add_missing_files(work, place);
    discard(work);
    return *standing;
  }
  // What stands there ended by chance, or is not whole.
  const std::string aside = work + "-old";
  fs::rename(place, aside, problem);
  discard(aside);
  fs::rename(work, place, problem);
  if (problem)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", place.string(), problem.message())};
  return result;
}

Result<void> RunFolder::write_manifest(const std::vector<BatchJob>& jobs) const {
  return publish_text(path_ + "/manifest.jsonl", manifest_text(jobs));
}

Result<std::vector<BatchJob>> RunFolder::manifest() const {
  const std::string name = path_ + "/manifest.jsonl";
  Result<std::string> text = read_file(name, kMostReportBytes);
  if (!text) return text.error();
  return parse_manifest(*text, name);
}

Result<void> RunFolder::write_row(const BatchRow& row) const {
  return publish_text(row_file(row.id), row_json(row) + "\n");
}

std::optional<BatchRow> RunFolder::row(const std::string& id) const {
  const std::string name = row_file(id);
  const Result<std::string> text = read_file(name, kMostReportBytes);
  if (!text) return std::nullopt;
  Result<BatchRow> row = parse_row(*text, name);
  if (!row || row->id != id) return std::nullopt;
  return std::move(*row);
}

}  // namespace pentimento
