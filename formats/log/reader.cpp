#include "formats/log/reader.h"

#include <fmt/format.h>

#include <deque>

#include "formats/io/utf8.h"
#include "formats/log/json/json_line.h"
#include "formats/log/json/json_scan.h"
#include "formats/log/parse/event_parser.h"
#include "formats/log/parse/header_parser.h"
#include "formats/log/parse/log_rules.h"
#include "formats/log/parse/repair.h"
#include "formats/log/stream/line_source.h"

namespace pentimento::log {

namespace {

/// What a file that is no UTF-8 JSON starts with, in words; empty if nothing is odd.
std::string_view foreign_start(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) return "a byte order mark, to be left out";
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "UTF-16, not UTF-8";
  return {};
}

std::string_view without_space(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  const std::size_t last = text.find_last_not_of(" \t\r");
  return text.substr(first, last + 1 - first);
}

class LogReader : public Reader {
 public:
  LogReader(std::string name, std::unique_ptr<ByteSource> source, const ReaderOptions& options)
      : name_(std::move(name)),
        options_(options),
        lines_(std::move(source), options),
        rules_(header_, options) {}

  Result<void> read_header();
  const Header& header() const override { return header_; }
  Result<std::optional<Event>> next() override;
  Result<void> rewind() override;
  std::string sha256() const override { return lines_.sha256(); }
  std::string salvaged() const override { return salvaged_; }
  std::vector<std::string> repaired() const override { return repair_.notes(); }

 private:
  Error located(const Error& error) const;
  Error bad(std::string_view what) const {
    return located({ErrorCode::kBadInput, std::string(what)});
  }
  Result<std::optional<Event>> next_in_file();
  Result<std::optional<Event>> next_repaired();
  Result<std::optional<Event>> at_end();
  Result<std::optional<Event>> at_cut(const Line& line);
  std::string header_problem(const Line& line);

  /// Of what is wrong with a line. A name in it may be as long as the line.
  static constexpr std::size_t kMostMessageBytes = 300;

  std::string name_;
  ReaderOptions options_;
  LineSource lines_;
  JsonLine json_;
  Header header_;
  LogRules rules_;
  std::string salvaged_;
  Repair repair_;
  std::deque<Event> ready_;  // mended events that come before the next line
};

Error LogReader::located(const Error& error) const {
  if (error.code == ErrorCode::kIo) return error;  // names the file itself
  if (error.code == ErrorCode::kInterrupted) return error;
  return {error.code, fmt::format("{}:{}: {}", name_, lines_.line_number(),
                                  brief_line(error.message, kMostMessageBytes))};
}

std::string LogReader::header_problem(const Line& line) {
  const std::string_view foreign = foreign_start(line.text);
  if (!foreign.empty()) return fmt::format("the log starts with {}", foreign);
  std::string problem = json_.parse(line.text, options_.limits.max_depth);
  if (!problem.empty()) {
    const bool cut = !line.ended && ends_inside_json(line.text);
    return cut ? "the log is cut short in its first line" : problem;
  }
  problem = parse_header(json_, header_);
  return problem.empty() ? header_file_problem(header_, options_.allow_outside) : problem;
}

Result<void> LogReader::read_header() {
  const Result<std::optional<Line>> line = lines_.next();
  if (!line) return located(line.error());
  if (!*line) return Error{ErrorCode::kBadInput, fmt::format("{}:1: the log is empty", name_)};
  header_ = Header();
  const std::string problem = header_problem(**line);
  if (!problem.empty()) return bad(problem);
  if (const std::string over = header_over_limit(header_, options_.limits); !over.empty())
    return located({ErrorCode::kLimit, over});
  rules_ = LogRules(header_, options_);
  return {};
}

Result<std::optional<Event>> LogReader::next() {
  return options_.repair ? next_repaired() : next_in_file();
}

Result<std::optional<Event>> LogReader::next_repaired() {
  bool ended = false;
  while (true) {
    while (!ready_.empty()) {
      Event event = std::move(ready_.front());
      ready_.pop_front();
      const Result<void> checked = rules_.check(event);
      if (checked) return std::optional(std::move(event));
      if (checked.error().code != ErrorCode::kBadInput) return located(checked.error());
      repair_.drop(event.line, checked.error().message);
    }
    if (ended) return std::optional<Event>();
    const Result<std::optional<Line>> next_line = lines_.next();
    if (!next_line) return located(next_line.error());
    std::vector<Event> mended;
    if (!*next_line) {
      ended = true;
      mended = repair_.finish();
    } else {
      const Line& line = **next_line;
      Event event;
      event.line = line.number;
      std::string problem = json_.parse(line.text, options_.limits.max_depth);
      if (problem.empty()) problem = parse_event(json_, without_space(line.text), event);
      if (problem.empty())
        mended = repair_.mend(event);
      else
        repair_.drop(line.number, problem);
    }
    ready_.insert(ready_.end(), mended.begin(), mended.end());
  }
}

Result<std::optional<Event>> LogReader::next_in_file() {
  const Result<std::optional<Line>> next_line = lines_.next();
  if (!next_line) return located(next_line.error());
  if (!*next_line) return at_end();
  const Line& line = **next_line;
  std::string problem = json_.parse(line.text, options_.limits.max_depth);
  if (!problem.empty() && !line.ended && ends_inside_json(line.text)) return at_cut(line);
  Event event;
  event.line = line.number;
  if (problem.empty()) problem = parse_event(json_, without_space(line.text), event);
  if (!problem.empty()) return bad(problem);
  const Result<void> checked = rules_.check(event);
  if (!checked) return located(checked.error());
  return std::optional(std::move(event));
}

Result<std::optional<Event>> LogReader::at_end() {
  if (!lines_.cut_short()) return std::optional<Event>();
  if (!options_.salvage) return bad("the log is cut short: its compressed data end too early");
  salvaged_ = fmt::format("the compressed data end too early, after line {}", lines_.line_number());
  return std::optional<Event>();
}

Result<std::optional<Event>> LogReader::at_cut(const Line& line) {
  if (!options_.salvage) {
    return bad(fmt::format("the log is cut short in its last line, after {} bytes of it",
                           line.text.size()));
  }
  salvaged_ = fmt::format("line {} is cut short ({} bytes dropped)", line.number, line.text.size());
  return std::optional<Event>();
}

Result<void> LogReader::rewind() {
  Result<void> rewound = lines_.rewind();
  if (!rewound) return rewound;
  rules_ = LogRules(header_, options_);
  repair_ = {};
  ready_.clear();
  // The header is known already. It is not replaced, for callers hold references to it.
  const Result<std::optional<Line>> line = lines_.next();
  if (!line) return located(line.error());
  return {};
}

}  // namespace

Result<std::unique_ptr<Reader>> Reader::open(const std::string& path,
                                             const ReaderOptions& options) {
  Result<std::unique_ptr<ByteSource>> source = ByteSource::open(path, options);
  if (!source) return source.error();
  return open(path, std::move(*source), options);
}

Result<std::unique_ptr<Reader>> Reader::open(const std::string& path,
                                             std::unique_ptr<ByteSource> source,
                                             const ReaderOptions& options) {
  auto reader = std::make_unique<LogReader>(path == "-" ? "standard input" : path,
                                            std::move(source), options);
  const Result<void> header = reader->read_header();
  if (!header) return header.error();
  return std::unique_ptr<Reader>(std::move(reader));
}

}  // namespace pentimento::log
