#pragma once
// Jobs of tests on logs of a few lines, each in a folder that goes away.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/io/provenance.h"
#include "replay/commands/render.h"
#include "tests/cli/command_run.h"
#include "tests/formats/scratch.h"

namespace pentimento::test {

/// The header of kSmallLog (80 x 60 cells, 0.4 x 0.3 m) and a newline.
inline std::string small_header() {
  return kSmallLog.substr(0, kSmallLog.find('\n') + 1);
}

/// A folder with the log `a.jsonl`.
class JobFolder {
 public:
  explicit JobFolder(const std::string& log = kSmallLog) { spill(path("a.jsonl"), log); }

  std::string path(const std::string& name) const { return scratch_.path(name); }
  void write(const std::string& name, const std::string& bytes) const { spill(path(name), bytes); }

  /// To write `outputs`, with its `--at`.
  RenderJob job(const std::vector<std::string>& outputs, const std::vector<std::string>& stops = {},
                const std::string& log = "a.jsonl") const {
    RenderJob job;
    job.log = path(log);
    for (const std::string& output : outputs) job.picture.outputs.push_back(path(output));
    for (const std::string& stop : stops) job.stops.push_back(parse_stop_point(stop).value());
    job.threads = 1;
    return job;
  }

  /// What the file `name` says of itself under `key`.
  std::string says(const std::string& name, const std::string& key) const {
    const auto about = describe_file(path(name));
    EXPECT_TRUE(about) << about.error().message;
    return about ? provenance_value(about->provenance, key) : "";
  }

 private:
  Scratch scratch_;
};

/// The report of a job that must succeed.
inline JobReport rendered(const RenderJob& job) {
  Result<JobReport> done = render(job, Control());
  EXPECT_TRUE(done) << done.error().message;
  return done ? std::move(*done) : JobReport();
}

}  // namespace pentimento::test
