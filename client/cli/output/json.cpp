#include "client/cli/output/json.h"

#include <google/protobuf/util/json_util.h>
#include <google/protobuf/wrappers.pb.h>

#include <algorithm>

#include "client/cli/output/numbers.h"
#include "gonio/base/shown.h"

namespace gonio::cli {

namespace {

// shown() writes only bytes that are no part of a character as "\x80", and nothing in a run of
// bytes beyond ASCII has these letters by itself.
bool is_utf8(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if_not(at, text.end(), is_ascii);
    at = std::find_if(begin, text.end(), is_ascii);
    if (shown(std::string(begin, at)).find("\\x") != std::string::npos) return false;
  }
  return true;
}

}  // namespace

std::string json_string(std::string_view text) {
  google::protobuf::StringValue value;
  // Protobuf leaves out what is not UTF-8.
  value.set_value(is_utf8(text) ? std::string(text) : shown(text));
  std::string json;
  return google::protobuf::util::MessageToJsonString(value, &json).ok() ? json : "\"\"";
}

std::string report_json(const client::Report& report, bool of_samples) {
  std::string json = of_samples ? "{\"samples\": " : "{\"pairs\": ";
  json += std::to_string(report.pairs);
  json += ", \"kernel_seconds\": " + shortest(report.kernel_seconds);
  json += ", \"instruction_set\": " + json_string(name_of(report.instruction_set));
  json += ", \"precision\": " + json_string(name_of(report.precision));
  json += ", \"error_bound\": {\"relative\": " + shortest(report.error_bound.relative) +
          ", \"above\": " + shortest(report.error_bound.above) +
          ", \"cosine\": " + shortest(report.error_bound.cosine) +
          ", \"note\": " + json_string(report.error_bound.note) + "}";
  if (of_samples) json += ", \"lost\": " + std::to_string(report.lost);
  json += ", \"flagged\": " + std::to_string(report.flagged);
  return json + ", \"retries\": " + std::to_string(report.retries) + "}";
}

}  // namespace gonio::cli
