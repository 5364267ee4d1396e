#include "replay/batch/workers.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "formats/io/read_file.h"
#include "replay/batch/moment.h"

namespace pentimento {

namespace {
namespace fs = std::filesystem;
constexpr std::chrono::milliseconds kBetweenLooks{10};
constexpr std::int64_t kMostOutputBytes = std::int64_t{1} << 30;

std::string text_of(const std::string& path) {
  Result<std::string> text = read_file(path, kMostOutputBytes);
  return text ? *text : std::string();
}

/// The last line with anything on it.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n");
  if (end == std::string::npos) return {};
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

JobResult read_result(const Task& task, const std::string& work, const ChildDone& done) {
  JobResult result;
  result.key = task.key;
  result.done = done;
  result.finished = utc_now();
  result.message = last_line(text_of(work + "/messages.txt"));
  const nlohmann::json report =
      nlohmann::json::parse(text_of(work + "/report.json"), nullptr, false);
  if (done.end != ChildEnd::kExit || done.code != 0 || !report.is_object()) return result;
  result.message.clear();
  result.report_json = report.dump();
  result.state_sha256 = report.value("state_sha256", "");
  result.guide_sha256 = report.value("guide_sha256", "");
  return result;
}

bool says_threads(const std::vector<std::string>& options) {
  return std::any_of(options.begin(), options.end(),
                     [](const std::string& word) { return word.starts_with("--threads"); });
}
}  // namespace

Workers::Workers(const WorkerLimits& limits, const RunFolder& run,
                 std::function<Result<void>(const Task&, const JobResult&)> found)
    : limits_(limits), run_(run), found_(std::move(found)) {}

std::int64_t Workers::memory_of(const Task& task) const {
  if (task.job.memory_bytes) return *task.job.memory_bytes;
  if (limits_.memory_bytes > 0 || limits_.memory_budget == 0) return limits_.memory_bytes;
  return limits_.memory_budget / limits_.at_once;
}

bool Workers::may_start(const Task& task) const {
  if (static_cast<int>(running_.size()) >= limits_.at_once) return false;
  std::int64_t memory = memory_of(task);
  for (const RunningJob& running : running_) {
    memory += running.memory_bytes;
    if (running.task.key == task.key) return false;
  }
  return limits_.memory_budget == 0 || running_.empty() || memory <= limits_.memory_budget;
}

std::vector<std::string> Workers::words_of(const Task& task, const std::string& work) const {
  // A name that begins with a dash is no option.
  const std::string log = task.job.log.starts_with('-') ? "./" + task.job.log : task.job.log;
  std::vector<std::string> words = {"render", log, "--json", "--progress", "none", "--quiet"};
  if (limits_.pictures) words.insert(words.end(), {"-o", work + "/picture.png"});
  // A render has an output; without a picture a dump is the cheapest, and it need not be kept.
  if (limits_.dumps || !limits_.pictures) words.insert(words.end(), {"-o", work + "/state.h5"});
  if (!says_threads(task.job.options)) {
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    words.insert(words.end(), {"--threads", std::to_string(std::max(1, cores / limits_.at_once))});
  }
  words.insert(words.end(), task.job.options.begin(), task.job.options.end());
  return words;
}

Result<void> Workers::start(const Task& task) {
  Result<std::string> work = run_.begin(task.key);
  if (!work) return work.error();
  ChildSpec spec;
  spec.program = limits_.program;
  spec.words = words_of(task, *work);
  spec.folder = limits_.folder;
  spec.output_file = *work + "/report.json";
  spec.message_file = *work + "/messages.txt";
  spec.timeout_s = task.job.timeout_s.value_or(limits_.timeout_s);
  spec.memory_bytes = memory_of(task);
  Result<std::unique_ptr<Child>> child = Child::start(spec);
  if (!child) return child.error();
  running_.push_back({task, *work, spec.memory_bytes, std::move(*child)});
  return {};
}

Result<void> Workers::start_what_fits(std::deque<Task>& tasks) {
  for (std::size_t i = 0; i < tasks.size();) {
    if (static_cast<int>(running_.size()) >= limits_.at_once) return {};
    if (!may_start(tasks[i])) {
      ++i;
      continue;
    }
    if (Result<void> started = start(tasks[i]); !started) return started;
    tasks.erase(tasks.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return {};
}

Result<void> Workers::collect(RunningJob& running) {
  const JobResult result = read_result(running.task, running.work, running.child->done());
  std::error_code ignored;
  fs::remove(running.work + "/report.json", ignored);
  if (!limits_.dumps) fs::remove(running.work + "/state.h5", ignored);
  if (fs::is_empty(running.work + "/messages.txt", ignored))
    fs::remove(running.work + "/messages.txt", ignored);
  Result<JobResult> kept = run_.keep(result, running.work);
  if (!kept) return kept.error();
  return found_(running.task, result);  // if another result stands there, both are seen
}

Result<void> Workers::collect_ended() {
  for (std::size_t i = 0; i < running_.size();) {
    if (!running_[i].child->has_ended()) {
      ++i;
      continue;
    }
    RunningJob ended = std::move(running_[i]);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
    if (Result<void> collected = collect(ended); !collected) return collected;
  }
  return {};
}

void Workers::stop_all() {
  for (RunningJob& running : running_) running.child->stop();
  while (!running_.empty()) {
    std::erase_if(running_, [](RunningJob& running) {
      if (!running.child->has_ended()) return false;
      RunFolder::discard(running.work);
      return true;
    });
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

Result<void> Workers::run(std::deque<Task> tasks, const Control& control) {
  Result<void> going;
  while (going && (!tasks.empty() || !running_.empty())) {
    going = control.go_on();
    if (going) going = start_what_fits(tasks);
    if (going) going = collect_ended();
    std::this_thread::sleep_for(kBetweenLooks);
  }
  stop_all();
  return going;
}

}  // namespace pentimento
