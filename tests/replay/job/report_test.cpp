#include "replay/job/report.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// The report's JSON as Python reads it: the value of the expression `e` of the object `r`.
std::string read(const JobReport& report, const std::string& e) {
  const test::Scratch scratch;
  test::spill(scratch.path("r.json"), report_json(report));
  test::spill(scratch.path("r.py"),
              "import json, sys\nr = json.load(open(sys.argv[1]))\nprint(" + e + ", end='')\n");
  return test::run("/usr/bin/python3 " + scratch.path("r.py") + " " + scratch.path("r.json"))
      .second;
}

JobReport made_up() {
  JobReport report;
  report.outputs = {{"a.png", 80, 60, "f1", {}}, {"a.depth.png", 81, 61, "f2", {{0.5, 0.25, "m"}}}};
  report.steps = 100;
  report.steps_computed = 40;
  report.simulated_s = 2.5;
  report.wall_s = 1.5;
  report.peak_memory_bytes = 181'000'000;
  report.threads = 7;
  report.state_sha256 = std::string(64, 's');
  report.guide_sha256 = "guide";
  report.log_sha256 = "log";
  report.detail = 3;
  report.paint = {{"medium", 8, 4, 2, 1}, {"blue", 16, 1, 2, 5}};
  report.lock = LockStatistics{{10, 20, 30, 5, 5, 10, 10, 10}, 9};
  report.fluid = {{"awake", 0.5}};
  report.phases = {{"read", 0.25}, {"shade", 0.5}};
  return report;
}

TEST(Report, JsonHasEveryMemberUnderItsName) {
  const JobReport report = made_up();
  EXPECT_EQ(read(report,
                 "[r[k] for k in ('steps', 'steps_computed', 'simulated_s', 'wall_s', "
                 "'peak_memory_bytes', 'threads', 'detail')]"),
            "[100, 40, 2.5, 1.5, 181000000, 7, 3]");
  EXPECT_EQ(read(report, "r['state_sha256'][:1], r['guide_sha256'], r['log_sha256']"),
            "s guide log");
  EXPECT_EQ(read(report, "[list(f.values()) for f in r['outputs']]"),
            "[['a.png', 80, 60, 'f1'], ['a.depth.png', 81, 61, 'f2', 0.5, 0.25, 'm']]");
  EXPECT_EQ(read(report, "r['phases'], r['fluid']"),
            "[{'name': 'read', 'wall_s': 0.25}, {'name': 'shade', 'wall_s': 0.5}] {'awake': 0.5}");
  EXPECT_EQ(read(report, "'painting' in r"), "False");
}

TEST(Report, TheBooksSayWhatIsMissing) {
  // Of 8 laid, 4 were lifted, 2 dried and 1 is wet: an eighth is missing. Of 16: a half.
  EXPECT_EQ(read(made_up(), "list(r['paint']['medium'].items())"),
            "[('deposited_m3', 8), ('picked_up_m3', 4), ('dried_m3', 2), ('wet_m3', 1), "
            "('relative_difference', 0.125)]");
  EXPECT_EQ(read(made_up(), "[list(p.items()) for p in r['paint']['pigments']]"),
            "[[('name', 'blue'), ('deposited', 16), ('picked_up', 1), ('dried', 2), ('wet', 5), "
            "('relative_difference', 0.5)]]");
  EXPECT_EQ(PaintLine().relative_difference(), 0);  // nothing of nothing
}

TEST(Report, SharesOfLockedBlocksAddUp) {
  // Of 100 blocks.
  EXPECT_EQ(read(made_up(), "list(r['lock'].values())"),
            "[100, 9, 0.1, 0.3, 0.6, 0.65, 0.7, 0.8, 0.9]");
  JobReport none = made_up();
  none.lock->blocks = {};
  EXPECT_EQ(read(none, "r['lock']['within_0.1']"), "0");
}

TEST(Report, PeopleReadItInAFewLines) {
  JobReport report = made_up();
  report.other_painting = "another";
  EXPECT_EQ(report_text(report),
            "a.png  80 x 60\na.depth.png  81 x 61\n100 steps (40 computed), 2.5 s simulated\n"
            "canvas 3 times finer\npainting: another\n1.5 s, 181 MB, state ssssssssssssssss\n");
}

TEST(PaintLines, AreTheBooksOfTheSimulation) {
  // 0.002 m deep all over 0.4 x 0.3 m: 2.4e-4 m^3, restored and thus deposited; then it dries.
  const CanvasGeometry grid = {32, 24, 0.4, 0.3};
  const std::vector<Pigment> paints = {{"a", Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 1, 1)},
                                       {"b", Eigen::Vector3d(1, 2, 1), Eigen::Vector3d(1, 1, 1)}};
  SimulationSetup setup;
  setup.geometry = grid;
  setup.basis = make_channels(paints);
  setup.paper_m = Field<float>(32, 24);
  const Threads threads(1);
  CanvasState state = make_canvas_state(grid, setup.model.layers, 2, 3, 0.9f);
  state.depth_m.fill(0.002f);
  state.channel(0, 0).fill(0.01f);
  state.channel(1, 1).fill(0.03f);
  Simulation simulation(std::move(setup), threads);
  simulation.restore(std::move(state));
  const auto expect = [&](bool dry) {
    const std::vector<PaintLine> lines = paint_lines(simulation);
    ASSERT_EQ(lines.size(), 3u);
    const double amount[] = {2.4e-4, 0.01 * 0.12, 0.03 * 0.12};
    const char* name[] = {"medium", "a", "b"};
    for (std::size_t i = 0; i < 3; ++i) {
      const double tolerance = 1e-6 * amount[i];  // the planes are float
      EXPECT_EQ(lines[i].name, name[i]);
      EXPECT_NEAR(lines[i].deposited, amount[i], tolerance);
      EXPECT_EQ(lines[i].picked_up, 0);
      EXPECT_NEAR(lines[i].dried, dry ? amount[i] : 0, tolerance);
      EXPECT_NEAR(lines[i].wet, dry ? 0 : amount[i], tolerance);
    }
  };
  expect(false);
  simulation.dry();
  expect(true);
}

}  // namespace
}  // namespace pentimento
