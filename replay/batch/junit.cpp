// JUnit's XML, as Jenkins, GitLab and GitHub read it.

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "formats/io/utf8.h"
#include "replay/batch/batch_report.h"

namespace pentimento {

namespace {
/// Text that XML 1.0 allows.
std::string printable(const std::string& text) {
  std::string out = valid_utf8(text);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n') c = '?';
  return out;
}

/// What a program did wrong is a failure; what kept it from being judged is an error.
bool is_error(RowKind kind) {
  return kind == RowKind::kCrash || kind == RowKind::kTimeout || kind == RowKind::kMemory ||
         kind == RowKind::kNotRun;
}

std::string seconds(double value) {
  return fmt::format("{:.3f}", value);
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

std::string everything_of(const BatchRow& row) {
  std::string text;
  for (const std::string& reason : row.reasons) text += reason + "\n";
  for (const GoldenDifference& d : row.differences)
    text += fmt::format("{} {}: at most {:.6g}, at {},{}, in {:.4f} % of the values\n", d.of,
                        d.name, d.max, d.x, d.y, 100 * d.share);
  return text;
}

void add_case(pugi::xml_node suite, const BatchRow& row) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", "pentimento");
  set(test, "name", printable(row.id));
  set(test, "time", seconds(row.result.done.wall_s));
  if (row.passed()) return;
  pugi::xml_node why = test.append_child(is_error(row.kind) ? "error" : "failure");
  set(why, "type", std::string(name_of(row.kind)));
  set(why, "message", printable(row.reasons.empty() ? "" : row.reasons.front()));
  why.text().set(printable(everything_of(row)).c_str());
}
}  // namespace

std::string junit_xml(const BatchReport& report) {
  int errors = 0;
  double wall_s = 0;
  for (const ReportRow& one : report.rows) {
    errors += is_error(one.row.kind) ? 1 : 0;
    wall_s += one.row.result.done.wall_s;
  }
  pugi::xml_document document;
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  set(suite, "name", "pentimento batch");
  set(suite, "tests", std::to_string(report.rows.size()));
  set(suite, "failures", std::to_string(report.failed() - errors));
  set(suite, "errors", std::to_string(errors));
  set(suite, "time", seconds(wall_s));
  for (const ReportRow& one : report.rows) add_case(suite, one.row);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace pentimento
