#include "formats/checkpoint/slot_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <utility>

#include "formats/checkpoint/archive.h"

namespace pentimento::checkpoint {

namespace {
constexpr std::string_view kMagic = "pentimento checkpoint\n";
constexpr std::uint32_t kVersion = 3;
// At the end: where the table begins, and its checksum.
constexpr std::size_t kTrailerBytes = 16;
constexpr std::size_t kLeastEntryBytes = 4 * 8;
// The guide of the largest grid that a slot is for, 16384 squared, has planes of 1 GB.
constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 30;
}  // namespace

std::uint64_t checksum_of(std::string_view bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

SlotWriter::SlotWriter(std::string path, std::unique_ptr<SyncedFile> file)
    : path_(std::move(path)), file_(std::move(file)) {
  file_->write(kMagic);
  ArchiveWriter version;
  version.u32(kVersion);
  file_->write(version.bytes());
}

Result<std::unique_ptr<SlotWriter>> SlotWriter::create(const std::string& path) {
  Result<std::unique_ptr<SyncedFile>> file = SyncedFile::create(path + ".part");
  if (!file) return file.error();
  return std::unique_ptr<SlotWriter>(new SlotWriter(path, std::move(*file)));
}

void SlotWriter::add(const std::string& name, std::string_view bytes) {
  parts_.push_back({name, file_->size(), bytes.size(), checksum_of(bytes)});
  file_->write(bytes);
}

Result<void> SlotWriter::finish() {
  ArchiveWriter table, trailer;
  table.u64(parts_.size());
  for (const PartEntry& part : parts_) {
    table.text(part.name);
    table.u64(part.offset);
    table.u64(part.size);
    table.u64(part.checksum);
  }
  trailer.u64(file_->size());
  trailer.u64(checksum_of(table.bytes()));
  file_->write(table.bytes());
  file_->write(trailer.bytes());
  if (Result<void> synced = file_->sync(); !synced) return synced;
  return rename_synced(path_ + ".part", path_);
}

Result<SlotParts> parse_slot(std::string_view bytes, const std::string& name) {
  const auto bad = [&](std::string_view what) {
    return Error{ErrorCode::kBadInput, fmt::format("{}: {}", name, what)};
  };
  if (!bytes.starts_with(kMagic)) return bad("it is no slot of a checkpoint");
  const std::size_t head = kMagic.size() + sizeof(kVersion);
  if (bytes.size() < head + kTrailerBytes) return bad("it ends too early");
  ArchiveReader version(bytes.substr(kMagic.size()));
  if (version.u32() != kVersion) return bad("it is of another version than this program's");
  ArchiveReader trailer(bytes.substr(bytes.size() - kTrailerBytes));
  const std::uint64_t begin = trailer.u64(), checksum = trailer.u64();
  const std::size_t end = bytes.size() - kTrailerBytes;
  if (begin < head || begin > end) return bad("it ends too early");
  const std::string_view rows = bytes.substr(begin, end - begin);
  if (checksum_of(rows) != checksum) return bad("its table of parts is damaged");
  ArchiveReader table(rows);
  SlotParts parts;
  const std::uint64_t count = table.count(kLeastEntryBytes);
  for (std::uint64_t i = 0; i < count && table.ok(); ++i) {
    const std::string part = table.text();
    const std::uint64_t offset = table.u64(), size = table.u64(), sum = table.u64();
    if (offset < head || offset > begin || size > begin - offset)
      return bad("a part lies outside of the file");
    const std::string_view content = bytes.substr(offset, size);
    if (checksum_of(content) != sum) return bad(fmt::format("its part \"{}\" is damaged", part));
    if (!parts.emplace(part, content).second) return bad("a part is there twice");
  }
  if (!table.complete()) return bad("its table of parts is damaged");
  return parts;
}

Result<SlotParts> read_slot(const std::string& path) {
  Result<std::unique_ptr<PlacedReader>> file = PlacedReader::open(path);
  if (!file) return file.error();
  if ((*file)->size() > kMostBytes)
    return Error{ErrorCode::kLimit, path + ": a slot of more than 16 GiB"};
  std::string bytes(static_cast<std::size_t>((*file)->size()), '\0');
  if (Result<void> read = (*file)->read(0, bytes); !read) return read.error();
  return parse_slot(bytes, path);
}

}  // namespace pentimento::checkpoint
