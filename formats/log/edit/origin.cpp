#include "formats/log/edit/origin.h"

#include <fmt/format.h>

#include "formats/log/write/json_object.h"

namespace pentimento::log {

void name_origin(Header& header, const std::string& key, const std::string& file,
                 const std::string& sha256) {
  JsonObject origin;
  origin.text("file", file).text("sha256", sha256);
  std::string name = key;
  for (int n = 2; header.extensions.find('"' + name + '"') != std::string::npos; ++n)
    name = fmt::format("{}-{}", key, n);
  if (!header.extensions.empty()) header.extensions += ',';
  header.extensions += '"' + name + "\":" + origin.close();
}

}  // namespace pentimento::log
