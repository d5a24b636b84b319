// Reading the fields of a JSON object that people write. Errors name the field, what is there and
// what is allowed. Thread safety: functions without state.
#pragma once

#include <google/protobuf/struct.pb.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"

namespace gonio::cli {

using JsonObject = google::protobuf::Struct;
using JsonValue = google::protobuf::Value;

// `what` is the field of errors: "scene".
Result<JsonObject> read_object(const std::string& file, const char* what);

std::string as_text(const JsonValue& value);

// Nothing but what is known. `prefix` comes before names in errors: "scene.".
Outcome check_names(const JsonObject& object, std::span<const std::string_view> known,
                    const std::string& prefix);

// Null where it is not there.
const JsonValue* find(const JsonObject& object, const std::string& name);

// A list of numbers, each times `unit`.
Result<std::vector<double>> numbers(const JsonValue& value, const std::string& field, double unit);

// These leave `to` alone where the field is not there.
Outcome read_number(const JsonObject& object, const char* name, const std::string& prefix,
                    double& to);
Outcome read_switch(const JsonObject& object, const char* name, const std::string& prefix,
                    bool& to);

}  // namespace gonio::cli
