#include "replay/output/kept_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "formats/checkpoint/synced_file.h"

namespace pentimento {

namespace {
constexpr std::size_t kCopiedAtOnce = std::size_t{1} << 20;
constexpr std::size_t kLeastOutputBytes = 8 + 4 + 4 + 8 + 1 + 1;  // name, sides, hash, two flags
}  // namespace

void put_outputs(const std::vector<KeptOutput>& outputs, checkpoint::ArchiveWriter& to) {
  to.u64(outputs.size());
  for (const KeptOutput& output : outputs) {
    const WrittenFile& file = output.file;
    to.text(file.file);
    to.i32(file.width);
    to.i32(file.height);
    to.text(file.sha256);
    to.flag(file.scale.has_value());
    if (file.scale) {
      to.f64(file.scale->offset);
      to.f64(file.scale->per_code);
      to.text(file.scale->unit);
    }
    to.flag(output.frames.has_value());
    if (output.frames) to.list(std::span<const std::uint64_t>(*output.frames));
  }
}

std::vector<KeptOutput> take_outputs(checkpoint::ArchiveReader& from) {
  std::vector<KeptOutput> outputs;
  const std::uint64_t count = from.count(kLeastOutputBytes);
  for (std::uint64_t i = 0; i < count && from.ok(); ++i) {
    KeptOutput output;
    WrittenFile& file = output.file;
    file.file = from.text();
    file.width = from.i32();
    file.height = from.i32();
    file.sha256 = from.text();
    if (from.flag()) file.scale = {from.f64(), from.f64(), from.text()};
    if (from.flag()) output.frames = from.list<std::uint64_t>();
    outputs.push_back(std::move(output));
  }
  return outputs;
}

bool is_planned(const std::string& file, const std::vector<std::vector<PlannedOutput>>& planned) {
  const auto is_it = [&](const PlannedOutput& output) {
    if (output.path == file) return true;
    // aov_path() puts the plane's name, in which there is no slash, before the extension.
    const std::string extension = std::filesystem::path(output.path).extension().string();
    const std::string stem = output.path.substr(0, output.path.size() - extension.size()) + ".";
    return output.kind == OutputKind::kPng && file.starts_with(stem) && file.ends_with(extension) &&
           file.find('/', stem.size()) == std::string::npos;
  };
  return std::any_of(planned.begin(), planned.end(), [&](const auto& outputs) {
    return std::any_of(outputs.begin(), outputs.end(), is_it);
  });
}

std::string kept_file(const std::string& folder, std::size_t index) {
  return fmt::format("{}/{}.output", folder, index);
}

std::string kept_frames(const std::string& folder, std::size_t index) {
  return fmt::format("{}/{}.frames", folder, index);
}

Result<std::unique_ptr<OutputFile>> adopt_kept(const std::string& kept, const WrittenFile& file,
                                               bool no_clobber) {
  using checkpoint::PlacedReader;
  Result<std::unique_ptr<PlacedReader>> from = PlacedReader::open(kept);
  if (!from) return from.error();
  Result<std::unique_ptr<OutputFile>> to = OutputFile::create(file.file, no_clobber);
  if (!to) return to.error();
  std::vector<char> bytes;
  for (std::uint64_t done = 0; done < (*from)->size(); done += bytes.size()) {
    bytes.resize(
        static_cast<std::size_t>(std::min<std::uint64_t>(kCopiedAtOnce, (*from)->size() - done)));
    if (Result<void> read = (*from)->read(done, bytes); !read) return read.error();
    (*to)->write(bytes.data(), bytes.size());
  }
  const Result<Published> whole = (*to)->complete();
  if (!whole) return whole.error();
  if (whole->sha256 == file.sha256) return to;
  return Error{ErrorCode::kBadInput, kept + ": it is not the output that was kept"};
}

}  // namespace pentimento
