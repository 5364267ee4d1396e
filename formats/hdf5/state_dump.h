#pragma once
// The HDF5 state dump of docs/state-format.md: everything that is needed to shade again, to compare
// and to go on. Its file appears under its name only when it is whole and has been read back
// (OutputFile).

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/detail/store/detail_checkpoint.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/lighting.h"
#include "formats/io/output_file.h"
#include "formats/io/picture_file.h"

namespace pentimento {

struct StateDump {
  CanvasState state;  // the guide: of the simulation's own grid
  /// At a detail above 1, the detail canvas, of which the dump is; else nullptr. After read_state()
  /// it reads from the file, part by part.
  int detail = 1;
  std::shared_ptr<const CanvasSource> fine;
  /// The checkpoint that goes with `fine`. Without it a replay cannot go on from the dump.
  std::optional<DetailCheckpoint> checkpoint;
  Model model;
  ChannelBasis basis;
  std::vector<Pigment> palette;
  Lighting lighting;
  double steps_per_second = 45;
  double time_s = 0;
  std::string log_sha256;
  // Of `fine` if there is one; reader: as stored, writer: computed, unless there is a `fine` and
  // this is given.
  std::string state_sha256;
  std::string guide_sha256;  // of `state`; reader: as stored, writer: computed
  Provenance provenance;     // reader only; the writer takes DumpOptions'
};

struct DumpOptions {
  int threads = 1;
  int deflate_level = 1;
  Provenance provenance;
  bool no_clobber = false;
  bool xdmf = false;                             // write PATH.xdmf beside it, for ParaView
  const std::atomic<bool>* cancelled = nullptr;  // set from a signal handler
};

struct DumpReadOptions {
  int threads = 1;
  const std::atomic<bool>* cancelled = nullptr;  // set from a signal handler
};

/// How a dump names itself, and the newest version known here.
inline constexpr const char* kStateFormat = "pentimento-state";
inline constexpr int kPlainVersion = 1;   // without a detail canvas
inline constexpr int kSerialVersion = 2;  // with one, which has the hash of serial_sha256()
inline constexpr int kStateVersion = 3;   // with one, which has the hash of detail_sha256()

// SHA-256 (hex) of a state's values, as docs/state-format.md defines it: the same for any number of
// threads, chunking and file. Once `cancelled` is set, of a part of the values only.

/// Of a state of the simulation's own grid.
std::string state_sha256(const CanvasState& state, const std::atomic<bool>* cancelled = nullptr);
/// Of a detail canvas: the hash of the hashes of its parts, which all threads compute.
std::string detail_sha256(const CanvasSource& canvas, const Threads& threads = Threads(1),
                          const std::atomic<bool>* cancelled = nullptr);
/// Of a detail canvas as state_sha256() hashes a state, for dumps of version 2.
std::string serial_sha256(const CanvasSource& canvas, const std::atomic<bool>* cancelled = nullptr);

/// Writes the dump's file whole under a temporary name; OutputFile::publish() gives it its own
/// name. Without the .xdmf file. Errors: kIo, kLimit, kUsage, kInterrupted.
Result<std::unique_ptr<OutputFile>> complete_state(const std::string& path, const StateDump& dump,
                                                   const DumpOptions& options);

Result<Published> write_state(const std::string& path, const StateDump& dump,
                              const DumpOptions& options);
/// Reads a dump. Errors: kIo; kLimit; kBadInput with the reason (not a dump, newer version, wrong
/// shape, a value out of range, a hash that differs); kInterrupted once `cancelled` is set.
Result<StateDump> read_state(const std::string& path, const DumpReadOptions& options = {});
/// Whether a file is HDF5 by its first bytes. Does not wait for what comes through a pipe. Errors:
/// kIo; kBadInput if it is no file but a pipe or a device.
Result<bool> is_hdf5_file(const std::string& path);

}  // namespace pentimento
