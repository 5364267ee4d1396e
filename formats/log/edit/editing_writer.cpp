#include "formats/log/edit/editing_writer.h"

#include <utility>

#include "formats/log/edit/as_spline.h"
#include "formats/log/edit/merge_gravity.h"
#include "formats/log/edit/merge_headers.h"
#include "formats/log/edit/merge_log.h"
#include "formats/log/edit/origin.h"
#include "formats/log/edit/pace.h"
#include "formats/log/edit/resample.h"
#include "formats/log/edit/trim.h"
#include "formats/log/json/json_line.h"
#include "formats/log/json/json_text.h"

namespace pentimento::log {

namespace {
constexpr int kMostDepth = 64;  // of what a reader has let through

/// An extension keeps its text word for word, but for its time.
void set_time(Extension& extension, std::int64_t time_us) {
  JsonLine line;
  std::string text = extension.json;
  text.reserve(text.size() + JsonLine::kPadding);
  if (!line.parse(text, kMostDepth).empty()) return;
  const std::vector<JsonNode>& nodes = line.nodes();
  std::string json = "{";
  for (int i = 1; i < nodes[0].end; i = nodes[static_cast<std::size_t>(i)].end) {
    const JsonNode& node = nodes[static_cast<std::size_t>(i)];
    if (json.size() > 1) json += ',';
    append_json_string(json, node.key);
    json += ':';
    if (node.key == "t")
      append_json_number(json, static_cast<double>(time_us) / 1e6);
    else
      json += line.json_of(node);
  }
  extension.json = json + "}";
}
}  // namespace

EditingWriter::EditingWriter(Edits edits, std::unique_ptr<Writer> inner)
    : edits_(std::move(edits)), inner_(std::move(inner)) {}

/// Where an event goes that is given to the chain as it stands.
EventSink EditingWriter::first() const {
  EventFilter* filter = filters_.back().get();
  return [filter](const Event& event) { filter->take(event); };
}

/// Into the file.
void EditingWriter::put(const Event& event) {
  ++events_;
  last_us_ = event.time_us;
  if (const auto* touch = std::get_if<Touch>(&event.action)) {
    strokes_ += touch->phase == TouchPhase::kDown ? 1 : 0;
    samples_ += touch->phase == TouchPhase::kDown || touch->phase == TouchPhase::kMove ? 1 : 0;
  }
  if (!std::holds_alternative<Extension>(event.action)) return inner_->write(event);
  Event timed = event;
  set_time(std::get<Extension>(timed.action), event.time_us);
  inner_->write(timed);
}

template <typename Filter, typename... Arguments>
void EditingWriter::put_before(Arguments&&... arguments) {
  EventSink next = filters_.empty() ? [this](const Event& event) { put(event); } : first();
  filters_.push_back(
      std::make_unique<Filter>(std::forward<Arguments>(arguments)..., std::move(next)));
}

void EditingWriter::write(const Header& header) {
  Header edited = header;
  if (edits_.merged) {
    if (const Result<void> merged = merge_headers(edited, edits_.merged->header); !merged) {
      problem_ = Error{merged.error().code, edits_.merged->file + ": " + merged.error().message};
      return;
    }
    name_origin(edited, "x-merged", edits_.merged->file, edits_.merged->sha256);
  }
  if (!edits_.gravity.empty())
    name_origin(edited, "x-gravity", edits_.gravity_file, edits_.gravity_sha256);
  Refit refit;
  if (edits_.canvas_m) refit = fit_header(edited, edits_.canvas_m->first, edits_.canvas_m->second);
  refit.size_factor = edits_.size_factor;
  inner_->write(edited);
  // From the last edit to the first.
  if (edits_.spline) put_before<AsSpline>(*edits_.spline);
  put_before<Refitted>(refit);
  if (edits_.resample_hz) put_before<Resample>(*edits_.resample_hz);
  if (edits_.speed != 1) put_before<Speed>(edits_.speed);
  if (edits_.longest_idle_us) put_before<DropIdle>(*edits_.longest_idle_us);
  if (edits_.trim_us) put_before<Trim>(edits_.trim_us->first, edits_.trim_us->second);
  if (!edits_.gravity.empty()) put_before<MergeGravity>(std::move(edits_.gravity));
  if (edits_.merged) put_before<MergeLog>(header, edits_.merged->header, edits_.merged->next);
}

void EditingWriter::write(const Event& event) {
  if (!problem_) filters_.back()->take(event);
}

Result<Published> EditingWriter::finish() {
  if (problem_) return *problem_;
  for (auto filter = filters_.rbegin(); filter != filters_.rend(); ++filter) (*filter)->finish();
  return inner_->finish();
}

}  // namespace pentimento::log
