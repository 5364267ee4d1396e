#pragma once
// Writes an action log: header first, then events, as canonical lines of JSON, plain or compressed.
// The file appears under its name only when it is whole (formats/io/output_file.h).

#include <memory>
#include <string>

#include "core/base/result.h"
#include "formats/io/picture_file.h"
#include "formats/log/stream/compress.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

class Writer {
 public:
  /// "-" is standard output. Errors: kIo.
  static Result<std::unique_ptr<Writer>> create(const std::string& path, Compression compression,
                                                bool no_clobber = false);
  virtual ~Writer() = default;

  /// Writes the header. Call once, before any event.
  virtual void write(const Header& header) = 0;
  /// Writes an event. It is not checked, and must be one that a reader accepts.
  virtual void write(const Event& event) = 0;
  /// Ends the file and gives it its name. Errors: kIo, also of earlier writes.
  virtual Result<Published> finish() = 0;
};

}  // namespace pentimento::log
