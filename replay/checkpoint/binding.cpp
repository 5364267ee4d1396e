#include "replay/checkpoint/binding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "formats/log/tables/model_fields.h"
#include "replay/job/build_info.h"

namespace pentimento {

namespace {
constexpr std::size_t kLeastPairBytes = 8 + 8;

std::string cells(const CanvasGeometry& grid) {
  return fmt::format("{} x {}", grid.width, grid.height);
}

const std::string* find(const Binding& binding, const std::string& name) {
  const auto found =
      std::find_if(binding.begin(), binding.end(), [&](const auto& p) { return p.first == name; });
  return found == binding.end() ? nullptr : &found->second;
}
}  // namespace

Binding binding_of(const RenderJob& job, const LogSession& session,
                   const std::map<std::string, std::string>& files_of_options) {
  Binding binding = {{"log", session.plan.sha256}};
  for (const auto& [name, sha256] : session.files.hashes())
    binding.emplace_back("file " + name, sha256);
  for (const auto& [option, sha256] : files_of_options) binding.emplace_back(option, sha256);
  binding.emplace_back("build", software());
  binding.emplace_back("grid", cells(session.grid));
  binding.emplace_back("detail", std::to_string(session.detail));
  for (const log::ModelField& field : log::model_fields())
    binding.emplace_back("model." + std::string(field.name),
                         log::model_value_json(field, session.model));
  binding.emplace_back("outputs", fmt::format("{}", fmt::join(job.picture.outputs, " ")));
  // All other options, as they are written.
  binding.emplace_back("command", job.command);
  return binding;
}

void put_binding(const Binding& binding, checkpoint::ArchiveWriter& to) {
  to.u64(binding.size());
  for (const auto& [name, value] : binding) {
    to.text(name);
    to.text(value);
  }
}

Binding take_binding(checkpoint::ArchiveReader& from) {
  Binding binding;
  const std::uint64_t count = from.count(kLeastPairBytes);
  for (std::uint64_t i = 0; i < count && from.ok(); ++i) {
    std::string name = from.text();
    binding.emplace_back(std::move(name), from.text());
  }
  return binding;
}

std::string difference(const Binding& kept, const Binding& now) {
  for (const auto& [name, value] : kept) {
    const std::string* other = find(now, name);
    if (other == nullptr) return fmt::format("{} {}, which this job does not have", name, value);
    if (*other != value) return fmt::format("{} {}, not {}", name, value, *other);
  }
  for (const auto& [name, value] : now)
    if (find(kept, name) == nullptr) return fmt::format("a job without {} {}", name, value);
  return {};
}

}  // namespace pentimento
