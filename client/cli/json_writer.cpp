#include <google/protobuf/util/json_util.h>
#include <google/protobuf/wrappers.pb.h>

#include <cmath>

#include "client/cli/numbers.h"
#include "client/cli/result_writer.h"

namespace gonio::cli {
namespace {

std::string json_string(std::string_view text) {
  google::protobuf::StringValue value;
  value.set_value(std::string(text));
  std::string json;
  return google::protobuf::util::MessageToJsonString(value, &json).ok() ? json : "\"\"";
}

std::string report_json(const client::Report& report) {
  std::string json = "{\"pairs\": " + std::to_string(report.pairs);
  json += ", \"kernel_seconds\": " + shortest(report.kernel_seconds);
  json += ", \"instruction_set\": " + json_string(name_of(report.instruction_set));
  json += ", \"precision\": " + json_string(name_of(report.precision));
  json += ", \"error_bound\": {\"relative\": " + shortest(report.error_bound.relative) +
          ", \"above\": " + shortest(report.error_bound.above) +
          ", \"cosine\": " + shortest(report.error_bound.cosine) +
          ", \"note\": " + json_string(report.error_bound.note) + "}";
  json += ", \"flagged\": " + std::to_string(report.flagged);
  return json + ", \"retries\": " + std::to_string(report.retries) + "}";
}

template <class T>
class JsonWriter final : public ResultWriter<T> {
 public:
  explicit JsonWriter(OutputFile& output) : output_(output) {}

  Outcome write(const client::Chunk<T, T>& chunk) override {
    text_.clear();
    begin(chunk.channels);
    const auto channels = static_cast<std::size_t>(chunk.channels);
    for (std::size_t i = 0; i < chunk.pairs; ++i) {
      text_ += flags_.empty() ? "\n[" : ",\n[";
      for (std::size_t c = 0; c < channels; ++c) {
        if (c > 0) text_ += ", ";
        add_number(chunk.values[i * channels + c]);
      }
      text_ += ']';
      flags_ += static_cast<char>(chunk.flags[i]);
    }
    return output_.write(text_);
  }

  Outcome finish(const client::Report& report) override {
    text_.clear();
    begin(report.channels);
    text_ += "\n],\n\"flags\": [";
    for (std::size_t i = 0; i < flags_.size(); ++i) {
      if (i > 0) text_ += ", ";
      text_ += std::to_string(static_cast<unsigned char>(flags_[i]));
    }
    text_ += "],\n\"report\": " + report_json(report) + "}\n";
    return output_.write(text_);
  }

 private:
  void begin(int channels) {
    if (begun_) return;
    begun_ = true;
    text_ += "{\"channels\": " + std::to_string(channels) + ",\n\"values\": [";
  }

  void add_number(T value) {
    if (!std::isfinite(value)) {  // JSON has no word for it
      text_ += "null";
      return;
    }
    char digits[kLongestNumber];
    text_.append(digits, put_number(digits, value));
  }

  OutputFile& output_;
  std::string text_;
  std::string flags_;  // one byte a pair, until the values are written
  bool begun_ = false;
};

}  // namespace

template <class T>
std::unique_ptr<ResultWriter<T>> json_writer(OutputFile& output) {
  return std::make_unique<JsonWriter<T>>(output);
}

template std::unique_ptr<ResultWriter<float>> json_writer(OutputFile&);
template std::unique_ptr<ResultWriter<double>> json_writer(OutputFile&);

}  // namespace gonio::cli
