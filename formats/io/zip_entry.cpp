#include "formats/io/zip_entry.h"

#include <fmt/format.h>
#include <zip.h>

#include <array>
#include <memory>

namespace pentimento {

namespace {
struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;
using EntryFile = std::unique_ptr<zip_file_t, CloseEntry>;

Error problem_of(const ZipBytes& archive, std::string_view what, zip_error_t& error) {
  Error out{ErrorCode::kBadInput,
            fmt::format("{}: {}: {}", archive.name, what, zip_error_strerror(&error))};
  zip_error_fini(&error);
  return out;
}

Result<Archive> open_archive(const ZipBytes& archive) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source =
      zip_source_buffer_create(archive.bytes.data(), archive.bytes.size(), 0, &error);
  if (source == nullptr) return problem_of(archive, "zip archive", error);
  Archive out(zip_open_from_source(source, ZIP_RDONLY, &error));
  if (out == nullptr) {
    zip_source_free(source);
    return problem_of(archive, "zip archive", error);
  }
  zip_error_fini(&error);
  return out;
}
}  // namespace

Result<std::string> read_zip_entry(const ZipBytes& archive, const std::string& entry,
                                   std::uint64_t most_bytes) {
  const Result<Archive> open = open_archive(archive);
  if (!open) return open.error();
  const EntryFile file(zip_fopen(open->get(), entry.c_str(), 0));
  if (file == nullptr)
    return Error{ErrorCode::kBadInput,
                 fmt::format("{}: {}: {}", archive.name, entry, zip_strerror(open->get()))};
  std::string out;
  std::array<char, 65536> piece;
  while (true) {
    const zip_int64_t count = zip_fread(file.get(), piece.data(), piece.size());
    if (count < 0)
      return Error{ErrorCode::kBadInput,
                   fmt::format("{}: {}: {}", archive.name, entry, zip_file_strerror(file.get()))};
    if (count == 0) return out;
    if (out.size() + static_cast<std::uint64_t>(count) > most_bytes)
      return Error{ErrorCode::kLimit, fmt::format("{}: {}: unpacks to more than {} bytes",
                                                  archive.name, entry, most_bytes)};
    out.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace pentimento
