#include "replay/job/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>

#include "replay/job/report_object.h"

namespace pentimento {

namespace {
std::string medium_json(const PaintLine& line) {
  return ReportObject()
      .add("deposited_m3", line.deposited)
      .add("picked_up_m3", line.picked_up)
      .add("dried_m3", line.dried)
      .add("wet_m3", line.wet)
      .add("relative_difference", line.relative_difference())
      .text();
}

std::string pigment_json(const PaintLine& line) {
  return ReportObject()
      .add("name", line.name)
      .add("deposited", line.deposited)
      .add("picked_up", line.picked_up)
      .add("dried", line.dried)
      .add("wet", line.wet)
      .add("relative_difference", line.relative_difference())
      .text();
}

std::string paint_json(const std::vector<PaintLine>& paint) {
  std::vector<std::string> pigments;
  for (std::size_t i = 1; i < paint.size(); ++i) pigments.push_back(pigment_json(paint[i]));
  return ReportObject()
      .add_json("medium", medium_json(paint.front()))
      .add_json("pigments", json_array(pigments))
      .text();
}

/// Shares of the blocks that had paint before they were locked.
std::string lock_json(const LockStatistics& lock) {
  const auto blocks = std::accumulate(lock.blocks.begin(), lock.blocks.end(), std::int64_t{0});
  ReportObject json;
  json.add("blocks", blocks).add("owed", lock.owed);
  std::int64_t within = 0;
  for (std::size_t i = 0; i < LockStatistics::kBound.size(); ++i) {
    within += lock.blocks[i];
    json.add(fmt::format("within_{}", LockStatistics::kBound[i]),
             static_cast<double>(within) / static_cast<double>(std::max<std::int64_t>(1, blocks)));
  }
  return json.text();
}

std::string outputs_json(const std::vector<WrittenFile>& outputs) {
  std::vector<std::string> files;
  for (const WrittenFile& f : outputs) {
    ReportObject file;
    file.add("file", f.file).add("width", f.width).add("height", f.height).add("sha256", f.sha256);
    if (f.scale) {
      file.add("offset", f.scale->offset)
          .add("per_code", f.scale->per_code)
          .add("unit", f.scale->unit);
    }
    files.push_back(file.text());
  }
  return json_array(files);
}

std::string checkpoint_json(const CheckpointReport& checkpoint) {
  ReportObject json;
  json.add("folder", checkpoint.folder);
  if (checkpoint.resumed_step) {
    json.add("resumed_step", *checkpoint.resumed_step).add("older_slot", checkpoint.older_slot);
  }
  return json.add("slots_written", checkpoint.slots_written)
      .add("bytes_written", checkpoint.bytes_written)
      .add("wall_s", checkpoint.wall_s)
      .text();
}
}  // namespace

double PaintLine::relative_difference() const {
  return (deposited - picked_up - dried - wet) /
         std::max(deposited, std::numeric_limits<double>::min());
}

std::vector<PaintLine> paint_lines(const Simulation& simulation) {
  const PaintAccount& account = simulation.account();
  const PaintFlow wet = simulation.wet();
  std::vector<PaintLine> lines = {{"medium", account.deposited.medium_m3,
                                   account.picked_up.medium_m3, account.dried.medium_m3,
                                   wet.medium_m3}};
  const std::vector<std::string>& names = simulation.basis().name;
  for (std::size_t c = 0; c < names.size(); ++c) {
    lines.push_back({names[c], account.deposited.channel[c], account.picked_up.channel[c],
                     account.dried.channel[c], wet.channel[c]});
  }
  return lines;
}

std::string report_json(const JobReport& report) {
  ReportObject json;
  json.add_json("outputs", outputs_json(report.outputs))
      .add("steps", report.steps)
      .add("steps_computed", report.steps_computed)
      .add("simulated_s", report.simulated_s)
      .add("wall_s", report.wall_s)
      .add("peak_memory_bytes", report.peak_memory_bytes)
      .add("threads", report.threads)
      .add("state_sha256", report.state_sha256)
      .add("guide_sha256", report.guide_sha256)
      .add("detail", report.detail)
      .add("log_sha256", report.log_sha256);
  if (!report.other_painting.empty()) json.add("painting", report.other_painting);
  if (!report.paint.empty()) json.add_json("paint", paint_json(report.paint));
  if (!report.fluid.empty()) {
    ReportObject fluid;
    for (const auto& [name, value] : report.fluid) fluid.add(name, value);
    json.add_json("fluid", fluid.text());
  }
  if (report.lock) json.add_json("lock", lock_json(*report.lock));
  std::vector<std::string> phases;
  for (const Phase& phase : report.phases) {
    phases.push_back(ReportObject().add("name", phase.name).add("wall_s", phase.wall_s).text());
  }
  if (!report.frame_steps.empty())
    json.add_json("frame_steps", fmt::format("[{}]", fmt::join(report.frame_steps, ",")));
  if (report.checkpoint) json.add_json("checkpoint", checkpoint_json(*report.checkpoint));
  return json.add_json("phases", json_array(phases)).text();
}

std::string report_text(const JobReport& report) {
  std::string text;
  for (const WrittenFile& f : report.outputs) {
    text += f.width > 0 ? fmt::format("{}  {} x {}\n", f.file, f.width, f.height) : f.file + "\n";
  }
  if (report.steps > 0) {
    text += fmt::format("{} steps ({} computed), {:.1f} s simulated\n", report.steps,
                        report.steps_computed, report.simulated_s);
  }
  if (report.detail > 1) text += fmt::format("canvas {} times finer\n", report.detail);
  if (!report.other_painting.empty()) text += "painting: " + report.other_painting + "\n";
  return text + fmt::format("{:.1f} s, {} MB, state {:.16}\n", report.wall_s,
                            report.peak_memory_bytes / 1'000'000, report.state_sha256);
}

std::int64_t peak_memory_bytes() {
  // The kernel's own line for this program. What getrusage() says may be the memory of the process
  // that started it.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace pentimento
