#pragma once
// The options that `render` and `relight` share: which files are written, how large, in which
// light.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/job/render_job.h"

namespace CLI {
class App;
}

namespace pentimento::cli {

/// The options as typed. The member functions turn them into the values that a job takes.
/// Errors: kUsage.
struct PictureOptions {
  std::vector<std::string> outputs;
  std::optional<int> width, height;
  std::optional<double> scale;
  std::string print;
  double dpi = 0;
  std::string crop, aov, debug_view, light, environment, backend = "auto";
  std::string profile = "srgb", dither = "off";
  std::vector<std::string> lamps;
  std::string white_point, tone_curve;
  std::optional<double> exposure, varnish, occlusion;
  int bit_depth = 8, tile = kPictureTile, threads = 0;
  bool full_float = false, no_clobber = false, soft_environment = false;

  void add_to(CLI::App& app);
  Result<PictureChoice> picture() const;
  Result<LightChoice> lighting() const;
  SizeRequest size() const;

 private:
  Result<void> development(log::PictureSpec& picture) const;
};

/// The options of progress, messages and the closing report.
struct TalkOptions {
  bool quiet = false, json = false;
  std::string progress = "auto";

  void add_to(CLI::App& app);
};

/// Checks that something is written, and that not both a picture and a report go to standard
/// output.
/// Errors: kUsage.
Result<void> check_outputs(const std::vector<std::string>& outputs, bool json);

}  // namespace pentimento::cli
