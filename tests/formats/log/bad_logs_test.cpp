// Every rule of docs/action-log.md broken once: the line and the words of the message.

#include <gtest/gtest.h>

#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

struct BadEvent {
  const char* events;  // after the header, that is from line 2 on
  const char* message;
};

void PrintTo(const BadEvent& bad, std::ostream* out) {
  *out << bad.events;
}

class BadEvents : public testing::TestWithParam<BadEvent> {};

TEST_P(BadEvents, AreNamedByLineFieldValueAndLimit) {
  const Outcome outcome = read_text(kHeaderLine + GetParam().events + "\n");
  EXPECT_FALSE(outcome.ok);
  EXPECT_EQ(outcome.code, ErrorCode::kBadInput);
  EXPECT_EQ(outcome.message, GetParam().message);
}

constexpr BadEvent kJson[] = {
    {R"({"t":1,"type":"dry")", "a.jsonl:2: not valid JSON: it does not end"},
    {R"({"t":1,"type":"dry"}})",
     "a.jsonl:2: not valid JSON: column 21: unexpected '}'; expected end of input"},
    {R"({"t":1,"type":"dry"} {})",
     "a.jsonl:2: not valid JSON: column 22: unexpected '{'; expected end of input"},
    {R"({"t":1,"type":"dry",})", "a.jsonl:2: not valid JSON: column 21: a comma before }"},
    {"{'t':1}", "a.jsonl:2: not valid JSON: column 2: JSON has double quotes, not single ones"},
    {R"({"t":1,"type":"dry"} // dry)",
     "a.jsonl:2: not valid JSON: column 22: JSON has no comments"},
    {R"({"t":01,"type":"dry"})",
     "a.jsonl:2: not valid JSON: column 7: unexpected number literal; expected '}'"},
    {R"({"t":NaN,"type":"dry"})",
     "a.jsonl:2: not valid JSON: column 6: NaN is not a number of JSON"},
    {R"({"t":Infinity,"type":"dry"})",
     "a.jsonl:2: not valid JSON: column 6: Infinity is not a number of JSON"},
    {"[1,2]", "a.jsonl:2: not a JSON object"},
    {"12", "a.jsonl:2: not a JSON object"},
    {"{\"t\":1,\"type\":\"mark\",\"name\":\"a\tb\"}",
     "a.jsonl:2: not valid JSON: a control character inside a string"},
    {"{\"t\":1,\"type\":\"mark\",\"name\":\"\xff\"}", "a.jsonl:2: not valid UTF-8"},
    {R"({"t":1,"type":"mark","name":"a\u0000b"})", "a.jsonl:2: a string holds a NUL character"},
    {R"({"t":1,"type":"mark","name":"\ud800"})",
     "a.jsonl:2: not valid JSON: column 36: invalid string: surrogate U+D800..U+DBFF must be "
     "followed by U+DC00..U+DFFF"},
    {R"({"t":1e400,"type":"dry"})", "a.jsonl:2: t 1e400 does not fit a double-precision number"},
    {R"({"t":1e-400,"type":"dry"})", "a.jsonl:2: t 1e-400 does not fit a double-precision number"},
    {R"({"t":100000000000000000000,"type":"dry"})",
     "a.jsonl:2: t 100000000000000000000 does not fit a double-precision number"},
    {R"({"t":1,"t":1,"type":"dry"})", R"(a.jsonl:2: duplicate key "t")"},
    {R"({"t":1,"\u0074":1,"type":"dry"})", R"(a.jsonl:2: duplicate key "t")"},
    {R"({"t":1,"type":"x-a","b":{"c":1,"c":2}})", R"(a.jsonl:2: duplicate key "c")"},
    {R"({"t":1,"type":"x-a","b":[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]})",
     "a.jsonl:2: nested deeper than 16 levels"},
};
INSTANTIATE_TEST_SUITE_P(Json, BadEvents, testing::ValuesIn(kJson));

constexpr BadEvent kCommon[] = {
    {R"({"type":"dry"})", "a.jsonl:2: t is missing"},
    {R"({"t":1})", "a.jsonl:2: type is missing"},
    {"{}", "a.jsonl:2: t is missing"},
    {R"({"t":"1","type":"dry"})", R"(a.jsonl:2: t "1" is not a number)"},
    {R"({"t":null,"type":"dry"})", "a.jsonl:2: t null is not a number"},
    {R"({"t":true,"type":"dry"})", "a.jsonl:2: t true is not a number"},
    {R"({"t":-0.1,"type":"dry"})", "a.jsonl:2: t -0.1 is outside 0..9000000000 s"},
    {R"({"t":1,"type":7})", "a.jsonl:2: type 7 is not a string"},
    {R"({"t":1,"type":"tuch"})", R"(a.jsonl:2: unknown type "tuch" (did you mean "touch"?))"},
    {R"({"t":1,"type":"dry","why":1})", R"(a.jsonl:2: unknown field "why")"},
    {R"({"t":1,"type":"header"})", "a.jsonl:2: a second header"},
    {R"({"type":"header","format":"pentimento-log","version":1})", "a.jsonl:2: a second header"},
    {"\n{\"t\":2,\"type\":\"dry\"}\n\n{\"t\":1.5,\"type\":\"dry\"}",
     "a.jsonl:5: t 1.5 is before 2, the time of the event before"},
};
INSTANTIATE_TEST_SUITE_P(Common, BadEvents, testing::ValuesIn(kCommon));

constexpr BadEvent kTouches[] = {
    {R"({"t":0,"type":"touch","x":0,"y":0})", "a.jsonl:2: phase is missing"},
    {R"({"t":0,"type":"touch","phase":"press","x":0,"y":0})",
     R"(a.jsonl:2: phase "press" is not down, move, up, cancel)"},
    {R"({"t":0,"type":"touch","phase":"down","y":0})", "a.jsonl:2: x is missing"},
    {R"({"t":0,"type":"touch","phase":"down","x":0})", "a.jsonl:2: y is missing"},
    {R"({"t":0,"type":"touch","phase":"down","x":1001,"y":0})",
     "a.jsonl:2: x 1001 is outside -1000..1000 m"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":[]})", "a.jsonl:2: y [] is not a number"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"pressure":1.7})",
     "a.jsonl:2: pressure 1.7 is outside 0..1"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"tilt_x":91})",
     "a.jsonl:2: tilt_x 91 is outside -90..90 degrees"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"tilt_y":-91})",
     "a.jsonl:2: tilt_y -91 is outside -90..90 degrees"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"twist":361})",
     "a.jsonl:2: twist 361 is outside -360..360 degrees"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"radius":1e30})",
     "a.jsonl:2: radius 1e+30 is outside 0..10 m"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"id":1.5})",
     "a.jsonl:2: id 1.5 is not a whole number"},
    {R"({"t":0,"type":"touch","phase":"down","x":0,"y":0,"presure":1})",
     R"(a.jsonl:2: unknown field "presure" (did you mean "pressure"?))"},
    {R"({"t":0,"type":"touch","phase":"move","x":0,"y":0})",
     R"(a.jsonl:2: phase "move" of id 0, which is not down)"},
    {R"({"t":0,"type":"touch","phase":"up","id":3,"x":0,"y":0})",
     R"(a.jsonl:2: phase "up" of id 3, which is not down)"},
    {R"({"t":0,"type":"touch","phase":"cancel","x":0,"y":0})",
     R"(a.jsonl:2: phase "cancel" of id 0, which is not down)"},
    {"{\"t\":0,\"type\":\"touch\",\"phase\":\"down\",\"x\":0,\"y\":0}\n"
     R"({"t":0,"type":"touch","phase":"down","x":0,"y":0})",
     R"(a.jsonl:3: phase "down" of id 0, which is down already)"},
};
INSTANTIATE_TEST_SUITE_P(Touches, BadEvents, testing::ValuesIn(kTouches));

constexpr BadEvent kControls[] = {
    {R"({"t":0,"type":"gravity","x":0,"y":0})", "a.jsonl:2: z is missing"},
    {R"({"t":0,"type":"gravity","x":0,"y":0,"z":1e9})",
     "a.jsonl:2: z 1000000000 is outside -1000..1000 m/s^2"},
    {R"({"t":0,"type":"slider","value":0})", "a.jsonl:2: name is missing"},
    {R"({"t":0,"type":"slider","name":"medium"})", "a.jsonl:2: value is missing"},
    {R"({"t":0,"type":"slider","name":"medum","value":0})",
     R"(a.jsonl:2: name "medum" is not a slider (did you mean "medium"?))"},
    {R"({"t":0,"type":"slider","name":"layers","value":2})",
     R"(a.jsonl:2: name "layers" is not a slider (did you mean "layer_mixing" or "layer_speed"?))"},
    {R"({"t":0,"type":"slider","name":"medium","value":1.1})",
     "a.jsonl:2: value 1.1 is outside 0..1 of max_medium"},
    {R"({"t":0,"type":"slider","name":"size","value":0})",
     "a.jsonl:2: value 0 is outside 1e-05..100 m"},
    {R"({"t":0,"type":"slider","name":"nu_min","value":1})",
     "a.jsonl:2: nu_min 1 is not below nu_max 0.01"},
    {R"({"t":0,"type":"slider","name":"superbee","value":1})",
     "a.jsonl:2: value 1 is not true or false"},
    {R"({"t":0,"type":"color"})", "a.jsonl:2: color needs either pigment or value"},
    {R"({"t":0,"type":"color","value":"#102030","across":[0.5,0.5]})",
     "a.jsonl:2: across 0.5 is not below 0.5"},
    {R"({"t":0,"type":"color","value":"#102030","across":[0,0.5,1]})",
     "a.jsonl:2: across has 3 numbers, not 2"},
    {R"({"t":0,"type":"color","value":"#102030","across":[0,2]})",
     "a.jsonl:2: across[1] 2 is outside 0..1"},
    {R"({"t":0,"type":"color","pigment":"a","value":"#000000"})",
     "a.jsonl:2: color needs either pigment or value"},
    {R"({"t":0,"type":"color","pigment":"mud"})", R"(a.jsonl:2: pigment "mud" is unknown)"},
    {R"({"t":0,"type":"color","value":"#12345"})", R"(a.jsonl:2: value "#12345" is not #rrggbb)"},
    {R"({"t":0,"type":"color","value":"#12345g"})", R"(a.jsonl:2: value "#12345g" is not #rrggbb)"},
    {R"({"t":0,"type":"color","value":[0,0]})",
     "a.jsonl:2: value [0,0] is not an array of three numbers"},
    {R"({"t":0,"type":"color","value":[0,0,2]})", "a.jsonl:2: value[2] 2 is outside 0..1"},
    {R"({"t":0,"type":"color","value":[[],0,2]})", "a.jsonl:2: value[0] [] is not a number"},
    {R"({"t":0,"type":"color","value":5})",
     R"(a.jsonl:2: value 5 is neither "#rrggbb" nor three numbers 0..1)"},
    {R"({"t":0,"type":"brush"})", "a.jsonl:2: name is missing"},
    {R"({"t":0,"type":"brush","name":"rond"})",
     R"(a.jsonl:2: brush "rond" is unknown (did you mean "round"?))"},
    {R"({"t":0,"type":"mark"})", "a.jsonl:2: name is missing"},
    {R"({"t":0,"type":"mark","name":""})", R"(a.jsonl:2: name "" is empty)"},
};
INSTANTIATE_TEST_SUITE_P(Controls, BadEvents, testing::ValuesIn(kControls));

constexpr BadEvent kScene[] = {
    {R"({"t":0,"type":"load"})", "a.jsonl:2: file is missing"},
    {R"({"t":0,"type":"load","file":""})", R"(a.jsonl:2: file "" is empty)"},
    {R"({"t":0,"type":"load","file":"/etc/passwd"})",
     R"(a.jsonl:2: file "/etc/passwd" is an absolute path)"},
    {R"({"t":0,"type":"load","file":"a/../../b.png"})",
     R"(a.jsonl:2: file "a/../../b.png" leaves the log's folder)"},
    {R"({"t":0,"type":"light"})",
     "a.jsonl:2: light needs direction, position, intensity, color or follow"},
    {R"({"t":0,"type":"light","direction":[0,0,1],"position":[0,0,1]})",
     "a.jsonl:2: light has both direction and position"},
    {R"({"t":0,"type":"light","lamp":7,"intensity":1})", "a.jsonl:2: lamp 7 is outside 0..6"},
    {R"({"t":0,"type":"light","direction":[0,0,0]})", "a.jsonl:2: direction [0,0,0] has no length"},
    {R"({"t":0,"type":"light","direction":[0,0,1],"follow":"gravity"})",
     "a.jsonl:2: light has both direction and follow"},
    {R"({"t":0,"type":"light","follow":"me"})", R"(a.jsonl:2: follow "me" is not gravity)"},
    {R"({"t":0,"type":"light","intensity":-1})", "a.jsonl:2: intensity -1 is outside 0..1000000"},
    {R"({"t":0,"type":"environment"})", "a.jsonl:2: environment needs either file or sh"},
    {R"({"t":0,"type":"environment","sh":[[1,1,1]]})",
     "a.jsonl:2: sh needs 9 triples of red, green and blue"},
    {R"({"t":0,"type":"environment","sh":[1,2,3,4,5,6,7,8,9]})",
     "a.jsonl:2: sh[0] 1 is not an array of three numbers"},
    {R"({"t":0,"type":"environment","soft":true,"sh":[[1,1,1],[0,0,0],[0,0,0],[0,0,0],[0,0,0],)"
     R"([0,0,0],[0,0,0],[0,0,0],[0,0,0]]})",
     "a.jsonl:2: environment has both sh and soft"},
    {R"({"t":0,"type":"environment","file":"a.exr","soft":1})",
     "a.jsonl:2: soft 1 is not true or false"},
    {R"({"t":0,"type":"camera"})", "a.jsonl:2: file is missing"},
    {R"({"t":0,"type":"camera","file":"a.mp4","fov":180})",
     "a.jsonl:2: fov 180 is outside 1..179 degrees"},
    {R"({"t":0,"type":"camera","file":"a.mp4","start":-1})",
     "a.jsonl:2: start -1 is outside 0..1000000 s"},
    {R"({"t":0,"type":"camera","file":"a.mp4","mirror":1})",
     "a.jsonl:2: mirror 1 is not true or false"},
};
INSTANTIATE_TEST_SUITE_P(Scene, BadEvents, testing::ValuesIn(kScene));

}  // namespace
}  // namespace pentimento::log
