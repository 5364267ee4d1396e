#include "formats/log/edit/merge_headers.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/log/write/to_json.h"

namespace pentimento::log {

namespace {
/// What a header says of one pigment or brush alone, as text.
template <typename List>
std::string text_of(List Header::*list, const typename List::value_type& value) {
  Header alone;
  (alone.*list).push_back(value);
  return header_json(alone);
}

template <typename List>
Result<void> merge_list(List Header::*member, const char* what, Header& header,
                        const Header& other) {
  List& list = header.*member;
  for (const auto& value : other.*member) {
    const auto known =
        std::find_if(list.begin(), list.end(), [&](const auto& v) { return v.name == value.name; });
    if (known == list.end())
      list.push_back(value);
    else if (text_of(member, *known) != text_of(member, value))
      return Error{ErrorCode::kBadInput,
                   fmt::format("the {} \"{}\" is another one in each log", what, value.name)};
  }
  return {};
}
}  // namespace

Result<void> merge_headers(Header& header, const Header& other) {
  if (header.canvas_width_m != other.canvas_width_m ||
      header.canvas_height_m != other.canvas_height_m)
    return Error{ErrorCode::kBadInput,
                 fmt::format("the canvas is {} x {} m, the other log's {} x {} m; a copy made "
                             "with --fit can be merged",
                             header.canvas_width_m, header.canvas_height_m, other.canvas_width_m,
                             other.canvas_height_m)};
  if (header.steps_per_second != other.steps_per_second)
    return Error{ErrorCode::kBadInput,
                 fmt::format("steps_per_second is {}, the other log's {}", header.steps_per_second,
                             other.steps_per_second)};
  // A log without a palette has the library's black as its first pigment; that must stay the first.
  if (header.palette.empty() && !other.palette.empty()) {
    PigmentSpec black;
    black.name = "Ivory Black";
    black.library = true;
    header.palette.push_back(black);
  }
  if (Result<void> merged = merge_list(&Header::palette, "pigment", header, other); !merged)
    return merged;
  return merge_list(&Header::brushes, "brush", header, other);
}

}  // namespace pentimento::log
