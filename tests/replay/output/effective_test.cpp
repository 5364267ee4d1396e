#include "replay/output/effective.h"

#include <gtest/gtest.h>

#include "formats/io/provenance.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(ShellWord, ComesOutOfAShellAsItWentIn) {
  for (const std::string word : {"plain-1.2_%.png", "a b", "", "it's", "$HOME `x` \"y\" \\", "~",
                                 "a;b", "é", "#1f2f8c", "{a,b}", "*", "!x"}) {
    const auto [status, said] = test::run("printf %s " + shell_word(word));
    EXPECT_EQ(status, 0) << word;
    EXPECT_EQ(said, word);
  }
  EXPECT_EQ(shell_word("plain-1.2_%.png"), "plain-1.2_%.png");  // as people write it
}

Origin made_up() {
  Origin origin;
  origin.log_sha256 = "hash of the log";
  origin.state_sha256 = "hash of the state";
  origin.guide_sha256 = "hash of the guide";
  origin.files = {{"front.png", "f"}};
  origin.grid = {80, 60, 0.4, 0.3};
  origin.detail = 4;
  origin.steps_per_second = 29.97;
  origin.step = 12;
  origin.time_s = 0.5;
  origin.command = "pentimento render a.jsonl";
  origin.model.nu_max_m2_s = 0.02f;
  origin.lighting.lamps[0].direction = {0, 0.6f, 0.8f};
  origin.lighting.lamps[0].intensity = 0.5f;
  Lamp near;
  near.position_m = {0.1f, 0.2f, 0.3f};
  near.intensity = 0.25f;
  near.color = {1, 0.5f, 0.25f};
  origin.lighting.lamps.push_back(near);
  origin.lighting.varnish = 0.125f;
  origin.lighting.exposure_ev = -1;
  origin.lighting.white_xy = {0.34f, 0.35f};
  origin.lighting.tone = ToneCurve::kSoft;
  return origin;
}

TEST(Provenance, SaysEverythingThatAFileDependsOn) {
  const Provenance said = provenance_of(made_up(), {320, 240, 150}, "a b.png");
  for (const auto& [key, value] : {std::pair{"log_sha256", "hash of the log"},
                                   {"state_sha256", "hash of the state"},
                                   {"guide_sha256", "hash of the guide"},
                                   {"file:front.png", "f"},
                                   {"grid", "80 x 60"},
                                   {"canvas_m", "0.4 x 0.3"},
                                   {"detail", "4"},
                                   {"picture", "320 x 240"},
                                   {"dpi", "150"},
                                   {"steps_per_second", "29.97"},
                                   {"step", "12"},
                                   {"time_s", "0.5"},
                                   {"command", "pentimento render a.jsonl -o 'a b.png'"},
                                   {"model.nu_max", "0.02"},
                                   {"light.direction", "0 0.6 0.8"},
                                   {"light.intensity", "0.5"},
                                   {"light1.position_m", "0.1 0.2 0.3"},
                                   {"light1.intensity", "0.25"},
                                   {"light1.color", "1 0.5 0.25"},
                                   {"light1.direction", ""},
                                   {"varnish", "0.125"},
                                   {"occlusion", "1"},
                                   {"exposure_ev", "-1"},
                                   {"white_point", "0.34 0.35"},
                                   {"tone_curve", "soft"},
                                   {"environment.gloss", "sh"},
                                   {"reflection", "environment"},
                                   {"painting", ""}})
    EXPECT_EQ(provenance_value(said, key), value) << key;
}

TEST(Provenance, NamesAnotherPaintingAProbeAndACamera) {
  Origin origin = made_up();
  origin.other_painting = "another";
  origin.lighting.probe[0] = Field<float>(2, 1);
  origin.lighting.reflection.rgb[0] = Field<float>(2, 1);
  const Provenance said = provenance_of(origin, {}, "a.png");
  EXPECT_EQ(provenance_value(said, "painting"), "another");
  EXPECT_EQ(provenance_value(said, "environment.gloss"), "probe");
  EXPECT_EQ(provenance_value(said, "reflection"), "camera");
}

}  // namespace
}  // namespace pentimento
