#include "replay/commands/file_info.h"

#include <gtest/gtest.h>

#include "tests/cli/command_run.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::json_member;

TEST(FileInfo, OfALogIsWhatItHolds) {
  std::string log = test::kSmallLog + R"({"t":1.3,"type":"dry"})" + "\n" +
                    R"({"t":1.4,"type":"undo"})" + "\n" + R"({"t":1.5,"type":"undo"})" + "\n";
  log.replace(log.find("\"palette\""), 0, R"("title":"T","author":"A","steps_per_second":50,)");
  const test::JobFolder folder(log);
  const auto info = file_info(folder.path("a.jsonl"), {});
  ASSERT_TRUE(info) << info.error().message;
  const std::string json = info_json(*info);
  for (const auto& [key, value] : {std::pair{"kind", "log"},
                                   {"title", "T"},
                                   {"author", "A"},
                                   {"canvas_width_m", "0.4"},
                                   {"canvas_height_m", "0.3"},
                                   {"grid_width", "80"},
                                   {"grid_height", "60"},
                                   {"steps_per_second", "50"},
                                   {"stepped", "false"},
                                   {"events", "13"},
                                   {"strokes", "2"},
                                   {"undone", "2"},  // the drying, then the second stroke
                                   {"steps", "76"},  // 1.5 s are 75 steps; the last event's own
                                   {"duration_s", "1.5"}})
    EXPECT_EQ(json_member(json, key), value) << key;
  EXPECT_NE(json.find(R"("pigments":["blue","red","#e0c020"])"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("marks":["half","end"])"), std::string::npos) << json;
  EXPECT_EQ(json_member(json, "log_sha256"),
            test::run("sha256sum " + folder.path("a.jsonl")).second.substr(0, 64));
  const std::string text = info_text(*info);
  for (const char* line :
       {"title        T\n", "canvas       0.4 x 0.3 m\n", "grid         80 x 60 cells\n",
        "duration     1.5 s, 76 steps of 1/50 s\n", "events       13\n",
        "strokes      2 (2 strokes, dryings, clearings or loads undone)\n",
        "pigments     3\n  blue\n", "mark         half\n"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
}

TEST(FileInfo, OfAnOutputIsWhatItSaysWhateverItIsCalled) {
  const test::JobFolder folder;
  RenderJob job = folder.job({"a.png", "a.h5", "a.exr"});
  job.size.dpi = 100;
  test::rendered(job);
  for (const auto& [file, kind, format] : {std::tuple{"a.png", "picture", "png"},
                                           {"a.h5", "state", "hdf5"},
                                           {"a.exr", "picture", "exr"}}) {
    std::filesystem::rename(folder.path(file), folder.path("x.jsonl"));
    const auto info = file_info(folder.path("x.jsonl"), {});
    ASSERT_TRUE(info) << info.error().message;
    const std::string json = info_json(*info);
    EXPECT_EQ(json_member(json, "kind"), kind);
    EXPECT_EQ(json_member(json, "format"), format);
    EXPECT_EQ(json_member(json, "width"), "80");
    EXPECT_EQ(json_member(json, "height"), "60");
    EXPECT_EQ(json_member(json, "step"), "55");
  }
}

}  // namespace
}  // namespace pentimento
