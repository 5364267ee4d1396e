// Prints the hash of a log's state, one line per line of standard input: what golden.py compares
// with what was frozen. Nothing is shaded or written.
//
// A line of input: LOG, SCHEME (conservative, paper), AT (as --at takes it), DETAIL, THREADS,
// separated by tabs. DETAIL above 1 is that of the detail canvas; the published fluid has none and
// is simulated on a grid that many times finer (--refine direct). A line of output is the hash.
// With the argument --instruction-set it prints which versions of the kernels it runs.

#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "replay/commands/render.h"
#include "tests/golden/instruction_set.h"

namespace pentimento {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
  return fields;
}

Result<RenderJob> job_of(const std::vector<std::string>& fields) {
  if (fields.size() != 5) return Error{ErrorCode::kUsage, "a line has five fields"};
  RenderJob job;
  job.log = fields[0];
  job.model.emplace_back("scheme", fields[1]);
  Result<StopPoint> at = parse_stop_point(fields[2]);
  if (!at) return at.error();
  job.stops.push_back(std::move(*at));
  const int detail = std::stoi(fields[3]);
  if (fields[1] == "paper" && detail > 1) {
    job.refine = Refine::kDirect;
    job.sim_scale = detail;
  } else {
    job.detail = detail;
  }
  job.threads = std::stoi(fields[4]);
  return job;
}

Result<std::string> hash_of(const std::string& line) {
  Result<RenderJob> job = job_of(fields_of(line));
  if (!job) return job.error();
  Result<JobReport> report = render(*job, Control{});
  if (!report) return report.error();
  return report->state_sha256;
}

int print_hashes() {
  for (std::string line; std::getline(std::cin, line);) {
    const Result<std::string> hash = hash_of(line);
    if (!hash) {
      std::cerr << line << ": " << hash.error().message << '\n';
      return 1;
    }
    std::cout << *hash << std::endl;
  }
  return 0;
}

}  // namespace
}  // namespace pentimento

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--instruction-set") {
    std::cout << pentimento::instruction_set() << '\n';
    return 0;
  }
  return pentimento::print_hashes();
}
