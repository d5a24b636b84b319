#include "client/cli/json.h"

#include <google/protobuf/util/json_util.h>
#include <google/protobuf/wrappers.pb.h>

#include "client/cli/numbers.h"
#include "gonio/base/shown.h"

namespace gonio::cli {

std::string json_string(std::string_view text) {
  google::protobuf::StringValue value;
  value.set_value(std::string(text));
  std::string json;
  if (google::protobuf::util::MessageToJsonString(value, &json).ok()) return json;
  value.set_value(shown(text));  // bytes that are not UTF-8
  json.clear();
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
