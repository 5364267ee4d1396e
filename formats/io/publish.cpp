#include "formats/io/publish.h"

#include "formats/io/output_file.h"

namespace pentimento {

Result<Published> publish_bytes(const std::string& path, std::string_view bytes, bool no_clobber) {
  Result<std::unique_ptr<OutputFile>> file = OutputFile::create(path, no_clobber);
  if (!file) return file.error();
  (*file)->write(bytes.data(), bytes.size());
  return (*file)->publish();
}

}  // namespace pentimento
