#include "formats/log/write/to_json.h"

#include <gtest/gtest.h>

#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

/// One event of each type, fields at values that are awkward to print.
const std::vector<std::string> kEvents = {
    R"({"t":0.1,"type":"touch","phase":"down","id":-3,"x":0.30000000000000004,"y":1e-07,)"
    R"("pressure":0.1,"tilt_x":-12.5,"tilt_y":3,"twist":359,"radius":0.004})",
    R"({"t":0.1,"type":"touch","phase":"move","id":-3,"x":5e-324,"y":-0.25})",
    R"({"t":0.2,"type":"touch","phase":"cancel","id":-3,"x":1,"y":2,"x-hover":{"a":[null,true]}})",
    R"({"t":0.3,"type":"gravity","x":-0.1,"y":9.81,"z":0.333333})",
    R"({"t":0.3,"type":"slider","name":"medium","value":0.7})",
    R"({"t":0.3,"type":"slider","name":"jacobi_iterations","value":8})",
    R"({"t":0.3,"type":"slider","name":"superbee","value":true})",
    R"({"t":0.3,"type":"slider","name":"optical_thickness","value":"depth"})",
    R"({"t":0.3,"type":"color","pigment":"mud"})",
    R"({"t":0.3,"type":"color","pigment":"mud","across":[0.25,1]})",
    R"({"t":0.3,"type":"color","value":"#1f2f8c"})",
    R"({"t":0.3,"type":"color","value":[0.1,0.2,1]})",
    R"({"t":0.3,"type":"brush","name":"knife"})",
    R"({"t":0.3,"type":"dry"})",
    R"({"t":0.3,"type":"clear"})",
    R"({"t":0.3,"type":"load","file":"a \"b\" \\ ü.png"})",
    R"({"t":0.3,"type":"undo"})",
    R"({"t":0.3,"type":"redo"})",
    R"({"t":0.3,"type":"light","direction":[0.1,-0.2,1],"intensity":2.5,"color":"#ffeedd"})",
    R"({"t":0.3,"type":"light","follow":"gravity"})",
    R"({"t":0.3,"type":"light","lamp":2,"position":[0.1,-0.2,1],"intensity":2.5})",
    R"({"t":0.3,"type":"environment","file":"probe.exr"})",
    R"({"t":0.3,"type":"environment","file":"probe.exr","soft":true})",
    R"({"t":0.3,"type":"environment","sh":[[1,2,3],[0.1,0.2,0.3],[0,0,0],[0,0,0],[0,0,0],)"
    R"([0,0,0],[0,0,0],[0,0,0],[-1,-2,-3]]})",
    R"({"t":0.3,"type":"camera","file":"a.mp4","start":1.5,"fov":70,"mirror":false})",
    R"({"t":0.3,"type":"step"})",
    R"({"t":12345.678901,"type":"mark","name":"line\u000abreak"})",
    R"({"type":"x-any",  "t":12345.678901, "a":1.50})",
};

const std::string kFullHeader =
    R"({"type":"header","format":"pentimento-log","version":1,)"
    R"("canvas":{"width":0.6,"height":0.45,"edge":"open"},"grid":{"width":64,"height":48},)"
    R"("steps_per_second":59.94,)"
    R"("paper":{"texture":"paper","relief":0.0005,"scale":0.1,"reflectance":[0.9,0.85,0.8]},)"
    R"("palette":[{"name":"mud","color":"#604020","opacity":0.6},)"
    R"({"name":"w","over_white":"#ffffff","over_black":[0.5,0.5,0.5]},)"
    R"({"name":"ks","K":[0.1,0.2,0.3],"S":[1,2,3]},{"name":"ivory black"},)"
    R"({"name":"s","spectrum":{"wavelength":[400,500,600.5],"K":[1,2,3],"S":[0,1,2]}}],)"
    R"("picture":{"exposure":-0.5,"varnish":0.25,"occlusion":0.5,"white_point":[0.35,0.36],)"
    R"("tone_curve":"soft"},)"
    R"("brushes":[{"name":"mop","shape":"round","spacing":0.03,"size_pressure":0.5,)"
    R"("flow_pressure":0.25,"follows_direction":false,"stiffness":0.9,"grip":0.5,"capacity":30,)"
    R"("film":0.75,"absorb":0.125,"bristles":{"count":60,"thickness":0.05,"length_spread":0.5,)"
    R"("clumping":0.25},"pressure":{"size":[[0,0.5],[1,1]],"flow":[[0.25,2]],"splay":[[0,0]]}},)"
    R"({"name":"t","texture":"tip.png"}],)";

TEST(ToJson, EventsAreWrittenAsTheyWereRead) {
  std::string text = kFullHeader + R"("title":"t"})";
  for (const std::string& event : kEvents) text += "\n" + event;
  const Outcome outcome = read_text(text);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  ASSERT_EQ(outcome.events.size(), kEvents.size());
  for (std::size_t i = 0; i < kEvents.size(); ++i) {
    EXPECT_EQ(event_json(outcome.events[i]), kEvents[i]);
  }
}

TEST(ToJson, AHeaderIsReadAsItWasWritten) {
  const Outcome first =
      read_text(kFullHeader + R"("model":{"layers":3,"nu_min":3.3e-6,"scheme":"conservative"},)"
                              R"("title":"a\"b","author":"c","recorded_by":"d","recorded_at":"e",)"
                              R"("x-a":{"b":[1,2.5,"c"]}})");
  ASSERT_TRUE(first.ok) << first.message;
  const std::string json = header_json(first.header);
  const Outcome second = read_text(json);
  ASSERT_TRUE(second.ok) << second.message;
  EXPECT_EQ(header_json(second.header), json);
  // What was given stands in it as it was given.
  EXPECT_EQ(json.substr(0, kFullHeader.size()), kFullHeader);
  EXPECT_NE(json.find(R"("layers":3,"nu_min":3.3e-06,)"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("title":"a\"b","author":"c","recorded_by":"d","recorded_at":"e")"),
            std::string::npos);
  EXPECT_NE(json.find(R"("x-a":{"b":[1,2.5,"c"]}})"), std::string::npos);
}

TEST(ToJson, EveryModelParameterSurvives) {
  Header header;
  header.model.gamma = 0.12345679f;
  header.model.speed_cap_m_s = 0;
  header.model.phi_scales_lateral = false;
  const Outcome outcome = read_text(header_json(header));
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.header.model.gamma, 0.12345679f);
  EXPECT_EQ(outcome.header.model.speed_cap_m_s, 0);
  EXPECT_FALSE(outcome.header.model.phi_scales_lateral);
  EXPECT_EQ(header_json(outcome.header), header_json(header));
}

}  // namespace
}  // namespace pentimento::log
