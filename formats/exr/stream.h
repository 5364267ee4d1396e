#pragma once
// OpenEXR writing into a file of ours. Its failures do not throw (OpenEXR swallows some of what is
// thrown while it closes): the file keeps the first one and publish() tells.

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
