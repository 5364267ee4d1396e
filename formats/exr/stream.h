#pragma once
// Lets OpenEXR write into an OutputFile. A failure does not throw, for OpenEXR swallows some
// exceptions while it closes. The OutputFile keeps the first failure, and publish() returns it.

#include <ImfIO.h>

#include <string>

#include "formats/io/output_file.h"

namespace pentimento::exr {

class FileStream final : public Imf::OStream {
 public:
  explicit FileStream(OutputFile& file, const std::string& name)
      : Imf::OStream(name.c_str()), file_(file) {}
  void write(const char bytes[], int count) override {
    file_.write(bytes, static_cast<std::size_t>(count));
  }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  OutputFile& file_;
};

}  // namespace pentimento::exr
