#pragma once
// A job that fills a folder with slots: what can go wrong with them is tried on it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/replay/checkpoint/interrupted_job.h"
#include "tests/replay/small_job.h"

namespace pentimento::test {

/// Two fingers at once, hairs, a knife that takes paint up, an undone stroke, paint that dries and
/// paint that runs, sliders, and a fresh canvas in between.
inline std::string busy_log(const std::string& header_members = "") {
  return R"({"type":"header","format":"pentimento-log","version":1,"canvas":{"width":0.2,"height":0.15},)"
         R"("grid":{"width":48,"height":36},)" +
         header_members +
         R"("palette":[{"name":"blue","over_white":"#1f2f8c","over_black":"#05071c"},)"
         R"({"name":"red","over_white":"#c02018","over_black":"#300808"}]})"
         R"(
{"t":0,"type":"color","pigment":"blue"}
{"t":0.02,"type":"brush","name":"fan"}
{"t":0.05,"type":"touch","id":1,"phase":"down","x":0.03,"y":0.04}
{"t":0.08,"type":"touch","id":2,"phase":"down","x":0.04,"y":0.11}
{"t":0.15,"type":"touch","id":1,"phase":"move","x":0.1,"y":0.06}
{"t":0.18,"type":"touch","id":2,"phase":"move","x":0.12,"y":0.1}
{"t":0.22,"type":"touch","id":1,"phase":"up","x":0.16,"y":0.04}
{"t":0.26,"type":"touch","id":2,"phase":"up","x":0.17,"y":0.12}
{"t":0.28,"type":"dry"}
{"t":0.3,"type":"color","pigment":"red"}
{"t":0.3,"type":"slider","name":"size","value":0.04}
{"t":0.32,"type":"touch","id":1,"phase":"down","x":0.05,"y":0.02}
{"t":0.42,"type":"touch","id":1,"phase":"up","x":0.06,"y":0.13}
{"t":0.43,"type":"undo"}
{"t":0.44,"type":"touch","id":1,"phase":"down","x":0.12,"y":0.02}
{"t":0.54,"type":"touch","id":1,"phase":"up","x":0.1,"y":0.1}
{"t":0.56,"type":"gravity","x":0,"y":9.8,"z":1}
{"t":0.7,"type":"brush","name":"knife"}
{"t":0.72,"type":"touch","id":4,"phase":"down","x":0.06,"y":0.05}
{"t":0.9,"type":"touch","id":4,"phase":"up","x":0.15,"y":0.08}
{"t":0.95,"type":"mark","name":"end"}
)";
}

inline RenderJob checkpointed(RenderJob job, const JobFolder& folder) {
  job.checkpoint.folder = folder.path("ck");
  return job;
}

/// A job that was interrupted at steps 20 and 30, so that it has two slots.
struct TwoSlots {
  TwoSlots() : folder(busy_log()), job(checkpointed(folder.job({"a.h5"}), folder)) {
    job.detail = 2;
    interrupt(job, 15);
    interrupt(job, 8);
  }
  std::vector<std::string> slots() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("ck")))
      if (entry.path().extension() == ".slot") names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  JobFolder folder;
  RenderJob job;
};

/// What another run of the job says, without changing the slots.
inline Error refusal(const RenderJob& job) {
  Result<JobReport> done = render(job, Control());
  EXPECT_FALSE(done) << "it was taken";
  return done ? Error{} : done.error();
}

}  // namespace pentimento::test
