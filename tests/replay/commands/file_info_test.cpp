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
        "pigments     3\n  blue ", "mark         half\n"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
}

TEST(FileInfo, TellsHowThePenWasHeld) {
  std::string log = test::kSmallLog;
  log +=
      R"({"t":1.3,"type":"touch","phase":"down","id":9,"x":0.1,"y":0.2,"pressure":0.05,"tilt_x":45})"
      "\n"
      R"({"t":1.4,"type":"touch","phase":"move","id":9,"x":0.2,"y":0.2,"pressure":1,"tilt_x":3,"tilt_y":-4})"
      "\n"
      R"({"t":1.5,"type":"touch","phase":"up","id":9,"x":0.2,"y":0.2,"pressure":0.95})"
      "\n";
  const test::JobFolder folder(log);
  const auto info = file_info(folder.path("a.jsonl"), {}, 20);
  ASSERT_TRUE(info) << info.error().message;
  EXPECT_EQ(info->log->summary.tilts, (std::array<std::int64_t, 9>{1, 0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_GE(info->log->summary.pressures[9], 2);
  EXPECT_GE(info->log->summary.pressures[0], 1);
  const std::string json = info_json(*info);
  EXPECT_NE(json.find("\"tilts\":[1,0,0,0,1,0,0,0,0]"), std::string::npos) << json;
  EXPECT_NE(json.find("\"extent_m\":["), std::string::npos) << json;
  ASSERT_TRUE(info->preview);
  EXPECT_EQ(info->preview->width(), 20);
  const std::string text = info_text(*info);
  EXPECT_NE(text.find("tilt         0 \u2588"), std::string::npos) << text;
  EXPECT_NE(text.find("\u2580"), std::string::npos);
  EXPECT_NE(text.find("#e0c020\n"), std::string::npos);
  EXPECT_FALSE(file_info(folder.path("a.jsonl"), {})->preview);
}

TEST(FileInfo, OfARecordingIsWhatItsLogWouldHold) {
  const test::JobFolder folder;
  folder.write("a.dat", "0 10 10 0.5\n1 20 30 0.6\n2 20 30 0\n");
  const auto info = file_info(folder.path("a.dat"), {}, 10);
  ASSERT_TRUE(info) << info.error().message;
  const std::string json = info_json(*info);
  for (const auto& [key, value] : {std::pair{"kind", "recording"},
                                   {"format", "mypaint"},
                                   {"strokes", "1"},
                                   {"samples", "2"},
                                   {"duration_s", "1"},
                                   {"colors", "1"}})
    EXPECT_EQ(json_member(json, key), value) << key;
  EXPECT_NE(json.find("\"swatches\":[\"#000000\"]"), std::string::npos) << json;
  const std::string text = info_text(*info);
  EXPECT_NE(text.find("recording, mypaint\n"), std::string::npos);
  EXPECT_NE(text.find("colours      1\n  \x1b[48;2;0;0;0m  \x1b[0m #000000\n"), std::string::npos)
      << "on a terminal a patch of the colour comes first: " << text;
  const auto piped = file_info(folder.path("a.dat"), {});
  ASSERT_TRUE(piped);
  EXPECT_NE(info_text(*piped).find("colours      1\n  #000000\n"), std::string::npos);
  EXPECT_TRUE(info->preview);
  folder.write("b.dat", "0 10 10 7\n");
  EXPECT_FALSE(file_info(folder.path("b.dat"), {}));
}

// What is no JSON is no log that somebody spoilt.
TEST(FileInfo, OfAFileOfNoKindItSaysThat) {
  const test::JobFolder folder;
  for (const std::string& bytes : {std::string("what is this\n"),
                                   std::string("\0\0\0\x20"
                                               "ftypisom\0\0\2\0",
                                               16),
                                   std::string("\xFF\xD8\xFF\xE0")}) {
    folder.write("film.mp4", bytes);
    const auto info = file_info(folder.path("film.mp4"), {});
    ASSERT_FALSE(info);
    EXPECT_EQ(info.error().code, ErrorCode::kBadInput);
    EXPECT_EQ(info.error().message,
              folder.path("film.mp4") +
                  ": neither a log nor a recording, PNG, EXR or state dump that can be read");
  }
  // A spoilt log is told where it is spoilt.
  for (const auto& [bytes, said] :
       {std::pair{std::string("{\"type\":\"header\",}\n"), ":1:"},
        {std::string(), ":1: the log is empty"},
        {"\xef\xbb\xbf" + test::kSmallLog, ":1: the log starts with a byte order mark"}}) {
    folder.write("b.jsonl", bytes);
    const auto info = file_info(folder.path("b.jsonl"), {});
    ASSERT_FALSE(info);
    EXPECT_TRUE(info.error().message.starts_with(folder.path("b.jsonl") + said))
        << info.error().message;
  }
}

TEST(FileInfo, OfAPipeIsWhatItIsOfTheFile) {
  const test::JobFolder folder;
  folder.write("a.dat", "0 10 10 0.5\n1 20 30 0.6\n2 20 30 0\n");
  const std::string command = PENTIMENTO_COMMAND;
  for (const char* name : {"a.dat", "a.jsonl"}) {
    const std::string path = folder.path(name);
    const auto plain = test::run(command + " info " + path);
    ASSERT_EQ(plain.first, 0) << plain.second;
    for (const std::string& given :
         {"cat " + path + " | " + command + " info -", command + " info - < " + path,
          "gzip -c " + path + " | " + command + " info -",
          "bash -c '" + command + " info <(cat " + path + ")'"})
      EXPECT_EQ(test::run(given), plain) << given;
  }
  const auto picture = test::run("printf '\\211PNG....' | " + command + " info -");
  EXPECT_EQ(picture.first, 3);
  EXPECT_EQ(picture.second,
            "pentimento: standard input: a picture or a state dump, which can be read from a file "
            "only\n");
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
