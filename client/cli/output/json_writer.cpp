#include <cmath>
#include <utility>

#include "client/cli/output/json.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/result_writer.h"

namespace gonio::cli {
namespace {

template <class T>
class JsonWriter final : public ResultWriter<T> {
 public:
  JsonWriter(OutputFile& output, Table table) : output_(output), table_(std::move(table)) {}

  Outcome write(const Rows<T>& rows) override {
    text_.clear();
    begin(rows.channels);
    for (std::size_t i = 0; i < rows.count; ++i) {
      text_ += flags_.empty() ? "\n[" : ",\n[";
      for (std::size_t c = 0; c < columns_; ++c) {
        if (c > 0) text_ += ", ";
        add_number(rows.numbers[i * columns_ + c]);
      }
      text_ += ']';
      flags_ += static_cast<char>(rows.flags[i]);
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
    text_ += "],\n\"report\": " + report_json(report, table_.of_samples) + "}\n";
    return output_.write(text_);
  }

 private:
  void begin(int channels) {
    if (begun_) return;
    begun_ = true;
    const auto columns = table_.columns(channels);
    columns_ = columns.size();
    text_ += "{\"channels\": " + std::to_string(channels) + ",\n";
    if (table_.is_mixed) {
      text_ += "\"columns\": [";
      for (const std::string& name : columns) {
        text_ += (&name == &columns.front() ? "" : ", ") + json_string(name);
      }
      text_ += "],\n";
    }
    text_ += table_.of_samples ? "\"samples\": [" : "\"values\": [";
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
  Table table_;
  std::string text_;
  std::string flags_;  // one byte a row, until the rows are written
  std::size_t columns_ = 0;
  bool begun_ = false;
};

}  // namespace

template <class T>
std::unique_ptr<ResultWriter<T>> json_writer(OutputFile& output, Table table) {
  return std::make_unique<JsonWriter<T>>(output, std::move(table));
}

template std::unique_ptr<ResultWriter<float>> json_writer(OutputFile&, Table);
template std::unique_ptr<ResultWriter<double>> json_writer(OutputFile&, Table);

}  // namespace gonio::cli
