// Drawings of Wacom's Universal Ink Model (developer-docs.wacom.com, github.com/Wacom-Developer):
// versions 3.0 and 3.1 in RIFF files, and 3.0 as JSON. Kept: places of the splines, times,
// pressure, tilt from altitude and azimuth, colour, the mean width of each stroke, strokes that
// erase. Guessed: brushes, from their names. Dropped: width within a stroke, pictures of brushes,
// what was erased, groups, and what words mean.

#include <fmt/format.h>

#include "formats/import/read/readers.h"
#include "formats/import/sketch/byte_reader.h"
#include "formats/import/sketch/text_rows.h"
#include "formats/import/wacom/uim_messages.h"
#include "formats/import/wacom/uim_strokes.h"

namespace pentimento::sketch {

namespace {
constexpr std::size_t kNameBytes = 4;
constexpr std::uint32_t kProtobuf = 1;  // content of a chunk
/// A million samples have 22 MB. An empty message of two bytes becomes some 120 in memory, so this
/// bounds that too.
constexpr std::size_t kMostBytes = 32u << 20;

/// A chunk of the file, and how HEAD describes it.
struct UimChunk {
  std::string_view name, bytes;
};

/// What HEAD says: the version, and eight bytes for each chunk: version, content, compression.
struct UimHead {
  int major = 0, minor = 0;
  std::vector<std::array<std::uint8_t, 8>> chunks;
};

class RiffReader {
 public:
  explicit RiffReader(const Source& source) : in_(source.name, source.bytes) {}

  Result<UimInk> read() {
    if (in_.bytes(kNameBytes, "RIFF") != "RIFF") in_.fail("no RIFF file");
    in_.skip(4, "size");
    if (in_.bytes(kNameBytes, "kind of the file") != "UINK") in_.fail("no ink in the file");
    const UimChunk head_chunk = next();
    if (in_.ok() && head_chunk.name != "HEAD") in_.fail("the first chunk is not HEAD");
    const UimHead head = read_head(head_chunk.bytes);
    std::vector<UimChunk> chunks;
    while (in_.ok() && in_.left() > 0) chunks.push_back(next());
    check(head, chunks);
    if (!in_.ok()) return in_.error();
    if (head.minor == 0) return read_uim_30(in_.name(), find(chunks, "DATA"));
    return read_uim_31(in_.name(), find(chunks, "INPT"), find(chunks, "INKD"));
  }

 private:
  UimChunk next() {
    UimChunk out;
    out.name = in_.bytes(kNameBytes, "name of a chunk");
    const std::uint32_t size = in_.count("bytes of a chunk", 1);
    out.bytes = in_.bytes(size, "chunk");
    if (size % 2 == 1 && in_.left() > 0) in_.skip(1, "padding");
    return out;
  }

  UimHead read_head(std::string_view bytes) {
    UimHead out;
    ByteReader head(in_.name(), bytes);
    out.major = head.u8("version");
    out.minor = head.u8("version");
    if (head.ok() && (out.major != 3 || out.minor > 1))
      head.fail(fmt::format("version {}.{} is not known, only 3.0 and 3.1", out.major, out.minor));
    if (out.minor == 1) head.skip(2, "version");
    while (out.minor == 1 && head.ok() && head.left() >= 8) {
      std::array<std::uint8_t, 8> about{};
      for (std::uint8_t& value : about) value = head.u8("description of a chunk");
      out.chunks.push_back(about);
    }
    in_.adopt(head);
    return out;
  }

  /// That the chunks are such as can be read.
  void check(const UimHead& head, const std::vector<UimChunk>& chunks) {
    constexpr std::size_t kContentAt = 3, kCompressionAt = 4;
    for (std::size_t i = 0; i < std::min(head.chunks.size(), chunks.size()) && in_.ok(); ++i) {
      if (head.chunks[i][kContentAt] != kProtobuf)
        in_.fail(fmt::format("content {} of the chunk {} is not known, only {}",
                             head.chunks[i][kContentAt], quotable(chunks[i].name), kProtobuf));
      else if (head.chunks[i][kCompressionAt] != 0)
        in_.fail(
            fmt::format("the chunk {} is compressed, which is not read", quotable(chunks[i].name)));
    }
    const std::string_view needed = head.minor == 0 ? "DATA" : "INKD";
    if (in_.ok() && find(chunks, needed).data() == nullptr)
      in_.fail(fmt::format("there is no chunk {}", needed));
  }

  static std::string_view find(const std::vector<UimChunk>& chunks, std::string_view name) {
    for (const UimChunk& chunk : chunks)
      if (chunk.name == name) return chunk.bytes;
    return {};
  }

  ByteReader in_;
};

bool is_riff(std::string_view bytes) {
  return bytes.starts_with("RIFF") && bytes.substr(8).starts_with("UINK");
}
}  // namespace

/// The JSON form begins with what it has of inputs, or with ink.
bool is_wacom(std::string_view bytes) {
  constexpr std::size_t kLook = 4096;
  if (bytes.size() >= 12 && is_riff(bytes)) return true;
  const std::string_view begin = bytes.substr(0, kLook);
  return begin.find('{') != std::string_view::npos &&
         (begin.find("\"inputData\"") != std::string_view::npos ||
          begin.find("\"inkData\"") != std::string_view::npos);
}

Result<Sketch> read_wacom(const Source& source, const ReadOptions&) {
  if (source.bytes.size() > kMostBytes)
    return Error{ErrorCode::kLimit, fmt::format("{}: {} bytes are over {}", source.name,
                                                source.bytes.size(), kMostBytes)};
  const Result<UimInk> ink = source.bytes.starts_with("RIFF")
                                 ? RiffReader(source).read()
                                 : read_uim_json(source.name, source.bytes);
  if (!ink) return ink.error();
  Sketch sketch;
  sketch.recorded_by = "Wacom ink";
  add_uim_strokes(*ink, sketch);
  return sketch;
}

}  // namespace pentimento::sketch
