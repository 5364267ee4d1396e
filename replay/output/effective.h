#pragma once
// Provenance: everything that a picture or a dump depends on, as keys and values.

#include <map>
#include <string>

#include "core/base/result.h"
#include "core/model/model.h"
#include "core/optics/lighting.h"
#include "formats/io/picture_file.h"
#include "replay/job/output_size.h"

namespace pentimento {

/// What a set of outputs shows, and where that came from.
struct Origin {
  std::string log_sha256;
  std::map<std::string, std::string> files;  // that the job reads: name, SHA-256
  std::string state_sha256;
  std::string guide_sha256;
  Model model;
  CanvasGeometry grid;  // of the simulation
  int detail = 1;
  std::string other_painting;  // why it is not the painting of the log's grid; empty: it is
  double steps_per_second = 45;
  std::int64_t step = 0;
  double time_s = 0;
  Lighting lighting;
  std::string command;  // without its -o
};

/// Adds the file of an option, as "--from", to the files of a job, unless it is empty. Errors: kIo.
Result<void> add_file_of_option(const std::string& option, const std::string& path,
                                std::map<std::string, std::string>& files);

/// The provenance of one output. `pattern`: its -o; `size`: that of the whole picture.
Provenance provenance_of(const Origin& origin, const OutputSize& size, const std::string& pattern);

/// `text` as a POSIX shell takes it: quoted if it must be.
std::string shell_word(const std::string& text);

}  // namespace pentimento
