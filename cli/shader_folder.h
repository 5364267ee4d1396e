#pragma once
// Where the command keeps compiled shaders between its runs.

#include <optional>
#include <string>

namespace pentimento::cli {

/// The folder for compiled shaders, which is made if it is missing: what PENTIMENTO_CACHE names, or
/// `pentimento` in XDG_CACHE_HOME or in `.cache` of HOME (XDG Base Directory Specification 0.8).
/// None if PENTIMENTO_CACHE is empty, and where there is no such place that belongs to this user
/// alone and can be written to: shaders are code that will run.
std::optional<std::string> shader_folder();

/// Lets pictures find shaders there, if there is such a folder.
void use_shader_folder();

}  // namespace pentimento::cli
