#include "client/cli/scene/json_fields.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/near_names.h"
#include "base/text/encoding.h"
#include "base/text/join.h"
#include "client/cli/input/file_kind.h"
#include "gonio/base/shown.h"
#include "wire/convert.h"

namespace gonio::cli {

Result<JsonObject> read_object(const std::string& file, const char* what) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, ignored))
    return bad_value(what, file, "a JSON file that can be read" + near_files(file),
                     ErrorCode::not_found);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  const auto plain = utf8_text(content, file);
  if (!plain) return plain.error();
  const std::string_view text = *plain;
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return bad_value(what, file + ", which is empty", "a JSON object");
  if (text[text.find_first_not_of(" \t\r\n")] != '{')
    return bad_value(what, file + ", which does not begin with {", "a JSON object");
  JsonObject object;
  const auto status = google::protobuf::util::JsonStringToMessage(
      google::protobuf::StringPiece(text.data(), text.size()), &object);
  if (status.ok()) return object;
  return Error{
      ErrorCode::invalid_argument,
      shown(file) + ": " + wire::json_problem({status.message().data(), status.message().size()}),
      what, shown(file), "a JSON object"};
}

std::string as_text(const JsonValue& value) {
  std::string text;
  (void)google::protobuf::util::MessageToJsonString(value, &text);
  return text;
}

Outcome check_names(const JsonObject& object, std::span<const std::string_view> known,
                    const std::string& prefix) {
  for (const auto& [name, value] : object.fields()) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return bad_value(prefix + name, "not a field", joined(known) + did_you_mean(name, known));
  }
  return Ok{};
}

const JsonValue* find(const JsonObject& object, const std::string& name) {
  const auto found = object.fields().find(name);
  return found == object.fields().end() ? nullptr : &found->second;
}

Result<std::vector<double>> numbers(const JsonValue& value, const std::string& field, double unit) {
  if (!value.has_list_value()) return bad_value(field, as_text(value), "a list of numbers");
  std::vector<double> all;
  for (const JsonValue& number : value.list_value().values()) {
    if (!number.has_number_value()) return bad_value(field, as_text(number), "numbers");
    all.push_back(number.number_value() * unit);
  }
  return all;
}

Outcome read_number(const JsonObject& object, const char* name, const std::string& prefix,
                    double& to) {
  const JsonValue* value = find(object, name);
  if (value == nullptr) return Ok{};
  if (!value->has_number_value()) return bad_value(prefix + name, as_text(*value), "a number");
  to = value->number_value();
  return Ok{};
}

Outcome read_switch(const JsonObject& object, const char* name, const std::string& prefix,
                    bool& to) {
  const JsonValue* value = find(object, name);
  if (value == nullptr) return Ok{};
  if (!value->has_bool_value()) return bad_value(prefix + name, as_text(*value), "true or false");
  to = value->bool_value();
  return Ok{};
}

}  // namespace gonio::cli
