#pragma once
// For messages about a misspelt name.

#include <span>
#include <string>
#include <string_view>

namespace pentimento {

/// ` (did you mean "pressure"?)` for the candidate nearest to `name`, if one is near; else, if
/// `name` is part of some, ` (did you mean "a", "b" or "c"?)` for the first three of these; else
/// the same for those with the word that is nearest to `name`, if one is near; else empty. Near: at
/// most a third of the letters, and no more than 3, inserted, deleted or replaced. Parts and words
/// have four letters or more, whatever their case.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace pentimento
