#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>

#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "formats/exr/chromaticities.h"
#include "formats/exr/exr_header.h"
#include "formats/exr/typed_attribute.h"
#include "formats/io/describe.h"
#include "formats/io/utf8.h"

namespace pentimento {

namespace {

/// The library quotes the file in its messages, which may be anything.
constexpr std::size_t kMostMessageBytes = 200;

constexpr std::string_view kEscape = "pentimento.";  // exr_writer.cpp: keys that OpenEXR has itself

FileDescription describe(const std::string& path) {
  const Imf::InputFile file(path.c_str(), 0);
  const Imf::Header& header = file.header();
  FileDescription out;
  out.format = "exr";
  out.width = header.dataWindow().max.x - header.dataWindow().min.x + 1;
  out.height = header.dataWindow().max.y - header.dataWindow().min.y + 1;
  out.bits = 16;
  std::string names;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    names += std::string(" ") + it.name();
    if (it.channel().type != Imf::HALF) out.bits = 32;
  }
  out.samples = (out.bits == 16 ? "half:" : "float:") + names;
  if (Imf::hasXDensity(header)) out.dpi = static_cast<double>(Imf::xDensity(header));
  if (const auto profile = exr::profile_in(header))
    out.profile = std::string(profile_title(*profile)) + " primaries";
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::optional<std::string> text = exr::attribute_text(it.attribute());
    if (!text) continue;
    std::string_view key = it.name();
    if (key.starts_with(kEscape)) key.remove_prefix(kEscape.size());
    out.provenance.emplace_back(std::string(key), *text);
  }
  return out;
}

}  // namespace

Result<FileDescription> describe_exr(const std::string& path) {
  if (const Result<void> sound = exr::check_header(path); !sound) return sound.error();
  try {
    return describe(path);
  } catch (const std::exception& error) {
    return Error{ErrorCode::kBadInput,
                 path + ": " + brief_line(valid_utf8(error.what()), kMostMessageBytes)};
  }
}

}  // namespace pentimento
