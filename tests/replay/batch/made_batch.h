#pragma once
// A batch whose renderer is a script: quick, and as wrong as a test wants it.

#include <algorithm>
#include <filesystem>

#include "formats/png/png_writer.h"
#include "replay/batch/batch.h"
#include "replay/job/report_object.h"
#include "tests/formats/scratch.h"

namespace pentimento::test {

class MadeBatch {
 public:
  /// Logs are text of their own: `ok`, `crash`, `hang`, `exit N`. The state's hash of a log that is
  /// well is that of its file, and the picture is `picture.png` of the folder.
  MadeBatch() {
    write_picture(path("picture.png"), -1);
    spill(path("renderer"), R"sh(#!/bin/sh
log=$2; picture=
while [ $# -gt 0 ]; do
  case $1 in *picture.png) picture=$1;; esac
  shift
done
[ -f "$log" ] || exit 5
case $(head -n 1 "$log") in
  crash) kill -SEGV $$;;
  hang) exec sleep 100;;
  exit*) echo "said so" >&2; exit $(cut -d' ' -f2 "$log");;
  random) state=$(date +%N);;
  ok*) state=$(sha256sum "$log" | cut -c1-64);;
esac
[ -z "$picture" ] || cp picture.png "$picture"
echo "{\"state_sha256\":\"$state\",\"guide_sha256\":\"$state\",\"steps\":3}"
)sh");
    std::filesystem::permissions(path("renderer"), std::filesystem::perms::owner_all);
    request.manifest = path("m.jsonl");
    request.run = path("run");
    request.program = path("renderer");
    request.jobs = 2;
    request.timeout_s = 20;
  }

  /// A job whose log holds `text`.
  void add(const std::string& id, const std::string& text, const std::string& more = {}) {
    if (text != "missing") spill(path(id + ".jsonl"), text + "\n");
    manifest_ +=
        "{\"id\":" + json_string(id) + ",\"log\":" + json_string(id + ".jsonl") + more + "}\n";
    spill(request.manifest, manifest_);
  }
  /// 32 x 24 pixels of grey; pixel `changed` is white.
  static void write_picture(const std::string& file, int changed) {
    PngOptions options;
    options.width = 32;
    options.height = 24;
    auto png = create_png(file, options);
    std::vector<Field<float>> planes;
    for (int c = 0; c < 3; ++c) {
      planes.emplace_back(32, 24, 0.25f);
      if (changed >= 0) planes.back()(changed % 32, changed / 32) = 1;
    }
    PENTIMENTO_CHECK(write_strips(**png, planes, {"R", "G", "B"}, 24).ok());
    PENTIMENTO_CHECK((*png)->finish().ok());
  }

  BatchSummary run() const {
    Result<BatchSummary> summary = run_batch(request, {});
    PENTIMENTO_CHECK(summary.ok());
    return std::move(*summary);
  }
  static const BatchRow& row(const BatchSummary& summary, const std::string& id) {
    const auto found = std::find_if(summary.rows.begin(), summary.rows.end(),
                                    [&](const BatchRow& row) { return row.id == id; });
    PENTIMENTO_CHECK(found != summary.rows.end());
    return *found;
  }
  std::string path(const std::string& name) const { return scratch_.path(name); }

  BatchRequest request;

 private:
  Scratch scratch_;
  std::string manifest_;
};

}  // namespace pentimento::test
