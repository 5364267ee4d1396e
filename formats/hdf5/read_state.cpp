#include "formats/hdf5/read_state.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <string_view>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/input_driver.h"
#include "formats/hdf5/objects.h"
#include "formats/hdf5/read_dump.h"
#include "formats/hdf5/rehearsal.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/regular_file.h"

namespace pentimento {

namespace {

using hdf5::Handle;

/// Error if the file cannot be opened, or is not HDF5 by its first bytes.
Result<void> check_signature(const std::string& path) {
  const Result<bool> right = is_hdf5_file(path);
  if (!right) return right.error();
  if (!*right) return Error{ErrorCode::kBadInput, path + ": not an HDF5 file"};
  return {};
}

/// `whole`: the values of the detail canvas too, which are read when they are needed.
Result<StateDump> read_here(const std::string& path, bool whole, const hdf5::Rehearsal& rehearsal,
                            const DumpReadOptions& options) {
  const hdf5::Silence silence;
  const Handle file = hdf5::open_to_read(path);
  if (!file.ok()) return Error{ErrorCode::kBadInput, path + ": a damaged or cut short HDF5 file"};
  return hdf5::read_dump({file.id(), path, rehearsal, options.cancelled, options.threads}, whole);
}

/// Reads all of it in a child.
Result<void> rehearse_reading(const std::string& path, const DumpReadOptions& options) {
  return hdf5::rehearse(
      path, options.cancelled, [&](const hdf5::Rehearsal& rehearsal) -> Result<void> {
        hdf5::load_no_filters();
        const Result<StateDump> dump = read_here(path, true, rehearsal, {options.threads, nullptr});
        if (!dump) return dump.error();
        return {};
      });
}

}  // namespace

Result<bool> is_hdf5_file(const std::string& path) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1A\n";
  const Result<std::string> head = first_bytes(path, kSignature.size());
  if (!head) return head.error();
  return *head == kSignature;
}

Result<StateDump> read_state(const std::string& path, const DumpReadOptions& options) {
  if (const Result<void> signed_file = check_signature(path); !signed_file)
    return signed_file.error();
  if (const Result<void> right = rehearse_reading(path, options); !right) return right.error();
  return read_here(path, false, {}, options);
}

Result<void> hdf5::check_dump_file(const std::string& file, const std::string& name,
                                   const DumpReadOptions& options) {
  const Result<void> right = rehearse_reading(file, options);
  if (right || right.error().code == ErrorCode::kInterrupted) return right;
  return Error{ErrorCode::kIo,
               fmt::format("{}: what was read back differs from what was written: {}", name,
                           right.error().message)};
}

}  // namespace pentimento
