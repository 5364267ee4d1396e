// The pages of a batch's report.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/image/read_image.h"
#include "formats/image/resample.h"
#include "formats/io/publish.h"
#include "formats/io/sha256.h"
#include "formats/png/png_writer.h"
#include "replay/batch/batch_report.h"
#include "replay/batch/page_source.h"
#include "replay/batch/run_folder.h"

namespace pentimento {

namespace {
namespace fs = std::filesystem;
using nlohmann::json;
constexpr int kThumbnailSide = 320;  // pixels, of the longer side

/// JSON that may stand in a page: no end of a script element within.
std::string page_json(const json& value) {
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  return text;
}

void replace(std::string& text, std::string_view mark, std::string_view with) {
  const std::size_t at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), with);
}

Result<void> write_thumbnail(const std::string& picture, const std::string& thumbnail) {
  Result<std::array<Field<float>, 3>> planes = read_rgb(picture);
  if (!planes) return planes.error();
  const int width = (*planes)[0].width(), height = (*planes)[0].height();
  const double scale = std::min(1.0, double{kThumbnailSide} / std::max(width, height));
  PngOptions options;
  options.width = std::max(1, static_cast<int>(width * scale));
  options.height = std::max(1, static_cast<int>(height * scale));
  Result<std::unique_ptr<PictureFile>> png = create_png(thumbnail, options);
  if (!png) return png.error();
  PictureStrip strip;
  std::array<Field<float>, 3> small;
  for (std::size_t i = 0; i < 3; ++i)
    small[i] = resample_to((*planes)[i].view(), options.width, options.height);
  strip.rows = options.height;
  strip.name = {"R", "G", "B"};
  for (const Field<float>& plane : small) strip.plane.push_back(plane.view());
  if (Result<void> wrote = (*png)->write(strip); !wrote) return wrote;
  Result<Published> done = (*png)->finish();
  if (!done) return done.error();
  return {};
}

Result<std::string> copied(const std::string& file, const fs::path& folder,
                           const std::string& name) {
  std::error_code problem;
  fs::copy_file(file, folder / name, fs::copy_options::overwrite_existing, problem);
  if (problem)
    return Error{ErrorCode::kIo,
                 fmt::format("{}: {}", (folder / name).string(), problem.message())};
  return name;
}

/// Adds the pictures that the page shows of a row: a small one of each, and both in full size of
/// what failed.
Result<void> add_pictures(const ReportRow& one, const fs::path& folder, json& row) {
  Result<RunFolder> run = RunFolder::open(one.run);
  if (!run || one.row.key.empty()) return {};
  const std::string picture = run->file_of(one.row.key, "picture.png");
  std::error_code ignored;
  if (!fs::exists(picture, ignored)) return {};
  const std::string stem = "pictures/" + one.row.key.substr(0, 32);
  if (Result<void> made = write_thumbnail(picture, (folder / (stem + "-small.png")).string());
      !made)
    return made;
  row["thumbnail"] = stem + "-small.png";
  if (one.row.passed()) return {};
  Result<std::string> full = copied(picture, folder, stem + ".png");
  if (!full) return full.error();
  row["picture"] = *full;
  const std::string golden = run->golden_picture(one.row.golden_picture_sha256);
  if (one.row.golden_picture_sha256.empty() || !fs::exists(golden, ignored)) return {};
  Result<std::string> its = copied(golden, folder, stem + "-golden.png");
  if (!its) return its.error();
  row["golden"] = *its;
  return {};
}
}  // namespace

Result<void> write_html(const BatchReport& report, const std::string& folder) {
  std::error_code problem;
  fs::create_directories(fs::path(folder) / "pictures", problem);
  if (problem) return Error{ErrorCode::kIo, fmt::format("{}: {}", folder, problem.message())};
  json data = json::parse(report_rows_json(report));
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    if (Result<void> added = add_pictures(report.rows[i], folder, data["rows"][i]); !added)
      return added;
  }
  std::string page(page_source("report.html"));
  replace(page, "@CSS@", page_source("report.css"));
  replace(page, "@SCRIPT@", page_source("report.js"));
  replace(page, "@REPORT@", page_json(data));
  Result<Published> done = publish_bytes((fs::path(folder) / "index.html").string(), page);
  if (!done) return done.error();
  return {};
}

}  // namespace pentimento
