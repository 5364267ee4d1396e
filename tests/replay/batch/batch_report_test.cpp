#include "replay/batch/batch_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "replay/batch/run_folder.h"
#include "tests/replay/batch/made_batch.h"

namespace pentimento {
namespace {

using test::MadeBatch;

/// A batch in two shards, of which `done` have run, each in a folder of its own.
std::vector<std::string> sharded(MadeBatch& batch, int done) {
  for (int i = 0; i < 6; ++i) batch.add("job " + std::to_string(i), "ok " + std::to_string(i));
  batch.add("bad <&\"", "exit 3");
  batch.request.shards = 2;
  std::vector<std::string> runs;
  for (batch.request.shard = 1; batch.request.shard <= done; ++batch.request.shard) {
    runs.push_back(batch.path("run-" + std::to_string(batch.request.shard)));
    batch.request.run = runs.back();
    batch.run();
  }
  return runs;
}

TEST(BatchReport, HasEachIdOnceWhateverTheShards) {
  MadeBatch batch;
  const Result<BatchReport> report = merge_runs(sharded(batch, 2));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rows.size(), 7U);
  EXPECT_EQ(report->failed(), 1);
  EXPECT_EQ(report->not_run(), 0);
}

TEST(BatchReport, ListsWhatDidNotRun) {
  MadeBatch batch;
  const Result<BatchReport> report = merge_runs(sharded(batch, 1));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rows.size(), 7U);
  EXPECT_GT(report->not_run(), 0);
  EXPECT_NE(report_rows_text(*report).find(": not run: not run\n"), std::string::npos);
}

TEST(BatchReport, TwoRunsThatContradictEachOtherAreAFailure) {
  MadeBatch batch;
  batch.add("random", "random");
  batch.run();
  const std::string first = batch.request.run;
  batch.request.run = batch.path("again");
  batch.run();
  const Result<BatchReport> report = merge_runs({first, batch.request.run});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rows.front().row.kind, RowKind::kNotDeterministic);
  EXPECT_EQ(report->failed(), 1);
  // The same run twice is no contradiction.
  EXPECT_EQ(merge_runs({first, first})->failed(), 0);
}

TEST(Junit, HasATestCaseForEachIdNamedByIt) {
  MadeBatch batch;
  const Result<BatchReport> report = merge_runs(sharded(batch, 1));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(junit_xml(*report).c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  int cases = 0, failures = 0, errors = 0;
  for (const pugi::xml_node test : suite.children("testcase")) {
    ++cases;
    failures += test.child("failure") ? 1 : 0;
    errors += test.child("error") ? 1 : 0;
    if (test.attribute("name").value() == std::string("bad <&\"") && test.child("failure")) {
      EXPECT_EQ(test.child("failure").attribute("message").value(),
                std::string("exit code 3 instead of 0: said so"));
    }
  }
  EXPECT_EQ(suite.attribute("tests").as_int(), cases);
  EXPECT_EQ(suite.attribute("failures").as_int(), failures);
  EXPECT_EQ(suite.attribute("errors").as_int(), errors);
  EXPECT_EQ(errors, report->not_run());
  EXPECT_EQ(cases, 7);
}

TEST(HtmlReport, HoldsItsDataAndThePicturesItShows) {
  MadeBatch batch;
  batch.add("fine", "ok");
  batch.add("speck <!--", "ok 2");
  batch.request.golden = batch.path("golden");
  batch.request.reason = "begun";
  batch.run();
  batch.request.reason.reset();
  batch.request.run = batch.path("later");
  MadeBatch::write_picture(batch.path("picture.png"), 9);
  batch.run();
  ASSERT_TRUE(write_html(*merge_runs({batch.request.run}), batch.path("html")));
  const std::string page = test::slurp(batch.path("html/index.html"));
  const std::string begin = "<script type=\"application/json\" id=\"report\">";
  const std::size_t at = page.find(begin) + begin.size();
  const nlohmann::json data =
      nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
  ASSERT_EQ(data["rows"].size(), 2U);
  for (const nlohmann::json& row : data["rows"])
    for (const char* picture : {"thumbnail", "picture", "golden"})
      EXPECT_TRUE(std::filesystem::exists(batch.path("html/") + row[picture].get<std::string>()));
  EXPECT_EQ(page.find("http"), std::string::npos) << "nothing from a network";
  EXPECT_EQ(page.find("@CSS@"), std::string::npos);
}

}  // namespace
}  // namespace pentimento
